using System;

namespace Farseer.Engine.Numerics;

/// <summary>A question that is asked of eight boxes at once: which of them may hold an answer, and how near it can be at best.</summary>
internal unsafe interface IBoxProbe
{
    /// <summary>Bit i is set if box <paramref name="index"/> + i may hold an answer not beyond <paramref name="limit"/>.</summary>
    /// <param name="boxes">The boxes.</param>
    /// <param name="index">The first of the eight.</param>
    /// <param name="limit">The best answer so far.</param>
    /// <param name="nearest">Takes, for each of the eight, a bound that no answer in the box falls below.</param>
    uint Reach(in WideBoxes boxes, int index, float limit, float* nearest);
}

/// <summary>
/// A straight way, of a point or of a box, against boxes: the answer is the share of the way at which they meet. The boxes are made
/// larger by more than the arithmetic of floats can err, so nothing is missed far from the origin.
/// </summary>
internal readonly unsafe struct RayProbe : IBoxProbe
{
    /// <summary>2⁻²¹ of the largest coordinate: a few roundings of the bounds, of the quotient and of the start.</summary>
    private const double RoundingShare = 1.0 / (1 << 21);

    /// <summary>In place of 1/0: finite, so that times 0 it is 0.</summary>
    private const float Steepest = 3e38f;

    private readonly Wide _nearX;
    private readonly Wide _nearY;
    private readonly Wide _farX;
    private readonly Wide _farY;
    private readonly Wide _inverseX;
    private readonly Wide _inverseY;
    private readonly bool _forwardX;
    private readonly bool _forwardY;

    /// <param name="x">Start of the middle.</param>
    /// <param name="y">Start of the middle.</param>
    /// <param name="dx">The way.</param>
    /// <param name="dy">The way.</param>
    /// <param name="halfX">Half the size of what moves; 0 for a point.</param>
    /// <param name="halfY">Half the size of what moves; 0 for a point.</param>
    public RayProbe(double x, double y, double dx, double dy, double halfX, double halfY)
    {
        double size = Math.Max(Math.Max(Math.Abs(x), Math.Abs(y)), Math.Max(Math.Abs(x + dx), Math.Abs(y + dy))) + halfX + halfY;
        double spareX = halfX + (size * RoundingShare);
        double spareY = halfY + (size * RoundingShare);
        _forwardX = dx >= 0;
        _forwardY = dy >= 0;
        _nearX = Wide.Splat((float)(_forwardX ? x + spareX : x - spareX));
        _farX = Wide.Splat((float)(_forwardX ? x - spareX : x + spareX));
        _nearY = Wide.Splat((float)(_forwardY ? y + spareY : y - spareY));
        _farY = Wide.Splat((float)(_forwardY ? y - spareY : y + spareY));
        _inverseX = Wide.Splat(Inverse(dx));
        _inverseY = Wide.Splat(Inverse(dy));
    }

    public uint Reach(in WideBoxes boxes, int index, float limit, float* nearest)
    {
        float* nearX = _forwardX ? boxes.MinX : boxes.MaxX;
        float* nearY = _forwardY ? boxes.MinY : boxes.MaxY;
        float* farX = _forwardX ? boxes.MaxX : boxes.MinX;
        float* farY = _forwardY ? boxes.MaxY : boxes.MinY;
        Wide last = Wide.Splat(limit);
        uint mask = 0;
        for (int lane = 0; lane < WideBoxes.Width; lane += Wide.Count)
        {
            int i = index + lane;
            Wide enterX = (Wide.Load(nearX + i) - _nearX) * _inverseX;
            Wide enterY = (Wide.Load(nearY + i) - _nearY) * _inverseY;
            Wide leaveX = (Wide.Load(farX + i) - _farX) * _inverseX;
            Wide leaveY = (Wide.Load(farY + i) - _farY) * _inverseY;
            Wide enter = Wide.Max(Wide.Max(enterX, enterY), Wide.Zero);
            Wide leave = Wide.Min(Wide.Min(leaveX, leaveY), last);
            enter.Store(nearest + lane);
            mask |= (uint)WideLanes.Bits(enter <= leave) << lane;
        }

        return mask & 0xFF;
    }

    private static float Inverse(double d)
    {
        double inverse = d == 0 ? Steepest : 1 / d;
        return inverse > Steepest ? Steepest : inverse < -Steepest ? -Steepest : (float)inverse;
    }
}

/// <summary>A point against boxes: the answer is a distance, and no point of a box is nearer than along the farther axis.</summary>
internal readonly unsafe struct PointProbe : IBoxProbe
{
    private const double RoundingShare = 1.0 / (1 << 22);

    private readonly Wide _lowX;
    private readonly Wide _lowY;
    private readonly Wide _highX;
    private readonly Wide _highY;

    public PointProbe(double x, double y)
    {
        double spare = Math.Max(Math.Abs(x), Math.Abs(y)) * RoundingShare;
        _lowX = Wide.Splat((float)(x - spare));
        _lowY = Wide.Splat((float)(y - spare));
        _highX = Wide.Splat((float)(x + spare));
        _highY = Wide.Splat((float)(y + spare));
    }

    public uint Reach(in WideBoxes boxes, int index, float limit, float* nearest)
    {
        Wide last = Wide.Splat(limit);
        uint mask = 0;
        for (int lane = 0; lane < WideBoxes.Width; lane += Wide.Count)
        {
            int i = index + lane;
            Wide x = Wide.Max(Wide.Load(boxes.MinX + i) - _highX, _lowX - Wide.Load(boxes.MaxX + i));
            Wide y = Wide.Max(Wide.Load(boxes.MinY + i) - _highY, _lowY - Wide.Load(boxes.MaxY + i));
            Wide distance = Wide.Max(Wide.Max(x, y), Wide.Zero);
            distance.Store(nearest + lane);
            mask |= (uint)WideLanes.Bits(distance <= last) << lane;
        }

        return mask & 0xFF;
    }
}
