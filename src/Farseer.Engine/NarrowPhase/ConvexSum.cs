using System;
using Farseer.Engine.Storage;

namespace Farseer.Engine.NarrowPhase;

/// <summary>A convex shape of points in order around it, with a rounding.</summary>
internal unsafe struct PointHull
{
    /// <summary>x and y of each point.</summary>
    public double* Points;
    public int Count;
    public double Radius;
}

/// <summary>Where two shapes that approach each other first touch.</summary>
internal struct SumHit
{
    public double Fraction;

    /// <summary>Unit normal of the standing shape at the point.</summary>
    public double NormalX;
    public double NormalY;
    public double X;
    public double Y;
}

/// <summary>
/// The set of all displacements at which a moving convex shape overlaps a standing one: the sum of the standing and the reversed
/// moving shape, convex again, rounded by both radii. A cast of the shape is then a ray against it, and an overlap is the question whether
/// it holds the displacement 0: both exact, without iteration.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class ConvexSum
{
    private readonly Column<double> _points = new Column<double>();
    private readonly Column<int> _ofStanding = new Column<int>();
    private readonly Column<int> _ofMoving = new Column<int>();
    private PointHull _standing;
    private PointHull _moving;
    private int _count;

    private double Radius => _standing.Radius + _moving.Radius;

    /// <summary>Forms the sum; the shapes' points must stay where they are as long as it is asked.</summary>
    public void Build(in PointHull standing, in PointHull moving)
    {
        _standing = standing;
        _moving = moving;
        _count = 0;
        int most = standing.Count + moving.Count + 1;
        _points.EnsureCapacity(2 * most);
        _ofStanding.EnsureCapacity(most);
        _ofMoving.EnsureCapacity(most);
        int i = Lowest(standing, 1);
        int j = Lowest(moving, -1);
        int leftOfStanding = standing.Count > 1 ? standing.Count : 0;
        int leftOfMoving = moving.Count > 1 ? moving.Count : 0;
        do
        {
            Emit(i, j);
            double cross = Turn(i, j);
            bool stepStanding = leftOfStanding > 0 && (leftOfMoving == 0 || cross >= 0);
            bool stepMoving = leftOfMoving > 0 && (leftOfStanding == 0 || cross <= 0);
            if (stepStanding)
            {
                i = i + 1 == standing.Count ? 0 : i + 1;
                leftOfStanding--;
            }

            if (stepMoving)
            {
                j = j + 1 == moving.Count ? 0 : j + 1;
                leftOfMoving--;
            }
        }
        while (leftOfStanding + leftOfMoving > 0);
    }

    /// <summary>Whether the shapes overlap or touch where they are.</summary>
    public bool HoldsOrigin()
    {
        double* p = _points.Pointer;
        bool inside = _count > 2 && Area() > 0;
        double nearest = double.PositiveInfinity;
        for (int i = 0; i < _count; i++)
        {
            int next = i + 1 == _count ? 0 : i + 1;
            double ax = p[2 * i];
            double ay = p[(2 * i) + 1];
            double ex = p[2 * next] - ax;
            double ey = p[(2 * next) + 1] - ay;
            inside &= (ey * ax) - (ex * ay) >= 0;
            double square = (ex * ex) + (ey * ey);
            double t = square > 0 ? -((ax * ex) + (ay * ey)) / square : 0;
            t = t < 0 ? 0 : t > 1 ? 1 : t;
            ax += t * ex;
            ay += t * ey;
            nearest = Math.Min(nearest, (ax * ax) + (ay * ay));
        }

        return inside || nearest <= Radius * Radius;
    }

    /// <summary>Moves the moving shape along a way, from a place where it does not overlap the standing one.</summary>
    /// <param name="dx">The way.</param>
    /// <param name="dy">The way.</param>
    /// <param name="limit">Share of the way from which on a touch does not count.</param>
    /// <param name="hit">Where they touch.</param>
    public bool Cast(double dx, double dy, double limit, out SumHit hit)
    {
        RayPath path = default;
        path.DirectionX = dx;
        path.DirectionY = dy;
        path.Fraction = limit;
        double* p = _points.Pointer;
        bool found = false;
        for (int i = 0; _count > 1 && i < _count; i++)
        {
            int next = i + 1 == _count ? 0 : i + 1;
            found |= path.EnterEdge(p[2 * i], p[(2 * i) + 1], p[2 * next], p[(2 * next) + 1], Radius, i);
        }

        for (int i = 0; Radius > 0 && i < _count; i++)
        {
            found |= path.EnterDisc(p[2 * i], p[(2 * i) + 1], Radius, i + _count);
        }

        hit.Fraction = path.Fraction;
        hit.NormalX = path.NormalX;
        hit.NormalY = path.NormalY;
        hit.X = 0;
        hit.Y = 0;
        if (found)
        {
            FindPoint(path, ref hit);
        }

        return found;
    }

    /// <summary>The lowest point, of those the leftmost; of the reversed shape with <paramref name="sign"/> −1.</summary>
    private static int Lowest(in PointHull hull, int sign)
    {
        int best = 0;
        for (int i = 1; i < hull.Count; i++)
        {
            double y = sign * (hull.Points[(2 * i) + 1] - hull.Points[(2 * best) + 1]);
            double x = sign * (hull.Points[2 * i] - hull.Points[2 * best]);
            if (y < 0 || (y == 0 && x < 0))
            {
                best = i;
            }
        }

        return best;
    }

    private void Emit(int i, int j)
    {
        _ofStanding[_count] = i;
        _ofMoving[_count] = j;
        _points[2 * _count] = _standing.Points[2 * i] - _moving.Points[2 * j];
        _points[(2 * _count) + 1] = _standing.Points[(2 * i) + 1] - _moving.Points[(2 * j) + 1];
        _count++;
    }

    /// <summary>Above 0 if the next edge of the standing shape comes before that of the reversed moving one.</summary>
    private double Turn(int i, int j)
    {
        int nextI = i + 1 == _standing.Count ? 0 : i + 1;
        int nextJ = j + 1 == _moving.Count ? 0 : j + 1;
        double ax = _standing.Points[2 * nextI] - _standing.Points[2 * i];
        double ay = _standing.Points[(2 * nextI) + 1] - _standing.Points[(2 * i) + 1];
        double bx = _moving.Points[2 * j] - _moving.Points[2 * nextJ];
        double by = _moving.Points[(2 * j) + 1] - _moving.Points[(2 * nextJ) + 1];
        double cross = (ax * by) - (ay * bx);

        // Opposite edges have no turn either; the one that still goes up comes first.
        return cross == 0 && (ax * bx) + (ay * by) < 0 ? (ay > 0 || (ay == 0 && ax > 0) ? 1 : -1) : cross;
    }

    private double Area()
    {
        double* p = _points.Pointer;
        double sum = 0;
        for (int i = 1; i + 1 < _count; i++)
        {
            double ax = p[2 * i] - p[0];
            double ay = p[(2 * i) + 1] - p[1];
            double bx = p[(2 * i) + 2] - p[0];
            double by = p[(2 * i) + 3] - p[1];
            sum += (ax * by) - (ay * bx);
        }

        return sum;
    }

    /// <summary>The point of the standing shape that is touched; of two edges that meet flat, the middle of what they share.</summary>
    private void FindPoint(in RayPath path, ref SumHit hit)
    {
        int feature = path.Feature % _count;
        int next = feature + 1 == _count ? 0 : feature + 1;
        bool corner = path.Feature >= _count;
        int a = _ofStanding[feature];
        int b = _ofMoving[feature];
        int endA = corner ? a : _ofStanding[next];
        int endB = corner ? b : _ofMoving[next];
        double wayX = path.DirectionX * path.Fraction;
        double wayY = path.DirectionY * path.Fraction;
        if (a == endA)
        {
            hit.X = _standing.Points[2 * a] + (hit.NormalX * _standing.Radius);
            hit.Y = _standing.Points[(2 * a) + 1] + (hit.NormalY * _standing.Radius);
            return;
        }

        double sx = _moving.Points[2 * b] + wayX - (hit.NormalX * _moving.Radius);
        double sy = _moving.Points[(2 * b) + 1] + wayY - (hit.NormalY * _moving.Radius);
        if (b != endB)
        {
            // Along the edge of the standing shape, from its start; the edge of the moving one runs the other way.
            double ex = -hit.NormalY;
            double ey = hit.NormalX;
            double end = Along(_standing, endA, a, ex, ey);
            double from = ((sx - _standing.Points[2 * a]) * ex) + ((sy - _standing.Points[(2 * a) + 1]) * ey);
            double to = from + Along(_moving, endB, b, ex, ey);
            double low = Math.Max(0, Math.Min(from, to));
            double high = Math.Min(end, Math.Max(from, to));
            double shift = (0.5 * (low + high)) - from;
            sx += shift * ex;
            sy += shift * ey;
        }

        hit.X = sx;
        hit.Y = sy;
    }

    private static double Along(in PointHull hull, int to, int from, double x, double y) =>
        ((hull.Points[2 * to] - hull.Points[2 * from]) * x) + ((hull.Points[(2 * to) + 1] - hull.Points[(2 * from) + 1]) * y);
}
