using System;
using System.Linq;
using System.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.Tests.NarrowPhase;

/// <summary>Random convex shapes about the size of 1, from a seed.</summary>
internal static class RandomShape
{
    public static ShapeGeometry Any(Random random) => random.Next(6) switch
    {
        0 => ShapeBuilder.Circle(Between(random, 0.2, 1)),
        1 => ShapeBuilder.Capsule(Point(random), Point(random), Between(random, 0.1, 0.5)),
        2 => ShapeBuilder.Segment(Point(random), Point(random)),
        3 => ShapeBuilder.Box(Between(random, 0.3, 2), Between(random, 0.3, 2)),
        4 => ShapeBuilder.Polygon(Convex(random), Between(random, 0.05, 0.3)),
        _ => ShapeBuilder.Polygon(Convex(random)),
    };

    public static ShapeGeometry Hull(Random random) => random.Next(3) switch
    {
        0 => ShapeBuilder.Box(Between(random, 0.3, 2), Between(random, 0.3, 2)),
        1 => ShapeBuilder.Segment(Point(random), Point(random)),
        _ => ShapeBuilder.Polygon(Convex(random)),
    };

    /// <summary>Points on an ellipse at random angles: always convex.</summary>
    public static Vector2[] Convex(Random random)
    {
        int count = random.Next(3, 12);
        double[] angles = Enumerable.Range(0, count).Select(i => (i + (0.8 * random.NextDouble())) * 2 * Math.PI / count).ToArray();
        double x = 0.3 + random.NextDouble();
        double y = 0.3 + random.NextDouble();
        return angles.Select(a => new Vector2((float)(x * Math.Cos(a)), (float)(y * Math.Sin(a)))).ToArray();
    }

    public static float Between(Random random, double low, double high) => (float)(low + ((high - low) * random.NextDouble()));

    public static Vector2 Point(Random random) => new Vector2(Between(random, -1, 1), Between(random, -1, 1));
}
