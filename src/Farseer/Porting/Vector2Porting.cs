using System.Numerics;

namespace FarseerGames.FarseerPhysics.Porting;

/// <summary>
/// The members of the old <c>Vector2</c> that <see cref="Vector2"/> lacks: forms with <c>ref</c> and <c>out</c>, splines, and
/// <c>Normalize()</c> in place. In reach after <c>using FarseerGames.FarseerPhysics.Porting;</c>, which the build property
/// <c>FarseerPortingAliases</c> adds (see docs/Porting.md). They call for C# 14.
/// </summary>
/// <example>
/// <code>
/// Vector2 way = body.LinearVelocity;
/// way.Normalize();
/// Vector2.Add(ref way, ref way, out Vector2 twice);
/// </code>
/// </example>
public static class Vector2Porting
{
    /// <param name="vector">The vector to change.</param>
    extension(ref Vector2 vector)
    {
        /// <summary>Brings the vector to length 1 in place; of (0, 0) it becomes not a number, as in the original.</summary>
        public void Normalize() => vector /= vector.Length();
    }

    extension(Vector2)
    {
        /// <summary>The sum of two vectors.</summary>
        /// <param name="value1">The first vector.</param>
        /// <param name="value2">The second vector.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Add(ref Vector2 value1, ref Vector2 value2, out Vector2 result) => result = value1 + value2;

        /// <summary>The difference of two vectors.</summary>
        /// <param name="value1">The first vector.</param>
        /// <param name="value2">The second vector.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Subtract(ref Vector2 value1, ref Vector2 value2, out Vector2 result) => result = value1 - value2;

        /// <summary>The product of two vectors, component by component.</summary>
        /// <param name="value1">The first vector.</param>
        /// <param name="value2">The second vector.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Multiply(ref Vector2 value1, ref Vector2 value2, out Vector2 result) => result = value1 * value2;

        /// <summary>The quotient of two vectors, component by component.</summary>
        /// <param name="value1">The first vector.</param>
        /// <param name="value2">The second vector.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Divide(ref Vector2 value1, ref Vector2 value2, out Vector2 result) => result = value1 / value2;

        /// <summary>A vector times a number.</summary>
        /// <param name="value1">The vector.</param>
        /// <param name="scaleFactor">The number.</param>
        /// <param name="result">The result; may be the input.</param>
        public static void Multiply(ref Vector2 value1, float scaleFactor, out Vector2 result) => result = value1 * scaleFactor;

        /// <summary>A vector divided by a number.</summary>
        /// <param name="value1">The vector.</param>
        /// <param name="divider">The number.</param>
        /// <param name="result">The result; may be the input.</param>
        public static void Divide(ref Vector2 value1, float divider, out Vector2 result) => result = value1 / divider;

        /// <summary>The vector that points the other way.</summary>
        /// <param name="value">The vector.</param>
        /// <param name="result">The result; may be the input.</param>
        public static void Negate(ref Vector2 value, out Vector2 result) => result = -value;

        /// <summary>The dot product of two vectors.</summary>
        /// <param name="value1">The first vector.</param>
        /// <param name="value2">The second vector.</param>
        /// <param name="result">The dot product.</param>
        public static void Dot(ref Vector2 value1, ref Vector2 value2, out float result) =>
            result = (value1.X * value2.X) + (value1.Y * value2.Y);

        /// <summary>The distance of two points.</summary>
        /// <param name="value1">The first vector.</param>
        /// <param name="value2">The second vector.</param>
        /// <param name="result">The distance, in the unit of the points; at least 0.</param>
        public static void Distance(ref Vector2 value1, ref Vector2 value2, out float result) => result = Vector2.Distance(value1, value2);

        /// <summary>The square of the distance of two points.</summary>
        /// <param name="value1">The first vector.</param>
        /// <param name="value2">The second vector.</param>
        /// <param name="result">The square, in the squared unit of the points; at least 0.</param>
        public static void DistanceSquared(ref Vector2 value1, ref Vector2 value2, out float result) =>
            result = Vector2.DistanceSquared(value1, value2);

        /// <summary>The larger of each component.</summary>
        /// <param name="value1">The first vector.</param>
        /// <param name="value2">The second vector.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Max(ref Vector2 value1, ref Vector2 value2, out Vector2 result) => result = Vector2.Max(value1, value2);

        /// <summary>The smaller of each component.</summary>
        /// <param name="value1">The first vector.</param>
        /// <param name="value2">The second vector.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Min(ref Vector2 value1, ref Vector2 value2, out Vector2 result) => result = Vector2.Min(value1, value2);

        /// <summary>Each component brought between two bounds.</summary>
        /// <param name="value1">The vector.</param>
        /// <param name="min">The lower bounds.</param>
        /// <param name="max">The upper bounds; where one is below the lower bound, it wins.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Clamp(ref Vector2 value1, ref Vector2 min, ref Vector2 max, out Vector2 result) =>
            result = Vector2.Min(Vector2.Max(value1, min), max);

        /// <summary>The vector of length 1 in the same direction.</summary>
        /// <param name="value">The vector; of (0, 0) the result is not a number.</param>
        /// <param name="result">The result; may be the input.</param>
        public static void Normalize(ref Vector2 value, out Vector2 result) => result = value / value.Length();

        /// <summary>A point on the line through two points.</summary>
        /// <param name="value1">The point at amount 0.</param>
        /// <param name="value2">The point at amount 1.</param>
        /// <param name="amount">The position on the line; not limited to [0, 1].</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Lerp(ref Vector2 value1, ref Vector2 value2, float amount, out Vector2 result) =>
            result = value1 + ((value2 - value1) * amount);

        /// <summary>A point between two points that starts and ends at rest.</summary>
        /// <param name="value1">The point at amount 0.</param>
        /// <param name="value2">The point at amount 1.</param>
        /// <param name="amount">The position between the points; limited to [0, 1].</param>
        /// <returns>The point.</returns>
        public static Vector2 SmoothStep(Vector2 value1, Vector2 value2, float amount) =>
            Vector2.Hermite(value1, Vector2.Zero, value2, Vector2.Zero, amount < 0 ? 0 : amount > 1 ? 1 : amount);

        /// <summary>A point between two points that starts and ends at rest.</summary>
        /// <param name="value1">The point at amount 0.</param>
        /// <param name="value2">The point at amount 1.</param>
        /// <param name="amount">The position between the points; limited to [0, 1].</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void SmoothStep(ref Vector2 value1, ref Vector2 value2, float amount, out Vector2 result) =>
            result = Vector2.SmoothStep(value1, value2, amount);

        /// <summary>A point of a triangle by its barycentric coordinates.</summary>
        /// <param name="value1">The first corner.</param>
        /// <param name="value2">The second corner.</param>
        /// <param name="value3">The third corner.</param>
        /// <param name="amount1">The weight of the second corner.</param>
        /// <param name="amount2">The weight of the third corner.</param>
        /// <returns>The point.</returns>
        public static Vector2 Barycentric(Vector2 value1, Vector2 value2, Vector2 value3, float amount1, float amount2) =>
            value1 + ((value2 - value1) * amount1) + ((value3 - value1) * amount2);

        /// <summary>A point of a triangle by its barycentric coordinates.</summary>
        /// <param name="value1">The first corner.</param>
        /// <param name="value2">The second corner.</param>
        /// <param name="value3">The third corner.</param>
        /// <param name="amount1">The weight of the second corner.</param>
        /// <param name="amount2">The weight of the third corner.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Barycentric(
            ref Vector2 value1,
            ref Vector2 value2,
            ref Vector2 value3,
            float amount1,
            float amount2,
            out Vector2 result) => result = Vector2.Barycentric(value1, value2, value3, amount1, amount2);

        /// <summary>A point of a cubic Hermite spline.</summary>
        /// <param name="value1">The point at amount 0.</param>
        /// <param name="tangent1">The slope there.</param>
        /// <param name="value2">The point at amount 1.</param>
        /// <param name="tangent2">The slope there.</param>
        /// <param name="amount">The position between the points, 0 to 1.</param>
        /// <returns>The point.</returns>
        public static Vector2 Hermite(Vector2 value1, Vector2 tangent1, Vector2 value2, Vector2 tangent2, float amount)
        {
            float square = amount * amount;
            float cube = square * amount;
            return (value1 * ((2 * cube) - (3 * square) + 1)) + (value2 * ((3 * square) - (2 * cube)))
                + (tangent1 * (cube - (2 * square) + amount)) + (tangent2 * (cube - square));
        }

        /// <summary>A point of a cubic Hermite spline.</summary>
        /// <param name="value1">The point at amount 0.</param>
        /// <param name="tangent1">The slope there.</param>
        /// <param name="value2">The point at amount 1.</param>
        /// <param name="tangent2">The slope there.</param>
        /// <param name="amount">The position between the points, 0 to 1.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Hermite(
            ref Vector2 value1,
            ref Vector2 tangent1,
            ref Vector2 value2,
            ref Vector2 tangent2,
            float amount,
            out Vector2 result) => result = Vector2.Hermite(value1, tangent1, value2, tangent2, amount);

        /// <summary>A point of a Catmull-Rom spline between its two middle points.</summary>
        /// <param name="value1">The point before.</param>
        /// <param name="value2">The point at amount 0.</param>
        /// <param name="value3">The point at amount 1.</param>
        /// <param name="value4">The point after.</param>
        /// <param name="amount">The position between the points, 0 to 1.</param>
        /// <returns>The point.</returns>
        public static Vector2 CatmullRom(Vector2 value1, Vector2 value2, Vector2 value3, Vector2 value4, float amount) =>
            Vector2.Hermite(value2, (value3 - value1) * 0.5f, value3, (value4 - value2) * 0.5f, amount);

        /// <summary>A point of a Catmull-Rom spline between its two middle points.</summary>
        /// <param name="value1">The point before.</param>
        /// <param name="value2">The point at amount 0.</param>
        /// <param name="value3">The point at amount 1.</param>
        /// <param name="value4">The point after.</param>
        /// <param name="amount">The position between the points, 0 to 1.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void CatmullRom(
            ref Vector2 value1,
            ref Vector2 value2,
            ref Vector2 value3,
            ref Vector2 value4,
            float amount,
            out Vector2 result) => result = Vector2.CatmullRom(value1, value2, value3, value4, amount);

        /// <summary>A point turned, scaled and moved by a matrix.</summary>
        /// <param name="position">The point.</param>
        /// <param name="matrix">The matrix.</param>
        /// <param name="result">The result; may be the input.</param>
        public static void Transform(ref Vector2 position, ref Matrix4x4 matrix, out Vector2 result) =>
            result = Vector2.Transform(position, matrix);

        /// <summary>A direction turned and scaled by a matrix.</summary>
        /// <param name="normal">The direction.</param>
        /// <param name="matrix">The matrix; its translation has no effect.</param>
        /// <param name="result">The result; may be the input.</param>
        public static void TransformNormal(ref Vector2 normal, ref Matrix4x4 matrix, out Vector2 result) =>
            result = Vector2.TransformNormal(normal, matrix);

        /// <summary>A vector thrown back by a surface.</summary>
        /// <param name="vector">The vector.</param>
        /// <param name="normal">The normal of the surface, of length 1.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Reflect(ref Vector2 vector, ref Vector2 normal, out Vector2 result) =>
            result = vector - (normal * (2 * ((vector.X * normal.X) + (vector.Y * normal.Y))));
    }
}
