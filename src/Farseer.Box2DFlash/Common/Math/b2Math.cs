using System;

namespace Box2D.Common.Math;

/// <summary>Vector and matrix arithmetic as functions; each returns a new object.</summary>
/// <example>
/// <code>
/// b2Vec2 way = b2Math.SubtractVV(second.GetPosition(), body.GetPosition());
/// float along = b2Math.b2Dot(way, new b2Vec2(1, 0));
/// </code>
/// </example>
public static class b2Math
{
    private static readonly Random _random = new Random(20080);

    /// <summary>A zero vector, a new one each time: the original hands out one that anybody may change.</summary>
    public static b2Vec2 b2Vec2_zero => new b2Vec2(0, 0);

    /// <summary>A unit matrix, a new one each time.</summary>
    public static b2Mat22 b2Mat22_identity => new b2Mat22();

    /// <summary>A transform that changes nothing, a new one each time.</summary>
    public static b2XForm b2XForm_identity => new b2XForm();

    /// <summary>Whether a number is finite.</summary>
    /// <param name="x">The number.</param>
    /// <returns>False for infinity and not-a-number.</returns>
    public static bool b2IsValid(float x) => !float.IsNaN(x) && !float.IsInfinity(x);

    /// <summary>Scalar product.</summary>
    /// <param name="a">First vector.</param>
    /// <param name="b">Second vector.</param>
    /// <returns>a·b.</returns>
    public static float b2Dot(b2Vec2 a, b2Vec2 b) => (a.x * b.x) + (a.y * b.y);

    /// <summary>Cross product of two vectors.</summary>
    /// <param name="a">First vector.</param>
    /// <param name="b">Second vector.</param>
    /// <returns>a.x·b.y − a.y·b.x.</returns>
    public static float b2CrossVV(b2Vec2 a, b2Vec2 b) => (a.x * b.y) - (a.y * b.x);

    /// <summary>Cross product of a vector and a number.</summary>
    /// <param name="a">The vector.</param>
    /// <param name="s">The number.</param>
    /// <returns>(s·a.y, −s·a.x).</returns>
    public static b2Vec2 b2CrossVF(b2Vec2 a, float s) => new b2Vec2(s * a.y, -s * a.x);

    /// <summary>Cross product of a number and a vector.</summary>
    /// <param name="s">The number.</param>
    /// <param name="a">The vector.</param>
    /// <returns>(−s·a.y, s·a.x).</returns>
    public static b2Vec2 b2CrossFV(float s, b2Vec2 a) => new b2Vec2(-s * a.y, s * a.x);

    /// <summary>A·v.</summary>
    /// <param name="A">The matrix.</param>
    /// <param name="v">The vector.</param>
    /// <returns>The product.</returns>
    public static b2Vec2 b2MulMV(b2Mat22 A, b2Vec2 v) =>
        new b2Vec2((A.col1.x * v.x) + (A.col2.x * v.y), (A.col1.y * v.x) + (A.col2.y * v.y));

    /// <summary>Aᵀ·v.</summary>
    /// <param name="A">The matrix.</param>
    /// <param name="v">The vector.</param>
    /// <returns>The product.</returns>
    public static b2Vec2 b2MulTMV(b2Mat22 A, b2Vec2 v) => new b2Vec2(b2Dot(v, A.col1), b2Dot(v, A.col2));

    /// <summary>A point of a body in the world.</summary>
    /// <param name="T">The body's transform.</param>
    /// <param name="v">The point of the body.</param>
    /// <returns>R·v + position.</returns>
    public static b2Vec2 b2MulX(b2XForm T, b2Vec2 v)
    {
        b2Vec2 a = b2MulMV(T.R, v);
        a.Add(T.position);
        return a;
    }

    /// <summary>A point of the world in a body.</summary>
    /// <param name="T">The body's transform.</param>
    /// <param name="v">The point of the world.</param>
    /// <returns>Rᵀ·(v − position).</returns>
    public static b2Vec2 b2MulXT(b2XForm T, b2Vec2 v) => b2MulTMV(T.R, SubtractVV(v, T.position));

    /// <summary>Sum of two vectors.</summary>
    /// <param name="a">First vector.</param>
    /// <param name="b">Second vector.</param>
    /// <returns>a + b.</returns>
    public static b2Vec2 AddVV(b2Vec2 a, b2Vec2 b) => new b2Vec2(a.x + b.x, a.y + b.y);

    /// <summary>Difference of two vectors.</summary>
    /// <param name="a">First vector.</param>
    /// <param name="b">Second vector.</param>
    /// <returns>a − b.</returns>
    public static b2Vec2 SubtractVV(b2Vec2 a, b2Vec2 b) => new b2Vec2(a.x - b.x, a.y - b.y);

    /// <summary>Distance of two points.</summary>
    /// <param name="a">First point.</param>
    /// <param name="b">Second point.</param>
    /// <returns>|a − b|.</returns>
    public static float b2Distance(b2Vec2 a, b2Vec2 b) => SubtractVV(a, b).Length();

    /// <summary>Square of the distance of two points.</summary>
    /// <param name="a">First point.</param>
    /// <param name="b">Second point.</param>
    /// <returns>|a − b|².</returns>
    public static float b2DistanceSquared(b2Vec2 a, b2Vec2 b) => SubtractVV(a, b).LengthSquared();

    /// <summary>A multiple of a vector.</summary>
    /// <param name="s">The number.</param>
    /// <param name="a">The vector.</param>
    /// <returns>s·a.</returns>
    public static b2Vec2 MulFV(float s, b2Vec2 a) => new b2Vec2(s * a.x, s * a.y);

    /// <summary>Sum of two matrices.</summary>
    /// <param name="A">First matrix.</param>
    /// <param name="B">Second matrix.</param>
    /// <returns>A + B.</returns>
    public static b2Mat22 AddMM(b2Mat22 A, b2Mat22 B) => new b2Mat22(0, AddVV(A.col1, B.col1), AddVV(A.col2, B.col2));

    /// <summary>Product of two matrices.</summary>
    /// <param name="A">First matrix.</param>
    /// <param name="B">Second matrix.</param>
    /// <returns>A·B.</returns>
    public static b2Mat22 b2MulMM(b2Mat22 A, b2Mat22 B) => new b2Mat22(0, b2MulMV(A, B.col1), b2MulMV(A, B.col2));

    /// <summary>Product of a transposed matrix with another.</summary>
    /// <param name="A">First matrix.</param>
    /// <param name="B">Second matrix.</param>
    /// <returns>Aᵀ·B.</returns>
    public static b2Mat22 b2MulTMM(b2Mat22 A, b2Mat22 B) => new b2Mat22(0, b2MulTMV(A, B.col1), b2MulTMV(A, B.col2));

    /// <summary>Absolute value.</summary>
    /// <param name="a">The number.</param>
    /// <returns>|a|.</returns>
    public static float b2Abs(float a) => a > 0 ? a : -a;

    /// <summary>Absolute values of both components.</summary>
    /// <param name="a">The vector.</param>
    /// <returns>(|a.x|, |a.y|).</returns>
    public static b2Vec2 b2AbsV(b2Vec2 a) => new b2Vec2(b2Abs(a.x), b2Abs(a.y));

    /// <summary>Absolute values of all numbers.</summary>
    /// <param name="A">The matrix.</param>
    /// <returns>A new matrix.</returns>
    public static b2Mat22 b2AbsM(b2Mat22 A) => new b2Mat22(0, b2AbsV(A.col1), b2AbsV(A.col2));

    /// <summary>The smaller number.</summary>
    /// <param name="a">First number.</param>
    /// <param name="b">Second number.</param>
    /// <returns>The smaller one.</returns>
    public static float b2Min(float a, float b) => a < b ? a : b;

    /// <summary>The smaller of each component.</summary>
    /// <param name="a">First vector.</param>
    /// <param name="b">Second vector.</param>
    /// <returns>A new vector.</returns>
    public static b2Vec2 b2MinV(b2Vec2 a, b2Vec2 b) => new b2Vec2(b2Min(a.x, b.x), b2Min(a.y, b.y));

    /// <summary>The larger number.</summary>
    /// <param name="a">First number.</param>
    /// <param name="b">Second number.</param>
    /// <returns>The larger one.</returns>
    public static float b2Max(float a, float b) => a > b ? a : b;

    /// <summary>The larger of each component.</summary>
    /// <param name="a">First vector.</param>
    /// <param name="b">Second vector.</param>
    /// <returns>A new vector.</returns>
    public static b2Vec2 b2MaxV(b2Vec2 a, b2Vec2 b) => new b2Vec2(b2Max(a.x, b.x), b2Max(a.y, b.y));

    /// <summary>The nearest number within a range.</summary>
    /// <param name="a">The number.</param>
    /// <param name="low">Lower end.</param>
    /// <param name="high">Upper end.</param>
    /// <returns>The number, or the nearer end.</returns>
    public static float b2Clamp(float a, float low, float high) => b2Max(low, b2Min(a, high));

    /// <summary>The same for each component.</summary>
    /// <param name="a">The vector.</param>
    /// <param name="low">Lower ends.</param>
    /// <param name="high">Upper ends.</param>
    /// <returns>A new vector.</returns>
    public static b2Vec2 b2ClampV(b2Vec2 a, b2Vec2 low, b2Vec2 high) => b2MaxV(low, b2MinV(a, high));

    /// <summary>Exchanges the first items of two arrays, the original's way to swap two variables.</summary>
    /// <typeparam name="T">What the arrays hold.</typeparam>
    /// <param name="a">First array, not empty.</param>
    /// <param name="b">Second array, not empty.</param>
    /// <exception cref="ArgumentException">An array is null or empty.</exception>
    public static void b2Swap<T>(T[] a, T[] b)
    {
        if (a is null || a.Length == 0)
        {
            throw new ArgumentException("The array must have an item.", nameof(a));
        }

        if (b is null || b.Length == 0)
        {
            throw new ArgumentException("The array must have an item.", nameof(b));
        }

        (a[0], b[0]) = (b[0], a[0]);
    }

    /// <summary>
    /// A number between −1 and 1, evenly spread. The sequence is the same in every run; nothing in the library uses it.
    /// </summary>
    /// <returns>The number.</returns>
    public static float b2Random() => b2RandomRange(-1, 1);

    /// <summary>A number within a range, evenly spread; see <see cref="b2Random"/>.</summary>
    /// <param name="lo">Lower end.</param>
    /// <param name="hi">Upper end.</param>
    /// <returns>The number.</returns>
    public static float b2RandomRange(float lo, float hi)
    {
        lock (_random)
        {
            return (float)(((hi - lo) * _random.NextDouble()) + lo);
        }
    }

    /// <summary>The least power of two above a number: 8 for 5, and 16 for 8, as in the original.</summary>
    /// <param name="x">The number.</param>
    /// <returns>The power; 0 if it has more than 32 bits.</returns>
    public static uint b2NextPowerOfTwo(uint x)
    {
        x |= x >> 1;
        x |= x >> 2;
        x |= x >> 4;
        x |= x >> 8;
        x |= x >> 16;
        return x + 1;
    }

    /// <summary>Whether a number is a power of two.</summary>
    /// <param name="x">The number.</param>
    /// <returns>True for 1, 2, 4, 8, …</returns>
    public static bool b2IsPowerOfTwo(uint x) => x > 0 && (x & (x - 1)) == 0;
}
