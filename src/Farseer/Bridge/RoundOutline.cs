using System;
using System.Collections.Generic;
using Farseer.Engine.Numerics;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// A region bounded by lines and arcs in the positive sense, concave or not. A cut leaves parts that lie apart joined along the line of the
/// cut, to and fro: these seams add nothing to area, centroid or width.
/// </summary>
internal sealed class RoundOutline
{
    private readonly List<OutlineEdge> _edges = new List<OutlineEdge>();
    private double _startX;
    private double _startY;
    private double _x;
    private double _y;
    private bool _isOpen;

    public int Count => _edges.Count;

    public OutlineEdge this[int index] => _edges[index];

    public void Clear()
    {
        _edges.Clear();
        _isOpen = false;
    }

    /// <summary>Adds an edge; one that does not begin where the last ended is joined to it by a line.</summary>
    public void Add(in OutlineEdge edge)
    {
        if (_isOpen)
        {
            JoinTo(edge.X, edge.Y);
        }
        else
        {
            _startX = edge.X;
            _startY = edge.Y;
            _isOpen = true;
        }

        _edges.Add(edge);
        _x = edge.EndX;
        _y = edge.EndY;
    }

    /// <summary>Joins the end of what was added since the last call to its beginning.</summary>
    public void Close()
    {
        if (_isOpen)
        {
            JoinTo(_startX, _startY);
            _isOpen = false;
        }
    }

    public void AddCircle(double x, double y, double radius)
    {
        AddArc(x, y, radius, 1, 0, -1, 0);
        AddArc(x, y, radius, -1, 0, 1, 0);
        Close();
    }

    /// <summary>Adds an arc of up to half a turn, in two parts.</summary>
    /// <param name="x">x of its centre.</param>
    /// <param name="y">y of its centre.</param>
    /// <param name="radius">Its radius.</param>
    /// <param name="fromX">x of the direction in which it begins; of length 1.</param>
    /// <param name="fromY">y of that.</param>
    /// <param name="toX">x of the direction in which it ends; of length 1.</param>
    /// <param name="toY">y of that.</param>
    public void AddArc(double x, double y, double radius, double fromX, double fromY, double toX, double toY)
    {
        OutlineEdge arc = OutlineEdge.Line(
            x + (radius * fromX), y + (radius * fromY), x + (radius * toX), y + (radius * toY));
        arc.CentreX = x;
        arc.CentreY = y;
        arc.Radius = radius;
        arc.Middle(out double middleX, out double middleY);
        Add(arc.Piece(arc.X, arc.Y, middleX, middleY));
        Add(arc.Piece(middleX, middleY, arc.EndX, arc.EndY));
    }

    /// <summary>Area and its first moments about the origin, by Green's theorem.</summary>
    /// <param name="momentX">Area times x of the centroid.</param>
    /// <param name="momentY">Area times y of the centroid.</param>
    /// <returns>The area.</returns>
    public double Area(out double momentX, out double momentY)
    {
        double area = 0;
        momentX = 0;
        momentY = 0;
        for (int i = 0; i < _edges.Count; i++)
        {
            OutlineEdge edge = _edges[i];
            double triangle = 0.5 * ((edge.X * edge.EndY) - (edge.Y * edge.EndX));
            area += triangle;
            momentX += triangle * (edge.X + edge.EndX) / 3;
            momentY += triangle * (edge.Y + edge.EndY) / 3;
            if (edge.Radius > 0)
            {
                // The segment between arc and chord: its moment about the centre is chord³ / 12, outwards.
                double chordX = edge.EndX - edge.X;
                double chordY = edge.EndY - edge.Y;
                double cross = Cross(edge, edge.X, edge.Y, edge.EndX, edge.EndY);
                double angle = StableMath.Atan2(cross, Dot(edge, edge.X, edge.Y, edge.EndX, edge.EndY));
                double segment = 0.5 * ((edge.Radius * edge.Radius * angle) - cross);
                double outward = ((chordX * chordX) + (chordY * chordY)) / 12;
                area += segment;
                momentX += (segment * edge.CentreX) + (outward * chordY);
                momentY += (segment * edge.CentreY) - (outward * chordX);
            }
        }

        return area;
    }

    /// <summary>How far the region reaches along a direction.</summary>
    /// <param name="x">x of the direction, of length 1.</param>
    /// <param name="y">y of the direction.</param>
    /// <returns>A length; 0 of an empty region.</returns>
    public double Width(double x, double y)
    {
        double min = double.PositiveInfinity;
        double max = double.NegativeInfinity;
        for (int i = 0; i < _edges.Count; i++)
        {
            OutlineEdge edge = _edges[i];
            double start = (x * edge.X) + (y * edge.Y);
            double end = (x * edge.EndX) + (y * edge.EndY);
            min = Math.Min(min, Math.Min(start, end));
            max = Math.Max(max, Math.Max(start, end));
            if (edge.Radius > 0)
            {
                double centre = (x * edge.CentreX) + (y * edge.CentreY);
                max = Holds(edge, edge.CentreX + x, edge.CentreY + y) ? Math.Max(max, centre + edge.Radius) : max;
                min = Holds(edge, edge.CentreX - x, edge.CentreY - y) ? Math.Min(min, centre - edge.Radius) : min;
            }
        }

        return _edges.Count > 0 ? max - min : 0;
    }

    /// <summary>Bounds of x; those of arcs are a little too wide.</summary>
    public void Reach(out double min, out double max)
    {
        min = double.PositiveInfinity;
        max = double.NegativeInfinity;
        for (int i = 0; i < _edges.Count; i++)
        {
            OutlineEdge edge = _edges[i];
            min = Math.Min(min, Math.Min(edge.X, edge.EndX) - edge.Radius);
            max = Math.Max(max, Math.Max(edge.X, edge.EndX) + edge.Radius);
        }
    }

    /// <summary>Puts what lies on the inner side of a line into another outline, which is emptied first.</summary>
    /// <param name="x">x of the outward normal, of length 1.</param>
    /// <param name="y">y of the outward normal.</param>
    /// <param name="distance">Distance of the line from the origin along it.</param>
    /// <param name="inside">Where to.</param>
    public void Cut(double x, double y, double distance, RoundOutline inside)
    {
        inside.Clear();
        for (int i = 0; i < _edges.Count; i++)
        {
            OutlineEdge edge = _edges[i];
            double start = (x * edge.X) + (y * edge.Y) - distance;
            double end = (x * edge.EndX) + (y * edge.EndY) - distance;
            if (edge.Radius > 0)
            {
                CutArc(edge, x, y, distance, start <= 0, end <= 0, inside);
            }
            else if (start <= 0 && end <= 0)
            {
                inside.Add(edge);
            }
            else if (start <= 0 || end <= 0)
            {
                double share = start / (start - end);
                double atX = edge.X + (share * (edge.EndX - edge.X));
                double atY = edge.Y + (share * (edge.EndY - edge.Y));
                inside.Add(start <= 0 ? edge.Piece(edge.X, edge.Y, atX, atY) : edge.Piece(atX, atY, edge.EndX, edge.EndY));
            }
        }

        inside.Close();
    }

    private static void CutArc(in OutlineEdge arc, double x, double y, double distance, bool startsIn, bool endsIn, RoundOutline inside)
    {
        double height = (distance - (x * arc.CentreX) - (y * arc.CentreY)) / arc.Radius;
        double half = 1 - (height * height);
        if (!(half > 0))
        {
            if (height > 0)
            {
                inside.Add(arc);
            }

            return;
        }

        // In the positive sense a circle leaves the inner side at the first of these points and comes back at the second.
        half = Math.Sqrt(half);
        double outX = arc.CentreX + (arc.Radius * ((height * x) + (half * y)));
        double outY = arc.CentreY + (arc.Radius * ((height * y) - (half * x)));
        double inX = arc.CentreX + (arc.Radius * ((height * x) - (half * y)));
        double inY = arc.CentreY + (arc.Radius * ((height * y) + (half * x)));
        if (startsIn && endsIn)
        {
            if (Holds(arc, outX, outY) && Holds(arc, inX, inY) && Cross(arc, outX, outY, inX, inY) > 0)
            {
                inside.Add(arc.Piece(arc.X, arc.Y, outX, outY));
                inside.Add(arc.Piece(inX, inY, arc.EndX, arc.EndY));
            }
            else
            {
                inside.Add(arc);
            }
        }
        else if (startsIn)
        {
            inside.Add(arc.Piece(arc.X, arc.Y, outX, outY));
        }
        else if (endsIn)
        {
            inside.Add(arc.Piece(inX, inY, arc.EndX, arc.EndY));
        }
        else if (Holds(arc, outX, outY) && Holds(arc, inX, inY))
        {
            inside.Add(arc.Piece(inX, inY, outX, outY));
        }
    }

    /// <summary>Whether the ray from the centre through a point meets the arc.</summary>
    private static bool Holds(in OutlineEdge arc, double x, double y) =>
        Cross(arc, arc.X, arc.Y, x, y) >= 0 && Cross(arc, x, y, arc.EndX, arc.EndY) >= 0;

    private static double Cross(in OutlineEdge arc, double x, double y, double endX, double endY) =>
        ((x - arc.CentreX) * (endY - arc.CentreY)) - ((y - arc.CentreY) * (endX - arc.CentreX));

    private static double Dot(in OutlineEdge arc, double x, double y, double endX, double endY) =>
        ((x - arc.CentreX) * (endX - arc.CentreX)) + ((y - arc.CentreY) * (endY - arc.CentreY));

    private void JoinTo(double x, double y)
    {
        if (_x != x || _y != y)
        {
            _edges.Add(OutlineEdge.Line(_x, _y, x, y));
        }
    }
}
