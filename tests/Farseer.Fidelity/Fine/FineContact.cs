using System;
using System.Collections.Generic;

namespace Farseer.Fidelity.Fine;

/// <summary>Where two shapes touch: up to two points, found anew in each small step, with the impulses of the last one.</summary>
internal sealed class FineContact(FineShape a, FineShape b, double friction, double restitution)
{
    private readonly FinePoint[] _points = [new(), new()];
    private double _normalX;
    private double _normalY;
    private int _count;

    public FineShape A => a;

    public FineShape B => b;

    /// <summary>How far the shapes are apart; not a number while they are farther than was looked.</summary>
    public double Gap => _count == 0 ? double.NaN : _count == 1 ? _points[0].Gap : Math.Min(_points[0].Gap, _points[1].Gap);

    /// <summary>Finds the points; what is further apart than <paramref name="near"/> does not matter yet.</summary>
    /// <returns>False if there is none.</returns>
    public bool Find(double near)
    {
        double reach = a.Reach() + b.Reach() + near;
        (double dx, double dy) = (b.Body.X - a.Body.X, b.Body.Y - a.Body.Y);
        if ((dx * dx) + (dy * dy) > reach * reach)
        {
            _count = 0;
            return false;
        }

        int before = _count;
        _count = 0;
        if (b.Radius > 0)
        {
            CircleAt(b, a, near, 1);
        }
        else if (a.Radius > 0)
        {
            CircleAt(a, b, near, -1);
        }
        else
        {
            Polygons(near);
        }

        for (int i = before; i < _points.Length; i++)
        {
            (_points[i].Normal, _points[i].Tangent) = (0, 0);
        }

        return _count > 0;
    }

    /// <summary>Takes over the impulses of the last small step, and decides which points bounce.</summary>
    public void Begin(double threshold)
    {
        for (int i = 0; i < _count; i++)
        {
            FinePoint point = _points[i];
            double speed = NormalSpeed(point);
            bool strikes = point.Normal == 0 && speed < -threshold;

            // What will bounce keeps its speed until it is there.
            point.Waits = strikes && restitution > 0 && point.Gap > 0;
            point.Bounce = strikes && point.Gap <= 0 ? -restitution * speed : 0;
            Apply(point, point.Normal, point.Tangent);
        }

        for (int i = _count; i < _points.Length; i++)
        {
            (_points[i].Normal, _points[i].Tangent) = (0, 0);
        }
    }

    /// <summary>One sweep of projected Gauss-Seidel.</summary>
    public void Solve(double step)
    {
        for (int i = 0; i < _count; i++)
        {
            FinePoint point = _points[i];
            if (point.Waits)
            {
                continue;
            }

            double wanted = point.Gap > 0 ? -point.Gap / step : point.Bounce;
            double normal = Math.Max(0, point.Normal + ((wanted - NormalSpeed(point)) / Response(point, _normalX, _normalY)));
            Apply(point, normal - point.Normal, 0);
            point.Normal = normal;
            double bound = friction * normal;
            double tangent = Math.Clamp(point.Tangent - (TangentSpeed(point) / Response(point, -_normalY, _normalX)), -bound, bound);
            Apply(point, 0, tangent - point.Tangent);
            point.Tangent = tangent;
        }
    }

    /// <summary>
    /// A circle at a polygon or at a circle; the normal points from A to B, the circle is B where <paramref name="side"/> is 1.
    /// </summary>
    private void CircleAt(FineShape circle, FineShape other, double near, int side)
    {
        (double x, double y) = circle.World(0);
        (double distance, double nx, double ny) = other.Radius > 0 ? FromCircle(other, x, y) : FromPolygon(other, x, y);
        double gap = distance - circle.Radius;
        if (gap <= near)
        {
            (_normalX, _normalY) = (side * nx, side * ny);
            double middle = circle.Radius + (gap / 2);
            Add(x - (nx * middle), y - (ny * middle), gap);
        }
    }

    private static (double Distance, double X, double Y) FromCircle(FineShape other, double x, double y)
    {
        (double ox, double oy) = other.World(0);
        double length = Math.Sqrt(((x - ox) * (x - ox)) + ((y - oy) * (y - oy)));
        return (length - other.Radius, (x - ox) / length, (y - oy) / length);
    }

    private static (double Distance, double X, double Y) FromPolygon(FineShape polygon, double x, double y)
    {
        (double best, int face) = (double.NegativeInfinity, 0);
        int count = polygon.Corners.Length;
        for (int i = 0; i < count; i++)
        {
            (double px, double py, double nx, double ny) = Face(polygon, i);
            double distance = ((x - px) * nx) + ((y - py) * ny);
            (best, face) = distance > best ? (distance, i) : (best, face);
        }

        ((double ax, double ay), (double bx, double by)) = (polygon.World(face), polygon.World((face + 1) % count));
        double length = ((bx - ax) * (bx - ax)) + ((by - ay) * (by - ay));
        double along = (((x - ax) * (bx - ax)) + ((y - ay) * (by - ay))) / length;
        if (best <= 0 || (along >= 0 && along <= 1))
        {
            (_, _, double nx, double ny) = Face(polygon, face);
            return (best, nx, ny);
        }

        (double cx, double cy) = along < 0 ? (ax, ay) : (bx, by);
        double far = Math.Sqrt(((x - cx) * (x - cx)) + ((y - cy) * (y - cy)));
        return (far, (x - cx) / far, (y - cy) / far);
    }

    /// <summary>The face that parts them most; the other's face that looks at it, cut off at its sides.</summary>
    private void Polygons(double near)
    {
        (double gapA, int faceA) = Deepest(a, b);
        (double gapB, int faceB) = Deepest(b, a);
        if (Math.Max(gapA, gapB) > near)
        {
            return;
        }

        // A tie is decided for A, so that rounding does not change the face.
        const double Tie = 1e-7;
        bool atA = gapA >= gapB - Tie;
        (FineShape reference, FineShape other, int face) = atA ? (a, b, faceA) : (b, a, faceB);
        (double px, double py, double nx, double ny) = Face(reference, face);
        (_normalX, _normalY) = atA ? (nx, ny) : (-nx, -ny);
        (double tx, double ty) = (-ny, nx);
        (double qx, double qy) = reference.World((face + 1) % reference.Corners.Length);
        double end = ((qx - px) * tx) + ((qy - py) * ty);
        int count = other.Corners.Length;
        (double best, int incident) = (double.PositiveInfinity, 0);
        for (int i = 0; i < count; i++)
        {
            (_, _, double ox, double oy) = Face(other, i);
            double facing = (ox * nx) + (oy * ny);
            (best, incident) = facing < best ? (facing, i) : (best, incident);
        }

        (double X, double Y) first = other.World(incident);
        (double X, double Y) second = other.World((incident + 1) % count);
        double u = ((first.X - px) * tx) + ((first.Y - py) * ty);
        double v = ((second.X - px) * tx) + ((second.Y - py) * ty);
        if (Math.Max(u, v) < 0 || Math.Min(u, v) > end)
        {
            return;
        }

        foreach (double cut in new[] { Math.Clamp(u, 0, end), Math.Clamp(v, 0, end) })
        {
            double share = u == v ? 0 : (cut - u) / (v - u);
            (double x, double y) = (first.X + (share * (second.X - first.X)), first.Y + (share * (second.Y - first.Y)));
            double gap = ((x - px) * nx) + ((y - py) * ny);
            if (gap <= near)
            {
                Add(x - (nx * gap / 2), y - (ny * gap / 2), gap);
            }
        }
    }

    private static (double Gap, int Face) Deepest(FineShape polygon, FineShape other)
    {
        (double best, int face) = (double.NegativeInfinity, 0);
        for (int i = 0; i < polygon.Corners.Length; i++)
        {
            (double px, double py, double nx, double ny) = Face(polygon, i);
            double least = double.PositiveInfinity;
            for (int k = 0; k < other.Corners.Length; k++)
            {
                (double x, double y) = other.World(k);
                least = Math.Min(least, ((x - px) * nx) + ((y - py) * ny));
            }

            (best, face) = least > best ? (least, i) : (best, face);
        }

        return (best, face);
    }

    /// <summary>A corner of an edge and the normal outwards.</summary>
    private static (double X, double Y, double NormalX, double NormalY) Face(FineShape polygon, int edge)
    {
        (double px, double py) = polygon.World(edge);
        (double qx, double qy) = polygon.World((edge + 1) % polygon.Corners.Length);
        double length = Math.Sqrt(((qx - px) * (qx - px)) + ((qy - py) * (qy - py)));
        return (px, py, (qy - py) / length, (px - qx) / length);
    }

    private void Add(double x, double y, double gap)
    {
        FinePoint point = _points[_count++];
        (point.X, point.Y, point.Gap) = (x, y, gap);
    }

    private double Response(FinePoint p, double x, double y)
    {
        double armA = ((p.X - a.Body.X) * y) - ((p.Y - a.Body.Y) * x);
        double armB = ((p.X - b.Body.X) * y) - ((p.Y - b.Body.Y) * x);
        return a.Body.InverseMass + b.Body.InverseMass + (armA * armA * a.Body.InverseInertia) + (armB * armB * b.Body.InverseInertia);
    }

    private double NormalSpeed(FinePoint p) => Speed(p, _normalX, _normalY);

    private double TangentSpeed(FinePoint p) => Speed(p, -_normalY, _normalX);

    private double Speed(FinePoint p, double x, double y)
    {
        double vx = b.Body.VelocityX - (b.Body.Spin * (p.Y - b.Body.Y)) - a.Body.VelocityX + (a.Body.Spin * (p.Y - a.Body.Y));
        double vy = b.Body.VelocityY + (b.Body.Spin * (p.X - b.Body.X)) - a.Body.VelocityY - (a.Body.Spin * (p.X - a.Body.X));
        return (vx * x) + (vy * y);
    }

    private void Apply(FinePoint p, double normal, double tangent)
    {
        double x = (_normalX * normal) - (_normalY * tangent);
        double y = (_normalY * normal) + (_normalX * tangent);
        a.Body.Push(p.X, p.Y, -x, -y);
        b.Body.Push(p.X, p.Y, x, y);
    }

    private sealed class FinePoint
    {
        public double X { get; set; }

        public double Y { get; set; }

        public double Gap { get; set; }

        public double Normal { get; set; }

        public double Tangent { get; set; }

        public double Bounce { get; set; }

        public bool Waits { get; set; }
    }
}
