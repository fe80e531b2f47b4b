using Farseer.Engine.Storage;

namespace Box2D.Common.Math;

/// <summary>
/// A vector of two components. It is a class, as in ActionScript, where vectors are handed on by reference: what
/// <see cref="Box2D.Dynamics.b2Body.GetLinearVelocity"/> returns is the velocity itself, and setting its <see cref="x"/> sets that
/// of the body. <see cref="Copy"/> makes a vector of one's own.
/// </summary>
/// <example>
/// <code>
/// var speed = new b2Vec2(3, -4);
/// body.SetLinearVelocity(speed);
/// float length = speed.Length();
/// </code>
/// </example>
public class b2Vec2
{
    private float _x;
    private float _y;

    /// <summary>Makes a vector.</summary>
    /// <param name="x_">First component.</param>
    /// <param name="y_">Second component.</param>
    public b2Vec2(float x_ = 0, float y_ = 0)
    {
        _x = x_;
        _y = y_;
    }

    /// <summary>First component.</summary>
    public virtual float x
    {
        get => _x;
        set => _x = value;
    }

    /// <summary>Second component.</summary>
    public virtual float y
    {
        get => _y;
        set => _y = value;
    }

    /// <summary>Makes a vector.</summary>
    /// <param name="x_">First component.</param>
    /// <param name="y_">Second component.</param>
    /// <returns>The vector.</returns>
    public static b2Vec2 Make(float x_, float y_) => new b2Vec2(x_, y_);

    /// <summary>Sets both components to 0.</summary>
    public void SetZero() => Set(0, 0);

    /// <summary>Sets both components.</summary>
    /// <param name="x_">First component.</param>
    /// <param name="y_">Second component.</param>
    public virtual void Set(float x_ = 0, float y_ = 0)
    {
        x = x_;
        y = y_;
    }

    /// <summary>Takes over the components of another vector.</summary>
    /// <param name="v">The vector.</param>
    public void SetV(b2Vec2 v) => Set(v.x, v.y);

    /// <summary>The opposite vector, a new one.</summary>
    /// <returns>(−x, −y).</returns>
    public b2Vec2 Negative() => new b2Vec2(-x, -y);

    /// <summary>A new vector with the same components.</summary>
    /// <returns>The copy.</returns>
    public b2Vec2 Copy() => new b2Vec2(x, y);

    /// <summary>Adds a vector to this one.</summary>
    /// <param name="v">The vector.</param>
    public void Add(b2Vec2 v) => Set(x + v.x, y + v.y);

    /// <summary>Subtracts a vector from this one.</summary>
    /// <param name="v">The vector.</param>
    public void Subtract(b2Vec2 v) => Set(x - v.x, y - v.y);

    /// <summary>Multiplies this vector by a number.</summary>
    /// <param name="a">The factor.</param>
    public void Multiply(float a) => Set(x * a, y * a);

    /// <summary>Replaces this vector by A·v.</summary>
    /// <param name="A">The matrix.</param>
    public void MulM(b2Mat22 A) => Set((A.col1.x * x) + (A.col2.x * y), (A.col1.y * x) + (A.col2.y * y));

    /// <summary>Replaces this vector by Aᵀ·v.</summary>
    /// <param name="A">The matrix.</param>
    public void MulTM(b2Mat22 A) => Set((x * A.col1.x) + (y * A.col1.y), (x * A.col2.x) + (y * A.col2.y));

    /// <summary>Replaces this vector v by v × s = (s·y, −s·x).</summary>
    /// <param name="s">The number.</param>
    public void CrossVF(float s) => Set(s * y, -s * x);

    /// <summary>Replaces this vector v by s × v = (−s·y, s·x).</summary>
    /// <param name="s">The number.</param>
    public void CrossFV(float s) => Set(-s * y, s * x);

    /// <summary>Takes the smaller of each component.</summary>
    /// <param name="b">The other vector.</param>
    public void MinV(b2Vec2 b) => Set(x < b.x ? x : b.x, y < b.y ? y : b.y);

    /// <summary>Takes the larger of each component.</summary>
    /// <param name="b">The other vector.</param>
    public void MaxV(b2Vec2 b) => Set(x > b.x ? x : b.x, y > b.y ? y : b.y);

    /// <summary>Takes the absolute value of each component.</summary>
    public void Abs() => Set(System.Math.Abs(x), System.Math.Abs(y));

    /// <summary>The length.</summary>
    /// <returns>√(x² + y²).</returns>
    public float Length() => (float)System.Math.Sqrt(Square());

    /// <summary>The square of the length.</summary>
    /// <returns>x² + y².</returns>
    public float LengthSquared() => (float)Square();

    /// <summary>Makes the length 1; the zero vector stays as it is.</summary>
    /// <returns>The length before; 0 if the vector was too short to have a direction.</returns>
    public float Normalize()
    {
        double length = System.Math.Sqrt(Square());
        if (!(length > 0))
        {
            return 0;
        }

        Set((float)(x / length), (float)(y / length));
        return (float)length;
    }

    /// <summary>Whether both components are finite.</summary>
    /// <returns>True if they are.</returns>
    public bool IsValid() => b2Math.b2IsValid(x) && b2Math.b2IsValid(y);

    /// <summary>The components, for a person to read.</summary>
    /// <returns>"(x, y)".</returns>
    public override string ToString() =>
        "(" + x.ToString(System.Globalization.CultureInfo.InvariantCulture) + ", "
        + y.ToString(System.Globalization.CultureInfo.InvariantCulture) + ")";

    private double Square() => ((double)x * x) + ((double)y * y);

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    internal void Visit(StateStream s)
    {
        s.Value(ref _x);
        s.Value(ref _y);
    }
}
