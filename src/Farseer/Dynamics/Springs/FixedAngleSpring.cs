using System;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Springs;

/// <summary>
/// A torsion bar between a body and the world: a torque of −constant·(angle of the body − target angle) − damping·(angular velocity).
/// </summary>
/// <example>
/// <code>
/// simulator.Add(new FixedAngleSpring(body, springConstant: 20, dampingConstant: 1));
/// </code>
/// </example>
public class FixedAngleSpring : Spring
{
    private Body? _body;
    private float _targetAngle;
    private float _maxTorque = float.MaxValue;
    private float _torqueMultiplier = 1;

    /// <summary>Makes a spring without a body; it does nothing until it has one.</summary>
    public FixedAngleSpring()
    {
    }

    /// <summary>Makes a spring whose target angle is the present rotation of the body.</summary>
    /// <param name="body">The body.</param>
    /// <param name="springConstant">Torque per radian; finite and at least 0.</param>
    /// <param name="dampingConstant">Torque per angular velocity; finite and at least 0.</param>
    /// <exception cref="ArgumentNullException"><paramref name="body"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedAngleSpring(Body body, float springConstant, float dampingConstant)
    {
        _body = Require.NotNull(body, nameof(body));
        SpringConstant = Require.NotNegative(springConstant, nameof(springConstant));
        DampingConstant = Require.NotNegative(dampingConstant, nameof(dampingConstant));
        _targetAngle = (float)SpringLink.Angle(null, body);
    }

    /// <summary>The body.</summary>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    public Body? Body
    {
        get => _body;
        set => _body = Require.NotNull(value, nameof(Body));
    }

    internal override Body? SecondBody => Body;

    /// <summary>Angle without force, radians; finite. More than a turn is allowed. Default: the angle when it was made, or 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float TargetAngle
    {
        get => _targetAngle;
        set => _targetAngle = Require.Finite(value, nameof(TargetAngle));
    }

    /// <summary>Largest torque on a body, after <see cref="TorqueMultiplier"/>; finite and at least 0. Default the largest float.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxTorque
    {
        get => _maxTorque;
        set => _maxTorque = Require.NotNegative(value, nameof(MaxTorque));
    }

    /// <summary>The torque of the spring is multiplied by it; finite and at least 0. Default 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float TorqueMultiplier
    {
        get => _torqueMultiplier;
        set => _torqueMultiplier = Require.NotNegative(value, nameof(TorqueMultiplier));
    }

    /// <inheritdoc />
    public override void Validate()
    {
        if (_body is { IsDisposed: true })
        {
            Dispose();
        }
    }

    /// <inheritdoc />
    public override void Update(float dt)
    {
        Require.NotNegative(dt, nameof(dt));
        if (_body is not null && Survives((float)(_targetAngle - SpringLink.Angle(null, _body))))
        {
            SpringLink.Angular(this, null, _body, _targetAngle, _torqueMultiplier, _maxTorque);
        }
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Reference(ref _body);
        s.Value(ref _targetAngle);
        s.Value(ref _maxTorque);
        s.Value(ref _torqueMultiplier);
    }
}
