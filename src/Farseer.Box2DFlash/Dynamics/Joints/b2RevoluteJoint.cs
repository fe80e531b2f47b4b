using System;
using System.ComponentModel;
using Box2D.Bridge;
using Box2D.Common.Math;
using Farseer.Engine.Joints;

namespace Box2D.Dynamics.Joints;

/// <summary>
/// A hinge: two bodies share a point about which they turn. The joint angle grows when the second body turns counter-clockwise. It
/// may have limits and a motor; a motor of speed 0 is a friction.
/// </summary>
/// <example>
/// <code>
/// var def = new b2RevoluteJointDef { enableMotor = true, motorSpeed = 3, maxMotorTorque = 20 };
/// def.Initialize(body, second, body.GetWorldCenter());
/// var wheel = (b2RevoluteJoint)world.CreateJoint(def);
/// float angle = wheel.GetJointAngle();
/// </code>
/// </example>
public class b2RevoluteJoint : b2DrivenJoint
{
    private readonly double _reference;

    internal b2RevoluteJoint(b2RevoluteJointDef def, b2World world)
        : base(def, world, JointKind.Revolute, def.localAnchor1, def.localAnchor2)
    {
        _reference = def.referenceAngle;
        Link.Settings.Target = _reference;
        Limit(def.enableLimit, def.lowerAngle, def.upperAngle);
        Drive(def.enableMotor, def.motorSpeed, def.maxMotorTorque);
    }

    /// <summary>The torque on the second body in the last step, N·m: that of the limits and of the motor.</summary>
    /// <returns>Positive counter-clockwise.</returns>
    public override float GetReactionTorque()
    {
        if (!Link.Limit && !Link.Motor)
        {
            return 0;
        }

        bool limitOnly = (World.Quirks & Box2DFlash202Quirks.RevoluteTorqueOfLimitOnly) != 0;
        return Reactions.Of(limitOnly ? Link.LimitForce : Link.Torque);
    }

    /// <summary>The angle, radians, with all whole turns.</summary>
    /// <returns>0 where the joint was made.</returns>
    public float GetJointAngle() => (float)(GetBody2().Link.Angle - GetBody1().Link.Angle - _reference);

    /// <summary>The speed of the angle, rad/s.</summary>
    /// <returns>Positive when the second body turns counter-clockwise.</returns>
    public float GetJointSpeed() => GetBody2().Link.Spin - GetBody1().Link.Spin;

    /// <summary>Sets the largest torque of the motor.</summary>
    /// <param name="torque">N·m, finite and 0 or more.</param>
    /// <exception cref="System.ArgumentOutOfRangeException"><paramref name="torque"/> is negative or not finite.</exception>
    public void SetMaxMotorTorque(float torque)
    {
        SetMotorLimit(Require.NotNegative(torque, nameof(torque)));
    }

    /// <summary>The torque that the motor gave in the last substep, N·m.</summary>
    /// <returns>0 if it does not drive.</returns>
    public float GetMotorTorque() => Reactions.Of(Link.MotorForce);

    /// <summary>
    /// A field of the original. Use <see cref="b2DrivenJoint.GetLowerLimit"/> and <see cref="b2DrivenJoint.SetLimits"/> instead.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite, or the limits are not in order.</exception>
    [Obsolete("Use GetLowerLimit() and SetLimits.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_lowerAngle
    {
        get => GetLowerLimit();
        set => SetLimits(value, GetUpperLimit());
    }

    /// <summary>
    /// A field of the original. Use <see cref="b2DrivenJoint.GetUpperLimit"/> and <see cref="b2DrivenJoint.SetLimits"/> instead.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite, or the limits are not in order.</exception>
    [Obsolete("Use GetUpperLimit() and SetLimits.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_upperAngle
    {
        get => GetUpperLimit();
        set => SetLimits(GetLowerLimit(), value);
    }

    /// <summary>A field of the original: the largest torque. Use <see cref="SetMaxMotorTorque"/> instead.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    [Obsolete("Use SetMaxMotorTorque.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_maxMotorTorque
    {
        get => (float)Link.Settings.MotorLimit;
        set => SetMaxMotorTorque(value);
    }

    /// <summary>A field of the original: what <see cref="GetJointAngle"/> counts from.</summary>
    [Obsolete("Use GetJointAngle().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_referenceAngle => (float)_reference;
}
