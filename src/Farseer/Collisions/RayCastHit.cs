using System;
using System.Numerics;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>Where a ray or a moving shape meets a geom. (An addition to the original.)</summary>
/// <example>
/// <code>
/// if (simulator.RayCast(new Vector2(0, 5), new Vector2(0, -5), out RayCastHit hit))
/// {
///     Vector2 where = hit.Point;
/// }
/// </code>
/// </example>
public readonly struct RayCastHit : IEquatable<RayCastHit>
{
    internal RayCastHit(Geom geom, Vector2 point, Vector2 normal, float fraction, bool startsInside)
    {
        Geom = geom;
        Point = point;
        Normal = normal;
        Fraction = fraction;
        StartsInside = startsInside;
    }

    /// <summary>The geom that is met; null in the value of a query without a hit.</summary>
    public Geom? Geom { get; }

    /// <summary>The point of the geom where it is met, in world coordinates.</summary>
    public Vector2 Point { get; }

    /// <summary>Unit vector out of the geom at <see cref="Point"/>, in world axes; (0, 0) if <see cref="StartsInside"/>.</summary>
    public Vector2 Normal { get; }

    /// <summary>Share of the way up to the hit, from 0 to 1.</summary>
    public float Fraction { get; }

    /// <summary>True if the way starts in or on the geom: it is then met at once.</summary>
    public bool StartsInside { get; }

    /// <summary>Compares all members.</summary>
    /// <param name="left">A hit.</param>
    /// <param name="right">Another hit.</param>
    /// <returns>True if all are equal.</returns>
    public static bool operator ==(RayCastHit left, RayCastHit right) => left.Equals(right);

    /// <summary>Compares all members.</summary>
    /// <param name="left">A hit.</param>
    /// <param name="right">Another hit.</param>
    /// <returns>True if one differs.</returns>
    public static bool operator !=(RayCastHit left, RayCastHit right) => !left.Equals(right);

    /// <inheritdoc />
    public bool Equals(RayCastHit other) =>
        ReferenceEquals(Geom, other.Geom) && Point == other.Point && Normal == other.Normal && Fraction.Equals(other.Fraction)
        && StartsInside == other.StartsInside;

    /// <inheritdoc />
    public override bool Equals(object? obj) => obj is RayCastHit other && Equals(other);

    /// <inheritdoc />
    public override int GetHashCode() => (Point.GetHashCode() * 397) ^ Fraction.GetHashCode();
}
