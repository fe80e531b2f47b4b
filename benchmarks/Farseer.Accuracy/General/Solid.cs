using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.General;

/// <summary>A shape that scenes throw, with density 1.</summary>
/// <param name="Name">For people.</param>
/// <param name="Symmetry">Turned by a whole turn over this it looks the same.</param>
/// <param name="Corners">Of its hull about the centre of mass; of a capsule the ends of its line.</param>
/// <param name="Rounding">Radius about the corners.</param>
/// <param name="Add">Adds a body of it at a place and an angle.</param>
internal sealed record Solid(string Name, int Symmetry, Vec[] Corners, double Rounding, Func<Rig, Vec, double, Actor> Add)
{
    public static Solid Box1 { get; } = Box(1, 1, "box 1x1");

    public static Solid Rod { get; } = Box(2, 0.2, "rod 2x0.2");

    public static Solid Triangle { get; } = Regular(3, 0.6, "triangle");

    public static Solid Hexagon { get; } = Regular(6, 0.6, "hexagon");

    public static Solid Capsule { get; } = new(
        "capsule", 2, [new Vec(-0.5, 0), new Vec(0.5, 0)], 0.25, (rig, at, angle) => rig.AddCapsule(at, angle, 1, 0.25));

    public static Solid Cross { get; } = MakeCross(1.2, 0.3);

    public static Solid[] All { get; } = [Box1, Rod, Triangle, Hexagon, Capsule, Cross];

    /// <summary>No point is further from the centre of mass.</summary>
    public double Radius
    {
        get
        {
            double farthest = 0;
            foreach (Vec corner in Corners)
            {
                farthest = Math.Max(farthest, corner.Length);
            }

            return farthest + Rounding;
        }
    }

    public static Solid Box(double width, double height, string name) => new(
        name,
        width == height ? 4 : 2,
        Outlines.Box(width, height),
        0,
        (rig, at, angle) => rig.AddBox(at.X, at.Y, width, height, angle));

    /// <summary>Height of the lowest point of a body of this shape.</summary>
    public double Lowest(Actor body)
    {
        double lowest = double.MaxValue;
        foreach (Vec corner in Corners)
        {
            lowest = Math.Min(lowest, body.Position.Y + corner.Turned(body.Angle).Y);
        }

        return lowest - Rounding;
    }

    private static Solid Regular(int sides, double radius, string name)
    {
        var corners = new Vec[sides];
        for (int i = 0; i < sides; i++)
        {
            Vec exact = new Vec(0, radius).Turned(2 * Math.PI * i / sides);
            corners[i] = new Vec((float)exact.X, (float)exact.Y);
        }

        return new(name, sides, corners, 0, (rig, at, angle) => rig.AddPolygon(at, angle, corners, [corners]));
    }

    private static Solid MakeCross(double length, double width)
    {
        Part[] parts = [new(new Vec(0, 0), length, width), new(new Vec(0, 0), width, length)];
        double bar = length * width;
        double shared = width * width;
        double inertia = (2 * bar * ((length * length) + (width * width)) / 12) - (shared * shared / 6);
        var corners = new List<Vec>();
        corners.AddRange(Outlines.Box(length, width));
        corners.AddRange(Outlines.Box(width, length));
        return new("cross", 4, [.. corners], 0, (rig, at, angle) => rig.AddCompound(at, angle, (2 * bar) - shared, inertia, parts));
    }
}
