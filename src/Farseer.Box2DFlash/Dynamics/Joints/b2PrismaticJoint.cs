using System;
using Box2D.Bridge;
using Box2D.Common.Math;
using Farseer.Engine.Joints;

namespace Box2D.Dynamics.Joints;

/// <summary>A slider: the second body moves along an axis of the first and does not turn against it.</summary>
public class b2PrismaticJoint : b2Joint
{
    private readonly b2Vec2 _local1;
    private readonly b2Vec2 _local2;

    internal b2PrismaticJoint(b2PrismaticJointDef def, b2World world)
        : base(def, world, JointKind.Prismatic, def.body1!, def.body2!)
    {
        _local1 = def.localAnchor1.Copy();
        _local2 = def.localAnchor2.Copy();
        Link.SetAnchors(def.body1!.Link, _local1.x, _local1.y, def.body2!.Link, _local2.x, _local2.y);
        double length = Math.Sqrt(((double)def.localAxis1.x * def.localAxis1.x) + ((double)def.localAxis1.y * def.localAxis1.y));
        Link.Settings.AxisX = def.localAxis1.x / length;
        Link.Settings.AxisY = def.localAxis1.y / length;
        Link.Settings.Target = def.referenceAngle;
        Link.Settings.Lower = def.lowerTranslation;
        Link.Settings.Upper = def.upperTranslation;
        Link.Settings.MotorSpeed = def.motorSpeed;
        Link.Settings.MotorLimit = def.maxMotorForce;
        Link.Limit = def.enableLimit;
        Link.Motor = def.enableMotor;
    }

    internal double LocalX2 => _local2.x;

    internal double LocalY2 => _local2.y;

    /// <inheritdoc/>
    public override b2Vec2 GetAnchor1() => GetBody1().GetWorldPoint(_local1);

    /// <inheritdoc/>
    public override b2Vec2 GetAnchor2() => GetBody2().GetWorldPoint(_local2);

    /// <summary>The force on the second body at its anchor in the last step, newtons.</summary>
    /// <returns>A new vector.</returns>
    public override b2Vec2 GetReactionForce()
    {
        if ((World.Quirks & Box2DFlash202Quirks.PrismaticForceSquared) == 0)
        {
            return base.GetReactionForce();
        }

        Axis(out double x, out double y);
        double along = (Link.ForceX * x) + (Link.ForceY * y);
        double across = (Link.ForceY * x) - (Link.ForceX * y);
        return new b2Vec2((float)((along * along * x) - (across * across * y)), (float)((along * along * y) + (across * across * x)));
    }

    /// <summary>How far the second body has slid along the axis, metres.</summary>
    /// <returns>0 where the joint was made.</returns>
    public float GetJointTranslation()
    {
        Reach(out double dx, out double dy);
        Axis(out double x, out double y);
        return (float)((dx * x) + (dy * y));
    }

    /// <summary>The speed of the translation, m/s.</summary>
    /// <returns>Positive along the axis.</returns>
    public float GetJointSpeed()
    {
        BodyLink a = GetBody1().Link;
        BodyLink b = GetBody2().Link;
        Reach(out double dx, out double dy);
        Axis(out double x, out double y);
        Arm(a, _local1, out double ax, out double ay);
        Arm(b, _local2, out double bx, out double by);
        double vx = b.Velocity.X - (b.Spin * by) - a.Velocity.X + (a.Spin * ay);
        double vy = b.Velocity.Y + (b.Spin * bx) - a.Velocity.Y - (a.Spin * ax);

        // The axis turns with the first body.
        return (float)((x * vx) + (y * vy) + (a.Spin * ((dy * x) - (dx * y))));
    }

    /// <summary>Whether the limits hold.</summary>
    /// <returns>The flag.</returns>
    public bool IsLimitEnabled() => Link.Limit;

    /// <summary>Switches the limits.</summary>
    /// <param name="flag">True lets them hold.</param>
    /// <exception cref="ArgumentOutOfRangeException">The limits are not in order.</exception>
    public void EnableLimit(bool flag)
    {
        LimitCheck.Ordered(GetLowerLimit(), GetUpperLimit(), "lower", "upper", flag);
        Link.Limit = flag;
        WakeBySetter();
    }

    /// <summary>Least translation, metres.</summary>
    /// <returns>The limit.</returns>
    public float GetLowerLimit() => (float)Link.Settings.Lower;

    /// <summary>Greatest translation, metres.</summary>
    /// <returns>The limit.</returns>
    public float GetUpperLimit() => (float)Link.Settings.Upper;

    /// <summary>Sets the limits.</summary>
    /// <param name="lower">Least translation, metres; finite.</param>
    /// <param name="upper">Greatest translation, metres; finite and not below <paramref name="lower"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A limit is not finite, or they are not in order.</exception>
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

    /// <summary>Sets the wanted speed.</summary>
    /// <param name="speed">m/s, finite.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="speed"/> is not finite.</exception>
    public void SetMotorSpeed(float speed)
    {
        Link.Settings.MotorSpeed = Require.Finite(speed, nameof(speed));
        Changed();
    }

    /// <summary>The wanted speed, m/s.</summary>
    /// <returns>The speed.</returns>
    public float GetMotorSpeed() => (float)Link.Settings.MotorSpeed;

    /// <summary>Sets the largest force of the motor.</summary>
    /// <param name="force">Newtons, finite and 0 or more.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="force"/> is negative or not finite.</exception>
    public void SetMaxMotorForce(float force)
    {
        Link.Settings.MotorLimit = Require.NotNegative(force, nameof(force));
        Changed();
    }

    /// <summary>The force that the motor gave in the last substep, newtons.</summary>
    /// <returns>0 if it does not drive.</returns>
    public float GetMotorForce() => (float)Link.MotorForce;

    internal void Axis(out double x, out double y)
    {
        BodyLink a = GetBody1().Link;
        x = (a.Cos * Link.Settings.AxisX) - (a.Sin * Link.Settings.AxisY);
        y = (a.Sin * Link.Settings.AxisX) + (a.Cos * Link.Settings.AxisY);
    }

    private static void Arm(BodyLink body, b2Vec2 local, out double x, out double y)
    {
        body.ToWorld(local.x, local.y, out double worldX, out double worldY);
        body.Arm(worldX, worldY, out x, out y);
    }

    /// <summary>From the anchor of the first body to that of the second.</summary>
    private void Reach(out double dx, out double dy)
    {
        GetBody1().Link.ToWorld(_local1.x, _local1.y, out double x1, out double y1);
        GetBody2().Link.ToWorld(_local2.x, _local2.y, out double x2, out double y2);
        dx = x2 - x1;
        dy = y2 - y1;
    }
}
