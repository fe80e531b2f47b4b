using System;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <summary>A point of a <see cref="Curve"/> with the tangents in which the curve comes and goes.</summary>
/// <example>
/// <code>
/// var key = new CurveKey(position: 1, value: 4) { TangentIn = 0, TangentOut = 2 };
/// </code>
/// </example>
public class CurveKey : IComparable<CurveKey>, IEquatable<CurveKey>
{
    private float _value;
    private float _tangentIn;
    private float _tangentOut;
    private CurveContinuity _continuity;

    /// <summary>Makes a key with flat tangents.</summary>
    /// <param name="position">The position on the curve; finite.</param>
    /// <param name="value">The value there; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite.</exception>
    public CurveKey(float position, float value)
        : this(position, value, 0, 0, CurveContinuity.Smooth)
    {
    }

    /// <summary>Makes a key.</summary>
    /// <param name="position">The position on the curve; finite.</param>
    /// <param name="value">The value there; finite.</param>
    /// <param name="tangentIn">Tangent towards the key, value per distance to the key before; finite.</param>
    /// <param name="tangentOut">Tangent away from the key, value per distance to the next key; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite.</exception>
    public CurveKey(float position, float value, float tangentIn, float tangentOut)
        : this(position, value, tangentIn, tangentOut, CurveContinuity.Smooth)
    {
    }

    /// <summary>Makes a key.</summary>
    /// <param name="position">The position on the curve; finite.</param>
    /// <param name="value">The value there; finite.</param>
    /// <param name="tangentIn">Tangent towards the key, value per distance to the key before; finite.</param>
    /// <param name="tangentOut">Tangent away from the key, value per distance to the next key; finite.</param>
    /// <param name="continuity">How the curve continues to the next key.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite, or the continuity is not a member of its enum.</exception>
    public CurveKey(float position, float value, float tangentIn, float tangentOut, CurveContinuity continuity)
    {
        Position = Require.Finite(position, nameof(position));
        _value = Require.Finite(value, nameof(value));
        _tangentIn = Require.Finite(tangentIn, nameof(tangentIn));
        _tangentOut = Require.Finite(tangentOut, nameof(tangentOut));
        _continuity = Known(continuity, nameof(continuity));
    }

    /// <summary>The position on the curve.</summary>
    public float Position { get; }

    /// <summary>The value there; finite.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float Value
    {
        get => _value;
        set => _value = Require.Finite(value, nameof(Value));
    }

    /// <summary>Tangent towards the key, value per distance to the key before; finite.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float TangentIn
    {
        get => _tangentIn;
        set => _tangentIn = Require.Finite(value, nameof(TangentIn));
    }

    /// <summary>Tangent away from the key, value per distance to the next key; finite.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float TangentOut
    {
        get => _tangentOut;
        set => _tangentOut = Require.Finite(value, nameof(TangentOut));
    }

    /// <summary>How the curve continues to the next key.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not a member of its enum.</exception>
    public CurveContinuity Continuity
    {
        get => _continuity;
        set => _continuity = Known(value, nameof(Continuity));
    }

    /// <summary>True if all parts of two keys are equal.</summary>
    /// <param name="a">One key.</param>
    /// <param name="b">The other.</param>
    /// <returns>True if they are.</returns>
    public static bool operator ==(CurveKey? a, CurveKey? b) => a is null ? b is null : a.Equals(b);

    /// <summary>True if a part of two keys differs.</summary>
    /// <param name="a">One key.</param>
    /// <param name="b">The other.</param>
    /// <returns>True if it does.</returns>
    public static bool operator !=(CurveKey? a, CurveKey? b) => !(a == b);

    /// <summary>Makes an equal key.</summary>
    /// <returns>The new key.</returns>
    public CurveKey Clone() => new CurveKey(Position, _value, _tangentIn, _tangentOut, _continuity);

    /// <summary>Compares the positions.</summary>
    /// <param name="other">The other key; null comes before all.</param>
    /// <returns>Below 0 if this key comes first, 0 if both are at the same position.</returns>
    public int CompareTo(CurveKey? other) => other is null ? 1 : Position.CompareTo(other.Position);

    /// <summary>True if all parts are equal.</summary>
    /// <param name="other">The other key.</param>
    /// <returns>True if they are.</returns>
    public bool Equals(CurveKey? other) =>
        other is not null && Position == other.Position && _value == other._value && _tangentIn == other._tangentIn
        && _tangentOut == other._tangentOut && _continuity == other._continuity;

    /// <summary>True if the object is an equal key.</summary>
    /// <param name="obj">The object.</param>
    /// <returns>True if it is.</returns>
    public override bool Equals(object? obj) => obj is CurveKey other && Equals(other);

    /// <summary>A number made of the position alone: the other parts may change.</summary>
    /// <returns>The number.</returns>
    public override int GetHashCode() => Position.GetHashCode();

    private static CurveContinuity Known(CurveContinuity value, string name) =>
        value is CurveContinuity.Smooth or CurveContinuity.Step
            ? value
            : throw Require.Range(name, value, "must be a member of CurveContinuity");
}
