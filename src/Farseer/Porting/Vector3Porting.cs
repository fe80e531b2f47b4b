using System.Numerics;

namespace FarseerGames.FarseerPhysics.Porting;

/// <summary>
/// The members of the old <c>Vector3</c> that <see cref="Vector3"/> lacks. In reach after
/// <c>using FarseerGames.FarseerPhysics.Porting;</c>, which the build property <c>FarseerPortingAliases</c> adds (see
/// docs/Porting.md). They call for C# 14.
/// </summary>
/// <example>
/// <code>
/// Vector3 up = Vector3.Up;
/// up.Normalize();
/// </code>
/// </example>
public static class Vector3Porting
{
    /// <param name="vector">The vector to change.</param>
    extension(ref Vector3 vector)
    {
        /// <summary>Brings the vector to length 1 in place; of (0, 0, 0) it becomes not a number, as in the original.</summary>
        public void Normalize() => vector /= vector.Length();
    }

    extension(Vector3)
    {
        /// <summary>(0, 1, 0).</summary>
        public static Vector3 Up => new(0, 1, 0);

        /// <summary>(0, -1, 0).</summary>
        public static Vector3 Down => new(0, -1, 0);

        /// <summary>(1, 0, 0).</summary>
        public static Vector3 Right => new(1, 0, 0);

        /// <summary>(-1, 0, 0).</summary>
        public static Vector3 Left => new(-1, 0, 0);

        /// <summary>(0, 0, -1).</summary>
        public static Vector3 Forward => new(0, 0, -1);

        /// <summary>(0, 0, 1).</summary>
        public static Vector3 Backward => new(0, 0, 1);

        /// <summary>The sum of two vectors.</summary>
        /// <param name="value1">The first vector.</param>
        /// <param name="value2">The second vector.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Add(ref Vector3 value1, ref Vector3 value2, out Vector3 result) => result = value1 + value2;

        /// <summary>The difference of two vectors.</summary>
        /// <param name="value1">The first vector.</param>
        /// <param name="value2">The second vector.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Subtract(ref Vector3 value1, ref Vector3 value2, out Vector3 result) => result = value1 - value2;

        /// <summary>The product of two vectors, component by component.</summary>
        /// <param name="value1">The first vector.</param>
        /// <param name="value2">The second vector.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Multiply(ref Vector3 value1, ref Vector3 value2, out Vector3 result) => result = value1 * value2;

        /// <summary>The dot product of two vectors.</summary>
        /// <param name="value1">The first vector.</param>
        /// <param name="value2">The second vector.</param>
        /// <param name="result">The dot product.</param>
        public static void Dot(ref Vector3 value1, ref Vector3 value2, out float result) =>
            result = (value1.X * value2.X) + (value1.Y * value2.Y) + (value1.Z * value2.Z);

        /// <summary>The cross product of two vectors.</summary>
        /// <param name="value1">The first vector.</param>
        /// <param name="value2">The second vector.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Cross(ref Vector3 value1, ref Vector3 value2, out Vector3 result) => result = Vector3.Cross(value1, value2);

        /// <summary>A point turned, scaled and moved by a matrix.</summary>
        /// <param name="position">The point.</param>
        /// <param name="matrix">The matrix.</param>
        /// <param name="result">The result; may be the input.</param>
        public static void Transform(ref Vector3 position, ref Matrix4x4 matrix, out Vector3 result) =>
            result = Vector3.Transform(position, matrix);
    }
}
