using System.Numerics;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>
/// The answer to "how far is this point from the geom?": the point asked about, the distance and the direction to the surface
/// (manual: "Grid").
/// </summary>
/// <example>
/// <code>
/// var point = new Vector2(0.2f, 0.1f);
/// if (geom.Intersect(ref point, out Feature surface))
/// {
///     Console.WriteLine($"{-surface.Distance} inside, nearest at {surface.Position}");
/// }
/// </code>
/// </example>
public struct Feature
{
    /// <summary>The distance to the surface, in world units: negative inside the geom. Default 0.</summary>
    public float Distance;

    /// <summary>The unit vector that points away from the nearest piece of surface. Default (0, 0).</summary>
    public Vector2 Normal;

    /// <summary>The point that was asked about. Default (0, 0).</summary>
    public Vector2 Position;

    /// <summary>Makes a feature of which only the position is known: no normal, infinitely far for all purposes.</summary>
    /// <param name="position">The point asked about; <see cref="Distance"/> becomes <see cref="float.MaxValue"/>.</param>
    public Feature(Vector2 position)
    {
        Position = position;
        Normal = Vector2.Zero;
        Distance = float.MaxValue;
    }

    /// <summary>Makes a feature.</summary>
    /// <param name="position">The point asked about.</param>
    /// <param name="normal">The unit vector away from the surface.</param>
    /// <param name="distance">The distance to the surface, negative inside.</param>
    public Feature(Vector2 position, Vector2 normal, float distance)
    {
        Position = position;
        Normal = normal;
        Distance = distance;
    }

    /// <summary>Tells whether two features agree in all fields.</summary>
    /// <param name="first">One feature.</param>
    /// <param name="second">The other feature.</param>
    /// <returns>True if position, normal and distance are equal.</returns>
    public static bool operator ==(Feature first, Feature second) => first.Equals(second);

    /// <summary>Tells whether two features differ in any field.</summary>
    /// <param name="first">One feature.</param>
    /// <param name="second">The other feature.</param>
    /// <returns>True if position, normal or distance differ.</returns>
    public static bool operator !=(Feature first, Feature second) => !first.Equals(second);

    /// <summary>Tells whether another feature agrees with this one in all fields.</summary>
    /// <param name="other">The other feature.</param>
    /// <returns>True if position, normal and distance are equal.</returns>
    public bool Equals(Feature other) =>
        Position.Equals(other.Position) && Normal.Equals(other.Normal) && Distance.Equals(other.Distance);

    /// <summary>Tells whether an object is an equal feature.</summary>
    /// <param name="obj">Any object.</param>
    /// <returns>True if it is a <see cref="Feature"/> with the same position, normal and distance.</returns>
    public override bool Equals(object? obj) => obj is Feature other && Equals(other);

    /// <summary>A hash code of all fields.</summary>
    /// <returns>The hash code.</returns>
    public override int GetHashCode()
    {
        unchecked
        {
            return (((Position.GetHashCode() * 397) ^ Normal.GetHashCode()) * 397) ^ Distance.GetHashCode();
        }
    }
}
