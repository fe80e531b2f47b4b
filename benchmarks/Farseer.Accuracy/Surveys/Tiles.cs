using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>What the surveys of seams share: rows of tiles and what goes over them, all without friction.</summary>
internal static class Tiles
{
    /// <summary>The share of its speed that what passes a seam may lose.</summary>
    public const double Limit = 0.01;

    public static readonly Piece[] Pieces = [Piece.Box, Piece.Polygon, Piece.Segment];

    public static readonly string[] Shapes = ["box", "ball", "hexagon", "capsule"];

    /// <summary>Points a step apart, the first at <paramref name="from"/>.</summary>
    public static Vector2[] Row(Vector2 from, Vector2 step, int pieces)
    {
        var points = new Vector2[pieces + 1];
        for (int i = 0; i <= pieces; i++)
        {
            points[i] = from + (i * step);
        }

        return points;
    }

    /// <summary>A body that nothing turns, with its lowest point at a height.</summary>
    public static Body Upright(
        Yard yard, string shape, float x, float bottom, float size) => Yard.Upright(Free(yard, shape, x, bottom, size));

    /// <summary>A body with its lowest point at a height.</summary>
    public static Body Free(Yard yard, string shape, float x, float bottom, float size)
    {
        float half = size / 2;
        return shape switch
        {
            "ball" => yard.Ball(x, bottom + half, half, 1, 0),
            "capsule" => yard.Capsule(x, bottom + (half / 2), half, half / 2, 0),
            "hexagon" => yard.Regular(x, bottom + (half * MathF.Sqrt(0.75f)), 6, half, 0),
            _ => yard.Box(x, bottom + half, size, size, 1, 0),
        };
    }

    /// <summary>The share of a speed that is gone; less than 0 if there is more of it.</summary>
    public static double Lost(double speed, double before) => 1 - (speed / before);
}
