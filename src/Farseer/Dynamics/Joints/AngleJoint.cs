using System;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// Turns two bodies until the angle of the second less that of the first is <see cref="TargetAngle"/>, without a snap: each update
/// takes away the share <see cref="Joint.BiasFactor"/> of what is missing. <see cref="Joint.JointError"/> is that angle less the target,
/// radians; angles count whole turns.
/// </summary>
/// <example>
/// <code>
/// simulator.Add(new AngleJoint(body, second) { TargetAngle = 0.5f });
/// </code>
/// </example>
public class AngleJoint : PairJoint
{
    private float _targetAngle;
    private float _maxImpulse = float.MaxValue;

    /// <summary>Makes a joint without bodies: set them before it is added.</summary>
    public AngleJoint()
    {
    }

    /// <summary>Makes a joint with target angle 0.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    public AngleJoint(Body body1, Body body2)
        : base(body1, body2)
    {
    }

    /// <summary>Makes a joint.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="targetAngle">Wanted angle, radians; finite.</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="targetAngle"/> is not finite.</exception>
    public AngleJoint(Body body1, Body body2, float targetAngle)
        : base(body1, body2) => _targetAngle = Require.Finite(targetAngle, nameof(targetAngle));

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
