using System;
using System.ComponentModel;
using Box2D.Bridge;
using Box2D.Collision.Shapes;
using Farseer.Engine.Storage;

namespace Box2D.Dynamics.Contacts;

/// <summary>
/// Two shapes whose boxes overlap, whether or not they touch. The engine makes and ends it; see <see cref="b2World.GetContactList"/>. Once
/// ended the object is used for another contact: nothing is to be kept of it from one step to the next.
/// </summary>
/// <example>
/// <code>
/// for (b2Contact c = world.GetContactList(); c != null; c = c.GetNext())
/// {
///     Console.WriteLine(c.GetShape1() + " and " + c.GetShape2());
/// }
/// </code>
/// </example>
public class b2Contact
{
    internal b2Contact(b2Shape shape1, b2Shape shape2)
    {
        Points = new ContactPoints();
        Shape1 = shape1;
        Shape2 = shape2;
    }

    internal b2Shape Shape1 { get; private set; }

    internal b2Shape Shape2 { get; private set; }

    internal b2Contact? Next { get; set; }

    internal b2Contact? Previous { get; set; }

    [NotState(Why.Derived)]
    internal ulong Key { get; set; }

    internal ContactPoints Points { get; }

    /// <summary>The boxes met before the body was put elsewhere.</summary>
    internal bool WasNear { get; set; }

    internal virtual bool IsAccepted => true;

    internal bool Concerns(b2Body body) => ReferenceEquals(Shape1.Body, body) || ReferenceEquals(Shape2.Body, body);

    /// <summary>Makes an ended contact one of two other shapes, as if it were new.</summary>
    internal void Begin(b2Shape shape1, b2Shape shape2)
    {
        Shape1 = shape1;
        Shape2 = shape2;
        Previous = null;
        Points.Begin();
    }

    /// <summary>First shape; of a polygon and a circle the polygon.</summary>
    /// <returns>The shape.</returns>
    public b2Shape GetShape1() => Shape1;

    /// <summary>Second shape.</summary>
    /// <returns>The shape.</returns>
    public b2Shape GetShape2() => Shape2;

    /// <summary>The next contact of the world: one made before this one.</summary>
    /// <returns>The contact, or null after the last.</returns>
    public b2Contact? GetNext() => Next;

    /// <summary>Whether the shapes push each other apart when they touch: neither is a sensor.</summary>
    /// <returns>True if they do.</returns>
    public virtual bool IsSolid() => !Shape1.IsSensor() && !Shape2.IsSensor();

    /// <summary>1 if the shapes touched in the last step and a contact listener is registered, otherwise 0.</summary>
    /// <returns>0 or 1.</returns>
    public int GetManifoldCount() => Points.Any ? 1 : 0;

    /// <summary>A field of the original. Use <see cref="GetNext"/> instead.</summary>
    [Obsolete("Use GetNext().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Contact? m_next => GetNext();

    /// <summary>A field of the original. Use <see cref="GetShape1"/> instead.</summary>
    [Obsolete("Use GetShape1().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Shape m_shape1 => GetShape1();

    /// <summary>A field of the original. Use <see cref="GetShape2"/> instead.</summary>
    [Obsolete("Use GetShape2().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Shape m_shape2 => GetShape2();

    /// <summary>A field of the original. Use <see cref="GetManifoldCount"/> instead.</summary>
    [Obsolete("Use GetManifoldCount().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public int m_manifoldCount => GetManifoldCount();

    /// <summary>Whether there is a contact: ActionScript's <c>if (contact)</c>, and <c>for (…; contact; …)</c>.</summary>
    /// <param name="contact">The contact, or null.</param>
    /// <returns>True if it is not null.</returns>
    public static bool operator true(b2Contact? contact) => contact is not null;

    /// <summary>Whether there is no contact.</summary>
    /// <param name="contact">The contact, or null.</param>
    /// <returns>True if it is null.</returns>
    public static bool operator false(b2Contact? contact) => contact is null;

    /// <summary>Whether there is no contact.</summary>
    /// <param name="contact">The contact, or null.</param>
    /// <returns>True if it is null.</returns>
    public static bool operator !(b2Contact? contact) => contact is null;
}
