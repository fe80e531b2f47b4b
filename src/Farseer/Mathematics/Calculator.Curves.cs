using System.Numerics;

namespace FarseerGames.FarseerPhysics.Mathematics;

/// <content>Bezier curves. The parameter runs from 0, the start, to 1, the end; outside the curve is extended. Headings are as
/// those of <see cref="VectorToRadians"/>.</content>
public static partial class Calculator
{
    /// <summary>A point of a straight line.</summary>
    /// <param name="start">The point for 0.</param>
    /// <param name="end">The point for 1.</param>
    /// <param name="t">The share of the way, 0 to 1.</param>
    /// <returns>The point.</returns>
    public static Vector2 LinearBezierCurve(Vector2 start, Vector2 end, float t) => start + ((end - start) * t);

    /// <summary>A point of a quadratic Bezier curve.</summary>
    /// <param name="start">The point for 0.</param>
    /// <param name="curve">The control point.</param>
    /// <param name="end">The point for 1.</param>
    /// <param name="t">The share of the way, 0 to 1.</param>
    /// <returns>The point.</returns>
    public static Vector2 QuadraticBezierCurve(Vector2 start, Vector2 curve, Vector2 end, float t) =>
        LinearBezierCurve(LinearBezierCurve(start, curve, t), LinearBezierCurve(curve, end, t), t);

    /// <summary>A point of a quadratic Bezier curve, and the heading there.</summary>
    /// <param name="start">The point for 0.</param>
    /// <param name="curve">The control point.</param>
    /// <param name="end">The point for 1.</param>
    /// <param name="t">The share of the way, 0 to 1.</param>
    /// <param name="radians">Set to the heading of the curve at the point.</param>
    /// <returns>The point.</returns>
    public static Vector2 QuadraticBezierCurve(Vector2 start, Vector2 curve, Vector2 end, float t, ref float radians)
    {
        var from = LinearBezierCurve(start, curve, t);
        var to = LinearBezierCurve(curve, end, t);
        radians = VectorToRadians(to - from);
        return LinearBezierCurve(from, to, t);
    }

    /// <summary>A point of a cubic Bezier curve.</summary>
    /// <param name="start">The point for 0.</param>
    /// <param name="curve1">The first control point.</param>
    /// <param name="curve2">The second control point.</param>
    /// <param name="end">The point for 1.</param>
    /// <param name="t">The share of the way, 0 to 1.</param>
    /// <returns>The point.</returns>
    public static Vector2 CubicBezierCurve(Vector2 start, Vector2 curve1, Vector2 curve2, Vector2 end, float t) =>
        QuadraticBezierCurve(
            LinearBezierCurve(start, curve1, t),
            LinearBezierCurve(curve1, curve2, t),
            LinearBezierCurve(curve2, end, t),
            t);

    /// <summary>A point of a cubic Bezier curve, and the heading there.</summary>
    /// <param name="start">The point for 0.</param>
    /// <param name="curve1">The first control point.</param>
    /// <param name="curve2">The second control point.</param>
    /// <param name="end">The point for 1.</param>
    /// <param name="t">The share of the way, 0 to 1.</param>
    /// <param name="radians">Set to the heading of the curve at the point.</param>
    /// <returns>The point.</returns>
    public static Vector2 CubicBezierCurve(
        Vector2 start,
        Vector2 curve1,
        Vector2 curve2,
        Vector2 end,
        float t,
        ref float radians) =>
        QuadraticBezierCurve(
            LinearBezierCurve(start, curve1, t),
            LinearBezierCurve(curve1, curve2, t),
            LinearBezierCurve(curve2, end, t),
            t,
            ref radians);

    /// <summary>A point of a cubic Bezier curve given by its ends and the directions there.</summary>
    /// <param name="start">The point for 0.</param>
    /// <param name="startPointsTo">From the start to the first control point.</param>
    /// <param name="end">The point for 1.</param>
    /// <param name="endPointsTo">From the end to the second control point.</param>
    /// <param name="t">The share of the way, 0 to 1.</param>
    /// <returns>The point.</returns>
    public static Vector2 CubicBezierCurve2(
        Vector2 start,
        Vector2 startPointsTo,
        Vector2 end,
        Vector2 endPointsTo,
        float t) =>
        CubicBezierCurve(start, start + startPointsTo, end + endPointsTo, end, t);

    /// <summary>A point of a cubic Bezier curve given by its ends and the directions there, and the heading there.</summary>
    /// <param name="start">The point for 0.</param>
    /// <param name="startPointsTo">From the start to the first control point.</param>
    /// <param name="end">The point for 1.</param>
    /// <param name="endPointsTo">From the end to the second control point.</param>
    /// <param name="t">The share of the way, 0 to 1.</param>
    /// <param name="radians">Set to the heading of the curve at the point.</param>
    /// <returns>The point.</returns>
    public static Vector2 CubicBezierCurve2(
        Vector2 start,
        Vector2 startPointsTo,
        Vector2 end,
        Vector2 endPointsTo,
        float t,
        ref float radians) =>
        CubicBezierCurve(start, start + startPointsTo, end + endPointsTo, end, t, ref radians);

    /// <summary>A point of a cubic Bezier curve given by its ends and the headings there, and the heading there.</summary>
    /// <param name="start">The point for 0.</param>
    /// <param name="startPointDirection">The heading from the start to the first control point, in radians.</param>
    /// <param name="startPointLength">The distance from the start to the first control point.</param>
    /// <param name="end">The point for 1.</param>
    /// <param name="endPointDirection">The heading from the end to the second control point, in radians.</param>
    /// <param name="endPointLength">The distance from the end to the second control point.</param>
    /// <param name="t">The share of the way, 0 to 1.</param>
    /// <param name="radians">Set to the heading of the curve at the point.</param>
    /// <returns>The point.</returns>
    /// <remarks>Version 2.0.1 took the two control points relative to the origin in this overload alone; here they are relative
    /// to the ends in all three.</remarks>
    public static Vector2 CubicBezierCurve2(
        Vector2 start,
        float startPointDirection,
        float startPointLength,
        Vector2 end,
        float endPointDirection,
        float endPointLength,
        float t,
        ref float radians) =>
        CubicBezierCurve2(
            start,
            RadiansToVector(startPointDirection) * startPointLength,
            end,
            RadiansToVector(endPointDirection) * endPointLength,
            t,
            ref radians);
}
