using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Interfaces;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// The part of a geom that is in a fluid. What has straight bounds is cut out exactly. Of any other fluid only points can be asked for: the
/// geom's outline is then divided, and where it passes the surface found by halving.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed class SubmergedPart
{
    /// <summary>Halvings of a side or an arc before its ends are asked for: four parts a side, eight a quarter turn.</summary>
    private const int LineHalvings = 2;

    private const int ArcHalvings = 3;

    /// <summary>Halvings that find where an edge passes the surface; the last is as fine as a float.</summary>
    private const int CrossingHalvings = 24;

    /// <summary>Share of its vertices that a geom must have in the fluid to feel it, where vertices are counted.</summary>
    private const double LeastShareOfVertices = 0.05;

    private readonly RoundOutline _whole = new RoundOutline();
    private readonly RoundOutline _inside = new RoundOutline();
    private readonly RoundOutline _cut = new RoundOutline();
    private readonly RoundOutline _cutAgain = new RoundOutline();
    private readonly Vector2[] _corners = new Vector2[4];

    // The place of the body; the outlines are relative to it.
    private double _x;
    private double _y;

    // The place of the geom, relative to the body's, and its turn.
    private double _armX;
    private double _armY;
    private double _cos;
    private double _sin;

    /// <summary>Area in the fluid; 0 or more.</summary>
    public double Area { get; private set; }

    /// <summary>Area of the geom; 0 or more.</summary>
    public double WholeArea { get; private set; }

    /// <summary>Centroid of what is in the fluid, as seen from the body's place.</summary>
    public double ArmX { get; private set; }

    /// <summary>See <see cref="ArmX"/>.</summary>
    public double ArmY { get; private set; }

    /// <summary>How far the part reaches along a direction of length 1.</summary>
    public double Width(double x, double y) => _inside.Width(x, y);

    /// <summary>Finds the part.</summary>
    /// <param name="geom">A geom with a body.</param>
    /// <param name="fluid">The fluid.</param>
    /// <param name="ahead">Seconds for which the body is to go on first.</param>
    public void Find(Geom geom, IFluidContainer fluid, double ahead)
    {
        Place(geom, ahead);
        Outline(geom.Form!);
        _inside.Clear();
        if (fluid is IStraightFluid straight)
        {
            CutOut(straight);
        }
        else
        {
            Gather(fluid);
        }

        Measure();
    }

    /// <summary>Finds the polygon of those vertices of a geom that are in a fluid (a quirk of the original).</summary>
    /// <param name="geom">A geom with a body.</param>
    /// <param name="fluid">The fluid.</param>
    /// <param name="ahead">Seconds for which the body is to go on first.</param>
    public void FindByVertices(Geom geom, IFluidContainer fluid, double ahead)
    {
        Place(geom, ahead);
        _whole.Clear();
        _inside.Clear();
        Vertices vertices = geom.LocalVertices;
        int found = 0;
        for (int i = 0; i < vertices.Count; i++)
        {
            Turned(vertices[i], out double x, out double y);
            OutlineEdge corner = OutlineEdge.Line(x, y, x, y);
            _whole.Add(corner);
            if (Holds(fluid, x, y))
            {
                _inside.Add(corner);
                found++;
            }
        }

        _whole.Close();
        _inside.Close();
        if (found < 3 || found < vertices.Count * LeastShareOfVertices)
        {
            _inside.Clear();
        }

        Measure();
    }

    private void Measure()
    {
        WholeArea = Math.Abs(_whole.Area(out _, out _));
        double area = _inside.Area(out double momentX, out double momentY);
        Area = Math.Abs(area);
        ArmX = area != 0 ? momentX / area : 0;
        ArmY = area != 0 ? momentY / area : 0;
    }

    private void Place(Geom geom, double ahead)
    {
        Body body = geom.Body;
        BodyPose pose = body.Link.PoseRef;
        geom.GetPlacement(out double x, out double y, out float cos, out float sin);

        // A turn by twice the arctangent of half the angle: a true turn for any spin.
        double half = 0.5 * ahead * body.AngularVelocity;
        double turnCos = (1 - (half * half)) / (1 + (half * half));
        double turnSin = 2 * half / (1 + (half * half));
        _x = pose.X + (ahead * body.LinearVelocity.X);
        _y = pose.Y + (ahead * body.LinearVelocity.Y);
        _armX = (turnCos * (x - pose.X)) - (turnSin * (y - pose.Y));
        _armY = (turnSin * (x - pose.X)) + (turnCos * (y - pose.Y));
        _cos = (turnCos * cos) - (turnSin * sin);
        _sin = (turnSin * cos) + (turnCos * sin);
    }

    private void Outline(GeomForm form)
    {
        _whole.Clear();
        switch (form.Kind)
        {
            case FormKind.Circle:
                _whole.AddCircle(_armX, _armY, form.Radius);
                break;
            case FormKind.Box:
                _corners[0] = new Vector2(-0.5f * form.Size.X, -0.5f * form.Size.Y);
                _corners[1] = new Vector2(0.5f * form.Size.X, -0.5f * form.Size.Y);
                _corners[2] = new Vector2(0.5f * form.Size.X, 0.5f * form.Size.Y);
                _corners[3] = new Vector2(-0.5f * form.Size.X, 0.5f * form.Size.Y);
                Round(_corners, 0);
                break;
            case FormKind.Segment:
                break;
            default:
                Round(form.Points, form.Radius);
                break;
        }
    }

    /// <summary>The outline of all points within a radius of a polygon, which is convex unless the radius is 0.</summary>
    private void Round(Vector2[] points, double radius)
    {
        double area = 0;
        for (int i = 0; i < points.Length; i++)
        {
            Vector2 next = points[(i + 1) % points.Length];
            area += ((double)points[i].X * next.Y) - ((double)points[i].Y * next.X);
        }

        int step = area < 0 ? points.Length - 1 : 1;
        double lastX = 0;
        double lastY = 0;
        for (int i = 0, at = 0; i <= points.Length; i++, at = (at + step) % points.Length)
        {
            Turned(points[at], out double x, out double y);
            Turned(points[(at + step) % points.Length], out double endX, out double endY);
            double alongX = endX - x;
            double alongY = endY - y;
            double length = Math.Sqrt((alongX * alongX) + (alongY * alongY));
            double normalX = length > 0 ? alongY / length : 1;
            double normalY = length > 0 ? -alongX / length : 0;
            if (i > 0 && radius > 0)
            {
                _whole.AddArc(x, y, radius, lastX, lastY, normalX, normalY);
            }

            if (i < points.Length)
            {
                double outX = radius * normalX;
                double outY = radius * normalY;
                _whole.Add(OutlineEdge.Line(x + outX, y + outY, endX + outX, endY + outY));
            }

            lastX = normalX;
            lastY = normalY;
        }

        _whole.Close();
    }

    private void Turned(Vector2 point, out double x, out double y)
    {
        x = _armX + ((_cos * point.X) - (_sin * point.Y));
        y = _armY + ((_sin * point.X) + (_cos * point.Y));
    }

    private void CutOut(IStraightFluid fluid)
    {
        _whole.Reach(out double min, out double max);
        fluid.PartsWithin(_x + min, _x + max, out int first, out int end);
        for (int i = first; i < end; i++)
        {
            FluidPart part = fluid.Part(i);
            OutlineEdge surface = part.Surface;
            double alongX = surface.EndX - surface.X;
            double alongY = surface.EndY - surface.Y;
            double length = Math.Sqrt((alongX * alongX) + (alongY * alongY));
            if (!(length > 0))
            {
                continue;
            }

            double outX = alongY / length;
            double outY = -alongX / length;
            _whole.Cut(outX, outY, (outX * (surface.X - _x)) + (outY * (surface.Y - _y)), _cut);
            _cut.Cut(0, 1, part.Bottom - _y, _cutAgain);
            _cutAgain.Cut(-1, 0, _x - part.Left, _cut);
            _cut.Cut(1, 0, part.Right - _x, _cutAgain);
            for (int edge = 0; edge < _cutAgain.Count; edge++)
            {
                _inside.Add(_cutAgain[edge]);
            }

            _inside.Close();
        }
    }

    private void Gather(IFluidContainer fluid)
    {
        for (int i = 0; i < _whole.Count; i++)
        {
            OutlineEdge edge = _whole[i];
            Gather(
                fluid,
                edge,
                Holds(fluid, edge.X, edge.Y),
                Holds(fluid, edge.EndX, edge.EndY),
                edge.Radius > 0 ? ArcHalvings : LineHalvings);
        }

        _inside.Close();
    }

    private void Gather(IFluidContainer fluid, in OutlineEdge edge, bool startsIn, bool endsIn, int halvings)
    {
        edge.Middle(out double x, out double y);
        if (halvings > 0)
        {
            bool middleIn = Holds(fluid, x, y);
            Gather(fluid, edge.Piece(edge.X, edge.Y, x, y), startsIn, middleIn, halvings - 1);
            Gather(fluid, edge.Piece(x, y, edge.EndX, edge.EndY), middleIn, endsIn, halvings - 1);
            return;
        }

        if (startsIn == endsIn)
        {
            if (startsIn)
            {
                _inside.Add(edge);
            }

            return;
        }

        OutlineEdge around = edge;
        for (int i = 0; i < CrossingHalvings; i++)
        {
            around.Middle(out x, out y);
            around = Holds(fluid, x, y) == startsIn ? around.Piece(x, y, around.EndX, around.EndY) : around.Piece(around.X, around.Y, x, y);
        }

        _inside.Add(startsIn ? edge.Piece(edge.X, edge.Y, around.X, around.Y) : edge.Piece(around.EndX, around.EndY, edge.EndX, edge.EndY));
    }

    private bool Holds(IFluidContainer fluid, double x, double y)
    {
        var point = new Vector2((float)(_x + x), (float)(_y + y));
        return fluid.Contains(ref point);
    }
}
