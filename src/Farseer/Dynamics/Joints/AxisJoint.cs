using System;
using System.Numerics;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// Base class of the joints that let a point of the second body move only along an axis of the first. <see cref="Joint.JointError"/> is the
/// distance of that point from the axis. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// AxisJoint slide = new PrismaticJoint(body, second, body.Position, Vector2.UnitX);
/// simulator.Add(slide);
/// simulator.Update(1f / 60);
/// float way = slide.Travel;
/// </code>
/// </example>
public abstract class AxisJoint : DrivenPairJoint
{
    [NotState(Why.Fixed)]
    private double _x1;
    [NotState(Why.Fixed)]
    private double _y1;
    [NotState(Why.Fixed)]
    private double _x2;
    [NotState(Why.Fixed)]
    private double _y2;
    [NotState(Why.Fixed)]
    private double _axisX;
    [NotState(Why.Fixed)]
    private double _axisY;

    private protected AxisJoint(Body body1, Body body2, Vector2 anchor, Vector2 axis)
        : base(body1, body2)
    {
        Require.Finite(anchor, nameof(anchor));
        Require.Direction(axis, nameof(axis));
        JointAttachment.ToLocal(body1, anchor, out _x1, out _y1);
        JointAttachment.ToLocal(body2, anchor, out _x2, out _y2);
        JointAttachment.ToLocalAxis(body1, axis, out _axisX, out _axisY);
    }

    /// <summary>How far the point of the second body has moved along the axis since the joint was made.</summary>
    public float Travel
    {
        get
        {
            JointAttachment.ToWorld(Body2, _x2, _y2, out double x, out double y);
            JointAttachment.ToLocal(Body1, x, y, out double alongX, out double alongY);
            return (float)(((alongX - _x1) * _axisX) + ((alongY - _y1) * _axisY));
        }
    }

    /// <summary>The axis as the first body has turned it, in world coordinates.</summary>
    internal Vector2 Axis => ((float)_axisX * Body1.XVectorInWorldCoordinates) + ((float)_axisY * Body1.YVectorInWorldCoordinates);

    internal override void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        base.Fill(ref settings, ref flags);
        settings.AnchorAX = _x1;
        settings.AnchorAY = _y1;
        settings.AnchorBX = _x2;
        settings.AnchorBY = _y2;
        settings.AxisX = _axisX;
        settings.AxisY = _axisY;
    }

    /// <inheritdoc/>
    internal override void VisitHidden(IHiddenFields fields)
    {
        base.VisitHidden(fields);
        fields.Value("localAnchor1X", ref _x1);
        fields.Value("localAnchor1Y", ref _y1);
        fields.Value("localAnchor2X", ref _x2);
        fields.Value("localAnchor2Y", ref _y2);
        fields.Value("axisX", ref _axisX);
        fields.Value("axisY", ref _axisY);
    }
}
