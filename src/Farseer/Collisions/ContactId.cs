using System;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>
/// Names a contact by the two geoms and the vertex that made it, so that the same contact can be recognised in the next step.
/// </summary>
/// <example>
/// <code>
/// var id = new ContactId(1, 0, 2);
/// bool same = id == new ContactId(1, 0, 2);
/// </code>
/// </example>
public struct ContactId : IEquatable<ContactId>
{
    /// <summary>Makes the name of a contact.</summary>
    /// <param name="geometryAIndex">See <see cref="Geom1Index"/>.</param>
    /// <param name="geometryAVertex">See <see cref="Geom1Vertex"/>.</param>
    /// <param name="geometryBIndex">See <see cref="Geom2Index"/>.</param>
    public ContactId(int geometryAIndex, int geometryAVertex, int geometryBIndex)
    {
        Geom1Index = geometryAIndex;
        Geom1Vertex = geometryAVertex;
        Geom2Index = geometryBIndex;
    }

    /// <summary>The number of the geom whose vertex touches. Default 0.</summary>
    public int Geom1Index { get; set; }

    /// <summary>The index of the touching vertex, or the feature number, within the first geom. Default 0.</summary>
    public int Geom1Vertex { get; set; }

    /// <summary>The number of the geom that is touched. Default 0.</summary>
    public int Geom2Index { get; set; }

    /// <summary>Tells whether two names are the same.</summary>
    /// <param name="contactId1">One name.</param>
    /// <param name="contactId2">The other name.</param>
    /// <returns>True if all three numbers agree.</returns>
    public static bool operator ==(ContactId contactId1, ContactId contactId2) => contactId1.Equals(contactId2);

    /// <summary>Tells whether two names differ.</summary>
    /// <param name="contactId1">One name.</param>
    /// <param name="contactId2">The other name.</param>
    /// <returns>True if any of the three numbers differs.</returns>
    public static bool operator !=(ContactId contactId1, ContactId contactId2) => !contactId1.Equals(contactId2);

    /// <summary>Tells whether this name is the same as another.</summary>
    /// <param name="other">The other name.</param>
    /// <returns>True if all three numbers agree.</returns>
    public bool Equals(ContactId other) =>
        Geom1Index == other.Geom1Index && Geom1Vertex == other.Geom1Vertex && Geom2Index == other.Geom2Index;

    /// <summary>Tells whether an object is the same name.</summary>
    /// <param name="obj">Any object.</param>
    /// <returns>True if it is a <see cref="ContactId"/> with the same three numbers.</returns>
    public override bool Equals(object? obj) => obj is ContactId other && Equals(other);

    /// <summary>A hash code of the three numbers; the same on every run.</summary>
    /// <returns>The hash code.</returns>
    public override int GetHashCode()
    {
        unchecked
        {
            return (((Geom1Index * 397) ^ Geom1Vertex) * 397) ^ Geom2Index;
        }
    }
}
