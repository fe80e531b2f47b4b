using System;
using System.Numerics;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// Draws a point of a body to a point of the world by a spring with a largest force: what a mouse that picks up a body needs.
/// <see cref="Joint.JointError"/> is the distance of the two. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// var grip = new TargetJoint(body, body.Position) { MaxForce = 1000 };
/// simulator.Add(grip);
/// grip.Target = new Vector2(3, 4);
/// </code>
/// </example>
public class TargetJoint : WorldJoint
{
    [NotState(Why.Fixed)]
    private double _x;
    [NotState(Why.Fixed)]
    private double _y;
    private Vector2 _target;
    private float _maxForce = float.MaxValue;
    private JointSpring _spring = new JointSpring { Frequency = 5, DampingRatio = 0.7f };

    /// <summary>Makes a joint that holds a body at a point.</summary>
    /// <param name="body">The body.</param>
    /// <param name="target">The point, in world coordinates: it is taken for that of the body and for its target; finite.</param>
    /// <exception cref="ArgumentNullException"><paramref name="body"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public TargetJoint(Body body, Vector2 target)
        : base(body)
    {
        _target = Require.Finite(target, nameof(target));
        JointAttachment.ToLocal(body, target, out _x, out _y);
    }

    /// <summary>Where the point of the body is drawn to, in world coordinates; finite.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 Target
    {
        get => _target;
        set
        {
            _target = Require.Finite(value, nameof(Target));
            Changed();
        }
    }

    /// <summary>Largest force; at least 0. Default <see cref="float.MaxValue"/>: as much as it takes.</summary>
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

    /// <summary>Frequency of the spring, hertz; at least 0. 0 makes it limp. Default 5.</summary>
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

    internal override JointKind? Kind => JointKind.Target;

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        settings.AnchorAX = _target.X;
        settings.AnchorAY = _target.Y;
        settings.AnchorBX = _x;
        settings.AnchorBY = _y;
        settings.MotorLimit = Bound(_maxForce);
        _spring.Fill(ref settings, ref flags);
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _target);
        s.Value(ref _maxForce);
        s.Value(ref _spring);
    }

    /// <inheritdoc/>
    internal override void VisitHidden(IHiddenFields fields)
    {
        base.VisitHidden(fields);
        fields.Value("localAnchorX", ref _x);
        fields.Value("localAnchorY", ref _y);
    }
}
