using System.Numerics;

namespace FarseerGames.FarseerPhysics.Porting;

/// <summary>
/// The members of the old <c>Matrix</c> that <see cref="Matrix4x4"/> lacks. In reach after
/// <c>using FarseerGames.FarseerPhysics.Porting;</c>, which the build property <c>FarseerPortingAliases</c> adds together with the
/// name <c>Matrix</c> (see docs/Porting.md). They call for C# 14.
/// </summary>
/// <example>
/// <code>
/// Matrix4x4 turn = Matrix4x4.CreateRotationZ(1);
/// Vector3 up = turn.Up;
/// </code>
/// </example>
public static class MatrixPorting
{
    /// <param name="matrix">The matrix that is read; also one that a method returned.</param>
    extension(Matrix4x4 matrix)
    {
        /// <summary>Where the x axis goes: the first row.</summary>
        public Vector3 Right => new(matrix.M11, matrix.M12, matrix.M13);

        /// <summary>Where the y axis goes: the second row.</summary>
        public Vector3 Up => new(matrix.M21, matrix.M22, matrix.M23);

        /// <summary>Where the negative x axis goes: the first row, negated.</summary>
        public Vector3 Left => new(-matrix.M11, -matrix.M12, -matrix.M13);

        /// <summary>Where the negative y axis goes: the second row, negated.</summary>
        public Vector3 Down => new(-matrix.M21, -matrix.M22, -matrix.M23);
    }

    extension(Matrix4x4)
    {
        /// <summary>The sum of two matrices, element by element.</summary>
        /// <param name="matrix1">The first matrix.</param>
        /// <param name="matrix2">The second matrix.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Add(ref Matrix4x4 matrix1, ref Matrix4x4 matrix2, out Matrix4x4 result) => result = matrix1 + matrix2;

        /// <summary>The difference of two matrices, element by element.</summary>
        /// <param name="matrix1">The first matrix.</param>
        /// <param name="matrix2">The second matrix.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Subtract(ref Matrix4x4 matrix1, ref Matrix4x4 matrix2, out Matrix4x4 result) => result = matrix1 - matrix2;

        /// <summary>The matrix that acts as the first and then the second.</summary>
        /// <param name="matrix1">The first matrix.</param>
        /// <param name="matrix2">The second matrix.</param>
        /// <param name="result">The result; may be one of the inputs.</param>
        public static void Multiply(ref Matrix4x4 matrix1, ref Matrix4x4 matrix2, out Matrix4x4 result) => result = matrix1 * matrix2;

        /// <summary>A matrix times a number, element by element.</summary>
        /// <param name="matrix1">The matrix.</param>
        /// <param name="scaleFactor">The number.</param>
        /// <param name="result">The result; may be the input.</param>
        public static void Multiply(ref Matrix4x4 matrix1, float scaleFactor, out Matrix4x4 result) => result = matrix1 * scaleFactor;

        /// <summary>A turn in the plane.</summary>
        /// <param name="radians">The angle in radians, from the x axis towards the y axis.</param>
        /// <param name="result">The matrix.</param>
        public static void CreateRotationZ(float radians, out Matrix4x4 result) => result = Matrix4x4.CreateRotationZ(radians);

        /// <summary>A displacement.</summary>
        /// <param name="xPosition">The displacement along x.</param>
        /// <param name="yPosition">The displacement along y.</param>
        /// <param name="zPosition">The displacement along z; 0 in the plane.</param>
        /// <param name="result">The matrix.</param>
        public static void CreateTranslation(float xPosition, float yPosition, float zPosition, out Matrix4x4 result) =>
            result = Matrix4x4.CreateTranslation(xPosition, yPosition, zPosition);

        /// <summary>A scaling about the origin.</summary>
        /// <param name="scale">The factor of all lengths.</param>
        /// <param name="result">The matrix.</param>
        public static void CreateScale(float scale, out Matrix4x4 result) => result = Matrix4x4.CreateScale(scale);

        /// <summary>The matrix that undoes another.</summary>
        /// <param name="matrix">The matrix.</param>
        /// <returns>The inverse; its elements are not numbers if there is none, as it always was.</returns>
        public static Matrix4x4 Invert(Matrix4x4 matrix) 
        {
            _ = Matrix4x4.Invert(matrix, out Matrix4x4 inverse);
            return inverse;
        }

        /// <summary>The matrix that undoes another.</summary>
        /// <param name="matrix">The matrix.</param>
        /// <param name="result">The inverse; its elements are not numbers if there is none, as it always was.</param>
        public static void Invert(ref Matrix4x4 matrix, out Matrix4x4 result) => Matrix4x4.Invert(matrix, out result);

        /// <summary>The matrix with rows and columns exchanged.</summary>
        /// <param name="matrix">The matrix.</param>
        /// <param name="result">The result; may be the input.</param>
        public static void Transpose(ref Matrix4x4 matrix, out Matrix4x4 result) => result = Matrix4x4.Transpose(matrix);
    }
}
