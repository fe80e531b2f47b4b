using System;
using System.Collections.Generic;

namespace Farseer.Accuracy;

/// <summary>Convex outlines, counter-clockwise, and what is measured on them, in double precision.</summary>
internal static class Outlines
{
    public static Vec[] Box(double width, double height) => Box(width, height, new Vec(0, 0));

    public static Vec[] Box(double width, double height, Vec centre)
    {
        double x = 0.5 * width;
        double y = 0.5 * height;
        return [centre + new Vec(-x, -y), centre + new Vec(x, -y), centre + new Vec(x, y), centre + new Vec(-x, y)];
    }

    public static double Area(IReadOnlyList<Vec> outline)
    {
        double twice = 0;
        for (int i = 0; i < outline.Count; i++)
        {
            twice += Vec.Cross(outline[i], outline[(i + 1) % outline.Count]);
        }

        return 0.5 * twice;
    }

    public static Vec Centroid(IReadOnlyList<Vec> outline)
    {
        double twice = 0;
        Vec sum = new(0, 0);
        for (int i = 0; i < outline.Count; i++)
        {
            Vec a = outline[i];
            Vec b = outline[(i + 1) % outline.Count];
            double cross = Vec.Cross(a, b);
            twice += cross;
            sum += cross * (a + b);
        }

        return (1.0 / (3.0 * twice)) * sum;
    }

    /// <summary>Second moment of area about the origin (times the density: the inertia).</summary>
    public static double SecondMoment(IReadOnlyList<Vec> outline)
    {
        double sum = 0;
        for (int i = 0; i < outline.Count; i++)
        {
            Vec a = outline[i];
            Vec b = outline[(i + 1) % outline.Count];
            sum += Vec.Cross(a, b) * (Vec.Dot(a, a) + Vec.Dot(a, b) + Vec.Dot(b, b));
        }

        return sum / 12.0;
    }

    public static Vec[] Placed(IReadOnlyList<Vec> outline, Vec position, double angle)
    {
        var placed = new Vec[outline.Count];
        for (int i = 0; i < placed.Length; i++)
        {
            placed[i] = position + outline[i].Turned(angle);
        }

        return placed;
    }

    /// <summary>Depth of the overlap by separating axes (the edge normals of both); 0 if an axis separates them.</summary>
    public static double Depth(IReadOnlyList<Vec> a, IReadOnlyList<Vec> b) =>
        Math.Max(0, Math.Min(LeastOverlap(a, b), LeastOverlap(b, a)));

    private static double LeastOverlap(IReadOnlyList<Vec> a, IReadOnlyList<Vec> b)
    {
        double least = double.MaxValue;
        for (int i = 0; i < a.Count; i++)
        {
            Vec edge = a[(i + 1) % a.Count] - a[i];
            double length = edge.Length;
            var normal = new Vec(edge.Y / length, -edge.X / length);

            // The outlines are convex: the support of a along its own edge normal is that edge, the depth the most inward point of b.
            double deepest = double.MinValue;
            foreach (Vec point in b)
            {
                deepest = Math.Max(deepest, Vec.Dot(a[i] - point, normal));
            }

            least = Math.Min(least, deepest);
        }

        return least;
    }
}
