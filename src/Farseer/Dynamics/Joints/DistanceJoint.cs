using System;
using System.Numerics;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// Keeps two anchors at a distance, rigidly or, with a <see cref="Frequency"/>, as a damped spring that is stable at any stiffness.
/// <see cref="Joint.JointError"/> is the distance less the wanted one. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// simulator.Add(new DistanceJoint(body, Vector2.Zero, second, Vector2.Zero) { Frequency = 4, DampingRatio = 0.5f });
/// </code>
/// </example>
public class DistanceJoint : AnchoredJoint
{
    private float _distance;
    private JointSpring _spring;
    private bool _limited;
    private float _lower;
    private float _upper;

    /// <summary>Makes a rigid joint whose distance is that of the anchors now.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="anchor1">Anchor in the coordinates of the first body; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor2">Anchor in the coordinates of the second body; finite.</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public DistanceJoint(Body body1, Vector2 anchor1, Body body2, Vector2 anchor2)
        : base(body1, anchor1, body2, anchor2)
    {
        _distance = AnchorDistance(anchor1, anchor2);
    }

    /// <summary>Wanted distance; finite and at least 0. Default the distance of the anchors when it was made.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float TargetDistance
    {
        get => _distance;
        set
        {
            _distance = Require.NotNegative(value, nameof(TargetDistance));
            Changed();
        }
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

    /// <summary>True keeps the distance of a springy joint between the limits. Default false.</summary>
    public bool AreLimitsEnabled
    {
        get => _limited;
        set
        {
            _limited = value;
            Changed();
        }
    }

    /// <summary>Smallest value of the distance of a springy joint; finite. Default 0.</summary>
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

    /// <summary>Largest value of the distance of a springy joint; finite. Default 0.</summary>
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

    internal override JointKind? Kind => JointKind.Distance;

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        base.Fill(ref settings, ref flags);
        settings.Target = _distance;
        _spring.Fill(ref settings, ref flags);
        settings.Lower = _lower;
        settings.Upper = _upper;
        flags |= _limited ? JointFlags.Limit : JointFlags.None;
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _distance);
        s.Value(ref _spring);
        s.Value(ref _limited);
        s.Value(ref _lower);
        s.Value(ref _upper);
    }
}
