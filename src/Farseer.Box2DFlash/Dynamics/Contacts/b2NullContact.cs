using Box2D.Collision.Shapes;

namespace Box2D.Dynamics.Contacts;

/// <summary>A pair of shapes that the filter refused: it keeps the answer until their boxes part.</summary>
/// <example>
/// <code>
/// for (b2Contact c = world.GetContactList(); c != null; c = c.GetNext())
/// {
///     bool isRefused = c is b2NullContact;
/// }
/// </code>
/// </example>
public class b2NullContact : b2Contact
{
    internal b2NullContact(b2Shape shape1, b2Shape shape2)
        : base(shape1, shape2)
    {
    }

    internal override bool IsAccepted => false;

    /// <summary>Always false: the shapes do not collide.</summary>
    /// <returns>False.</returns>
    public override bool IsSolid() => false;
}
