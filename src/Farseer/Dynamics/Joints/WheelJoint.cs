using System;
using System.Numerics;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// A wheel on a car: the second body turns freely about a point that moves, sprung, along an axis of the first.
/// <see cref="Joint.JointError"/> is its distance from the axis. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// var axle = new WheelJoint(body, second, second.Position, Vector2.UnitY)
/// {
///     Frequency = 4, DampingRatio = 0.7f, IsMotorEnabled = true, MotorSpeed = -20, MaxMotorTorque = 30,
/// };
/// simulator.Add(axle);
/// </code>
/// </example>
public class WheelJoint : AxisJoint
{
    private JointSpring _spring = new JointSpring { Frequency = 2, DampingRatio = 0.7f };

    /// <summary>Makes a joint; the spring is relaxed as the bodies stand.</summary>
    /// <param name="body1">The car.</param>
    /// <param name="body2">The wheel.</param>
    /// <param name="anchor">The hub, in world coordinates; finite.</param>
    /// <param name="axis">Direction of the spring, in world coordinates, of any length; finite and not (0, 0).</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public WheelJoint(Body body1, Body body2, Vector2 anchor, Vector2 axis)
        : base(body1, body2, anchor, axis)
    {
    }

    /// <summary>Frequency of the spring, hertz; at least 0. 0 makes the wheel slide freely. Default 2.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Frequency
    {
        get => _spring.Frequency;
        set
        {
            _spring.Frequency = Require.NotNegative(value, nameof(Frequency));
            Changed();
        }
    }

    /// <summary>Damping of the spring in terms of the critical one; at least 0. Default 0.7.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float DampingRatio
    {
        get => _spring.DampingRatio;
        set
        {
            _spring.DampingRatio = Require.NotNegative(value, nameof(DampingRatio));
            Changed();
        }
    }

    /// <summary>Largest torque of the motor; at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxMotorTorque
    {
        get => MaxEffort;
        set => MaxEffort = Require.NotNegative(value, nameof(MaxMotorTorque));
    }

    internal override JointKind? Kind => JointKind.Wheel;

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        base.Fill(ref settings, ref flags);
        _spring.Fill(ref settings, ref flags);
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _spring);
    }
}
