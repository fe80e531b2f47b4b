using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace FarseerGames.FarseerPhysics.Views;

/// <content>How joints are drawn.</content>
public partial class PhysicsSimulatorView
{
    private void DrawJoint(Joint joint)
    {
        DebugColor color = ColorOf(joint);
        switch (joint)
        {
            case RevoluteJoint hinge when BodiesOf(hinge, out Body one, out Body two):
                DrawHinge(one, two, hinge.CurrentAnchor, color);
                break;
            case PinJoint pin when BodiesOf(pin, out _, out _):
                DrawRod(pin.WorldAnchor1, pin.WorldAnchor2, color);
                break;
            case SliderJoint slider when BodiesOf(slider, out _, out _):
                DrawRod(slider.WorldAnchor1, slider.WorldAnchor2, color);
                break;
            case DistanceJoint distance when BodiesOf(distance, out _, out _):
                DrawRod(distance.WorldAnchor1, distance.WorldAnchor2, color);
                break;
            case RopeJoint rope when BodiesOf(rope, out _, out _):
                DrawRod(rope.WorldAnchor1, rope.WorldAnchor2, color);
                break;
            case PulleyJoint pulley when BodiesOf(pulley, out _, out _):
                DrawRod(pulley.WorldAnchor1, pulley.Ground1, color);
                DrawRod(pulley.WorldAnchor2, pulley.Ground2, color);
                _draw.DrawLine(pulley.Ground1, pulley.Ground2, color);
                break;
            case PrismaticJoint slide when BodiesOf(slide, out Body one, out Body two):
                DrawAxis(slide.Axis, two.Position, color);
                DrawRod(one.Position, two.Position, color);
                break;
            case WheelJoint wheel when BodiesOf(wheel, out Body one, out Body two):
                DrawAxis(wheel.Axis, two.Position, color);
                DrawRod(one.Position, two.Position, color);
                break;
            case PairJoint pair when BodiesOf(pair, out Body one, out Body two):
                DrawRod(one.Position, two.Position, color);
                break;
            case FixedRevoluteJoint { Body: { } body } nail:
                DrawRod(body.Position, nail.Anchor, color);
                break;
            case TargetJoint { Body: { } body } target:
                DrawRod(body.Position, target.Target, color);
                break;
            case FixedPrismaticJoint { Body: { } body } rail:
                DrawAxis(rail.Axis, body.Position, color);
                _draw.DrawPoint(body.Position, _pointSize, color);
                break;
            case WorldJoint { Body: { } body }:
                _draw.DrawCircle(body.Position, _markLength / 2, color, color.WithAlpha(0));
                _draw.DrawPoint(body.Position, _pointSize, color);
                break;
        }
    }

    private static bool BodiesOf(PairJoint joint, out Body one, out Body two)
    {
        one = joint.Body1;
        two = joint.Body2;
        return one is not null && two is not null;
    }

    /// <summary>A joint that is off is half as opaque; one near its breakpoint has the colour of strain.</summary>
    private DebugColor ColorOf(Joint joint)
    {
        if (!joint.Enabled)
        {
            return JointColor.WithAlpha((byte)(JointColor.A / 2));
        }

        float strain = Math.Min(1, Math.Abs(joint.JointError) / Math.Max(joint.Breakpoint, float.Epsilon));
        return Mixed(JointColor, strain);
    }

    private void DrawHinge(Body one, Body two, Vector2 anchor, DebugColor color)
    {
        _draw.DrawLine(one.Position, anchor, color);
        _draw.DrawLine(anchor, two.Position, color);
        _draw.DrawPoint(anchor, _pointSize, color);
    }

    /// <summary>A piece of the line along which a body slides.</summary>
    private void DrawAxis(Vector2 axis, Vector2 middle, DebugColor color) =>
        _draw.DrawLine(middle - (_markLength * axis), middle + (_markLength * axis), color);

    private void DrawRod(Vector2 start, Vector2 end, DebugColor color)
    {
        _draw.DrawLine(start, end, color);
        _draw.DrawPoint(start, _pointSize, color);
        _draw.DrawPoint(end, _pointSize, color);
    }
}
