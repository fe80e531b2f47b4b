using System;
using System.Numerics;
using Farseer.Engine.Joints;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// A wheel on a car: the second body turns freely about a point that moves, sprung, along an axis of the first.
/// <see cref="Joint.JointError"/> is its distance from the axis. (An addition to the original.)
/// </summary>
public class WheelJoint : PairJoint
{
    private readonly double _x1;
    private readonly double _y1;
    private readonly double _x2;
    private readonly double _y2;
    private readonly double _axisX;
    private readonly double _axisY;
    private float _frequency = 2;
    private float _dampingRatio = 0.7f;
    private bool _limited;
    private float _lower;
    private float _upper;
    private bool _motor;
    private float _motorSpeed;
    private float _maxMotor;

    /// <summary>Makes a joint; the spring is relaxed as the bodies stand.</summary>
    /// <param name="body1">The car.</param>
    /// <param name="body2">The wheel.</param>
    /// <param name="anchor">The hub, in world coordinates; finite.</param>
    /// <param name="axis">Direction of the spring, in world coordinates, of any length; finite and not (0, 0).</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public WheelJoint(Body body1, Body body2, Vector2 anchor, Vector2 axis)
        : base(body1, body2)
    {
        Require.Finite(anchor, nameof(anchor));
        Require.Direction(axis, nameof(axis));
        JointAttachment.ToLocal(body1, anchor, out _x1, out _y1);
        JointAttachment.ToLocal(body2, anchor, out _x2, out _y2);
        JointAttachment.ToLocalAxis(body1, axis, out _axisX, out _axisY);
    }

    /// <summary>Frequency of the spring, hertz; at least 0. 0 makes the wheel slide freely. Default 2.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Frequency
    {
        get => _frequency;
        set
        {
            _frequency = Require.NotNegative(value, nameof(Frequency));
            Changed();
        }
    }

    /// <summary>Damping of the spring in terms of the critical one; at least 0. Default 0.7.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float DampingRatio
    {
        get => _dampingRatio;
        set
        {
            _dampingRatio = Require.NotNegative(value, nameof(DampingRatio));
            Changed();
        }
    }

    /// <summary>True keeps the travel of the wheel along the axis between the limits. Default false.</summary>
    public bool AreLimitsEnabled
    {
        get => _limited;
        set
        {
            _limited = value;
            Changed();
        }
    }

    /// <summary>Smallest value of the travel of the wheel along the axis; finite. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float LowerLimit
    {
        get => _lower;
        set
        {
            _lower = Require.Finite(value, nameof(LowerLimit));
            Changed();
        }
    }

    /// <summary>Largest value of the travel of the wheel along the axis; finite. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float UpperLimit
    {
        get => _upper;
        set
        {
            _upper = Require.Finite(value, nameof(UpperLimit));
            Changed();
        }
    }

    /// <summary>True lets a motor drive the joint. Default false.</summary>
    public bool IsMotorEnabled
    {
        get => _motor;
        set
        {
            _motor = value;
            Changed();
        }
    }

    /// <summary>Wanted speed, rad/s; finite. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float MotorSpeed
    {
        get => _motorSpeed;
        set
        {
            _motorSpeed = Require.Finite(value, nameof(MotorSpeed));
            Changed();
        }
    }

    /// <summary>Largest torque of the motor; at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxMotorTorque
    {
        get => _maxMotor;
        set
        {
            _maxMotor = Require.NotNegative(value, nameof(MaxMotorTorque));
            Changed();
        }
    }

    /// <summary>The axis as the first body has turned it, in world coordinates.</summary>
    internal Vector2 Axis => ((float)_axisX * Body1.XVectorInWorldCoordinates) + ((float)_axisY * Body1.YVectorInWorldCoordinates);

    internal override JointKind? Kind => JointKind.Wheel;

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        settings.AnchorAX = _x1;
        settings.AnchorAY = _y1;
        settings.AnchorBX = _x2;
        settings.AnchorBY = _y2;
        settings.AxisX = _axisX;
        settings.AxisY = _axisY;
        settings.Frequency = _frequency;
        settings.DampingRatio = _dampingRatio;
        flags |= _frequency > 0 ? JointFlags.Spring : JointFlags.None;
        settings.Lower = _lower;
        settings.Upper = _upper;
        flags |= _limited ? JointFlags.Limit : JointFlags.None;
        settings.MotorSpeed = _motorSpeed;
        settings.MotorLimit = Bound(_maxMotor);
        flags |= _motor ? JointFlags.Motor : JointFlags.None;
    }
}
