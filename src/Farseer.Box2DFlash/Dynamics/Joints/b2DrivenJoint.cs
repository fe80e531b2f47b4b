using System;
using System.ComponentModel;
using Box2D.Bridge;
using Box2D.Common.Math;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Box2D.Dynamics.Joints;

/// <summary>
/// A joint that leaves one coordinate free, the angle of a hinge or the translation of a slider, and may limit it and drive it with a
/// motor. Version 2.0.2 writes these members out in both joints; old code finds them there as before.
/// </summary>
/// <example>
/// <code>
/// b2DrivenJoint motor = hinge;
/// motor.EnableMotor(true);
/// motor.SetMotorSpeed(2);
/// </code>
/// </example>
public abstract class b2DrivenJoint : b2Joint
{
    private protected b2DrivenJoint(b2JointDef def, b2World world, JointKind kind, b2Vec2 local1, b2Vec2 local2)
        : base(def, world, kind, def.body1!, def.body2!)
    {
        Local1 = local1.Copy();
        Local2 = local2.Copy();
        Link.SetAnchors(def.body1!.Link, Local1.x, Local1.y, def.body2!.Link, Local2.x, Local2.y);
    }

    /// <summary>The anchor in the first body.</summary>
    internal b2Vec2 Local1 { get; }

    /// <summary>The anchor in the second body.</summary>
    internal b2Vec2 Local2 { get; }

    /// <inheritdoc/>
    public override b2Vec2 GetAnchor1() => GetBody1().GetWorldPoint(Local1);

    /// <inheritdoc/>
    public override b2Vec2 GetAnchor2() => GetBody2().GetWorldPoint(Local2);

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
        Changed();
    }

    /// <summary>Smallest angle of a hinge, radians, or translation of a slider, metres.</summary>
    /// <returns>The limit.</returns>
    public float GetLowerLimit() => (float)Link.Settings.Lower;

    /// <summary>Largest angle of a hinge, radians, or translation of a slider, metres.</summary>
    /// <returns>The limit.</returns>
    public float GetUpperLimit() => (float)Link.Settings.Upper;

    /// <summary>Sets the limits.</summary>
    /// <param name="lower">Smallest angle, radians, or translation, metres; finite.</param>
    /// <param name="upper">Largest angle, radians, or translation, metres; finite and not below <paramref name="lower"/>.</param>
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
        Changed();
    }

    /// <summary>Sets the wanted speed; it may be called before every step.</summary>
    /// <param name="speed">rad/s for a hinge, m/s for a slider; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="speed"/> is not finite.</exception>
    public void SetMotorSpeed(float speed)
    {
        Link.Settings.MotorSpeed = Require.Finite(speed, nameof(speed));
        Changed();
    }

    /// <summary>The wanted speed, rad/s for a hinge, m/s for a slider.</summary>
    /// <returns>The speed.</returns>
    public float GetMotorSpeed() => (float)Link.Settings.MotorSpeed;

    private protected void Limit(bool isOn, float lower, float upper)
    {
        Link.Settings.Lower = lower;
        Link.Settings.Upper = upper;
        Link.Limit = isOn;
    }

    private protected void Drive(bool isOn, float speed, float limit)
    {
        Link.Settings.MotorSpeed = speed;
        Link.Settings.MotorLimit = limit;
        Link.Motor = isOn;
    }

    private protected void SetMotorLimit(float limit)
    {
        Link.Settings.MotorLimit = limit;
        Changed();
    }

    /// <summary>A field of the original. Use <see cref="IsLimitEnabled"/> and <see cref="EnableLimit"/> instead.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The limits are not in order.</exception>
    [Obsolete("Use IsLimitEnabled() and EnableLimit.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public bool m_enableLimit
    {
        get => IsLimitEnabled();
        set => EnableLimit(value);
    }

    /// <summary>A field of the original. Use <see cref="IsMotorEnabled"/> and <see cref="EnableMotor"/> instead.</summary>
    [Obsolete("Use IsMotorEnabled() and EnableMotor.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public bool m_enableMotor
    {
        get => IsMotorEnabled();
        set => EnableMotor(value);
    }

    /// <summary>A field of the original. Use <see cref="GetMotorSpeed"/> and <see cref="SetMotorSpeed"/> instead.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    [Obsolete("Use GetMotorSpeed() and SetMotorSpeed.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_motorSpeed
    {
        get => GetMotorSpeed();
        set => SetMotorSpeed(value);
    }

    /// <summary>A field of the original: the anchor in the first body. It returns a copy.</summary>
    [Obsolete("Use GetAnchor1() and GetLocalPoint of the body.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Vec2 m_localAnchor1 => Local1.Copy();

    /// <summary>A field of the original: the anchor in the second body. It returns a copy.</summary>
    [Obsolete("Use GetAnchor2() and GetLocalPoint of the body.")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Vec2 m_localAnchor2 => Local2.Copy();

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        Local1.Visit(s);
        Local2.Visit(s);
    }
}
