using System;
using System.Linq;

namespace Farseer.Fidelity.Fine;

/// <summary>A circle (one corner, its centre) or a convex polygon (radius 0, corners counter-clockwise) in the frame of its body.</summary>
internal sealed class FineShape
{
    private FineShape(FineBody body, (double X, double Y)[] corners, double radius)
    {
        Body = body;
        Corners = corners;
        Radius = radius;
    }

    public FineBody Body { get; }

    public double Density { get; init; }

    public double Friction { get; init; }

    public double Restitution { get; init; }

    /// <summary>0 for a polygon.</summary>
    public double Radius { get; }

    public (double X, double Y)[] Corners { get; }

    public static FineShape Circle(
        FineBody body, (double X, double Y) centre, double radius, (double Density, double Friction, double Restitution) of)
        => new(body, [centre], radius) { Density = of.Density, Friction = of.Friction, Restitution = of.Restitution };

    /// <exception cref="NotExpressedException">The corners are not convex.</exception>
    public static FineShape Polygon(FineBody body, (double X, double Y)[] corners, (double Density, double Friction, double Restitution) of)
    {
        double area = Enumerable.Range(0, corners.Length).Sum(i => Cross(corners[i], corners[(i + 1) % corners.Length]));
        corners = area < 0 ? [.. corners.Reverse()] : corners;
        for (int i = 0; i < corners.Length; i++)
        {
            ((double px, double py), (double qx, double qy)) = (corners[i], corners[(i + 1) % corners.Length]);
            (double rx, double ry) = corners[(i + 2) % corners.Length];
            if (Cross((qx - px, qy - py), (rx - qx, ry - qy)) < 0)
            {
                throw new NotExpressedException("a polygon that is not convex");
            }
        }

        return new(body, corners, 0) { Density = of.Density, Friction = of.Friction, Restitution = of.Restitution };
    }

    /// <summary>The corners of a box about a centre, turned.</summary>
    public static (double X, double Y)[] Box(double halfWidth, double halfHeight, (double X, double Y) centre = default, double angle = 0)
    {
        (double sin, double cos) = Math.SinCos(angle);
        return [.. new[] { (-1, -1), (1, -1), (1, 1), (-1, 1) }.Select(c => (
            centre.X + (c.Item1 * halfWidth * cos) - (c.Item2 * halfHeight * sin),
            centre.Y + (c.Item1 * halfWidth * sin) + (c.Item2 * halfHeight * cos)))];
    }

    /// <summary>Area, centroid, and second moment about the body's origin of a unit density.</summary>
    public (double Area, double X, double Y, double Moment) Integrals()
    {
        if (Radius > 0)
        {
            (double cx, double cy) = Corners[0];
            double disc = Math.PI * Radius * Radius;
            return (disc, cx, cy, disc * ((Radius * Radius / 2) + (cx * cx) + (cy * cy)));
        }

        (double area, double x, double y, double moment) = (0, 0, 0, 0);
        for (int i = 0; i < Corners.Length; i++)
        {
            ((double px, double py), (double qx, double qy)) = (Corners[i], Corners[(i + 1) % Corners.Length]);
            double cross = Cross((px, py), (qx, qy));
            area += cross / 2;
            x += (px + qx) * cross / 6;
            y += (py + qy) * cross / 6;
            moment += cross * ((px * px) + (py * py) + (px * qx) + (py * qy) + (qx * qx) + (qy * qy)) / 12;
        }

        return (area, x / area, y / area, moment);
    }

    public (double X, double Y) World(int corner) => Body.ToWorld(Corners[corner]);

    /// <summary>Largest distance of a point of the shape from the body's centre of mass.</summary>
    public double Reach() => Corners.Max(c => Math.Sqrt(Square(c.X - Body.LocalX) + Square(c.Y - Body.LocalY))) + Radius;

    /// <summary>Half of the shape's narrowest width.</summary>
    public double HalfWidth() => Radius > 0 ? Radius : Enumerable.Range(0, Corners.Length).Min(Width) / 2;

    private static double Cross((double X, double Y) a, (double X, double Y) b) => (a.X * b.Y) - (a.Y * b.X);

    private static double Square(double value) => value * value;

    /// <summary>How far the corners lie from the line of an edge.</summary>
    private double Width(int edge)
    {
        ((double px, double py), (double qx, double qy)) = (Corners[edge], Corners[(edge + 1) % Corners.Length]);
        double length = Math.Sqrt(Square(qx - px) + Square(qy - py));
        return Corners.Max(c => Cross((qx - px, qy - py), (c.X - px, c.Y - py))) / length;
    }
}
