using System;
using Box2D.Bridge;
using Box2D.Common.Math;

namespace Box2D.Dynamics.Joints;

/// <summary>The definition of a joint. It can be used again; a joint keeps copies of its values.</summary>
/// <example>
/// <code>
/// b2JointDef def = new b2RevoluteJointDef { collideConnected = true, userData = "elbow" };
/// </code>
/// </example>
public abstract class b2JointDef
{
    internal b2JointDef(int kind) => type = kind;

    /// <summary>Kind of joint, for example <see cref="b2Joint.e_revoluteJoint"/>.</summary>
    public int type { get; }

    /// <summary>Any object. Default null.</summary>
    public object? userData { get; set; }

    /// <summary>First body. Default null: it must be set.</summary>
    public b2Body? body1 { get; set; }

    /// <summary>Second body, another one. Default null: it must be set.</summary>
    public b2Body? body2 { get; set; }

    /// <summary>Whether the two bodies collide with each other all the same. Default false.</summary>
    public bool collideConnected { get; set; }

    internal abstract b2Joint Make(b2World world);

    /// <summary>Both bodies, checked: of this world and different.</summary>
    internal virtual void CheckBodies(b2World world)
    {
        world.CheckMine(body1, nameof(body1));
        world.CheckMine(body2, nameof(body2));
        if (ReferenceEquals(body1, body2))
        {
            throw new ArgumentException("A joint needs two different bodies.", nameof(body2));
        }
    }

    private protected static void Check(b2Body b1, b2Body b2)
    {
        Require.NotNull(b1, nameof(b1));
        Require.NotNull(b2, nameof(b2));
    }

    private protected static b2Vec2 Copy(b2Vec2 value, string name) => Require.Vector(value, name).Copy();
}
