using System;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// Turns a body to <see cref="TargetAngle"/>: each update takes away the share <see cref="Joint.BiasFactor"/> of what is missing.
/// <see cref="Joint.JointError"/> is the angle of the body less the target, radians; angles count whole turns.
/// </summary>
/// <example>
/// <code>
/// simulator.Add(new FixedAngleJoint(body) { TargetAngle = 0, MaxImpulse = 10 });
/// </code>
/// </example>
public class FixedAngleJoint : WorldJoint
{
    private float _targetAngle;
    private float _maxImpulse = float.MaxValue;

    /// <summary>Makes a joint without a body: set it before it is added.</summary>
    public FixedAngleJoint()
    {
    }

    /// <summary>Makes a joint with target angle 0.</summary>
    /// <param name="body">The body.</param>
    /// <exception cref="ArgumentNullException"><paramref name="body"/> is null.</exception>
    public FixedAngleJoint(Body body)
        : base(body)
    {
    }

    /// <summary>Makes a joint.</summary>
    /// <param name="body">The body.</param>
    /// <param name="targetAngle">Wanted angle, radians; finite.</param>
    /// <exception cref="ArgumentNullException"><paramref name="body"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="targetAngle"/> is not finite.</exception>
    public FixedAngleJoint(Body body, float targetAngle)
        : base(body) => _targetAngle = Require.Finite(targetAngle, nameof(targetAngle));

    /// <summary>Wanted angle, radians; finite. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float TargetAngle
    {
        get => _targetAngle;
        set
        {
            _targetAngle = Require.Finite(value, nameof(TargetAngle));
            Changed();
        }
    }

    /// <summary>
    /// Largest impulse that the joint gives in one of the <see cref="PhysicsSimulator.Iterations"/> of an update; at least 0.
    /// Default <see cref="float.MaxValue"/>: as much as it takes.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxImpulse
    {
        get => _maxImpulse;
        set
        {
            _maxImpulse = Require.NotNegative(value, nameof(MaxImpulse));
            Changed();
        }
    }

    internal override JointKind? Kind => JointKind.Angle;

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        settings.Target = _targetAngle;
        settings.MaxImpulse = Bound(_maxImpulse);
        settings.Softness = Math.Min(1, settings.Softness);
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _targetAngle);
        s.Value(ref _maxImpulse);
    }
}
