using Box2D.Collision.Shapes;
using Box2D.Dynamics.Joints;

namespace Box2D.Dynamics;

/// <summary>
/// Hears of joints and shapes that go because their body does. Derive from it and hand it to
/// <see cref="b2World.SetDestructionListener"/>. What the user destroys by itself is not told.
/// </summary>
/// <example>
/// <code>
/// public class Cleaner : b2DestructionListener
/// {
///     public override void SayGoodbyeJoint(b2Joint joint) =&gt; Console.WriteLine("a joint went with its body");
///
///     public override void SayGoodbyeShape(b2Shape shape)
///     {
///     }
/// }
/// </code>
/// </example>
public class b2DestructionListener
{
    /// <summary>A joint is about to go with a body of it.</summary>
    /// <param name="joint">The joint.</param>
    public virtual void SayGoodbyeJoint(b2Joint joint)
    {
    }

    /// <summary>A shape is about to go with its body.</summary>
    /// <param name="shape">The shape.</param>
    public virtual void SayGoodbyeShape(b2Shape shape)
    {
    }
}
