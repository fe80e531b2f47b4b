using System;
using System.ComponentModel;
using Box2D.Bridge;
using Box2D.Common.Math;
using Farseer.Engine.Joints;

namespace Box2D.Dynamics.Joints;

/// <summary>A slider: the second body moves along an axis of the first and does not turn against it.</summary>
/// <example>
/// <code>
/// var def = new b2PrismaticJointDef { enableMotor = true, motorSpeed = 1, maxMotorForce = 500 };
/// def.Initialize(world.GetGroundBody(), body, body.GetWorldCenter(), new b2Vec2(0, -1));
/// var lift = (b2PrismaticJoint)world.CreateJoint(def);
/// float way = lift.GetJointTranslation();
/// </code>
/// </example>
public class b2PrismaticJoint : b2DrivenJoint
{
    internal b2PrismaticJoint(b2PrismaticJointDef def, b2World world)
        : base(def, world, JointKind.Prismatic, def.localAnchor1, def.localAnchor2)
    {
        double length = Math.Sqrt(((double)def.localAxis1.x * def.localAxis1.x) + ((double)def.localAxis1.y * def.localAxis1.y));
        Link.Settings.AxisX = def.localAxis1.x / length;
        Link.Settings.AxisY = def.localAxis1.y / length;
        Link.Settings.Target = def.referenceAngle;
        Limit(def.enableLimit, def.lowerTranslation, def.upperTranslation);
        Drive(def.enableMotor, def.motorSpeed, def.maxMotorForce);
    }

    internal double LocalX2 => Local2.x;

    internal double LocalY2 => Local2.y;

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
        double forceX = (along * along * x) - (across * across * y);
        double forceY = (along * along * y) + (across * across * x);
        return new b2Vec2(Reactions.Of(forceX), Reactions.Of(forceY));
    }

    /// <summary>The distance that the second body has slid along the axis, metres.</summary>
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
        Arm(a, Local1, out double ax, out double ay);
        Arm(b, Local2, out double bx, out double by);
        double vx = b.Velocity.X - (b.Spin * by) - a.Velocity.X + (a.Spin * ay);
        double vy = b.Velocity.Y + (b.Spin * bx) - a.Velocity.Y - (a.Spin * ax);

        // The axis turns with the first body.
        return (float)((x * vx) + (y * vy) + (a.Spin * ((dy * x) - (dx * y))));
    }

    /// <summary>Sets the largest force of the motor.</summary>
    /// <param name="force">Newtons, finite and 0 or more.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="force"/> is negative or not finite.</exception>
    public void SetMaxMotorForce(float force)
    {
        SetMotorLimit(Require.NotNegative(force, nameof(force)));
    }

    /// <summary>The force that the motor gave in the last substep, newtons.</summary>
    /// <returns>0 if it does not drive.</returns>
    public float GetMotorForce() => Reactions.Of(Link.MotorForce);

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
        GetBody1().Link.ToWorld(Local1.x, Local1.y, out double x1, out double y1);
        GetBody2().Link.ToWorld(Local2.x, Local2.y, out double x2, out double y2);
        dx = x2 - x1;
        dy = y2 - y1;
    }

    /// <summary>
    /// A field of the original. Use <see cref="b2DrivenJoint.GetLowerLimit"/> and <see cref="b2DrivenJoint.SetLimits"/> instead.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite, or the limits are not in order.</exception>
    [Obsolete("Use GetLowerLimit() and SetLimits.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_lowerTranslation
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
    public float m_upperTranslation
    {
        get => GetUpperLimit();
        set => SetLimits(GetLowerLimit(), value);
    }

    /// <summary>A name of the manual: <see cref="SetMaxMotorForce"/>.</summary>
    /// <param name="force">Newtons, finite and 0 or more.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="force"/> is negative or not finite.</exception>
    [Obsolete("Use SetMaxMotorForce.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public void SetMotorForce(float force) => SetMaxMotorForce(force);

    /// <summary>A field of the original: the largest force. Use <see cref="SetMaxMotorForce"/> instead.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    [Obsolete("Use SetMaxMotorForce.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_maxMotorForce
    {
        get => (float)Link.Settings.MotorLimit;
        set => SetMaxMotorForce(value);
    }
}
