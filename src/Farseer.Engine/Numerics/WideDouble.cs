global using WideDouble = System.Numerics.Vector<double>;
global using WideDoubleMask = System.Numerics.Vector<long>;
using System.Numerics;
using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
#endif

namespace Farseer.Engine.Numerics;

/// <summary>
/// <c>WideDouble</c>, a few doubles side by side, for what needs them: see <see cref="WideLanes"/>, whose rules hold here as well. Records
/// are stored in bundles of <see cref="BundleLanes"/> lanes; a kernel walks a bundle in strides of <c>WideDouble.Count</c>.
/// </summary>
internal static unsafe class DoubleLanes
{
    /// <summary>Lanes of a stored bundle, the same everywhere.</summary>
    public const int BundleLanes = 4;

    extension(WideDouble)
    {
#if NET8_0_OR_GREATER
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDouble Splat(double value) =>
            WideDouble.Count == BundleLanes ? Vector256.Create(value).AsVector() : Vector128.Create(value).AsVector();

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDouble Load(double* source) => *(WideDouble*)source;
#else
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDouble Splat(double value) => new WideDouble(value);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDouble Load(double* source) => Unsafe.ReadUnaligned<WideDouble>(source);
#endif

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDouble Sqrt(WideDouble a) => Vector.SquareRoot(a);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDouble Abs(WideDouble a) => Vector.Abs(a);

        /// <summary>The other sign, of 0 as well.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDouble Negate(WideDouble a) => a ^ new WideDouble(-0.0);

        /// <summary>Where the mask is set <paramref name="a"/>, elsewhere <paramref name="b"/>.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDouble Select(WideDoubleMask mask, WideDouble a, WideDouble b) => Vector.ConditionalSelect(mask, a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDoubleMask operator >(WideDouble a, WideDouble b) => Vector.GreaterThan(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDoubleMask operator <(WideDouble a, WideDouble b) => Vector.LessThan(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDoubleMask operator >=(WideDouble a, WideDouble b) => Vector.GreaterThanOrEqual(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDoubleMask operator <=(WideDouble a, WideDouble b) => Vector.LessThanOrEqual(a, b);

        /// <summary>Lanes that are not numbers.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDoubleMask IsNotNumber(WideDouble a) => ~Vector.Equals(a, a);

        /// <summary>A mask that was stored: all bits of a lane, or none.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDoubleMask LoadMask(long* source) => Unsafe.ReadUnaligned<WideDoubleMask>(source);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void StoreMask(WideDoubleMask mask, long* target) => Unsafe.WriteUnaligned(target, mask);
    }

    /// <summary>A pointer to a bundle's record, of which all is in groups of lanes, moved on to later lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T* Shift<T>(T* record, int lane)
        where T : unmanaged => (T*)((double*)record + lane);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
#if NET8_0_OR_GREATER
    public static void Store(this WideDouble value, double* target) => *(WideDouble*)target = value;
#else
    public static void Store(this WideDouble value, double* target) => Unsafe.WriteUnaligned(target, value);
#endif

    /// <summary>Bit i is set where lane i of the mask is.</summary>
#if NET8_0_OR_GREATER
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Bits(WideDoubleMask mask) =>
        (int)(Avx2.IsSupported && Wide.Count == WideLanes.BundleLanes
            ? mask.AsVector256().ExtractMostSignificantBits()
            : mask.AsVector128().ExtractMostSignificantBits());
#else
    public static int Bits(WideDoubleMask mask)
    {
        int bits = 0;
        for (int i = 0; i < WideDoubleMask.Count; i++)
        {
            bits |= (int)(mask[i] & 1) << i;
        }

        return bits;
    }
#endif
}
