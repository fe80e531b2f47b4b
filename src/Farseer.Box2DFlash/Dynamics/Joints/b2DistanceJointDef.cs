using Box2D.Bridge;
using Box2D.Common.Math;

namespace Box2D.Dynamics.Joints;

/// <summary>The definition of a distance joint.</summary>
/// <example>
/// <code>
/// var def = new b2DistanceJointDef();
/// def.Initialize(body, second, body.GetWorldCenter(), second.GetWorldCenter());
/// world.CreateJoint(def);
/// </code>
/// </example>
public class b2DistanceJointDef : b2JointDef
{
    /// <summary>Makes a definition of a rod of length 1 between the origins of two bodies.</summary>
    public b2DistanceJointDef()
        : base(b2Joint.e_distanceJoint)
    {
    }

    /// <summary>Anchor in the first body, metres. Default (0, 0).</summary>
    public b2Vec2 localAnchor1 { get; set; } = new b2Vec2();

    /// <summary>Anchor in the second body, metres. Default (0, 0).</summary>
    public b2Vec2 localAnchor2 { get; set; } = new b2Vec2();

    /// <summary>Distance of the anchors, metres; finite and 0 or more. Default 1.</summary>
    public float length { get; set; } = 1.0f;

    /// <summary>Frequency of a spring, Hz; 0, the default, is a rigid rod.</summary>
    public float frequencyHz { get; set; }

    /// <summary>Damping of the spring: 0 none, 1 critical. Default 0.</summary>
    public float dampingRatio { get; set; }

    /// <summary>Takes the bodies, and the anchors and their distance as they are now. Frequency and damping become 0.</summary>
    /// <param name="b1">First body.</param>
    /// <param name="b2">Second body.</param>
    /// <param name="anchor1">Anchor at the first body, in the world.</param>
    /// <param name="anchor2">Anchor at the second body, in the world.</param>
    /// <exception cref="System.ArgumentException">An argument is null or not finite.</exception>
    public void Initialize(b2Body b1, b2Body b2, b2Vec2 anchor1, b2Vec2 anchor2)
    {
        Check(b1, b2);
        Require.Vector(anchor1, nameof(anchor1));
        Require.Vector(anchor2, nameof(anchor2));
        body1 = b1;
        body2 = b2;
        localAnchor1 = b1.GetLocalPoint(anchor1);
        localAnchor2 = b2.GetLocalPoint(anchor2);
        length = b2Math.b2Distance(anchor1, anchor2);
        frequencyHz = 0;
        dampingRatio = 0;
    }

    internal override b2Joint Make(b2World world)
    {
        Require.Vector(localAnchor1, nameof(localAnchor1));
        Require.Vector(localAnchor2, nameof(localAnchor2));
        Require.NotNegative(length, nameof(length));
        Require.NotNegative(frequencyHz, nameof(frequencyHz));
        Require.NotNegative(dampingRatio, nameof(dampingRatio));
        return new b2DistanceJoint(this, world);
    }
}
