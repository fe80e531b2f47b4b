using System;
using System.Numerics;

namespace FarseerGames.FarseerPhysics.Mathematics;

/// <content>Vectors. A direction given as one number is a heading: 0 is (0, -1), up on a screen, and pi/2 is (1, 0).</content>
public static partial class Calculator
{
    /// <summary>The z coordinate of the vector product of two vectors of the plane.</summary>
    /// <param name="value1">The first vector.</param>
    /// <param name="value2">The second vector.</param>
    /// <returns>Positive when the second is turned from the first in the sense from the x axis to the y axis.</returns>
    public static float Cross(Vector2 value1, Vector2 value2) => (value1.X * value2.Y) - (value1.Y * value2.X);

    /// <summary>The vector product of a vector of the plane and one along z.</summary>
    /// <param name="value1">The vector of the plane.</param>
    /// <param name="value2">The length of the vector along z.</param>
    /// <returns>(value2 * y, -value2 * x).</returns>
    public static Vector2 Cross(Vector2 value1, float value2) => new Vector2(value2 * value1.Y, -value2 * value1.X);

    /// <summary>The vector product of a vector along z and one of the plane.</summary>
    /// <param name="value2">The length of the vector along z.</param>
    /// <param name="value1">The vector of the plane.</param>
    /// <returns>(-value2 * y, value2 * x): with an angular velocity and an arm, the velocity.</returns>
    public static Vector2 Cross(float value2, Vector2 value1) => new Vector2(-value2 * value1.Y, value2 * value1.X);

    /// <summary>The z coordinate of the vector product of two vectors of the plane.</summary>
    /// <param name="value1">The first vector; not changed.</param>
    /// <param name="value2">The second vector; not changed.</param>
    /// <param name="ret">The product.</param>
    public static void Cross(ref Vector2 value1, ref Vector2 value2, out float ret) => ret = Cross(value1, value2);

    /// <summary>The vector product of a vector of the plane and one along z.</summary>
    /// <param name="value1">The vector of the plane; not changed.</param>
    /// <param name="value2">The length of the vector along z; not changed.</param>
    /// <param name="ret">The product.</param>
    public static void Cross(ref Vector2 value1, ref float value2, out Vector2 ret) => ret = Cross(value1, value2);

    /// <summary>The vector product of a vector along z and one of the plane.</summary>
    /// <param name="value2">The length of the vector along z; not changed.</param>
    /// <param name="value1">The vector of the plane; not changed.</param>
    /// <param name="ret">The product.</param>
    public static void Cross(ref float value2, ref Vector2 value1, out Vector2 ret) => ret = Cross(value2, value1);

    /// <summary>The distance between two points.</summary>
    /// <param name="point1">One point.</param>
    /// <param name="point2">The other point.</param>
    /// <returns>The distance, in the units of the points.</returns>
    public static float DistanceBetweenPointAndPoint(Vector2 point1, Vector2 point2) => (point1 - point2).Length();

    /// <summary>The distance between two points.</summary>
    /// <param name="point1">One point; not changed.</param>
    /// <param name="point2">The other point; not changed.</param>
    /// <returns>The distance, in the units of the points.</returns>
    public static float DistanceBetweenPointAndPoint(ref Vector2 point1, ref Vector2 point2) => (point1 - point2).Length();

    /// <summary>The distance from a point to the nearest point of a segment.</summary>
    /// <param name="point">The point.</param>
    /// <param name="lineEndPoint1">One end of the segment.</param>
    /// <param name="lineEndPoint2">The other end of the segment.</param>
    /// <returns>The distance, in the units of the points.</returns>
    public static float DistanceBetweenPointAndLineSegment(Vector2 point, Vector2 lineEndPoint1, Vector2 lineEndPoint2)
    {
        var line = lineEndPoint2 - lineEndPoint1;
        var along = Vector2.Dot(point - lineEndPoint1, line);
        var square = line.LengthSquared();
        if (along <= 0f || square == 0f)
        {
            return DistanceBetweenPointAndPoint(point, lineEndPoint1);
        }

        return along >= square
            ? DistanceBetweenPointAndPoint(point, lineEndPoint2)
            : DistanceBetweenPointAndPoint(point, lineEndPoint1 + (line * (along / square)));
    }

    /// <summary>The part of a vector along another.</summary>
    /// <param name="projectVector">The vector.</param>
    /// <param name="onToVector">The vector that gives the direction; of any length.</param>
    /// <returns>The projection; (0, 0) if the direction has no length.</returns>
    public static Vector2 Project(Vector2 projectVector, Vector2 onToVector)
    {
        var square = onToVector.LengthSquared();
        return square == 0f ? Vector2.Zero : onToVector * (Vector2.Dot(onToVector, projectVector) / square);
    }

    /// <summary>Shortens a vector that is longer than a length.</summary>
    /// <param name="vector">The vector; not changed.</param>
    /// <param name="maxLength">The longest length; 0 or more.</param>
    /// <param name="truncatedVector">The vector itself, or one of the same direction and of <paramref name="maxLength"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="maxLength"/> is negative or not finite.</exception>
    public static void Truncate(ref Vector2 vector, float maxLength, out Vector2 truncatedVector)
    {
        Require.NotNegative(maxLength, nameof(maxLength));
        var length = vector.Length();
        truncatedVector = length > maxLength ? vector * (maxLength / length) : vector;
    }

    /// <summary>The range that points cover along a direction.</summary>
    /// <param name="points">One point or more; not changed.</param>
    /// <param name="axis">The direction, of any length but 0; not changed.</param>
    /// <param name="min">The least coordinate along the direction, in the units of the points.</param>
    /// <param name="max">The largest coordinate along the direction.</param>
    /// <exception cref="ArgumentNullException"><paramref name="points"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="points"/> is empty, or <paramref name="axis"/> is (0, 0) or not
    /// finite.</exception>
    public static void ProjectToAxis(ref Vector2[] points, ref Vector2 axis, out float min, out float max)
    {
        Require.NotNull(points, nameof(points));
        if (points.Length == 0)
        {
            throw new ArgumentException("There must be at least one point; the array has 0.", nameof(points));
        }

        var unit = Require.Direction(axis, nameof(axis));
        min = Vector2.Dot(points[0], unit);
        max = min;
        for (var i = 1; i < points.Length; i++)
        {
            var product = Vector2.Dot(points[i], unit);
            min = Math.Min(min, product);
            max = Math.Max(max, product);
        }
    }

    /// <summary>The heading of a vector.</summary>
    /// <param name="vector">The vector.</param>
    /// <returns>-pi to pi: 0 for (0, -1), pi/2 for (1, 0); 0 or pi for (0, 0).</returns>
    public static float VectorToRadians(Vector2 vector) => ATan2(vector.X, -vector.Y);

    /// <summary>The unit vector of a heading.</summary>
    /// <param name="radians">The heading: 0 is (0, -1), pi/2 is (1, 0).</param>
    /// <returns>The unit vector.</returns>
    public static Vector2 RadiansToVector(float radians) => new Vector2(Sin(radians), -Cos(radians));

    /// <summary>The unit vector of a heading.</summary>
    /// <param name="radians">The heading: 0 is (0, -1), pi/2 is (1, 0).</param>
    /// <param name="vector">Set to the unit vector.</param>
    public static void RadiansToVector(float radians, ref Vector2 vector) => vector = RadiansToVector(radians);

    /// <summary>Turns a vector.</summary>
    /// <param name="vector">The vector; changed.</param>
    /// <param name="radians">The angle; a positive one turns the x axis towards the y axis.</param>
    public static void RotateVector(ref Vector2 vector, float radians)
    {
        var sin = Sin(radians);
        var cos = Cos(radians);
        vector = new Vector2((vector.X * cos) - (vector.Y * sin), (vector.X * sin) + (vector.Y * cos));
    }

    /// <summary>A unit vector between two others.</summary>
    /// <param name="vector1">The result for 0.</param>
    /// <param name="vector2">The result for 1.</param>
    /// <param name="t">The share of the chord between them, 0 to 1.</param>
    /// <returns>The unit vector; (0, 0) half way between opposite ones.</returns>
    public static Vector2 InterpolateNormal(Vector2 vector1, Vector2 vector2, float t)
    {
        var between = vector1 + ((vector2 - vector1) * t);
        var length = between.Length();
        return length > 0f ? between / length : Vector2.Zero;
    }

    /// <summary>A unit vector between two others.</summary>
    /// <param name="vector1">The result for 0.</param>
    /// <param name="vector2">The result for 1.</param>
    /// <param name="t">The share of the chord between them, 0 to 1.</param>
    /// <param name="vector">The unit vector; see <see cref="InterpolateNormal(Vector2, Vector2, float)"/>.</param>
    public static void InterpolateNormal(Vector2 vector1, Vector2 vector2, float t, out Vector2 vector) =>
        vector = InterpolateNormal(vector1, vector2, t);

    /// <summary>A unit vector between two others.</summary>
    /// <param name="vector1">The result for 0; replaced by the unit vector.</param>
    /// <param name="vector2">The result for 1.</param>
    /// <param name="t">The share of the chord between them, 0 to 1.</param>
    public static void InterpolateNormal(ref Vector2 vector1, Vector2 vector2, float t) =>
        vector1 = InterpolateNormal(vector1, vector2, t);

    /// <summary>An angle between two others, the short way round.</summary>
    /// <param name="radians1">The result for 0.</param>
    /// <param name="radians2">The result for 1.</param>
    /// <param name="t">The share of the chord between the two directions, 0 to 1.</param>
    /// <returns>The angle, -pi to pi.</returns>
    public static float InterpolateRotation(float radians1, float radians2, float t) =>
        VectorToRadians(InterpolateNormal(RadiansToVector(radians1), RadiansToVector(radians2), t));
}
