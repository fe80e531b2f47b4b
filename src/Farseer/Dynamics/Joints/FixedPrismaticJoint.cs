using System;
using System.Numerics;
using Farseer.Engine.Joints;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// A slide in the world: the body moves along a line and cannot turn. <see cref="Joint.JointError"/> is its distance from the line. (An addition to the original.)
/// </summary>
public class FixedPrismaticJoint : WorldJoint
{
    private readonly Vector2 _anchor;
    private readonly double _x;
    private readonly double _y;
    private readonly double _startAngle;
    private readonly double _axisX;
    private readonly double _axisY;
    private bool _limited;
    private float _lower;
    private float _upper;
    private bool _motor;
    private float _motorSpeed;
    private float _maxMotor;

    /// <summary>Makes a joint; the travel is 0 as the body stands.</summary>
    /// <param name="body">The body.</param>
    /// <param name="anchor">A point of the line, in world coordinates; finite.</param>
    /// <param name="axis">Direction of the line, in world coordinates, of any length; finite and not (0, 0).</param>
    /// <exception cref="ArgumentNullException"><paramref name="body"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public FixedPrismaticJoint(Body body, Vector2 anchor, Vector2 axis)
        : base(body)
    {
        _anchor = Require.Finite(anchor, nameof(anchor));
        Require.Direction(axis, nameof(axis));
        double length = Math.Sqrt(((double)axis.X * axis.X) + ((double)axis.Y * axis.Y));
        _axisX = axis.X / length;
        _axisY = axis.Y / length;
        JointAttachment.ToLocal(body, anchor, out _x, out _y);
        _startAngle = JointAttachment.Angle(body);
    }

    /// <summary>True keeps the travel of the body along the line between the limits. Default false.</summary>
    public bool AreLimitsEnabled
    {
        get => _limited;
        set
        {
            _limited = value;
            Changed();
        }
    }

    /// <summary>Smallest value of the travel of the body along the line; finite. Default 0.</summary>
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

    /// <summary>Largest value of the travel of the body along the line; finite. Default 0.</summary>
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

    /// <summary>Wanted speed, length/s; finite. Default 0.</summary>
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

    /// <summary>Largest force of the motor; at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxMotorForce
    {
        get => _maxMotor;
        set
        {
            _maxMotor = Require.NotNegative(value, nameof(MaxMotorForce));
            Changed();
        }
    }

    /// <summary>How far the body has moved along the line.</summary>
    public float Travel
    {
        get
        {
            JointAttachment.ToWorld(Body, _x, _y, out double x, out double y);
            return (float)(((x - _anchor.X) * _axisX) + ((y - _anchor.Y) * _axisY));
        }
    }

    internal Vector2 Axis => new Vector2((float)_axisX, (float)_axisY);

    internal override JointKind? Kind => JointKind.Prismatic;

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        settings.AnchorAX = _anchor.X;
        settings.AnchorAY = _anchor.Y;
        settings.AnchorBX = _x;
        settings.AnchorBY = _y;
        settings.AxisX = _axisX;
        settings.AxisY = _axisY;
        settings.Target = _startAngle;
        settings.Lower = _lower;
        settings.Upper = _upper;
        flags |= _limited ? JointFlags.Limit : JointFlags.None;
        settings.MotorSpeed = _motorSpeed;
        settings.MotorLimit = Bound(_maxMotor);
        flags |= _motor ? JointFlags.Motor : JointFlags.None;
    }
}
