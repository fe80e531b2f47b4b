using System;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// Base class of the joints that leave the second body one way to move against the first: the turn of a hinge, the travel of a slide or of
/// a wheel's hub. Limits can bound it, and a motor can drive it. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// DrivenPairJoint motor = new RevoluteJoint(body, second, body.Position) { IsMotorEnabled = true, MotorSpeed = 3 };
/// simulator.Add(motor);
/// </code>
/// </example>
public abstract class DrivenPairJoint : PairJoint
{
    private JointDrive _drive;

    private protected DrivenPairJoint()
    {
    }

    private protected DrivenPairJoint(Body body1, Body body2)
        : base(body1, body2)
    {
    }

    /// <summary>
    /// True keeps the angle of a hinge since it was made, radians, or the travel along an axis between the limits. Default false.
    /// </summary>
    public bool AreLimitsEnabled
    {
        get => _drive.IsLimited;
        set
        {
            _drive.IsLimited = value;
            Changed();
        }
    }

    /// <summary>
    /// Smallest value of the angle of a hinge since it was made, radians, or of the travel along an axis; finite. Default 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float LowerLimit
    {
        get => _drive.Lower;
        set
        {
            _drive.Lower = Require.Finite(value, nameof(LowerLimit));
            Changed();
        }
    }

    /// <summary>
    /// Largest value of the angle of a hinge since it was made, radians, or of the travel along an axis; finite. Default 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float UpperLimit
    {
        get => _drive.Upper;
        set
        {
            _drive.Upper = Require.Finite(value, nameof(UpperLimit));
            Changed();
        }
    }

    /// <summary>True lets a motor drive the joint. Default false.</summary>
    public bool IsMotorEnabled
    {
        get => _drive.IsDriven;
        set
        {
            _drive.IsDriven = value;
            Changed();
        }
    }

    /// <summary>
    /// Wanted speed of the second body against the first, rad/s for a hinge or a wheel, length/s for a slide; finite. Default 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float MotorSpeed
    {
        get => _drive.Speed;
        set
        {
            _drive.Speed = Require.Finite(value, nameof(MotorSpeed));
            Changed();
        }
    }

    /// <summary>Largest torque or force of the motor.</summary>
    private protected float MaxEffort
    {
        get => _drive.MaxEffort;
        set
        {
            _drive.MaxEffort = value;
            Changed();
        }
    }

    internal override void Fill(ref JointSettings settings, ref JointFlags flags) => _drive.Fill(ref settings, ref flags);

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _drive);
    }
}
