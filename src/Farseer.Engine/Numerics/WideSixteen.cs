#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Farseer.Engine.Numerics.Sixteen;

using Wide = System.Runtime.Intrinsics.Vector512<float>;
using WideMask = System.Runtime.Intrinsics.Vector512<float>;

/// <summary>
/// <c>Wide</c> with sixteen lanes, for the kernels that are compiled a second time where processors have them: see
/// docs/decisions/021-sixteen-lanes.md. What the members mean is told in <see cref="Farseer.Engine.Numerics.WideLanes"/>.
/// </summary>
internal static unsafe class WideLanes
{
    /// <summary>Lanes of a bundle: all that lie side by side in a record.</summary>
    public const int BundleLanes = 16;

    /// <summary>The processor computes with sixteen lanes at a time, and takes no longer for it to be worth while.</summary>
    public static bool AreThere => Vector512.IsHardwareAccelerated && Avx512F.IsSupported;

    public static WideMask AllSet => ~WideMask.Zero;

    extension(Wide)
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Splat(float value) => Vector512.Create(value);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Load(float* source) => *(Wide*)source;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Max(Wide a, Wide b) => Avx512F.Max(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Min(Wide a, Wide b) => Avx512F.Min(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Sqrt(Wide a) => Avx512F.Sqrt(a);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Abs(Wide a) => Vector512.Abs(a);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Select(WideMask mask, Wide a, Wide b) => Vector512.ConditionalSelect(mask, a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideMask operator >(Wide a, Wide b) => Vector512.GreaterThan(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideMask operator <(Wide a, Wide b) => Vector512.LessThan(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideMask operator >=(Wide a, Wide b) => Vector512.GreaterThanOrEqual(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideMask operator <=(Wide a, Wide b) => Vector512.LessThanOrEqual(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide FromBits(int bits) => Unsafe.BitCast<Vector512<int>, Wide>(Vector512.Create(bits));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideMask SameBits(Wide a, Wide b)
        {
            Vector512<int> same = Vector512.Equals(Unsafe.BitCast<Wide, Vector512<int>>(a), Unsafe.BitCast<Wide, Vector512<int>>(b));
            return Unsafe.BitCast<Vector512<int>, WideMask>(same);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Wide Keep(WideMask mask, Wide a) => mask & a;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask Has(Wide value, int bits) => Wide.SameBits(value & Wide.FromBits(bits), Wide.FromBits(bits));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Any(WideMask mask) => Bits(mask) != 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Replace(WideMask mask, Wide value, float* target) => Wide.Select(mask, value, Wide.Load(target)).Store(target);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideMask Mask(int bits)
    {
        Vector512<int> each = Vector512.Create(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768);
        return Unsafe.BitCast<Vector512<int>, WideMask>(Vector512.Equals(Vector512.Create(bits) & each, each));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Bits(WideMask mask) => (int)Vector512.ExtractMostSignificantBits(mask);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Bits(WideMask a, WideMask b, WideMask c, WideMask d, out int bitsA, out int bitsB, out int bitsC, out int bitsD)
    {
        bitsA = Bits(a);
        bitsB = Bits(b);
        bitsC = Bits(c);
        bitsD = Bits(d);
    }

    /// <summary>Transposes the 4x4 blocks of each 128 bits; its own inverse.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Transpose(ref Wide r0, ref Wide r1, ref Wide r2, ref Wide r3)
    {
        Wide t0 = Avx512F.UnpackLow(r0, r1);
        Wide t1 = Avx512F.UnpackHigh(r0, r1);
        Wide t2 = Avx512F.UnpackLow(r2, r3);
        Wide t3 = Avx512F.UnpackHigh(r2, r3);
        r0 = Avx512F.Shuffle(t0, t2, 0x44);
        r1 = Avx512F.Shuffle(t0, t2, 0xEE);
        r2 = Avx512F.Shuffle(t1, t3, 0x44);
        r3 = Avx512F.Shuffle(t1, t3, 0xEE);
    }

    /// <summary>The same of blocks of 128 bits: what four vectors have in each quarter is put into one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void TransposeQuarters(ref Wide r0, ref Wide r1, ref Wide r2, ref Wide r3)
    {
        Wide t0 = Avx512F.Shuffle4x128(r0, r1, 0x44);
        Wide t1 = Avx512F.Shuffle4x128(r0, r1, 0xEE);
        Wide t2 = Avx512F.Shuffle4x128(r2, r3, 0x44);
        Wide t3 = Avx512F.Shuffle4x128(r2, r3, 0xEE);
        r0 = Avx512F.Shuffle4x128(t0, t2, 0x88);
        r1 = Avx512F.Shuffle4x128(t0, t2, 0xDD);
        r2 = Avx512F.Shuffle4x128(t1, t3, 0x88);
        r3 = Avx512F.Shuffle4x128(t1, t3, 0xDD);
    }
}
#endif
