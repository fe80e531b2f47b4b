using Box2D.Collision.Shapes;
using Box2D.Common.Math;

namespace Box2D.Collision;

/// <summary>A contact point as a listener gets it, before the solver. The object is used again: copy what you want to keep.</summary>
/// <example>
/// <code>
/// public class Sounds : b2ContactListener
/// {
///     public override void Add(b2ContactPoint point) =&gt; Console.WriteLine("touched at " + point.position.x);
/// }
/// </code>
/// </example>
public class b2ContactPoint
{
    /// <summary>First shape.</summary>
    public b2Shape shape1 { get; set; } = null!;

    /// <summary>Second shape.</summary>
    public b2Shape shape2 { get; set; } = null!;

    /// <summary>Place in the world, metres.</summary>
    public b2Vec2 position { get; set; } = new b2Vec2();

    /// <summary>Velocity of shape2 relative to shape1 at the point, m/s.</summary>
    public b2Vec2 velocity { get; set; } = new b2Vec2();

    /// <summary>Unit vector from shape1 to shape2.</summary>
    public b2Vec2 normal { get; set; } = new b2Vec2();

    /// <summary>Distance of the two shapes, metres; negative when they overlap.</summary>
    public float separation { get; set; }

    /// <summary>Friction of the pair: the square root of the product of both.</summary>
    public float friction { get; set; }

    /// <summary>Restitution of the pair: the larger of both.</summary>
    public float restitution { get; set; }

    /// <summary>The features that touch.</summary>
    public b2ContactID id { get; set; } = new b2ContactID();
}
