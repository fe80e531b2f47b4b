using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

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
    public static Box FromDouble(double minX, double minY, double maxX, double maxY) =>
        new Box(FloatBits.RoundDown(minX), FloatBits.RoundDown(minY), FloatBits.RoundUp(maxX), FloatBits.RoundUp(maxY));
}
