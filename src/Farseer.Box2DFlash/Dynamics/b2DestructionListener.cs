using Box2D.Collision.Shapes;
using Box2D.Dynamics.Joints;

namespace Box2D.Dynamics;

/// <summary>
/// Hears of joints and shapes that go because their body does. Derive from it and hand it to
/// <see cref="b2World.SetDestructionListener"/>. It hears nothing of what the program destroys itself.
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
    /// <summary>Called when a joint is about to be destroyed with a body of it.</summary>
    /// <param name="joint">The joint.</param>
    public virtual void SayGoodbyeJoint(b2Joint joint)
    {
    }

    /// <summary>Called when a shape is about to be destroyed with its body.</summary>
    /// <param name="shape">The shape.</param>
    public virtual void SayGoodbyeShape(b2Shape shape)
    {
    }
}
