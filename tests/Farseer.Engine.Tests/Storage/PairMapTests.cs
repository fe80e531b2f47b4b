using System;
using System.Collections.Generic;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Storage;

public class PairMapTests
{
    [Theory]
    [InlineData(1, 40, 1)]
    [InlineData(2, 400, 1)]
    [InlineData(3, 5000, 1)]
    [InlineData(4, 400, 1 << 12)]
    [InlineData(5, 400, 1 << 20)]
    public void PairMap_UnderRandomUse_AgreesWithDictionary(int seed, int members, int apart)
    {
        var random = new Random(seed);
        var map = new PairMap();
        var expected = new Dictionary<ulong, int>();
        for (int i = 0; i < 200_000; i++)
        {
            // Few members, so that keys come back often and runs of slots grow and shrink.
            ulong key = ((ulong)random.Next(members) * (uint)apart << 32) | (uint)random.Next(8);
            switch (random.Next(3))
            {
                case 0:
                    Assert.Equal(!expected.ContainsKey(key), map.Set(key, i));
                    expected[key] = i;
                    break;
                case 1:
                    bool had = expected.TryGetValue(key, out int old);
                    Assert.Equal(had, map.Remove(key, out int removed));
                    Assert.Equal(old, removed);
                    expected.Remove(key);
                    break;
                default:
                    bool has = expected.TryGetValue(key, out int value);
                    Assert.Equal(has, map.TryGet(key, out int found));
                    Assert.Equal(value, found);
                    break;
            }

            Assert.Equal(expected.Count, map.Count);
        }

        foreach (KeyValuePair<ulong, int> entry in expected)
        {
            Assert.True(map.TryGet(entry.Key, out int value));
            Assert.Equal(entry.Value, value);
        }

        map.Clear();
        Assert.Equal(0, map.Count);
        Assert.False(map.Contains(0));
    }

    [Theory]
    [InlineData(0xFFFFF, 0xFFFFF, 0xFFFFFE)]
    [InlineData(0x100000, 3, 3)]
    [InlineData(3, 0x100000, 3)]
    [InlineData(3, 3, 0xFFFFFF)]
    [InlineData(0x7FFFFFFE, 0x7FFFFFFF, 0x7FFFFFFF)]
    public void PairMap_GivenLargeNumbers_KeepsWhatItHas(int lower, int higher, int value)
    {
        var map = new PairMap();
        ulong large = ((ulong)(uint)lower << 32) | (uint)higher;
        for (uint i = 0; i < 100; i++)
        {
            Assert.True(map.Set(((ulong)i << 32) | (i + 1), (int)i));
        }

        Assert.False(map.Contains(large));
        Assert.True(map.Set(large, value));
        Assert.False(map.Set(large, value));
        for (uint i = 0; i < 100; i++)
        {
            Assert.True(map.TryGet(((ulong)i << 32) | (i + 1), out int found));
            Assert.Equal((int)i, found);
        }

        Assert.True(map.Remove(large, out int removed));
        Assert.Equal(value, removed);
        Assert.False(map.Contains(large));
        Assert.Equal(100, map.Count);
    }

    [Fact]
    public void PairMap_InSteadyUse_AllocatesNothing()
    {
        var map = new PairMap();
        map.EnsureCapacity(1000);
        AddAndRemove(map, 10);
        long before = GC.GetAllocatedBytesForCurrentThread();
        AddAndRemove(map, 1000);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    private static void AddAndRemove(PairMap map, int rounds)
    {
        for (int round = 0; round < rounds; round++)
        {
            for (uint i = 0; i < 1000; i++)
            {
                map.Set(((ulong)i << 32) | (i + 1 + (uint)round), (int)i);
            }

            for (uint i = 0; i < 1000; i++)
            {
                map.Remove(((ulong)i << 32) | (i + 1 + (uint)round));
            }
        }
    }
}
