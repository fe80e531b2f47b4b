using Box2D.Bridge;
using System;
using System.ComponentModel;
using Box2D.Common.Math;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Box2D.Dynamics.Joints;

/// <summary>
/// A rope over two points of the world that holds two bodies: length1 + ratio·length2 does not grow. It pulls and does not push.
/// </summary>
/// <example>
/// <code>
/// var def = new b2PulleyJointDef();
/// def.Initialize(body, second, new b2Vec2(-2, -8), new b2Vec2(2, -8), body.GetWorldCenter(), second.GetWorldCenter(), 1);
/// var pulley = (b2PulleyJoint)world.CreateJoint(def);
/// float rope = pulley.GetLength1();
/// </code>
/// </example>
public class b2PulleyJoint : b2Joint
{
    /// <summary>Shortest side that the largest lengths leave, metres.</summary>
    public const float b2_minPulleyLength = 2.0f;

    private readonly b2Vec2 _local1;
    private readonly b2Vec2 _local2;
    private readonly b2Vec2 _ground1;
    private readonly b2Vec2 _ground2;

    internal b2PulleyJoint(b2PulleyJointDef def, b2World world)
        : base(def, world, JointKind.Pulley, def.body1!, def.body2!)
    {
        _local1 = def.localAnchor1.Copy();
        _local2 = def.localAnchor2.Copy();
        _ground1 = def.groundAnchor1.Copy();
        _ground2 = def.groundAnchor2.Copy();
        Link.SetAnchors(def.body1!.Link, _local1.x, _local1.y, def.body2!.Link, _local2.x, _local2.y);
        double total = def.length1 + ((double)def.ratio * def.length2);
        Link.Settings.GroundAX = _ground1.x;
        Link.Settings.GroundAY = _ground1.y;
        Link.Settings.GroundBX = _ground2.x;
        Link.Settings.GroundBY = _ground2.y;
        Link.Settings.Ratio = def.ratio;
        Link.Settings.Target = total;
        Link.Settings.Upper = Math.Min(def.maxLength1, total - (def.ratio * b2_minPulleyLength));
        Link.Settings.Lower = Math.Min(def.maxLength2, (total - b2_minPulleyLength) / def.ratio);
        Link.Limit = true;
    }

    internal b2Vec2 Local1 => _local1;

    internal b2Vec2 Local2 => _local2;

    /// <inheritdoc/>
    public override b2Vec2 GetAnchor1() => GetBody1().GetWorldPoint(_local1);

    /// <inheritdoc/>
    public override b2Vec2 GetAnchor2() => GetBody2().GetWorldPoint(_local2);

    /// <summary>The point over which the first side runs.</summary>
    /// <returns>A new vector.</returns>
    public b2Vec2 GetGroundAnchor1() => _ground1.Copy();

    /// <summary>The point over which the second side runs.</summary>
    /// <returns>A new vector.</returns>
    public b2Vec2 GetGroundAnchor2() => _ground2.Copy();

    /// <summary>The force of the rope on the second body in the last step, newtons.</summary>
    /// <returns>A new vector.</returns>
    public override b2Vec2 GetReactionForce()
    {
        if ((World.Quirks & Box2DFlash202Quirks.PulleyForceSign) == 0)
        {
            return base.GetReactionForce();
        }

        b2Vec2 direction = b2Math.SubtractVV(GetAnchor2(), _ground2);
        direction.Normalize();
        direction.Multiply(Reactions.Of(Link.RowForce(0)));
        return direction;
    }

    /// <summary>Always 0: a rope transmits no torque.</summary>
    /// <returns>0.</returns>
    public override float GetReactionTorque() => 0;

    /// <summary>The length of the first side now, metres.</summary>
    /// <returns>0 or more.</returns>
    public float GetLength1() => b2Math.b2Distance(GetAnchor1(), _ground1);

    /// <summary>The length of the second side now, metres.</summary>
    /// <returns>0 or more.</returns>
    public float GetLength2() => b2Math.b2Distance(GetAnchor2(), _ground2);

    /// <summary>How the sides share the rope.</summary>
    /// <returns>Above 0.</returns>
    public float GetRatio() => (float)Link.Settings.Ratio;

    /// <summary>A field of the original. Use <see cref="GetRatio"/> instead.</summary>
    [Obsolete("Use GetRatio().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_ratio => GetRatio();

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        _local1.Visit(s);
        _local2.Visit(s);
        _ground1.Visit(s);
        _ground2.Visit(s);
    }
}
