using System;
using System.IO;
using System.IO.Compression;

namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>
/// Packs the numbers of a column, frame after frame. Each is taken against the same slot in the frame before, so what did not change
/// is zero; bytes of the same weight lie together, so that zeros and signs do; then the whole is deflated.
/// </summary>
internal static class ColumnCodec
{
    private const int Bound = 1 << 30;

    /// <summary>All bits: the exclusive or with the frame before.</summary>
    public static byte[] Encode(ColumnKind kind, double[] values, int slots)
    {
        int width = Width(kind);
        byte[] planes = new byte[values.Length * width];
        for (int i = 0; i < values.Length; i++)
        {
            ulong before = i < slots ? 0 : Bits(kind, values[i - slots]);
            Scatter(planes, i, values.Length, width, Bits(kind, values[i]) ^ before);
        }

        // All bits are mostly noise, on which more effort is lost.
        return Deflate(planes, CompressionLevel.Fastest);
    }

    /// <summary>What <see cref="Encode"/> packed.</summary>
    public static double[] Decode(ColumnKind kind, byte[] packed, int slots, int count)
    {
        int width = Width(kind);
        byte[] planes = Inflate(packed, count * width);
        ulong[] bits = new ulong[count];
        double[] values = new double[count];
        for (int i = 0; i < count; i++)
        {
            ulong word = i < slots ? 0 : bits[i - slots];
            for (int k = 0; k < width; k++)
            {
                word ^= (ulong)planes[(k * count) + i] << (8 * k);
            }

            bits[i] = word;
            values[i] = Value(kind, word);
        }

        return values;
    }

    /// <summary>
    /// Whole multiples of 10^-decimals: the difference from the frame before, and where <paramref name="steady"/> from where the last
    /// two frames lead.
    /// </summary>
    public static byte[] EncodeDecimals(double[] values, int slots, in Rounding rounding, bool steady)
    {
        int[] wholes = new int[values.Length];
        byte[] planes = new byte[values.Length * 4];
        for (int i = 0; i < values.Length; i++)
        {
            int whole = wholes[i] = rounding.Whole(values[i]);
            int one = i < slots ? 0 : wholes[i - slots];
            int two = !steady || i < 2 * slots ? one : wholes[i - (2 * slots)];
            int rest = unchecked(whole - (one + (one - two)));
            Scatter(planes, i, values.Length, 4, unchecked((uint)((rest << 1) ^ (rest >> 31))));
        }

        return Deflate(planes, CompressionLevel.Optimal);
    }

    private static int Width(ColumnKind kind) => kind switch
    {
        ColumnKind.Double => 8,
        ColumnKind.Byte => 1,
        _ => 4,
    };

    private static void Scatter(byte[] planes, int index, int count, int width, ulong word)
    {
        for (int k = 0; word != 0 && k < width; k++)
        {
            planes[(k * count) + index] = (byte)word;
            word >>= 8;
        }
    }

    private static ulong Bits(ColumnKind kind, double value) => kind switch
    {
        ColumnKind.Double => unchecked((ulong)BitConverter.DoubleToInt64Bits(value)),
        ColumnKind.Single => SingleBits((float)value),
        ColumnKind.Integer => unchecked((uint)(int)value),
        _ => (byte)value,
    };

    private static double Value(ColumnKind kind, ulong bits) => kind switch
    {
        ColumnKind.Double => BitConverter.Int64BitsToDouble(unchecked((long)bits)),
        ColumnKind.Single => BitsSingle((uint)bits),
        ColumnKind.Integer => unchecked((int)(uint)bits),
        _ => bits,
    };

#if NET8_0_OR_GREATER
    private static uint SingleBits(float value) => BitConverter.SingleToUInt32Bits(value);

    private static float BitsSingle(uint bits) => BitConverter.UInt32BitsToSingle(bits);
#else
    private static uint SingleBits(float value) => BitConverter.ToUInt32(BitConverter.GetBytes(value), 0);

    private static float BitsSingle(uint bits) => BitConverter.ToSingle(BitConverter.GetBytes(bits), 0);
#endif

    private static byte[] Deflate(byte[] bytes, CompressionLevel level)
    {
        using MemoryStream packed = new MemoryStream();
        using (DeflateStream deflate = new DeflateStream(packed, level, leaveOpen: true))
        {
            deflate.Write(bytes, 0, bytes.Length);
        }

        return packed.ToArray();
    }

    private static byte[] Inflate(byte[] packed, int length)
    {
        byte[] bytes = new byte[length];
        using DeflateStream inflate = new DeflateStream(new MemoryStream(packed), CompressionMode.Decompress);
        int at = 0;
        while (at < length)
        {
            int read = inflate.Read(bytes, at, length - at);
            if (read == 0)
            {
                throw new InvalidDataException("A column ends too early.");
            }

            at += read;
        }

        return bytes;
    }

    /// <summary>Decimals and the number that all are taken from, so that what is left fits into 31 bits.</summary>
    internal readonly struct Rounding
    {
        private readonly double _scale;
        private readonly double _base;

        /// <param name="decimals">At least 0; fewer are taken where the range asks for it.</param>
        /// <param name="least">The smallest number.</param>
        /// <param name="most">The largest.</param>
        public Rounding(int decimals, double least, double most)
        {
            while (decimals > -300 && (most - least) * Math.Pow(10, decimals) > Bound)
            {
                decimals--;
            }

            Decimals = decimals;
            _scale = Math.Pow(10, Math.Abs(decimals));
            _base = Math.Round(Scaled(least));
        }

        public int Decimals { get; }

        /// <summary>The whole number that stands for 0.</summary>
        public double Base => _base;

        public int Whole(double value)
        {
            if (double.IsNaN(value) || double.IsInfinity(value))
            {
                return 0;
            }

            return (int)Math.Max(-Bound, Math.Min(2.0 * Bound - 1, Math.Round(Scaled(value)) - _base));
        }

        private double Scaled(double value) => Decimals >= 0 ? value * _scale : value / _scale;
    }
}
