using System;
using System.Numerics;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>The geom that is nearest to a point. (An addition to the original.)</summary>
/// <example>
/// <code>
/// if (simulator.ClosestPoint(new Vector2(1, 2), 10, out ClosestPointHit hit))
/// {
///     Console.WriteLine($"{hit.Geom} is {hit.Distance} away at {hit.Point}");
/// }
/// </code>
/// </example>
public readonly struct ClosestPointHit : IEquatable<ClosestPointHit>
{
    internal ClosestPointHit(Geom geom, Vector2 point, float distance)
    {
        Geom = geom;
        Point = point;
        Distance = distance;
    }

    /// <summary>The geom; null in the value of a query that found none.</summary>
    public Geom? Geom { get; }

    /// <summary>The point of the geom's border that is nearest, in world coordinates.</summary>
    public Vector2 Point { get; }

    /// <summary>Distance of <see cref="Point"/> from the point that was asked for; negative if that is inside the geom.</summary>
    public float Distance { get; }

    /// <summary>Compares all members.</summary>
    /// <param name="left">A hit.</param>
    /// <param name="right">Another hit.</param>
    /// <returns>True if all are equal.</returns>
    public static bool operator ==(ClosestPointHit left, ClosestPointHit right) => left.Equals(right);

    /// <summary>Compares all members.</summary>
    /// <param name="left">A hit.</param>
    /// <param name="right">Another hit.</param>
    /// <returns>True if one differs.</returns>
    public static bool operator !=(ClosestPointHit left, ClosestPointHit right) => !left.Equals(right);

    /// <inheritdoc />
    public bool Equals(ClosestPointHit other) =>
        ReferenceEquals(Geom, other.Geom) && Point == other.Point && Distance.Equals(other.Distance);

    /// <inheritdoc />
    public override bool Equals(object? obj) => obj is ClosestPointHit other && Equals(other);

    /// <inheritdoc />
    public override int GetHashCode() => (Point.GetHashCode() * 397) ^ Distance.GetHashCode();
}
