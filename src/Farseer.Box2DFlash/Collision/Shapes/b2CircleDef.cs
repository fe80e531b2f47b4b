using Box2D.Common.Math;

namespace Box2D.Collision.Shapes;

/// <summary>The definition of a circle.</summary>
/// <example>
/// <code>
/// var ball = new b2CircleDef { radius = 0.5f, density = 1, friction = 0.3f, restitution = 0.5f };
/// body.CreateShape(ball);
/// body.SetMassFromShapes();
/// </code>
/// </example>
public class b2CircleDef : b2ShapeDef
{
    /// <summary>Makes a definition of a circle of radius 1 about the origin of the body.</summary>
    public b2CircleDef()
        : base(b2Shape.e_circleShape)
    {
    }

    /// <summary>Centre in the body, metres. Default (0, 0).</summary>
    public b2Vec2 localPosition { get; set; } = new b2Vec2(0, 0);

    /// <summary>Radius, metres; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸. Default 1.</summary>
    public float radius { get; set; } = 1.0f;
}
