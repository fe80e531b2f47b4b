using Box2D.Collision.Shapes;
using Box2D.Common.Math;

namespace Box2D.Dynamics;

/// <summary>The definition of a body. It can be used again: a body keeps a copy of all but <see cref="userData"/>.</summary>
/// <example>
/// <code>
/// var def = new b2BodyDef { angle = 0.3f, isBullet = true };
/// def.position.Set(0, -5);
/// b2Body bullet = world.CreateBody(def);
/// </code>
/// </example>
public class b2BodyDef
{
    /// <summary>Makes a definition of a body at the origin, without mass: static.</summary>
    public b2BodyDef()
    {
    }

    /// <summary>
    /// Mass properties; a mass of 0, the default, makes a static body. <see cref="b2Body.SetMassFromShapes"/> and
    /// <see cref="b2Body.SetMass"/> change them.
    /// </summary>
    public b2MassData massData { get; set; } = new b2MassData();

    /// <summary>Any object. Default null.</summary>
    public object? userData { get; set; }

    /// <summary>The position of the origin of the body, metres. Default (0, 0).</summary>
    public b2Vec2 position { get; set; } = new b2Vec2(0, 0);

    /// <summary>The angle of the body, radians; within ±9.2·10¹⁸. Default 0.</summary>
    public float angle { get; set; }

    /// <summary>Rate by which the velocity dies away, 1/s: v falls as e^(−c·t). Finite and 0 or more, usually 0 to 1. Default 0.</summary>
    public float linearDamping { get; set; }

    /// <summary>Rate by which the angular velocity dies away, 1/s. Finite and 0 or more. Default 0.</summary>
    public float angularDamping { get; set; }

    /// <summary>Whether the body may sleep. Default true.</summary>
    public bool allowSleep { get; set; } = true;

    /// <summary>Whether the body sleeps at first. Default false.</summary>
    public bool isSleeping { get; set; }

    /// <summary>True keeps the body from turning. Default false.</summary>
    public bool fixedRotation { get; set; }

    /// <summary>True keeps the body from passing through other moving bodies too. Default false.</summary>
    public bool isBullet { get; set; }
}
