using System;
using System.Numerics;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>One point at which two geoms touch or overlap, as the narrow phase found it (manual: "Narrow phase").</summary>
/// <remarks>
/// A contact handed out is a copy of what the last update found: changing its fields changes nothing in the simulation. Two
/// contacts are equal when their <see cref="ContactId"/> is: a contact of this step equals the one it continues from the step
/// before, although it has moved.
/// </remarks>
/// <example>
/// <code>
/// foreach (Arbiter pair in simulator.ArbiterList)
/// {
///     foreach (Contact contact in pair.ContactList)
///     {
///         Console.WriteLine($"{contact.Position}: overlap {-contact.Separation}, impulse {contact.NormalImpulse}");
///     }
/// }
/// </code>
/// </example>
public struct Contact : IEquatable<Contact>
{
    /// <summary>
    /// The unit vector along which the geoms are pushed apart, in world coordinates, from the first geom towards the second.
    /// Default (0, 0).
    /// </summary>
    public Vector2 Normal;

    /// <summary>The point of contact in world coordinates. Default (0, 0).</summary>
    public Vector2 Position;

    /// <summary>
    /// The distance between the surfaces, in the units of the world: negative where the geoms overlap, positive for a gap.
    /// Default 0.
    /// </summary>
    public float Separation;

    internal ContactId ContactId;
    internal float MassNormal;
    internal float MassTangent;
    internal float Bias;

    /// <summary>Makes a contact.</summary>
    /// <param name="position">The point, in world coordinates.</param>
    /// <param name="normal">The unit normal, from the first geom towards the second.</param>
    /// <param name="separation">The distance between the surfaces, negative for an overlap.</param>
    /// <param name="contactId">The name by which the contact is recognised.</param>
    public Contact(Vector2 position, Vector2 normal, float separation, ContactId contactId)
    {
        Position = position;
        Normal = normal;
        Separation = separation;
        ContactId = contactId;
        NormalImpulse = 0f;
        TangentImpulse = 0f;
        MassNormal = 0f;
        MassTangent = 0f;
        Bias = 0f;
    }

    /// <summary>
    /// The impulse along the normal that the contact gave in the last update, mass times length/s; at least 0. It pushed the second geom
    /// along
    /// <see cref="Normal"/> and the first one the other way. At rest it is the load times the time of the update. With
    /// <see cref="PhysicsSimulator.SumImpulses"/> it is the sum over the whole update, else that of its last substep as if all had been
    /// like it, which is the same for what presses evenly. Default 0. (An addition to the original.)
    /// </summary>
    public float NormalImpulse { readonly get; private set; }

    /// <summary>
    /// The impulse of friction, as <see cref="NormalImpulse"/>: on the second geom along (<see cref="Normal"/>.Y, -<see cref="Normal"/>.X),
    /// on the first one the other way; either sign. Default 0. (An addition to the original.)
    /// </summary>
    public float TangentImpulse { readonly get; private set; }

    /// <summary>Tells whether two contacts are the same one.</summary>
    /// <param name="contact1">One contact.</param>
    /// <param name="contact2">The other contact.</param>
    /// <returns>True if their names (<see cref="Collisions.ContactId"/>) are equal, wherever they are.</returns>
    public static bool operator ==(Contact contact1, Contact contact2) => contact1.Equals(contact2);

    /// <summary>Tells whether two contacts are different ones.</summary>
    /// <param name="contact1">One contact.</param>
    /// <param name="contact2">The other contact.</param>
    /// <returns>True if their names (<see cref="Collisions.ContactId"/>) differ.</returns>
    public static bool operator !=(Contact contact1, Contact contact2) => !contact1.Equals(contact2);

    /// <summary>Tells whether another contact is the same one as this.</summary>
    /// <param name="other">The other contact.</param>
    /// <returns>True if their names (<see cref="Collisions.ContactId"/>) are equal, wherever they are.</returns>
    public bool Equals(Contact other) => ContactId.Equals(other.ContactId);

    /// <summary>Tells whether an object is the same contact.</summary>
    /// <param name="obj">Any object.</param>
    /// <returns>True if it is a <see cref="Contact"/> with the same name.</returns>
    public override bool Equals(object? obj) => obj is Contact other && Equals(other);

    /// <summary>The hash code of the contact's name.</summary>
    /// <returns>The hash code.</returns>
    public override int GetHashCode() => ContactId.GetHashCode();

    /// <summary>Stores the velocity that pushes an overlap apart.</summary>
    /// <param name="bias">The velocity along the normal, in world units per second.</param>
    /// <remarks>Kept for programs that solve contacts themselves; the simulation does not read it.</remarks>
    public void SetBias(float bias) => Bias = bias;

    /// <summary>Stores the effective mass of the two bodies along the normal.</summary>
    /// <param name="massNormal">The effective mass, in units of mass.</param>
    /// <remarks>Kept for programs that solve contacts themselves; the simulation does not read it.</remarks>
    public void SetMassNormal(float massNormal) => MassNormal = massNormal;

    /// <summary>Stores the effective mass of the two bodies along the surface.</summary>
    /// <param name="massTangent">The effective mass, in units of mass.</param>
    /// <remarks>Kept for programs that solve contacts themselves; the simulation does not read it.</remarks>
    public void SetMassTangent(float massTangent) => MassTangent = massTangent;

    /// <summary>Stores the impulse along the normal.</summary>
    /// <param name="normalImpulse">The impulse, mass times world units per second; 0 or more.</param>
    /// <remarks>Kept for programs that solve contacts themselves; the simulation does not read it.</remarks>
    public void SetNormalImpulse(float normalImpulse) => NormalImpulse = normalImpulse;

    /// <summary>Stores the impulse of friction, along the surface.</summary>
    /// <param name="tangentImpulse">The impulse, mass times world units per second; either sign.</param>
    /// <remarks>Kept for programs that solve contacts themselves; the simulation does not read it.</remarks>
    public void SetTangentImpulse(float tangentImpulse) => TangentImpulse = tangentImpulse;
}
