using System;
using System.Numerics;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// A rope over two fixed points: the length on the first side plus <see cref="Ratio"/> times that on the second never grows beyond what it
/// was when the joint was made. A rope pulls and does not push. <see cref="Joint.JointError"/> is how much too long it is. (An addition to
/// the original.)
/// </summary>
/// <example>
/// <code>
/// simulator.Add(new PulleyJoint(
///     body, Vector2.Zero, new Vector2(-2, 8), second, Vector2.Zero, new Vector2(2, 8), ratio: 1));
/// </code>
/// </example>
public class PulleyJoint : AnchoredJoint
{
    [NotState(Why.Fixed)]
    private Vector2 _ground1;
    [NotState(Why.Fixed)]
    private Vector2 _ground2;
    private float _ratio;
    private float _length;

    /// <summary>Makes a joint whose rope is taut as the bodies stand.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="groundAnchor1">Point over which the rope to the first body runs, in world coordinates; finite.</param>
    /// <param name="anchor1">Anchor in the coordinates of the first body; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="groundAnchor2">Point over which the rope to the second body runs, in world coordinates; finite.</param>
    /// <param name="anchor2">Anchor in the coordinates of the second body; finite.</param>
    /// <param name="ratio">Weight of the second side, as in a block and tackle; finite and above 0.</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public PulleyJoint(
        Body body1, Vector2 groundAnchor1, Vector2 anchor1, Body body2, Vector2 groundAnchor2, Vector2 anchor2, float ratio = 1)
        : base(body1, anchor1, body2, anchor2)
    {
        _ground1 = Require.Finite(groundAnchor1, nameof(groundAnchor1));
        _ground2 = Require.Finite(groundAnchor2, nameof(groundAnchor2));
        _ratio = Require.Positive(ratio, nameof(ratio));
        _length = Length1 + (ratio * Length2);
    }

    /// <summary>Length of the rope on the first side.</summary>
    public float Length1 => Vector2.Distance(_ground1, WorldAnchor1);

    /// <summary>Length of the rope on the second side.</summary>
    public float Length2 => Vector2.Distance(_ground2, WorldAnchor2);

    /// <summary>
    /// Largest value of <see cref="Length1"/> + <see cref="Ratio"/> · <see cref="Length2"/>; finite and at least 0. Default that when it
    /// was made.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float TotalLength
    {
        get => _length;
        set
        {
            _length = Require.NotNegative(value, nameof(TotalLength));
            Changed();
        }
    }

    /// <summary>Weight of the second side, as in a block and tackle; finite and above 0. Default 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite or not above 0.</exception>
    public float Ratio
    {
        get => _ratio;
        set
        {
            _ratio = Require.Positive(value, nameof(Ratio));
            Changed();
        }
    }

    internal Vector2 Ground1 => _ground1;

    internal Vector2 Ground2 => _ground2;

    internal override JointKind? Kind => JointKind.Pulley;

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        base.Fill(ref settings, ref flags);
        settings.GroundAX = _ground1.X;
        settings.GroundAY = _ground1.Y;
        settings.GroundBX = _ground2.X;
        settings.GroundBY = _ground2.Y;
        settings.Ratio = _ratio;
        settings.Target = _length;

        // While one side is drawn up to its point its direction says nothing. The other side alone is no longer than the rope, and has one.
        settings.Upper = _length;
        settings.Lower = _length / (double)_ratio;
        flags |= JointFlags.Limit;
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _ratio);
        s.Value(ref _length);
    }

    /// <inheritdoc/>
    internal override void VisitHidden(IHiddenFields fields)
    {
        base.VisitHidden(fields);
        fields.Value("groundAnchor1", ref _ground1);
        fields.Value("groundAnchor2", ref _ground2);
    }
}
