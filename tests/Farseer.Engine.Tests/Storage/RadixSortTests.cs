using System;
using System.Linq;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Storage;

public unsafe class RadixSortTests
{
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(48)]
    [InlineData(49)]
    [InlineData(5000)]
    public void Sort_RandomKeys_IsStableAndAscending(int count)
    {
        var random = new Random(count);
        var sorter = new RadixSort();
        for (int round = 0; round < 20; round++)
        {
            ulong[] keys = Enumerable.Range(0, count).Select(_ => (ulong)random.NextInt64() >> random.Next(64)).ToArray();
            int[] payload = Enumerable.Range(0, count).ToArray();
            int[] expected = payload.OrderBy(i => keys[i]).ToArray();
            ulong[] sorted = expected.Select(i => keys[i]).ToArray();
            ulong[] alone = (ulong[])keys.Clone();
            fixed (ulong* k = keys)
            fixed (ulong* a = alone)
            fixed (int* p = payload)
            {
                sorter.Sort(k, p, count);
                sorter.Sort(a, count);
            }

            Assert.Equal(sorted, keys);
            Assert.Equal(sorted, alone);
            Assert.Equal(expected, payload);
        }
    }

    [Fact]
    public void OrderedBits_OfFloats_KeepsTheirOrder()
    {
        float[] values =
            { float.NegativeInfinity, float.MinValue, -1, -float.Epsilon, 0, float.Epsilon, 1, float.MaxValue, float.PositiveInfinity };
        for (int i = 1; i < values.Length; i++)
        {
            Assert.True(RadixSort.OrderedBits(values[i - 1]) < RadixSort.OrderedBits(values[i]));
        }

        Assert.Equal(RadixSort.OrderedBits(0f), RadixSort.OrderedBits(-0f));
    }
}
