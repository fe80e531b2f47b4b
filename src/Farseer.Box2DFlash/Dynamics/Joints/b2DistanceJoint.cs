using Box2D.Common.Math;
using Farseer.Engine.Joints;

namespace Box2D.Dynamics.Joints;

/// <summary>Keeps two points of two bodies at one distance, as a rod or as a spring.</summary>
public class b2DistanceJoint : b2Joint
{
    private readonly b2Vec2 _local1;
    private readonly b2Vec2 _local2;

    internal b2DistanceJoint(b2DistanceJointDef def, b2World world)
        : base(def, world, JointKind.Distance, def.body1!, def.body2!)
    {
        _local1 = def.localAnchor1.Copy();
        _local2 = def.localAnchor2.Copy();
        Link.SetAnchors(def.body1!.Link, _local1.x, _local1.y, def.body2!.Link, _local2.x, _local2.y);
        Link.Settings.Target = def.length;
        Link.Settings.Frequency = def.frequencyHz;
        Link.Settings.DampingRatio = def.dampingRatio;
        Link.Spring = def.frequencyHz > 0;
    }

    /// <inheritdoc/>
    public override b2Vec2 GetAnchor1() => GetBody1().GetWorldPoint(_local1);

    /// <inheritdoc/>
    public override b2Vec2 GetAnchor2() => GetBody2().GetWorldPoint(_local2);

    /// <summary>Always 0: a rod transmits no torque.</summary>
    /// <returns>0.</returns>
    public override float GetReactionTorque() => 0;
}
