global using Wide = System.Numerics.Vector<float>;
global using WideMask = System.Numerics.Vector<int>;
using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
#endif

namespace Farseer.Engine.Numerics;

/// <summary>
/// <c>Wide</c>, a few floats side by side, is the one type that kernels compute with; <c>WideMask</c> is what a comparison gives:
/// all bits of a lane set, or none. Rows are stored in bundles of <see cref="BundleLanes"/> lanes on every machine; a kernel walks
/// a bundle in strides of <c>Wide.Count</c>. No operation crosses lanes and none is fused, so each lane gives the bits of the
/// scalar formula at any width. Both names are aliases of the platform's vectors: a struct around them costs two inlined calls
/// an operation, and a kernel has so many that the compiler gives up inlining (measured: five times slower). What kernels use often is
/// reinterpreted by <c>Unsafe.BitCast</c>, and its alternatives are statements: with <c>AsVector256</c> and <c>?:</c> the code is the
/// same, but takes the compiler longer, and kernels are half of what a process's first step waits for (docs/performance/first-seconds.md).
/// </summary>
internal static unsafe class WideLanes
{
    /// <summary>Lanes of a stored bundle, the same everywhere so that the state has one layout.</summary>
    public const int BundleLanes = 8;

    /// <summary>Vectors longer than a bundle would reach into the next one.</summary>
    /// <exception cref="PlatformNotSupportedException">They are: the runtime makes them so only if it is told to.</exception>
    public static void RequireFit()
    {
        if (Wide.Count > BundleLanes)
        {
            throw new PlatformNotSupportedException(
                $"Vector<float> has {Wide.Count} lanes in this process, and Farseer computes with at most {BundleLanes} of them: leave "
                    + $"DOTNET_MaxVectorTBitWidth unset, or set it to {BundleLanes * 32}. "
                + "(Where processors have AVX-512, long passes take sixteen lanes all the same.)");
        }
    }

    /// <summary>Every lane set.</summary>
    public static WideMask AllSet => ~WideMask.Zero;

    extension(Wide)
    {
#if NET8_0_OR_GREATER
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Splat(float value)
        {
            if (Wide.Count == BundleLanes)
            {
                return Unsafe.BitCast<Vector256<float>, Wide>(Vector256.Create(value));
            }

            return Unsafe.BitCast<Vector128<float>, Wide>(Vector128.Create(value));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Load(float* source) => *(Wide*)source;

        /// <summary>a &gt; b ? a : b, in every lane and on every processor.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Max(Wide a, Wide b)
        {
            if (Avx2.IsSupported && Wide.Count == BundleLanes)
            {
                Vector256<float> larger = Avx.Max(Unsafe.BitCast<Wide, Vector256<float>>(a), Unsafe.BitCast<Wide, Vector256<float>>(b));
                return Unsafe.BitCast<Vector256<float>, Wide>(larger);
            }

            return Vector.ConditionalSelect(Vector.GreaterThan(a, b), a, b);
        }

        /// <summary>a &lt; b ? a : b, in every lane and on every processor.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Min(Wide a, Wide b)
        {
            if (Avx2.IsSupported && Wide.Count == BundleLanes)
            {
                Vector256<float> smaller = Avx.Min(Unsafe.BitCast<Wide, Vector256<float>>(a), Unsafe.BitCast<Wide, Vector256<float>>(b));
                return Unsafe.BitCast<Vector256<float>, Wide>(smaller);
            }

            return Vector.ConditionalSelect(Vector.LessThan(a, b), a, b);
        }

        /// <summary>
        /// Where the mask is set <paramref name="a"/>, elsewhere <paramref name="b"/>. Of a mask that is not itself a comparison the
        /// compiler does not know that lanes are set or not as a whole, and takes three instructions where AVX-512 has one for it; a blend
        /// is one as well.
        /// </summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Select(WideMask mask, Wide a, Wide b)
        {
            if (Avx2.IsSupported && Wide.Count == BundleLanes && !Avx512F.VL.IsSupported)
            {
                Vector256<float> where = Unsafe.BitCast<WideMask, Vector256<float>>(mask);
                Vector256<float> selected = Avx.BlendVariable(
                    Unsafe.BitCast<Wide, Vector256<float>>(b), Unsafe.BitCast<Wide, Vector256<float>>(a), where);
                return Unsafe.BitCast<Vector256<float>, Wide>(selected);
            }

            return Vector.ConditionalSelect(mask, a, b);
        }

        /// <summary>Lanes whose bits are those of the integer.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide FromBits(int bits) => Unsafe.BitCast<WideMask, Wide>(new WideMask(bits));

        /// <summary>Where both have the same bits, whatever number these stand for.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideMask SameBits(Wide a, Wide b) =>
            Vector.Equals(Unsafe.BitCast<Wide, WideMask>(a), Unsafe.BitCast<Wide, WideMask>(b));

        /// <summary>Where the mask is set <paramref name="a"/>, elsewhere 0.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Keep(WideMask mask, Wide a) => Unsafe.BitCast<WideMask, Wide>(mask) & a;
#else
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Splat(float value) => new Wide(value);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Load(float* source) => Unsafe.ReadUnaligned<Wide>(source);

        /// <summary>a &gt; b ? a : b, in every lane and on every processor.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Max(Wide a, Wide b) => Vector.ConditionalSelect(Vector.GreaterThan(a, b), a, b);

        /// <summary>a &lt; b ? a : b, in every lane and on every processor.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Min(Wide a, Wide b) => Vector.ConditionalSelect(Vector.LessThan(a, b), a, b);

        /// <summary>Where the mask is set <paramref name="a"/>, elsewhere <paramref name="b"/>.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Select(WideMask mask, Wide a, Wide b) => Vector.ConditionalSelect(mask, a, b);

        /// <summary>Lanes whose bits are those of the integer.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide FromBits(int bits) => Vector.AsVectorSingle(new Vector<int>(bits));

        /// <summary>Where both have the same bits, whatever number these stand for.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideMask SameBits(Wide a, Wide b) => Vector.Equals(Vector.AsVectorInt32(a), Vector.AsVectorInt32(b));

        /// <summary>Where the mask is set <paramref name="a"/>, elsewhere 0.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Keep(WideMask mask, Wide a) => Vector.AsVectorSingle(mask) & a;
#endif

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Sqrt(Wide a) => Vector.SquareRoot(a);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Abs(Wide a) => Vector.Abs(a);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideMask operator >(Wide a, Wide b) => Vector.GreaterThan(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideMask operator <(Wide a, Wide b) => Vector.LessThan(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideMask operator >=(Wide a, Wide b) => Vector.GreaterThanOrEqual(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideMask operator <=(Wide a, Wide b) => Vector.LessThanOrEqual(a, b);

    }

    /// <summary>Where all of <paramref name="bits"/> are set in <paramref name="value"/>, both taken as bits.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask Has(Wide value, int bits) => Wide.SameBits(value & Wide.FromBits(bits), Wide.FromBits(bits));

    /// <summary>True if a lane of the mask is set.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
#if NET8_0_OR_GREATER
    public static bool Any(WideMask mask) => Bits(mask) != 0;
#else
    public static bool Any(WideMask mask) => !Vector.EqualsAll(mask, WideMask.Zero);
#endif

    /// <summary>Stores the lanes where the mask is set and leaves the others in memory as they are.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Replace(WideMask mask, Wide value, float* target) => Wide.Select(mask, value, Wide.Load(target)).Store(target);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
#if NET8_0_OR_GREATER
    public static void Store(this Wide value, float* target) => *(Wide*)target = value;
#else
    public static void Store(this Wide value, float* target) => Unsafe.WriteUnaligned(target, value);
#endif

    /// <summary>The mask whose lane i is set where bit i is: the reverse of <see cref="Bits(WideMask)"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask Mask(int bits)
    {
#if NET8_0_OR_GREATER
        if (Avx2.IsSupported && Wide.Count == BundleLanes)
        {
            Vector256<int> eight = Vector256.Create(1, 2, 4, 8, 16, 32, 64, 128);
            return Unsafe.BitCast<Vector256<int>, WideMask>(Vector256.Equals(Vector256.Create(bits) & eight, eight));
        }
#endif
        Vector<int> each = Unsafe.ReadUnaligned<Vector<int>>(ref MemoryMarshal.GetReference(EachBytes));
        return Vector.Equals(new Vector<int>(bits) & each, each);
    }

    // 1, 2, 4 … 128. Bytes, which need no array: they are read where they lie in the assembly.
    private static ReadOnlySpan<byte> EachBytes =>
        [1, 0, 0, 0, 2, 0, 0, 0, 4, 0, 0, 0, 8, 0, 0, 0, 16, 0, 0, 0, 32, 0, 0, 0, 64, 0, 0, 0, 128, 0, 0, 0];

#if NET8_0_OR_GREATER
    /// <summary>Transposes 4x4 blocks in both 128-bit halves; its own inverse.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Transpose(ref Vector256<float> r0, ref Vector256<float> r1, ref Vector256<float> r2, ref Vector256<float> r3)
    {
        Vector256<float> t0 = Avx.UnpackLow(r0, r1);
        Vector256<float> t1 = Avx.UnpackHigh(r0, r1);
        Vector256<float> t2 = Avx.UnpackLow(r2, r3);
        Vector256<float> t3 = Avx.UnpackHigh(r2, r3);
        r0 = Avx.Shuffle(t0, t2, 0x44);
        r1 = Avx.Shuffle(t0, t2, 0xEE);
        r2 = Avx.Shuffle(t1, t3, 0x44);
        r3 = Avx.Shuffle(t1, t3, 0xEE);
    }

    /// <summary>Bit i is set where lane i of the mask is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Bits(WideMask mask)
    {
        if (Avx2.IsSupported && Wide.Count == BundleLanes)
        {
            return Avx.MoveMask(Unsafe.BitCast<WideMask, Vector256<float>>(mask));
        }

        return (int)Vector128.ExtractMostSignificantBits(Unsafe.BitCast<WideMask, Vector128<int>>(mask));
    }

    /// <summary>The bits of four masks.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Bits(WideMask a, WideMask b, WideMask c, WideMask d, out int bitsA, out int bitsB, out int bitsC, out int bitsD)
    {
        bitsA = Bits(a);
        bitsB = Bits(b);
        bitsC = Bits(c);
        bitsD = Bits(d);
    }
#else
    /// <summary>Bit i is set where lane i of the mask is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Bits(WideMask mask)
    {
        Vector<short> words = Vector.Narrow(mask, mask);
        return BitsOf(Vector.Narrow(words, words), 0);
    }

    /// <summary>The bits of four masks.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Bits(WideMask a, WideMask b, WideMask c, WideMask d, out int bitsA, out int bitsB, out int bitsC, out int bitsD)
    {
        Vector<sbyte> bytes = Vector.Narrow(Vector.Narrow(a, b), Vector.Narrow(c, d));
        bitsA = BitsOf(bytes, 0);
        bitsB = BitsOf(bytes, 1);
        bitsC = BitsOf(bytes, 2);
        bitsD = BitsOf(bytes, 3);
    }

    /// <summary>The bits of a quarter of a vector: of each byte its own bit, and all added up in the highest one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int BitsOf(Vector<sbyte> bytes, int quarter) => WideMask.Count == BundleLanes
        ? (int)(((Vector.AsVectorUInt64(bytes)[quarter] & 0x8040201008040201UL) * 0x0101010101010101UL) >> 56)
        : (int)(((Vector.AsVectorUInt32(bytes)[quarter] & 0x08040201u) * 0x01010101u) >> 24);
#endif
}
