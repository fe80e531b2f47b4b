using System;
using System.Numerics;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// A hinge: two bodies share an anchor about which they turn freely. Both can still move. It is made from one point of the world, kept as
/// a point of each body. <see cref="Joint.JointError"/> is the distance of the two points in the world.
/// </summary>
/// <example>
/// <code>
/// var elbow = new RevoluteJoint(body, second, new Vector2(1, 0)) { LowerLimit = -1, UpperLimit = 1, AreLimitsEnabled = true };
/// simulator.Add(elbow);
/// </code>
/// </example>
public class RevoluteJoint : DrivenPairJoint
{
    private Vector2 _anchor;
    private bool _anchorWaits;
    private double _x1;
    private double _y1;
    private double _x2;
    private double _y2;
    private double _startAngle;

    /// <summary>Makes a joint without bodies: set them and the anchor before it is added.</summary>
    public RevoluteJoint()
    {
    }

    /// <summary>Makes a joint at a point of the world.</summary>
    /// <param name="body1">First body.</param>
    /// <param name="body2">Second body.</param>
    /// <param name="anchor">The hinge, in world coordinates; finite.</param>
    /// <exception cref="ArgumentNullException">A body is null.</exception>
    /// <exception cref="ArgumentException">Both bodies are the same.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="anchor"/> is not finite.</exception>
    public RevoluteJoint(Body body1, Body body2, Vector2 anchor)
        : base(body1, body2) => SetInitialAnchor(Require.Finite(anchor, nameof(anchor)));

    /// <summary>The point of the world given last; setting it moves the hinge there, as the bodies stand. Finite. Default (0, 0).</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 Anchor
    {
        get => _anchor;
        set => SetInitialAnchor(Require.Finite(value, nameof(Anchor)));
    }

    /// <summary>Where the hinge is now: the anchor of the first body in world coordinates.</summary>
    public Vector2 CurrentAnchor => Body1 is null ? _anchor : At(Body1, _x1, _y1);

    /// <summary>Largest torque of the motor; at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float MaxMotorTorque
    {
        get => MaxEffort;
        set => MaxEffort = Require.NotNegative(value, nameof(MaxMotorTorque));
    }

    /// <summary>The angle of the second body relative to the first since the joint was made, radians, whole turns included.</summary>
    public float JointAngle => HasBodies ? (float)(JointAttachment.Angle(Body2) - JointAttachment.Angle(Body1) - _startAngle) : 0;

    internal override JointKind? Kind => JointKind.Revolute;

    /// <summary>Sets the hinge, as the bodies stand. With no bodies yet, it is taken up when both are set.</summary>
    /// <param name="initialAnchor">The hinge, in world coordinates; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="initialAnchor"/> is not finite.</exception>
    public void SetInitialAnchor(Vector2 initialAnchor)
    {
        _anchor = Require.Finite(initialAnchor, nameof(initialAnchor));
        _anchorWaits = true;
        NoteSet();
        BodiesSet();
    }

    /// <summary>Another name of <see cref="SetInitialAnchor"/>.</summary>
    /// <param name="anchor">The hinge, in world coordinates; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="anchor"/> is not finite.</exception>
    public void SetAnchor(Vector2 anchor) => SetInitialAnchor(Require.Finite(anchor, nameof(anchor)));

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        base.Fill(ref settings, ref flags);
        settings.AnchorAX = _x1;
        settings.AnchorAY = _y1;
        settings.AnchorBX = _x2;
        settings.AnchorBY = _y2;
        settings.Target = _startAngle;
    }

    private protected override void BodiesSet()
    {
        if (_anchorWaits && HasBodies)
        {
            _anchorWaits = false;
            JointAttachment.ToLocal(Body1, _anchor, out _x1, out _y1);
            JointAttachment.ToLocal(Body2, _anchor, out _x2, out _y2);
            _startAngle = JointAttachment.Angle(Body2) - JointAttachment.Angle(Body1);
            Changed();
        }
    }

    private static Vector2 At(Body body, double x, double y)
    {
        JointAttachment.ToWorld(body, x, y, out double worldX, out double worldY);
        return new Vector2((float)worldX, (float)worldY);
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.Value(ref _anchor);
        s.Value(ref _anchorWaits);
        s.Value(ref _x1);
        s.Value(ref _y1);
        s.Value(ref _x2);
        s.Value(ref _y2);
        s.Value(ref _startAngle);
    }

    /// <inheritdoc/>
    internal override void VisitHidden(IHiddenFields fields)
    {
        base.VisitHidden(fields);
        fields.Value("anchor", ref _anchor);
        fields.Value("anchorWaits", ref _anchorWaits);
        fields.Value("localAnchor1X", ref _x1);
        fields.Value("localAnchor1Y", ref _y1);
        fields.Value("localAnchor2X", ref _x2);
        fields.Value("localAnchor2Y", ref _y2);
        fields.Value("startAngle", ref _startAngle);
    }
}
