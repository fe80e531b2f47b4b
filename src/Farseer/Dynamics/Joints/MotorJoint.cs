using System;
using System.Numerics;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// Drives the second body to an offset and an angle relative to the first, with a largest force and torque: for what is moved by hand
/// and yet pushes no harder than it can. Each update takes away the share <see cref="Joint.BiasFactor"/> of what is missing.
/// <see cref="Joint.JointError"/> is the distance that is missing. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// simulator.Add(new MotorJoint(body, second) { Offset = new Vector2(2, 0), TargetAngle = 0, MaxForce = 100, MaxTorque = 50 });
/// </code>
/// </example>
public class MotorJoint : PairJoint
{
    private Vector2 _offset;
    private float _angle;
    private float _maxForce = float.MaxValue;
    private float _maxTorque = float.MaxValue;

    /// <summary>Makes a joint that holds the bodies as they stand.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    public MotorJoint(Body body1, Body body2)
        : base(body1, body2)
    {
        JointAttachment.ToLocal(body1, body2.Position, out double x, out double y);
        _offset = new Vector2((float)x, (float)y);
        _angle = (float)(JointAttachment.Angle(body2) - JointAttachment.Angle(body1));
    }

    /// <summary>Wanted position of the second body in the coordinates of the first; finite. Default that when it was made.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 Offset
    {
        get => _offset;
        set
        {
            _offset = Require.Finite(value, nameof(Offset));
            Changed();
        }
    }

    /// <summary>Wanted angle of the second body less that of the first, radians; finite. Default that when it was made.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float TargetAngle
    {
        get => _angle;
        set
        {
            _angle = Require.Finite(value, nameof(TargetAngle));
            Changed();
        }
    }

    /// <summary>Largest force along each axis; at least 0. Default <see cref="float.MaxValue"/>: as much as it takes.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxForce
    {
        get => _maxForce;
        set
        {
            _maxForce = Require.NotNegative(value, nameof(MaxForce));
            Changed();
        }
    }

    /// <summary>Largest torque; at least 0. Default <see cref="float.MaxValue"/>: as much as it takes.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxTorque
    {
        get => _maxTorque;
        set
        {
            _maxTorque = Require.NotNegative(value, nameof(MaxTorque));
            Changed();
        }
    }

    internal override JointKind? Kind => JointKind.Motor;

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        settings.AxisX = _offset.X;
        settings.AxisY = _offset.Y;
        settings.Target = _angle;
        settings.MotorLimit = Bound(_maxForce);
        settings.TorqueLimit = Bound(_maxTorque);
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _offset);
        s.Value(ref _angle);
        s.Value(ref _maxForce);
        s.Value(ref _maxTorque);
    }
}
