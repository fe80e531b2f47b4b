using System;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// Keeps the angle of a body between two limits. It has no target and never turns the body by itself. <see cref="Joint.JointError"/> is
/// how far the angle is past a limit, radians: 0 within the slop.
/// </summary>
/// <example>
/// <code>
/// simulator.Add(new FixedAngleLimitJoint(body, -0.5f, 0.5f));
/// </code>
/// </example>
public class FixedAngleLimitJoint : WorldJoint
{
    private float _lowerLimit;
    private float _upperLimit;
    private float _slop = 0.01f;

    /// <summary>Makes a joint without a body: set it and the limits before it is added.</summary>
    public FixedAngleLimitJoint()
    {
    }

    /// <summary>Makes a joint.</summary>
    /// <param name="body">The body.</param>
    /// <param name="lowerLimit">Smallest angle, radians; finite.</param>
    /// <param name="upperLimit">Largest angle, radians; finite.</param>
    /// <exception cref="ArgumentNullException"><paramref name="body"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A limit is not finite, or the upper one is below the lower one.</exception>
    public FixedAngleLimitJoint(Body body, float lowerLimit, float upperLimit)
        : base(body)
    {
        _lowerLimit = Require.Finite(lowerLimit, nameof(lowerLimit));
        _upperLimit = Require.NotBelow(Require.Finite(upperLimit, nameof(upperLimit)), lowerLimit, nameof(upperLimit), nameof(lowerLimit));
    }

    /// <summary>Smallest angle, radians; finite. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float LowerLimit
    {
        get => _lowerLimit;
        set
        {
            _lowerLimit = Require.Finite(value, nameof(LowerLimit));
            Changed();
        }
    }

    /// <summary>
    /// Largest angle, radians; finite. With a value below <see cref="LowerLimit"/> the joint comes to rest between the two. Default 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float UpperLimit
    {
        get => _upperLimit;
        set
        {
            _upperLimit = Require.Finite(value, nameof(UpperLimit));
            Changed();
        }
    }

    /// <summary>How far past a limit the angle may be without being turned back, radians; at least 0. Default 0.01.</summary>
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

    internal override JointKind? Kind => JointKind.AngleLimit;

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        settings.Lower = _lowerLimit;
        settings.Upper = _upperLimit;
        settings.Slop = _slop;
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _lowerLimit);
        s.Value(ref _upperLimit);
        s.Value(ref _slop);
    }
}
