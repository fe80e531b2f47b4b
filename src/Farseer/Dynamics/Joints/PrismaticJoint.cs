using System;
using System.Numerics;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// A slide: the second body moves along an axis of the first and cannot turn against it. <see cref="Joint.JointError"/> is its distance
/// from the axis. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// var drawer = new PrismaticJoint(body, second, body.Position, Vector2.UnitX)
/// {
///     AreLimitsEnabled = true, LowerLimit = 0, UpperLimit = 1.5f,
/// };
/// simulator.Add(drawer);
/// </code>
/// </example>
public class PrismaticJoint : AxisJoint
{
    [NotState(Why.Fixed)]
    private double _startAngle;

    /// <summary>Makes a joint; the travel is 0 as the bodies stand.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor">The point at which they are joined, in world coordinates; finite.</param>
    /// <param name="axis">Direction of the slide, in world coordinates, of any length; finite and not (0, 0).</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public PrismaticJoint(Body body1, Body body2, Vector2 anchor, Vector2 axis)
        : base(body1, body2, anchor, axis)
    {
        _startAngle = JointAttachment.Angle(body2) - JointAttachment.Angle(body1);
    }

    /// <summary>Largest force of the motor; at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxMotorForce
    {
        get => MaxEffort;
        set => MaxEffort = Require.NotNegative(value, nameof(MaxMotorForce));
    }

    internal override JointKind? Kind => JointKind.Prismatic;

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        base.Fill(ref settings, ref flags);
        settings.Target = _startAngle;
    }

    /// <inheritdoc/>
    internal override void VisitHidden(IHiddenFields fields)
    {
        base.VisitHidden(fields);
        fields.Value("startAngle", ref _startAngle);
    }
}
