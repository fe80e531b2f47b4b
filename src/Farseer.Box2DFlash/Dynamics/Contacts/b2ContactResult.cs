using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;

namespace Box2D.Dynamics.Contacts;

/// <summary>What the solver did at a contact point. The object is used again: copy what you want to keep.</summary>
/// <example>
/// <code>
/// public class Hits : b2ContactListener
/// {
///     public override void Result(b2ContactResult point) =&gt; Console.WriteLine(point.normalImpulse);
/// }
/// </code>
/// </example>
public class b2ContactResult
{
    /// <summary>First shape.</summary>
    public b2Shape shape1 { get; set; } = null!;

    /// <summary>Second shape.</summary>
    public b2Shape shape2 { get; set; } = null!;

    /// <summary>Place in the world, metres.</summary>
    public b2Vec2 position { get; set; } = new b2Vec2();

    /// <summary>Unit vector from shape1 to shape2.</summary>
    public b2Vec2 normal { get; set; } = new b2Vec2();

    /// <summary>Impulse along the normal in the step, N·s; 0 or more.</summary>
    public float normalImpulse { get; set; }

    /// <summary>Friction impulse in the step, N·s, along the normal turned clockwise by a right angle.</summary>
    public float tangentImpulse { get; set; }

    /// <summary>The features that touch.</summary>
    public b2ContactID id { get; set; } = new b2ContactID();
}
