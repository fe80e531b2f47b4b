using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics.Views;

/// <content>How single things are drawn.</content>
public partial class PhysicsSimulatorView
{
    private const byte FillAlpha = 60;
    private const int TurnsOfASpring = 6;

    private float _markLength = 10;
    private float _pointSize = 4;

    private void DrawGeom(Geom geom)
    {
        DebugColor color = ColorOf(geom);
        if (EnableEdgeView)
        {
            if (geom.Form?.Kind == FormKind.Circle)
            {
                Vector2 center = geom.Position;
                _draw.DrawCircle(center, Vector2.Distance(geom.WorldVertices[0], center), color, color.WithAlpha(FillAlpha));
                _draw.DrawLine(center, geom.WorldVertices[0], color);
            }
            else if (geom.Form is { Kind: FormKind.Chain or FormKind.Segment } line)
            {
                DrawLines(geom.WorldVertices, line.IsLoop, color);
            }
            else
            {
                _draw.DrawPolygon(geom.WorldVertices, color, color.WithAlpha(FillAlpha));
            }
        }

        if (EnableAABBView)
        {
            DrawBox(geom.AABB, AABBColor, AABBColor.WithAlpha(0));
        }

        if (EnableGridView)
        {
            DrawGrid(geom);
        }

        if (EnableVerticeView)
        {
            foreach (Vector2 vertex in geom.WorldVertices)
            {
                _draw.DrawPoint(vertex, _pointSize, VerticeColor);
            }
        }
    }

    /// <summary>A chain or a segment has no inside to fill.</summary>
    private void DrawLines(Vertices points, bool isLoop, DebugColor color)
    {
        for (int i = isLoop ? 0 : 1; i < points.Count; i++)
        {
            _draw.DrawLine(points[i == 0 ? points.Count - 1 : i - 1], points[i], color);
        }
    }

    private void DrawBox(AABB box, DebugColor line, DebugColor fill)
    {
        _corners.Clear();
        _corners.Add(box.Min);
        _corners.Add(new Vector2(box.Max.X, box.Min.Y));
        _corners.Add(box.Max);
        _corners.Add(new Vector2(box.Min.X, box.Max.Y));
        _draw.DrawPolygon(_corners, line, fill);
    }

    private void DrawFluid(Controller controller)
    {
        if (controller is WaveController { CurrentWave: { } heights, XPosition: { } places } wave)
        {
            _corners.Clear();
            for (int i = 0; i < heights.Length; i++)
            {
                _corners.Add(new Vector2(places[i], wave.Position.Y + heights[i]));
            }

            _corners.Add(new Vector2(wave.Position.X + wave.Width, wave.Position.Y + wave.Height));
            _corners.Add(new Vector2(wave.Position.X, wave.Position.Y + wave.Height));
            _draw.DrawPolygon(_corners, FluidColor, FluidColor.WithAlpha(FillAlpha));
        }
        else if (controller is FluidDragController { Container: AABBFluidContainer { AABB: { } box } })
        {
            DrawBox(box, FluidColor, FluidColor.WithAlpha(FillAlpha));
        }
    }

    private void DrawGrid(Geom geom)
    {
        if (geom.Grid?.Points is not { } points)
        {
            return;
        }

        foreach (Vector2 point in points)
        {
            Vector2 world = geom.GetWorldPosition(point);
            bool isInside = geom.Collide(world);
            _draw.DrawPoint(world, _pointSize / 2, isInside ? GridColor : GridColor.WithAlpha((byte)(GridColor.A / 2)));
        }
    }

    private void DrawAxes(Body body)
    {
        _draw.DrawLine(body.Position, body.Position + (_markLength * body.XVectorInWorldCoordinates), AxisColor);
        _draw.DrawLine(
            body.Position, body.Position + (_markLength * body.YVectorInWorldCoordinates), AxisColor.WithAlpha((byte)(AxisColor.A / 2)));
        _draw.DrawPoint(body.Position, _pointSize, AxisColor);
    }

    private void DrawSpring(Spring spring)
    {
        switch (spring)
        {
            case LinearSpring { Body1: { } one, Body2: { } two } linear:
                DrawCoil(
                    one.GetWorldPosition(linear.AttachPoint1),
                    two.GetWorldPosition(linear.AttachPoint2),
                    Strain(spring, linear.RestLength));
                break;
            case FixedLinearSpring { Body: { } body } linear:
                DrawCoil(body.GetWorldPosition(linear.BodyAttachPoint), linear.WorldAttachPoint, Strain(spring, linear.RestLength));
                break;
            case AngleSpring { Body1: { } one, Body2: { } two } angle:
                DrawTwist(one.GetWorldPosition(angle.Anchor1), spring);
                DrawTwist(two.GetWorldPosition(angle.Anchor2), spring);
                break;
            case FixedAngleSpring { Body: { } body }:
                DrawTwist(body.Position, spring);
                break;
        }
    }

    /// <summary>0 at rest, 1 near breaking or with an error as large as the spring itself.</summary>
    private static float Strain(Spring spring, float size)
    {
        float error = Math.Abs(spring.SpringError);
        float share = size > 0 ? error / size : 0;
        return spring.Enabled ? Math.Min(1, Math.Max(share, error / Math.Max(spring.Breakpoint, float.Epsilon))) : 0;
    }

    private DebugColor Mixed(DebugColor rest, float strain) => new DebugColor(
        Mix(rest.R, StrainedColor.R, strain),
        Mix(rest.G, StrainedColor.G, strain),
        Mix(rest.B, StrainedColor.B, strain),
        Mix(rest.A, StrainedColor.A, strain));

    private static byte Mix(byte a, byte b, float share) => (byte)(a + ((b - a) * share));

    private void DrawCoil(Vector2 start, Vector2 end, float strain)
    {
        DebugColor color = Mixed(SpringColor, strain);
        Vector2 way = end - start;
        Vector2 side = new Vector2(-way.Y, way.X);
        float length = way.Length();
        side = length > 0 ? side / length * Math.Min(_markLength / 3, length / 4) : Vector2.Zero;
        Vector2 last = start;
        for (int i = 1; i < 2 * TurnsOfASpring; i++)
        {
            Vector2 next = start + (way * (i / (2f * TurnsOfASpring))) + (i % 2 == 0 ? side : -side);
            _draw.DrawLine(last, next, color);
            last = next;
        }

        _draw.DrawLine(last, end, color);
        _draw.DrawPoint(start, _pointSize, color);
        _draw.DrawPoint(end, _pointSize, color);
    }

    private void DrawTwist(Vector2 place, Spring spring)
    {
        DebugColor color = Mixed(SpringColor, Strain(spring, (float)Math.PI));
        _draw.DrawCircle(place, _markLength / 2, color, color.WithAlpha(0));
        _draw.DrawPoint(place, _pointSize, color);
    }
}
