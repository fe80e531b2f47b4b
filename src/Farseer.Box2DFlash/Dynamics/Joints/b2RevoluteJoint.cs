using Box2D.Bridge;
using Box2D.Common.Math;
using Farseer.Engine.Joints;

namespace Box2D.Dynamics.Joints;

/// <summary>
/// A hinge: two bodies share a point about which they turn. The joint angle grows when the second body turns counter-clockwise. It
/// may have limits and a motor; a motor of speed 0 is a friction.
/// </summary>
public class b2RevoluteJoint : b2Joint
{
    private readonly b2Vec2 _local1;
    private readonly b2Vec2 _local2;
    private readonly double _reference;

    internal b2RevoluteJoint(b2RevoluteJointDef def, b2World world)
        : base(def, world, JointKind.Revolute, def.body1!, def.body2!)
    {
        _local1 = def.localAnchor1.Copy();
        _local2 = def.localAnchor2.Copy();
        _reference = def.referenceAngle;
        Link.SetAnchors(def.body1!.Link, _local1.x, _local1.y, def.body2!.Link, _local2.x, _local2.y);
        Link.Settings.Target = _reference;
        Link.Settings.Lower = def.lowerAngle;
        Link.Settings.Upper = def.upperAngle;
        Link.Settings.MotorSpeed = def.motorSpeed;
        Link.Settings.MotorLimit = def.maxMotorTorque;
        Link.Limit = def.enableLimit;
        Link.Motor = def.enableMotor;
    }

    /// <inheritdoc/>
    public override b2Vec2 GetAnchor1() => GetBody1().GetWorldPoint(_local1);

    /// <inheritdoc/>
    public override b2Vec2 GetAnchor2() => GetBody2().GetWorldPoint(_local2);

    /// <summary>The torque on the second body in the last step, N·m: that of the limits and of the motor.</summary>
    /// <returns>Positive counter-clockwise.</returns>
    public override float GetReactionTorque()
    {
        if (!Link.Limit && !Link.Motor)
        {
            return 0;
        }

        return (World.Quirks & Box2DFlash202Quirks.RevoluteTorqueOfLimitOnly) != 0 ? (float)Link.LimitForce : (float)Link.Torque;
    }

    /// <summary>The angle, radians, with all whole turns.</summary>
    /// <returns>0 where the joint was made.</returns>
    public float GetJointAngle() => (float)(GetBody2().Link.Angle - GetBody1().Link.Angle - _reference);

    /// <summary>The speed of the angle, rad/s.</summary>
    /// <returns>Positive when the second body turns counter-clockwise.</returns>
    public float GetJointSpeed() => GetBody2().Link.Spin - GetBody1().Link.Spin;

    /// <summary>Whether the limits hold.</summary>
    /// <returns>The flag.</returns>
    public bool IsLimitEnabled() => Link.Limit;

    /// <summary>Switches the limits.</summary>
    /// <param name="flag">True lets them hold.</param>
    /// <exception cref="System.ArgumentOutOfRangeException">The limits are not in order.</exception>
    public void EnableLimit(bool flag)
    {
        LimitCheck.Ordered(GetLowerLimit(), GetUpperLimit(), "lower", "upper", flag);
        Link.Limit = flag;
        WakeBySetter();
    }

    /// <summary>Least angle, radians.</summary>
    /// <returns>The limit.</returns>
    public float GetLowerLimit() => (float)Link.Settings.Lower;

    /// <summary>Greatest angle, radians.</summary>
    /// <returns>The limit.</returns>
    public float GetUpperLimit() => (float)Link.Settings.Upper;

    /// <summary>Sets the limits.</summary>
    /// <param name="lower">Least angle, radians; finite.</param>
    /// <param name="upper">Greatest angle, radians; finite and not below <paramref name="lower"/>.</param>
    /// <exception cref="System.ArgumentOutOfRangeException">A limit is not finite, or they are not in order.</exception>
    public void SetLimits(float lower, float upper)
    {
        LimitCheck.Ordered(lower, upper, nameof(lower), nameof(upper), true);
        Link.Settings.Lower = lower;
        Link.Settings.Upper = upper;
        Changed();
    }

    /// <summary>Whether the motor drives.</summary>
    /// <returns>The flag.</returns>
    public bool IsMotorEnabled() => Link.Motor;

    /// <summary>Switches the motor.</summary>
    /// <param name="flag">True lets it drive.</param>
    public void EnableMotor(bool flag)
    {
        Link.Motor = flag;
        WakeBySetter();
    }

    /// <summary>Sets the wanted speed; it may be called before every step.</summary>
    /// <param name="speed">rad/s, finite.</param>
    /// <exception cref="System.ArgumentOutOfRangeException"><paramref name="speed"/> is not finite.</exception>
    public void SetMotorSpeed(float speed)
    {
        Link.Settings.MotorSpeed = Require.Finite(speed, nameof(speed));
        Changed();
    }

    /// <summary>The wanted speed, rad/s.</summary>
    /// <returns>The speed.</returns>
    public float GetMotorSpeed() => (float)Link.Settings.MotorSpeed;

    /// <summary>Sets the largest torque of the motor.</summary>
    /// <param name="torque">N·m, finite and 0 or more.</param>
    /// <exception cref="System.ArgumentOutOfRangeException"><paramref name="torque"/> is negative or not finite.</exception>
    public void SetMaxMotorTorque(float torque)
    {
        Link.Settings.MotorLimit = Require.NotNegative(torque, nameof(torque));
        Changed();
    }

    /// <summary>The torque that the motor gave in the last substep, N·m.</summary>
    /// <returns>0 if it does not drive.</returns>
    public float GetMotorTorque() => (float)Link.MotorForce;
}
