using System;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// Base class of the joints that leave a body one way to move in the world: the turn about a nail, the travel on a line. Limits can bound
/// it, and a motor can drive it. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// DrivenWorldJoint lift = new FixedPrismaticJoint(body, body.Position, Vector2.UnitY)
/// {
///     IsMotorEnabled = true, MotorSpeed = 1, AreLimitsEnabled = true, LowerLimit = 0, UpperLimit = 5,
/// };
/// simulator.Add(lift);
/// </code>
/// </example>
public abstract class DrivenWorldJoint : WorldJoint
{
    private JointDrive _drive;

    private protected DrivenWorldJoint()
    {
    }

    private protected DrivenWorldJoint(Body body)
        : base(body)
    {
    }

    /// <summary>
    /// True keeps the angle of the body since the joint was made, radians, or its travel on the line between the limits. Default false.
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
    /// Smallest value of the angle of the body since the joint was made, radians, or of its travel on the line; finite. Default 0.
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
    /// Largest value of the angle of the body since the joint was made, radians, or of its travel on the line; finite. Default 0.
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

    /// <summary>Wanted speed of the body, rad/s about a nail, length/s on a line; finite. Default 0.</summary>
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
