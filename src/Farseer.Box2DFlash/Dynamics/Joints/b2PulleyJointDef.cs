using Box2D.Bridge;
using Box2D.Common.Math;

namespace Box2D.Dynamics.Joints;

/// <summary>The definition of a pulley.</summary>
/// <example>
/// <code>
/// var def = new b2PulleyJointDef();
/// def.Initialize(body, second, new b2Vec2(-2, -8), new b2Vec2(2, -8), body.GetWorldCenter(), second.GetWorldCenter(), 1);
/// world.CreateJoint(def);
/// </code>
/// </example>
public class b2PulleyJointDef : b2JointDef
{
    /// <summary>Makes a definition whose bodies collide with each other.</summary>
    public b2PulleyJointDef()
        : base(b2Joint.e_pulleyJoint) => collideConnected = true;

    /// <summary>The point of the world over which the first side of the rope runs, metres. Default (−1, 1).</summary>
    public b2Vec2 groundAnchor1 { get; set; } = new b2Vec2(-1, 1);

    /// <summary>The point of the world over which the second side of the rope runs, metres. Default (1, 1).</summary>
    public b2Vec2 groundAnchor2 { get; set; } = new b2Vec2(1, 1);

    /// <summary>Where the rope holds the first body, metres. Default (−1, 0).</summary>
    public b2Vec2 localAnchor1 { get; set; } = new b2Vec2(-1, 0);

    /// <summary>Where the rope holds the second body, metres. Default (1, 0).</summary>
    public b2Vec2 localAnchor2 { get; set; } = new b2Vec2(1, 0);

    /// <summary>Length of the first side, metres; finite and 0 or more. Default 0.</summary>
    public float length1 { get; set; }

    /// <summary>Length that the first side may not exceed, metres; finite and 0 or more. Default 0.</summary>
    public float maxLength1 { get; set; }

    /// <summary>Length of the second side, metres; finite and 0 or more. Default 0.</summary>
    public float length2 { get; set; }

    /// <summary>Length that the second side may not exceed, metres; finite and 0 or more. Default 0.</summary>
    public float maxLength2 { get; set; }

    /// <summary>How the sides share the rope: length1 + ratio·length2 is constant. Finite and above 0. Default 1.</summary>
    public float ratio { get; set; } = 1.0f;

    /// <summary>
    /// Takes the bodies, and anchors and lengths as they are now. The largest lengths leave the other side
    /// <see cref="b2PulleyJoint.b2_minPulleyLength"/>.
    /// </summary>
    /// <param name="b1">First body.</param>
    /// <param name="b2">Second body.</param>
    /// <param name="ga1">Point of the world over which the first side runs.</param>
    /// <param name="ga2">Point of the world over which the second side runs.</param>
    /// <param name="anchor1">Where the rope holds the first body, in the world.</param>
    /// <param name="anchor2">Where the rope holds the second body, in the world.</param>
    /// <param name="r">The ratio; finite and above 0.</param>
    /// <exception cref="System.ArgumentException">An argument is null or not finite, or the ratio not above 0.</exception>
    public void Initialize(b2Body b1, b2Body b2, b2Vec2 ga1, b2Vec2 ga2, b2Vec2 anchor1, b2Vec2 anchor2, float r)
    {
        Check(b1, b2);
        Require.Vector(anchor1, nameof(anchor1));
        Require.Vector(anchor2, nameof(anchor2));
        Require.Positive(r, nameof(r));
        groundAnchor1 = Copy(ga1, nameof(ga1));
        groundAnchor2 = Copy(ga2, nameof(ga2));
        body1 = b1;
        body2 = b2;
        localAnchor1 = b1.GetLocalPoint(anchor1);
        localAnchor2 = b2.GetLocalPoint(anchor2);
        length1 = b2Math.b2Distance(anchor1, ga1);
        length2 = b2Math.b2Distance(anchor2, ga2);
        ratio = r;
        float total = length1 + (r * length2);
        maxLength1 = total - (r * b2PulleyJoint.b2_minPulleyLength);
        maxLength2 = (total - b2PulleyJoint.b2_minPulleyLength) / r;
    }

    internal override b2Joint Make(b2World world)
    {
        Require.Vector(groundAnchor1, nameof(groundAnchor1));
        Require.Vector(groundAnchor2, nameof(groundAnchor2));
        Require.Vector(localAnchor1, nameof(localAnchor1));
        Require.Vector(localAnchor2, nameof(localAnchor2));
        Require.NotNegative(length1, nameof(length1));
        Require.NotNegative(length2, nameof(length2));
        Require.Finite(maxLength1, nameof(maxLength1));
        Require.Finite(maxLength2, nameof(maxLength2));
        Require.Positive(ratio, nameof(ratio));
        return new b2PulleyJoint(this, world);
    }
}
