using System;
using System.Numerics;

namespace Farseer.Engine.Shapes;

/// <summary>Area, centroid and second moment of area about the centroid (inertia = mass · moment / area).</summary>
internal readonly struct MassProperties
{
    public MassProperties(double area, double centroidX, double centroidY, double secondMoment)
    {
        Area = area;
        CentroidX = centroidX;
        CentroidY = centroidY;
        SecondMoment = secondMoment;
    }

    public double Area { get; }

    public double CentroidX { get; }

    public double CentroidY { get; }

    public double SecondMoment { get; }

    public Vector2 Centroid => new Vector2((float)CentroidX, (float)CentroidY);

    /// <summary>Positive if the points run from the x axis towards the y axis.</summary>
    public static double SignedArea(ReadOnlySpan<Vector2> points)
    {
        double twice = 0;
        for (int i = 1; i + 1 < points.Length; i++)
        {
            twice += Outline.Cross(points[0], points[i], points[i + 1]);
        }

        return 0.5 * twice;
    }

    /// <summary>
    /// Of any simple outline, either order: triangles from the first point with their signs, so what a fan counts outside a
    /// concave outline it takes back. Differences from the first point keep the precision of far outlines.
    /// </summary>
    public static MassProperties OfOutline(ReadOnlySpan<Vector2> points)
    {
        double twice = 0;
        double sumX = 0;
        double sumY = 0;
        double sumMoment = 0;
        double x0 = points[0].X;
        double y0 = points[0].Y;
        for (int i = 1; i + 1 < points.Length; i++)
        {
            double ax = points[i].X - x0;
            double ay = points[i].Y - y0;
            double bx = points[i + 1].X - x0;
            double by = points[i + 1].Y - y0;
            double d = (ax * by) - (ay * bx);
            twice += d;
            sumX += d * (ax + bx);
            sumY += d * (ay + by);
            sumMoment += d * ((ax * ax) + (ax * bx) + (bx * bx) + (ay * ay) + (ay * by) + (by * by));
        }

        double cx = sumX / (3 * twice);
        double cy = sumY / (3 * twice);
        double area = 0.5 * twice;
        double moment = (sumMoment / 12) - (area * ((cx * cx) + (cy * cy)));
        return new MassProperties(Math.Abs(area), x0 + cx, y0 + cy, Math.Abs(moment));
    }

    public static MassProperties OfCircle(double radius)
    {
        double square = radius * radius;
        return new MassProperties(Math.PI * square, 0, 0, 0.5 * Math.PI * square * square);
    }

    public static MassProperties OfCapsule(Vector2 a, Vector2 b, double radius)
    {
        double x = (double)b.X - a.X;
        double y = (double)b.Y - a.Y;
        double length = Math.Sqrt((x * x) + (y * y));
        double square = radius * radius;

        // The two half discs make one disc whose halves are moved out by length/2: their centroids lie 4r/3π from the flat
        // side, so the parallel-axis terms are A(L²/4 + L·4r/3π) on top of the disc's own moment.
        double disc = Math.PI * square;
        double bar = 2 * radius * length;
        double discMoment = disc * ((0.5 * square) + (0.25 * length * length) + (length * 4 * radius / (3 * Math.PI)));
        double barMoment = bar * ((length * length) + (4 * square)) / 12;
        return new MassProperties(disc + bar, 0.5 * ((double)a.X + b.X), 0.5 * ((double)a.Y + b.Y), discMoment + barMoment);
    }
}
