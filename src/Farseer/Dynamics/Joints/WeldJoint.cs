using System;
using System.Numerics;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// Holds two bodies together as one; with a <see cref="Frequency"/> they may bend against each other as on a damped spring.
/// <see cref="Joint.JointError"/> is the distance of the two anchors. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// simulator.Add(new WeldJoint(body, second, body.Position));
/// </code>
/// </example>
public class WeldJoint : PairJoint
{
    [NotState(Why.Fixed)]
    private double _x1;
    [NotState(Why.Fixed)]
    private double _y1;
    [NotState(Why.Fixed)]
    private double _x2;
    [NotState(Why.Fixed)]
    private double _y2;
    [NotState(Why.Fixed)]
    private double _startAngle;
    private JointSpring _spring;

    /// <summary>Makes a rigid joint of the bodies as they stand.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor">The point at which they are joined, in world coordinates; finite.</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public WeldJoint(Body body1, Body body2, Vector2 anchor)
        : base(body1, body2)
    {
        Require.Finite(anchor, nameof(anchor));
        JointAttachment.ToLocal(body1, anchor, out _x1, out _y1);
        JointAttachment.ToLocal(body2, anchor, out _x2, out _y2);
        _startAngle = JointAttachment.Angle(body2) - JointAttachment.Angle(body1);
    }

    /// <summary>Frequency of the spring, hertz; at least 0. 0 makes it rigid. Default 0.</summary>
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

    /// <summary>Damping of the spring in terms of the critical one; at least 0. Default 0.</summary>
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

    internal override JointKind? Kind => JointKind.Weld;

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        settings.AnchorAX = _x1;
        settings.AnchorAY = _y1;
        settings.AnchorBX = _x2;
        settings.AnchorBY = _y2;
        settings.Target = _startAngle;
        _spring.Fill(ref settings, ref flags);
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _spring);
    }

    /// <inheritdoc/>
    internal override void VisitHidden(IHiddenFields fields)
    {
        base.VisitHidden(fields);
        fields.Value("localAnchor1X", ref _x1);
        fields.Value("localAnchor1Y", ref _y1);
        fields.Value("localAnchor2X", ref _x2);
        fields.Value("localAnchor2Y", ref _y2);
        fields.Value("startAngle", ref _startAngle);
    }
}
