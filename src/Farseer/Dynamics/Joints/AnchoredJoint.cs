using System;
using System.Numerics;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>Base class of the joints between a point of one body and a point of another.</summary>
/// <example>
/// <code>
/// AnchoredJoint rope = new RopeJoint(body, Vector2.Zero, second, Vector2.Zero, maxLength: 4);
/// simulator.Add(rope);
/// Console.WriteLine($"from {rope.WorldAnchor1} to {rope.WorldAnchor2}");
/// </code>
/// </example>
public abstract class AnchoredJoint : PairJoint
{
    private Vector2 _anchor1;
    private Vector2 _anchor2;

    private protected AnchoredJoint()
    {
    }

    private protected AnchoredJoint(Body body1, Vector2 anchor1, Body body2, Vector2 anchor2)
        : base(body1, body2)
    {
        _anchor1 = Require.Finite(anchor1, nameof(anchor1));
        _anchor2 = Require.Finite(anchor2, nameof(anchor2));
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

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        settings.AnchorAX = _anchor1.X;
        settings.AnchorAY = _anchor1.Y;
        settings.AnchorBX = _anchor2.X;
        settings.AnchorBY = _anchor2.Y;
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _anchor1);
        s.Value(ref _anchor2);
    }
}
