using System;
using System.Numerics;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// A nail: a body is pinned to a point of the world about which it turns freely. <see cref="Joint.JointError"/> is the distance of the
/// body's anchor from that point. Each update takes away four times the share <see cref="Joint.BiasFactor"/> of its error.
/// </summary>
/// <example>
/// <code>
/// var nail = new FixedRevoluteJoint(body, new Vector2(0, 2));
/// simulator.Add(nail);
/// </code>
/// </example>
public class FixedRevoluteJoint : DrivenWorldJoint
{
    /// <summary>In the original this joint alone corrected by 0.8 of its error where the manual says 0.2.</summary>
    private const double Haste = 4;

    private Vector2 _anchor;
    private bool _anchorWaits;
    private double _x;
    private double _y;
    private double _startAngle;
    private float _maxImpulse = float.MaxValue;

    /// <summary>Makes a joint without a body: set it and the anchor before it is added.</summary>
    public FixedRevoluteJoint()
    {
    }

    /// <summary>Makes a joint at a point of the world.</summary>
    /// <param name="body">The body.</param>
    /// <param name="anchor">The nail, in world coordinates; finite.</param>
    /// <exception cref="ArgumentNullException"><paramref name="body"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="anchor"/> is not finite.</exception>
    public FixedRevoluteJoint(Body body, Vector2 anchor)
        : base(body) => SetAnchor(anchor);

    /// <summary>The nail, in world coordinates; setting it drives it into the body where that stands. Finite. Default (0, 0).</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 Anchor
    {
        get => _anchor;
        set => SetAnchor(Require.Finite(value, nameof(Anchor)));
    }

    /// <summary>Where the anchor of the body is now, in world coordinates.</summary>
    public Vector2 CurrentAnchor
    {
        get
        {
            if (!HasBody)
            {
                return _anchor;
            }

            JointAttachment.ToWorld(Body, _x, _y, out double x, out double y);
            return new Vector2((float)x, (float)y);
        }
    }

    /// <summary>
    /// Largest impulse that each coordinate of the joint gives in one of the <see cref="PhysicsSimulator.Iterations"/> of an update; at
    /// least 0. Default <see cref="float.MaxValue"/>: as much as it takes.
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

    /// <summary>Largest torque of the motor; at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxMotorTorque
    {
        get => MaxEffort;
        set => MaxEffort = Require.NotNegative(value, nameof(MaxMotorTorque));
    }

    /// <summary>The angle of the body since the joint was made, radians, whole turns included.</summary>
    public float JointAngle => HasBody ? (float)(JointAttachment.Angle(Body) - _startAngle) : 0;

    internal override JointKind? Kind => JointKind.Revolute;

    /// <summary>Sets the nail, as the body stands. With no body yet, it is taken up when that is set.</summary>
    /// <param name="anchor">The nail, in world coordinates; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="anchor"/> is not finite.</exception>
    public void SetAnchor(Vector2 anchor)
    {
        _anchor = Require.Finite(anchor, nameof(anchor));
        _anchorWaits = true;
        NoteSet();
        BodySet();
    }

    /// <summary>Another name of <see cref="SetAnchor"/>.</summary>
    /// <param name="initialAnchor">The nail, in world coordinates; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="initialAnchor"/> is not finite.</exception>
    public void SetInitialAnchor(Vector2 initialAnchor) => SetAnchor(Require.Finite(initialAnchor, nameof(initialAnchor)));

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        base.Fill(ref settings, ref flags);
        settings.AnchorAX = _anchor.X;
        settings.AnchorAY = _anchor.Y;
        settings.AnchorBX = _x;
        settings.AnchorBY = _y;
        settings.Target = _startAngle;
        settings.MaxImpulse = Bound(_maxImpulse);
        settings.BiasFactor = Math.Min(1, Haste * settings.BiasFactor);
    }

    private protected override void BodySet()
    {
        if (_anchorWaits && HasBody)
        {
            _anchorWaits = false;
            JointAttachment.ToLocal(Body, _anchor, out _x, out _y);
            _startAngle = JointAttachment.Angle(Body);
            Changed();
        }
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _anchor);
        s.Value(ref _anchorWaits);
        s.Value(ref _x);
        s.Value(ref _y);
        s.Value(ref _startAngle);
        s.Value(ref _maxImpulse);
    }

    /// <inheritdoc/>
    internal override void VisitHidden(IHiddenFields fields)
    {
        base.VisitHidden(fields);
        fields.Value("anchor", ref _anchor);
        fields.Value("anchorWaits", ref _anchorWaits);
        fields.Value("localAnchorX", ref _x);
        fields.Value("localAnchorY", ref _y);
        fields.Value("startAngle", ref _startAngle);
    }
}
