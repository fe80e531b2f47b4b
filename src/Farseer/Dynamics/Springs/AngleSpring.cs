using System;
using System.Numerics;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Springs;

/// <summary>
/// A torsion bar between two bodies: a torque of constant·(angle of body 2 − angle of body 1 − target angle), against each other,
/// and on each body a torque of −damping·(its own angular velocity).
/// </summary>
/// <example>
/// <code>
/// simulator.Add(new AngleSpring(body, second, springConstant: 20, dampingConstant: 1));
/// </code>
/// </example>
public class AngleSpring : Spring
{
    /// <summary>The original's number, with the quirk.</summary>
    private const float LargestTarget = 5.5f;

    private Body? _body1;
    private Body? _body2;
    private Vector2 _anchor1;
    private Vector2 _anchor2;
    private float _targetAngle;
    private bool _isTargetSet;
    private float _maxTorque = float.MaxValue;
    private float _torqueMultiplier = 1;

    /// <summary>Makes a spring without bodies; it does nothing until it has both.</summary>
    public AngleSpring()
    {
    }

    /// <summary>Makes a spring whose target angle is the present difference of the rotations.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="springConstant">Torque per radian; finite and at least 0.</param>
    /// <param name="dampingConstant">Torque per angular velocity; finite and at least 0.</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public AngleSpring(Body body1, Body body2, float springConstant, float dampingConstant)
    {
        _body1 = Require.NotNull(body1, nameof(body1));
        _body2 = Require.NotNull(body2, nameof(body2));
        SpringCheck.Distinct(body1, body2, nameof(body2));
        SpringConstant = Require.NotNegative(springConstant, nameof(springConstant));
        DampingConstant = Require.NotNegative(dampingConstant, nameof(dampingConstant));
        _targetAngle = (float)SpringLink.Angle(body1, body2);
    }

    /// <summary>First body.</summary>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    /// <exception cref="ArgumentException">The value is the other body.</exception>
    public Body? Body1
    {
        get => _body1;
        set
        {
            SpringCheck.Distinct(Require.NotNull(value, nameof(Body1)), _body2, nameof(Body1));
            _body1 = value;
        }
    }

    /// <summary>Second body.</summary>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    /// <exception cref="ArgumentException">The value is the other body.</exception>
    public Body? Body2
    {
        get => _body2;
        set
        {
            SpringCheck.Distinct(Require.NotNull(value, nameof(Body2)), _body1, nameof(Body2));
            _body2 = value;
        }
    }

    /// <summary>
    /// A point of <see cref="Body1"/>, in its coordinates, for drawing the spring: a torque is the same about every point.
    /// Default (0, 0).
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 Anchor1
    {
        get => _anchor1;
        set => _anchor1 = Require.Finite(value, nameof(Anchor1));
    }

    /// <summary>A point of <see cref="Body2"/>, as <see cref="Anchor1"/>. Default (0, 0).</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 Anchor2
    {
        get => _anchor2;
        set => _anchor2 = Require.Finite(value, nameof(Anchor2));
    }

    /// <summary>
    /// Angle without force, radians; finite. More than a turn is allowed, but for
    /// <see cref="Farseer201Quirks.AngleSpringTargetLimited"/>. Default that
    /// when it was made, or 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float TargetAngle
    {
        get
        {
            bool isLimited = _isTargetSet && _body2?.Simulator is { } simulator
                && (simulator.Quirks & Farseer201Quirks.AngleSpringTargetLimited) != 0;
            return isLimited ? Math.Min(Math.Max(_targetAngle, -LargestTarget), LargestTarget) : _targetAngle;
        }

        set
        {
            _targetAngle = Require.Finite(value, nameof(TargetAngle));
            _isTargetSet = true;
        }
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

    internal override Body? FirstBody => _body1;

    internal override Body? SecondBody => _body2;

    /// <inheritdoc />
    public override void Validate()
    {
        if (_body1 is { IsDisposed: true } || _body2 is { IsDisposed: true })
        {
            Dispose();
        }
    }

    /// <inheritdoc />
    public override void Update(float dt)
    {
        Require.NotNegative(dt, nameof(dt));
        if (_body1 is not null && _body2 is not null && Survives((float)(SpringLink.Angle(_body1, _body2) - TargetAngle)))
        {
            SpringLink.Angular(this, _body1, _body2, TargetAngle, _torqueMultiplier, _maxTorque);
        }
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Reference(ref _body1);
        s.Reference(ref _body2);
        s.Value(ref _anchor1);
        s.Value(ref _anchor2);
        s.Value(ref _targetAngle);
        s.Value(ref _isTargetSet);
        s.Value(ref _maxTorque);
        s.Value(ref _torqueMultiplier);
    }

    /// <inheritdoc/>
    internal override void VisitHidden(IHiddenFields fields)
    {
        base.VisitHidden(fields);
        fields.Value("targetAngle", ref _targetAngle);
        fields.Value("isTargetSet", ref _isTargetSet);
    }
}
