using System;
using System.Numerics;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// A rope: two anchors are never further apart than <see cref="MaxLength"/>. <see cref="Joint.JointError"/> is how much further they are.
/// (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// simulator.Add(new RopeJoint(body, Vector2.Zero, second, Vector2.Zero, maxLength: 4));
/// </code>
/// </example>
public class RopeJoint : AnchoredJoint
{
    private float _maxLength;

    /// <summary>Makes a joint.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="anchor1">Anchor in the coordinates of the first body; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor2">Anchor in the coordinates of the second body; finite.</param>
    /// <param name="maxLength">Largest distance of the anchors; finite and at least 0.</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public RopeJoint(Body body1, Vector2 anchor1, Body body2, Vector2 anchor2, float maxLength)
        : base(body1, anchor1, body2, anchor2)
    {
        _maxLength = Require.NotNegative(maxLength, nameof(maxLength));
    }

    /// <summary>Largest distance of the anchors; finite and at least 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxLength
    {
        get => _maxLength;
        set
        {
            _maxLength = Require.NotNegative(value, nameof(MaxLength));
            Changed();
        }
    }

    internal override JointKind? Kind => JointKind.Rope;

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        base.Fill(ref settings, ref flags);
        settings.Upper = _maxLength;
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _maxLength);
    }
}
