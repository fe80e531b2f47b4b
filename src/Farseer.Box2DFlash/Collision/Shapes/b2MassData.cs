using Box2D.Common.Math;

namespace Box2D.Collision.Shapes;

/// <summary>Mass, centre of mass and inertia of a shape or a body.</summary>
/// <example>
/// <code>
/// body.SetMass(new b2MassData { mass = 2, I = 0.5f });
/// </code>
/// </example>
public class b2MassData
{
    /// <summary>Mass, kg; 0 or more. Default 0.</summary>
    public float mass { get; set; }

    /// <summary>Centre of mass in the body, metres. Default (0, 0).</summary>
    public b2Vec2 center { get; set; } = new b2Vec2(0, 0);

    /// <summary>
    /// Inertia, kg·m²; 0 or more, and 0 for a body that does not turn. Of a body it is about its centre of mass. Default 0.
    /// </summary>
    public float I { get; set; }
}
