using System;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <summary>
/// A pair of geoms and its contacts. The arbiters in <see cref="PhysicsSimulator.ArbiterList"/> come from a pool and are used
/// again; a user's own broad phase makes them to name its pairs.
/// </summary>
/// <example>
/// <code>
/// foreach (Arbiter pair in simulator.ArbiterList)
/// {
///     Console.WriteLine($"{pair.GeomA} touches {pair.GeomB} at {pair.ContactList.Count} points");
/// }
/// </code>
/// </example>
public class Arbiter : IEquatable<Arbiter>
{
    /// <summary>Makes an arbiter without geoms.</summary>
    public Arbiter()
    {
    }

    /// <summary>The geom created first. Default null.</summary>
    public Geom GeomA { get; set; } = null!;

    /// <summary>The other geom. Default null.</summary>
    public Geom GeomB { get; set; } = null!;

    /// <summary>The same as <see cref="GeomA"/>, a public field in the original.</summary>
    public Geom GeometryA
    {
        get => GeomA;
        set => GeomA = value;
    }

    /// <summary>The same as <see cref="GeomB"/>, a public field in the original.</summary>
    public Geom GeometryB
    {
        get => GeomB;
        set => GeomB = value;
    }

    /// <summary>The contacts of the last step, deepest first; the normals point from A to B.</summary>
    public ContactList ContactList { get; } = new ContactList(4);

    /// <summary>True for the arbiters that the library makes, false for those of a user's broad phase.</summary>
    internal bool IsOwned { get; set; }

    /// <summary>True if both name the same pair in the same order.</summary>
    /// <param name="arbiter1">One arbiter.</param>
    /// <param name="arbiter2">The other arbiter.</param>
    /// <returns>True if they are equal.</returns>
    public static bool operator ==(Arbiter? arbiter1, Arbiter? arbiter2) => arbiter1 is null ? arbiter2 is null : arbiter1.Equals(arbiter2);

    /// <summary>False if both name the same pair in the same order.</summary>
    /// <param name="arbiter1">One arbiter.</param>
    /// <param name="arbiter2">The other arbiter.</param>
    /// <returns>True if they differ.</returns>
    public static bool operator !=(Arbiter? arbiter1, Arbiter? arbiter2) => !(arbiter1 == arbiter2);

    /// <summary>True if the other names the same pair in the same order.</summary>
    /// <param name="other">The arbiter to compare with.</param>
    /// <returns>True if they are equal.</returns>
    public bool Equals(Arbiter? other) => other is not null && ReferenceEquals(GeomA, other.GeomA) && ReferenceEquals(GeomB, other.GeomB);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is Arbiter other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => ((GeomA is null ? 0 : GeomA.Id) * 397) ^ (GeomB is null ? 0 : GeomB.Id);
}
