using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
#endif

namespace Farseer.Engine.Numerics;

/// <summary>
/// An axis-aligned box in world coordinates, 16 bytes. The bounds are rounded outwards from double precision, so a box
/// at 10^7 m is a little larger than the shape but never smaller: it may cost a candidate pair, never a missed one.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal struct Box
{
    public float MinX;
    public float MinY;
    public float MaxX;
    public float MaxY;

    public Box(float minX, float minY, float maxX, float maxY)
    {
        MinX = minX;
        MinY = minY;
        MaxX = maxX;
        MaxY = maxY;
    }

    /// <summary>Overlaps nothing, not even itself.</summary>
    public static Box Empty =>
        new Box(float.PositiveInfinity, float.PositiveInfinity, float.NegativeInfinity, float.NegativeInfinity);

    public readonly float Width => MaxX - MinX;

    public readonly float Height => MaxY - MinY;

    /// <summary>True if the boxes share a point; touching edges count, as in the original.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Overlap(in Box a, in Box b) =>
        a.MinX <= b.MaxX & b.MinX <= a.MaxX & a.MinY <= b.MaxY & b.MinY <= a.MaxY;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly bool Contains(in Box inner) =>
        MinX <= inner.MinX & MinY <= inner.MinY & MaxX >= inner.MaxX & MaxY >= inner.MaxY;

    /// <summary>Rounds double bounds outwards to the nearest floats.</summary>
    public static Box FromDouble(double minX, double minY, double maxX, double maxY)
    {
#if NET8_0_OR_GREATER
        if (Avx.IsSupported)
        {
            return RoundOut(Vector256.Create(minX, minY, -maxX, -maxY));
        }
#endif
        return new Box(FloatBits.RoundDown(minX), FloatBits.RoundDown(minY), FloatBits.RoundUp(maxX), FloatBits.RoundUp(maxY));
    }

#if NET8_0_OR_GREATER
    /// <summary>The same of two corners.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Box FromDouble(Vector128<double> min, Vector128<double> max) =>
        Avx.IsSupported
            ? RoundOut(Vector256.Create(min, -max))
            : FromDouble(min.GetElement(0), min.GetElement(1), max.GetElement(0), max.GetElement(1));

    /// <summary>
    /// The four bounds side by side, with their upper half negated so that all are rounded down. Which way the nearest float lies cannot be
    /// foreseen: with a branch for each bound half of them were guessed wrong.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static unsafe Box RoundOut(Vector256<double> value)
    {
        Vector128<float> nearest = Avx.ConvertToVector128Single(value);
        Vector256<float> above = Avx.CompareGreaterThan(Avx.ConvertToVector256Double(nearest), value).AsSingle();
        Vector128<int> isAbove = Sse.Shuffle(above.GetLower(), above.GetUpper(), 0x88).AsInt32();
        Vector128<int> bits = nearest.AsInt32();

        // Towards zero from above it, away from it below it, and from zero of either sign to the first number below.
        Vector128<int> step = (bits >> 31) | Vector128<int>.One;
        Vector128<int> isZero = Vector128.Equals(nearest, Vector128<float>.Zero).AsInt32();
        Vector128<int> below = Vector128.ConditionalSelect(isZero, Vector128.Create(unchecked((int)0x80000001)), bits - step);
        Vector128<int> down = Vector128.ConditionalSelect(isAbove, below, bits);
        Vector128<int> box = down ^ Vector128.Create(0, 0, int.MinValue, int.MinValue);
        return *(Box*)&box;
    }
#endif
}
