using System;
using System.Numerics;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// A slide in the world: the body moves along a line and cannot turn. <see cref="Joint.JointError"/> is its distance from the line. (An
/// addition to the original.)
/// </summary>
/// <example>
/// <code>
/// var lift = new FixedPrismaticJoint(body, body.Position, Vector2.UnitY) { IsMotorEnabled = true, MotorSpeed = 1, MaxMotorForce = 500 };
/// simulator.Add(lift);
/// </code>
/// </example>
public class FixedPrismaticJoint : DrivenWorldJoint
{
    [NotState(Why.Fixed)]
    private Vector2 _anchor;
    [NotState(Why.Fixed)]
    private double _x;
    [NotState(Why.Fixed)]
    private double _y;
    [NotState(Why.Fixed)]
    private double _startAngle;
    [NotState(Why.Fixed)]
    private double _axisX;
    [NotState(Why.Fixed)]
    private double _axisY;

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

    /// <summary>Largest force of the motor; at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxMotorForce
    {
        get => MaxEffort;
        set => MaxEffort = Require.NotNegative(value, nameof(MaxMotorForce));
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
        base.Fill(ref settings, ref flags);
        settings.AnchorAX = _anchor.X;
        settings.AnchorAY = _anchor.Y;
        settings.AnchorBX = _x;
        settings.AnchorBY = _y;
        settings.AxisX = _axisX;
        settings.AxisY = _axisY;
        settings.Target = _startAngle;
    }

    /// <inheritdoc/>
    internal override void VisitHidden(IHiddenFields fields)
    {
        base.VisitHidden(fields);
        fields.Value("anchor", ref _anchor);
        fields.Value("localAnchorX", ref _x);
        fields.Value("localAnchorY", ref _y);
        fields.Value("axisX", ref _axisX);
        fields.Value("axisY", ref _axisY);
        fields.Value("startAngle", ref _startAngle);
    }
}
