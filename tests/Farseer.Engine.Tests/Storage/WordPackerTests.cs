using System;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Storage;

public sealed unsafe class WordPackerTests
{
    [Fact]
    public void Pack_OfAnyDifferences_IsTakenBackByUnpack()
    {
        var packer = new WordPacker();
        var random = new Random(1);
        uint* from = stackalloc uint[WordPacker.Words];
        uint* to = stackalloc uint[WordPacker.Words];
        uint* made = stackalloc uint[WordPacker.Words];
        byte* bytes = stackalloc byte[WordPacker.MostBytes];
        for (int turn = 0; turn < 100_000; turn++)
        {
            int expected = 0;
            for (int i = 0; i < WordPacker.Words; i++)
            {
                from[i] = (uint)random.Next(int.MinValue, int.MaxValue);
                int bits = random.Next(0, 33);
                uint difference = bits == 0 ? 0 : uint.MaxValue >> (32 - bits) & (uint)random.Next(int.MinValue, int.MaxValue);
                to[i] = random.Next(2) == 0 ? from[i] + difference : from[i] - difference;
                made[i] = from[i];
                expected += BytesOf(to[i] - from[i]);
            }

            byte* end = packer.Pack(from, to, bytes, out byte code);

            Assert.Equal(expected, end - bytes);
            Assert.Equal(expected == 0, code == 0);
            Assert.True(packer.Unpack(bytes, code, made) == end, "another number of bytes is read than was written");
            Assert.True(
                new ReadOnlySpan<uint>(made, WordPacker.Words).SequenceEqual(new ReadOnlySpan<uint>(to, WordPacker.Words)), $"turn {turn}");
        }
    }

    [Theory]
    [InlineData(0u, 0, "")]
    [InlineData(1u, 0x01, "02 00")]
    [InlineData(uint.MaxValue, 0x01, "01 00")]
    [InlineData(0x8000u, 0x10, "00 00 01")]
    [InlineData(0x00800000u, 0x11, "00 00 00 01")]
    [InlineData(0x80000000u, 0x11, "FF FF FF FF")]
    public void Pack_OfOneDifference_TakesTheBytesThatAreNotZero(uint difference, int code, string expected)
    {
        var packer = new WordPacker();
        uint* from = stackalloc uint[WordPacker.Words];
        uint* to = stackalloc uint[WordPacker.Words];
        byte* bytes = stackalloc byte[WordPacker.MostBytes];
        new Span<uint>(from, WordPacker.Words).Clear();
        new Span<uint>(to, WordPacker.Words).Clear();
        to[0] = difference;

        byte* end = packer.Pack(from, to, bytes, out byte taken);

        Assert.Equal(code, taken);
        Assert.Equal(expected, BitConverter.ToString(new ReadOnlySpan<byte>(bytes, (int)(end - bytes)).ToArray()).Replace('-', ' '));
    }

    [Fact]
    public void PackBlock_OfSixteenWords_IsThatOfEachFour()
    {
        const int Block = 4 * WordPacker.Words;
        var random = new Random(5);
        var packer = new WordPacker();
        uint* from = stackalloc uint[Block];
        uint* to = stackalloc uint[Block];
        byte* bytes = stackalloc byte[4 * WordPacker.MostBytes];
        byte* expected = stackalloc byte[4 * WordPacker.MostBytes];
        byte* codes = stackalloc byte[4];
        for (int round = 0; round < 10_000; round++)
        {
            for (int i = 0; i < Block; i++)
            {
                from[i] = (uint)random.NextInt64();
                to[i] = from[i] + ((uint)random.NextInt64() >> random.Next(33));
            }

            byte* end = packer.PackBlock(from, to, codes, bytes);
            byte* expectedEnd = expected;
            for (int four = 0; four < 4; four++)
            {
                int first = four * WordPacker.Words;
                expectedEnd = packer.Pack(from + first, to + first, expectedEnd, out byte code);
                Assert.Equal(code, codes[four]);
            }

            Assert.True(new ReadOnlySpan<byte>(bytes, (int)(end - bytes))
                .SequenceEqual(new ReadOnlySpan<byte>(expected, (int)(expectedEnd - expected))));
        }
    }

    private static int BytesOf(uint difference)
    {
        uint folded = StateBlock.Fold(difference);
        return folded == 0 ? 0 : folded < 1u << 16 ? 2 : folded < 1u << 24 ? 3 : 4;
    }
}
