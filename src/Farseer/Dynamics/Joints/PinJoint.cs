using System;
using System.Numerics;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// A rod: keeps two anchors at a set distance, and lets the bodies turn. <see cref="Joint.JointError"/> is the distance less the wanted
/// one.
/// </summary>
/// <example>
/// <code>
/// simulator.Add(new PinJoint(body, Vector2.Zero, second, Vector2.Zero));
/// </code>
/// </example>
public class PinJoint : AnchoredJoint
{
    private float _targetDistance;

    /// <summary>Makes a joint without bodies: set them, the anchors and the distance before it is added.</summary>
    public PinJoint()
    {
    }

    /// <summary>Makes a joint whose distance is that of the anchors now.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="anchor1">Anchor in the coordinates of the first body; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor2">Anchor in the coordinates of the second body; finite.</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite.</exception>
    public PinJoint(Body body1, Vector2 anchor1, Body body2, Vector2 anchor2)
        : base(body1, anchor1, body2, anchor2)
    {
        _targetDistance = AnchorDistance(anchor1, anchor2);
    }

    /// <summary>Wanted distance of the anchors; finite and at least 0. Default: what it was when the joint was made.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float TargetDistance
    {
        get => _targetDistance;
        set
        {
            _targetDistance = Require.NotNegative(value, nameof(TargetDistance));
            Changed();
        }
    }

    internal override JointKind? Kind => JointKind.Pin;

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        base.Fill(ref settings, ref flags);
        settings.Target = _targetDistance;
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _targetDistance);
    }
}
