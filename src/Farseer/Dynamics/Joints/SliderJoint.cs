using System;
using System.Numerics;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// Keeps the distance of two anchors between a smallest and a largest, as a rod that slides in a tube. <see cref="Joint.JointError"/> is
/// how far the distance is past a limit: 0 within the slop.
/// </summary>
/// <example>
/// <code>
/// simulator.Add(new SliderJoint(body, Vector2.Zero, second, Vector2.Zero, min: 1, max: 3));
/// </code>
/// </example>
public class SliderJoint : AnchoredJoint
{
    private float _min;
    private float _max;
    private float _slop = 0.01f;

    /// <summary>Makes a joint without bodies: set them, the anchors and the limits before it is added.</summary>
    public SliderJoint()
    {
    }

    /// <summary>Makes a joint.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="anchor1">Anchor in the coordinates of the first body; finite.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor2">Anchor in the coordinates of the second body; finite.</param>
    /// <param name="min">Smallest distance; finite and at least 0.</param>
    /// <param name="max">Largest distance; finite, at least 0 and not below <paramref name="min"/>.</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is not finite, a distance is negative, or the largest one is below the
    /// smallest one.</exception>
    public SliderJoint(Body body1, Vector2 anchor1, Body body2, Vector2 anchor2, float min, float max)
        : base(body1, anchor1, body2, anchor2)
    {
        _min = Require.NotNegative(min, nameof(min));
        _max = Require.NotBelow(Require.NotNegative(max, nameof(max)), min, nameof(max), nameof(min));
    }

    /// <summary>Smallest distance of the anchors; finite and at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Min
    {
        get => _min;
        set
        {
            _min = Require.NotNegative(value, nameof(Min));
            Changed();
        }
    }

    /// <summary>Largest distance of the anchors; finite and at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Max
    {
        get => _max;
        set
        {
            _max = Require.NotNegative(value, nameof(Max));
            Changed();
        }
    }

    /// <summary>How far past a limit the distance may be without being pushed back; at least 0. Default 0.01.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Slop
    {
        get => _slop;
        set
        {
            _slop = Require.NotNegative(value, nameof(Slop));
            Changed();
        }
    }

    /// <summary>
    /// The distance midway between <see cref="Min"/> and <see cref="Max"/>; setting it moves both limits by the same amount, the lower
    /// one no further than to 0. Finite and at least 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float TargetDistance
    {
        get => (_min + _max) / 2;
        set
        {
            Require.NotNegative(value, nameof(TargetDistance));
            float half = (_max - _min) / 2;
            _min = Math.Max(0, value - half);
            _max = value + half;
            Changed();
        }
    }

    /// <summary>The anchor of the first body in world coordinates.</summary>
    public Vector2 CurrentAnchorPosition => WorldAnchor1;

    internal override JointKind? Kind => JointKind.Slider;

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        base.Fill(ref settings, ref flags);
        settings.Lower = _min;
        settings.Upper = _max;
        settings.Slop = _slop;
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _min);
        s.Value(ref _max);
        s.Value(ref _slop);
    }
}
