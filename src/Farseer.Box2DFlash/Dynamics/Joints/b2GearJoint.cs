using System;
using System.ComponentModel;
using Box2D.Common.Math;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Box2D.Dynamics.Joints;

/// <summary>
/// Ties two joints, hinges or sliders: coordinate1 + ratio·coordinate2 is constant, where a coordinate is a hinge's angle or a
/// slider's translation. The ratio has the unit that this asks for. A gear goes with either of its joints.
/// </summary>
/// <example>
/// <code>
/// var gear = (b2GearJoint)world.CreateJoint(new b2GearJointDef
/// {
///     body1 = body, body2 = second, joint1 = hinge, joint2 = slide, ratio = 2,
/// });
/// </code>
/// </example>
public class b2GearJoint : b2Joint
{
    [NotState(Why.Fixed)]
    private readonly b2Joint _joint1;
    [NotState(Why.Fixed)]
    private readonly b2Joint _joint2;

    internal b2GearJoint(b2GearJointDef def, b2World world)
        : base(def, world, JointKind.Transmission, def.joint1!.GetBody2(), def.joint2!.GetBody2())
    {
        _joint1 = def.joint1!;
        _joint2 = def.joint2!;
        b2Vec2 local1 = Local(_joint1);
        b2Vec2 local2 = Local(_joint2);
        Link.SetAnchors(GetBody1().Link, local1.x, local1.y, GetBody2().Link, local2.x, local2.y);
        Motion(_joint1, local1, out double x1, out double y1, out double coordinate1);
        Motion(_joint2, local2, out double x2, out double y2, out double coordinate2);
        Link.Settings.GroundAX = x1;
        Link.Settings.GroundAY = y1;
        Link.Settings.GroundBX = x2;
        Link.Settings.GroundBY = y2;
        Link.Settings.Ratio = def.ratio;
        Link.Settings.Target = coordinate1 + (def.ratio * coordinate2);
    }

    internal b2Joint Joint1 => _joint1;

    internal b2Joint Joint2 => _joint2;

    /// <inheritdoc/>
    public override b2Vec2 GetAnchor1() => _joint1.GetAnchor2();

    /// <inheritdoc/>
    public override b2Vec2 GetAnchor2() => _joint2.GetAnchor2();

    /// <summary>The ratio.</summary>
    /// <returns>Not 0.</returns>
    public float GetRatio() => (float)Link.Settings.Ratio;

    internal override bool DependsOn(b2Joint joint) => ReferenceEquals(joint, _joint1) || ReferenceEquals(joint, _joint2);

    private static b2Vec2 Local(b2Joint joint) => joint.GetBody2().GetLocalPoint(joint.GetAnchor2());

    /// <summary>The axis of a slider in the world, zero for a hinge, and where it is along it or by what angle.</summary>
    private static void Motion(b2Joint joint, b2Vec2 local, out double x, out double y, out double coordinate)
    {
        if (joint is b2PrismaticJoint slider)
        {
            slider.Axis(out x, out y);
            joint.GetBody2().Link.ToWorld(local.x, local.y, out double worldX, out double worldY);
            coordinate = (x * worldX) + (y * worldY);
        }
        else
        {
            x = 0;
            y = 0;
            coordinate = joint.GetBody2().Link.Angle;
        }
    }

    /// <summary>A field of the original. Use <see cref="GetRatio"/> instead.</summary>
    [Obsolete("Use GetRatio().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_ratio => GetRatio();
}
