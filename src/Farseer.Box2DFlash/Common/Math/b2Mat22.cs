using Farseer.Engine.Numerics;

namespace Box2D.Common.Math;

/// <summary>A matrix of two columns; as a rotation by θ they are (cos θ, sin θ) and (−sin θ, cos θ).</summary>
/// <example>
/// <code>
/// var turn = new b2Mat22(0.5f);
/// b2Vec2 turned = b2Math.b2MulMV(turn, new b2Vec2(1, 0));
/// </code>
/// </example>
public class b2Mat22
{
    /// <summary>Makes the rotation by an angle, or a matrix of two columns, whose components are copied.</summary>
    /// <param name="angle">Radians; used if a column is null.</param>
    /// <param name="c1">First column.</param>
    /// <param name="c2">Second column.</param>
    public b2Mat22(float angle = 0, b2Vec2? c1 = null, b2Vec2? c2 = null)
    {
        col1 = new b2Vec2();
        col2 = new b2Vec2();
        if (c1 is not null && c2 is not null)
        {
            SetVV(c1, c2);
        }
        else
        {
            Set(angle);
        }
    }

    internal b2Mat22(b2Vec2 first, b2Vec2 second, bool shared)
    {
        _ = shared;
        col1 = first;
        col2 = second;
    }

    /// <summary>First column.</summary>
    public b2Vec2 col1 { get; set; }

    /// <summary>Second column.</summary>
    public b2Vec2 col2 { get; set; }

    /// <summary>Becomes the rotation by an angle.</summary>
    /// <param name="angle">Radians.</param>
    public void Set(float angle)
    {
        StableMath.SinCos(angle, out double s, out double c);
        col1.Set((float)c, (float)s);
        col2.Set((float)-s, (float)c);
    }

    /// <summary>Takes over two columns.</summary>
    /// <param name="c1">First column.</param>
    /// <param name="c2">Second column.</param>
    public void SetVV(b2Vec2 c1, b2Vec2 c2)
    {
        col1.SetV(c1);
        col2.SetV(c2);
    }

    /// <summary>A new matrix with the same numbers.</summary>
    /// <returns>The copy.</returns>
    public b2Mat22 Copy() => new b2Mat22(0, col1, col2);

    /// <summary>Takes over another matrix.</summary>
    /// <param name="m">The matrix.</param>
    public void SetM(b2Mat22 m) => SetVV(m.col1, m.col2);

    /// <summary>Adds a matrix.</summary>
    /// <param name="m">The matrix.</param>
    public void AddM(b2Mat22 m)
    {
        col1.Add(m.col1);
        col2.Add(m.col2);
    }

    /// <summary>Becomes the unit matrix.</summary>
    public void SetIdentity()
    {
        col1.Set(1, 0);
        col2.Set(0, 1);
    }

    /// <summary>Becomes the zero matrix.</summary>
    public void SetZero()
    {
        col1.SetZero();
        col2.SetZero();
    }

    /// <summary>The angle of the rotation that the first column stands for.</summary>
    /// <returns>Radians, −π to π.</returns>
    public float GetAngle() => (float)StableMath.Atan2(col1.y, col1.x);

    /// <summary>Writes the inverse into another matrix; of a singular one the zero matrix.</summary>
    /// <param name="out">Where to.</param>
    /// <returns><paramref name="out"/>.</returns>
    public b2Mat22 Invert(b2Mat22 @out)
    {
        double a = col1.x;
        double b = col2.x;
        double c = col1.y;
        double d = col2.y;
        double determinant = (a * d) - (b * c);
        double inverse = determinant == 0 ? 0 : 1 / determinant;
        @out.col1.Set((float)(inverse * d), (float)(-inverse * c));
        @out.col2.Set((float)(-inverse * b), (float)(inverse * a));
        return @out;
    }

    /// <summary>Solves A·x = b; 0 if the matrix is singular.</summary>
    /// <param name="out">Where the solution goes.</param>
    /// <param name="bX">First component of b.</param>
    /// <param name="bY">Second component of b.</param>
    /// <returns><paramref name="out"/>.</returns>
    public b2Vec2 Solve(b2Vec2 @out, float bX, float bY)
    {
        double a11 = col1.x;
        double a12 = col2.x;
        double a21 = col1.y;
        double a22 = col2.y;
        double determinant = (a11 * a22) - (a12 * a21);
        double inverse = determinant == 0 ? 0 : 1 / determinant;
        @out.Set((float)(inverse * ((a22 * bX) - (a12 * bY))), (float)(inverse * ((a11 * bY) - (a21 * bX))));
        return @out;
    }

    /// <summary>Takes the absolute value of each number.</summary>
    public void Abs()
    {
        col1.Abs();
        col2.Abs();
    }
}
