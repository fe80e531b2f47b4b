using System;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// Meshing gears: as the first body turns by an angle, the second turns by <see cref="Ratio"/> times that angle the other way; a negative
/// ratio turns both the same way. <see cref="Joint.JointError"/> is how far the second is from where it should be, radians.
/// </summary>
/// <example>
/// <code>
/// simulator.Add(new GearJoint(body, second, 2));
/// </code>
/// </example>
public class GearJoint : PairJoint
{
    private float _ratio = 1;
    private float _maxImpulse = float.MaxValue;
    private double _constant;
    private bool _measured;

    /// <summary>Makes a joint without bodies: set them before it is added.</summary>
    public GearJoint()
    {
    }

    /// <summary>Makes a joint of ratio 1.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    public GearJoint(Body body1, Body body2)
        : this(body1, body2, 1)
    {
    }

    /// <summary>Makes a joint; the gears mesh as they stand.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="ratio">Turns of the second body for each turn of the first; finite.</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="ratio"/> is not finite.</exception>
    public GearJoint(Body body1, Body body2, float ratio)
        : base(body1, body2)
    {
        _ratio = Require.Finite(ratio, nameof(ratio));
        Measure();
    }

    /// <summary>
    /// Turns of the second body for each turn of the first, counted the other way; finite. Setting it meshes the gears anew. Default 1.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float Ratio
    {
        get => _ratio;
        set
        {
            _ratio = Require.Finite(value, nameof(Ratio));
            Measure();
            Changed();
        }
    }

    /// <summary>
    /// Largest impulse that the joint gives in one of the <see cref="PhysicsSimulator.Iterations"/> of an update; at least 0. A low
    /// value lets the gear lag or slip. Default <see cref="float.MaxValue"/>: as much as it takes.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxImpulse
    {
        get => _maxImpulse;
        set
        {
            _maxImpulse = Require.NotNegative(value, nameof(MaxImpulse));
            Changed();
        }
    }

    internal override JointKind? Kind => JointKind.Gear;

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        if (!_measured)
        {
            Measure();
        }

        settings.Ratio = _ratio;
        settings.Target = _constant;
        settings.MaxImpulse = Bound(_maxImpulse);
        settings.Softness = Math.Min(1, settings.Softness);
    }

    private protected override void BodiesSet() => Measure();

    private void Measure()
    {
        if (HasBodies)
        {
            _measured = true;
            _constant = JointAttachment.Angle(Body2) + (_ratio * JointAttachment.Angle(Body1));
        }
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _ratio);
        s.Value(ref _maxImpulse);
        s.Value(ref _constant);
        s.Value(ref _measured);
    }

    /// <inheritdoc/>
    internal override void VisitHidden(IHiddenFields fields)
    {
        base.VisitHidden(fields);
        fields.Value("constant", ref _constant);
        fields.Value("isMeasured", ref _measured);
    }
}
