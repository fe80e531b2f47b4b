namespace Box2D.Collision.Shapes;

/// <summary>
/// The definition of a shape: see <see cref="b2CircleDef"/> and <see cref="b2PolygonDef"/>. It can be used again: a shape keeps a
/// copy of all but <see cref="userData"/>.
/// </summary>
/// <example>
/// <code>
/// b2ShapeDef sensor = new b2CircleDef { radius = 2, isSensor = true };
/// body.CreateShape(sensor);
/// </code>
/// </example>
public abstract class b2ShapeDef
{
    internal b2ShapeDef(int kind) => type = kind;

    /// <summary>Kind of shape: <see cref="b2Shape.e_circleShape"/> or <see cref="b2Shape.e_polygonShape"/>.</summary>
    public int type { get; }

    /// <summary>Any object. Default null.</summary>
    public object? userData { get; set; }

    /// <summary>Coefficient of friction, finite and 0 or more, usually 0 to 1. Default 0.2.</summary>
    public float friction { get; set; } = 0.2f;

    /// <summary>Restitution, finite and 0 or more: 0 no bounce, 1 perfectly elastic. Default 0.</summary>
    public float restitution { get; set; }

    /// <summary>Mass per area, kg/m²; finite and 0 or more. Default 0.</summary>
    public float density { get; set; }

    /// <summary>True makes a shape that notices overlaps and does not respond to them. Default false.</summary>
    public bool isSensor { get; set; }

    /// <summary>The filter: the shapes that it collides with. Default with all: see <see cref="b2FilterData"/>.</summary>
    public b2FilterData filter { get; set; } = new b2FilterData();
}
