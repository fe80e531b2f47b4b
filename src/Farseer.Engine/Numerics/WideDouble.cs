#if NET8_0_OR_GREATER
global using WideDouble = System.Runtime.Intrinsics.Vector256<double>;
global using WideDoubleMask = System.Runtime.Intrinsics.Vector256<double>;
using System.Runtime.Intrinsics;
#else
global using WideDouble = System.Numerics.Vector<double>;
global using WideDoubleMask = System.Numerics.Vector<long>;
using System.Numerics;
#endif
using System.Runtime.CompilerServices;

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
        public static WideDouble Splat(double value) => Vector256.Create(value);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDouble Load(double* source) => Vector256.Load(source);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDouble Sqrt(WideDouble a) => Vector256.Sqrt(a);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDouble Abs(WideDouble a) => Vector256.Abs(a);

        /// <summary>The other sign, of 0 as well.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDouble Negate(WideDouble a) => a ^ Vector256.Create(-0.0);

        /// <summary>Where the mask is set <paramref name="a"/>, elsewhere <paramref name="b"/>.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDouble Select(WideDoubleMask mask, WideDouble a, WideDouble b) => Vector256.ConditionalSelect(mask, a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDoubleMask operator >(WideDouble a, WideDouble b) => Vector256.GreaterThan(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDoubleMask operator <(WideDouble a, WideDouble b) => Vector256.LessThan(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDoubleMask operator >=(WideDouble a, WideDouble b) => Vector256.GreaterThanOrEqual(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDoubleMask operator <=(WideDouble a, WideDouble b) => Vector256.LessThanOrEqual(a, b);

        /// <summary>Lanes that are not numbers.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDoubleMask IsNotNumber(WideDouble a) => ~Vector256.Equals(a, a);

        /// <summary>A mask that was stored: all bits of a lane, or none.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDoubleMask LoadMask(long* source) => Vector256.Load(source).AsDouble();

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void StoreMask(WideDoubleMask mask, long* target) => mask.AsInt64().Store(target);
#else
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDouble Splat(double value) => new WideDouble(value);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static WideDouble Load(double* source) => Unsafe.ReadUnaligned<WideDouble>(source);

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
#endif
    }

    /// <summary>A pointer to a bundle's record, of which all is in groups of lanes, moved on to later lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T* Shift<T>(T* record, int lane)
        where T : unmanaged => (T*)((double*)record + lane);

#if NET8_0_OR_GREATER
    /// <summary>Bit i is set where lane i of the mask is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Bits(WideDoubleMask mask) => (int)Vector256.ExtractMostSignificantBits(mask);
#else
    /// <summary>Bit i is set where lane i of the mask is.</summary>
    public static int Bits(WideDoubleMask mask)
    {
        int bits = 0;
        for (int i = 0; i < WideDoubleMask.Count; i++)
        {
            bits |= (int)(mask[i] & 1) << i;
        }

        return bits;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Store(this WideDouble value, double* target) => Unsafe.WriteUnaligned(target, value);
#endif
}
