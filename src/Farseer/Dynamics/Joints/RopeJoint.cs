using System;
using System.Numerics;
using Farseer.Engine.Joints;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// A rope: two anchors are never further apart than <see cref="MaxLength"/>. <see cref="Joint.JointError"/> is how much further they are. (An addition to the original.)
/// </summary>
public class RopeJoint : PairJoint
{
    private Vector2 _anchor1;
    private Vector2 _anchor2;
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
        : base(body1, body2)
    {
        _anchor1 = Require.Finite(anchor1, nameof(anchor1));
        _anchor2 = Require.Finite(anchor2, nameof(anchor2));
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

    /// <summary>Anchor in the coordinates of the first body; finite. Default (0, 0).</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 Anchor1
    {
        get => _anchor1;
        set
        {
            _anchor1 = Require.Finite(value, nameof(Anchor1));
            Changed();
        }
    }

    /// <summary>Anchor in the coordinates of the second body; finite. Default (0, 0).</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 Anchor2
    {
        get => _anchor2;
        set
        {
            _anchor2 = Require.Finite(value, nameof(Anchor2));
            Changed();
        }
    }

    /// <summary>The anchor of the first body in world coordinates.</summary>
    public Vector2 WorldAnchor1 => World1(_anchor1);

    /// <summary>The anchor of the second body in world coordinates.</summary>
    public Vector2 WorldAnchor2 => World2(_anchor2);

    internal override JointKind? Kind => JointKind.Rope;

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        settings.AnchorAX = _anchor1.X;
        settings.AnchorAY = _anchor1.Y;
        settings.AnchorBX = _anchor2.X;
        settings.AnchorBY = _anchor2.Y;
        settings.Upper = _maxLength;
    }
}
