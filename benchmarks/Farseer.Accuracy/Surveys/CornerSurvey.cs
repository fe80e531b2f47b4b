using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>
/// What goes exactly level with the corners of tiles, its own corner coming exactly to theirs, passes: there is nothing in
/// its way.
/// </summary>
internal sealed class CornerSurvey : Survey
{
    private const int TileCount = 20;

    private static readonly string[] _ways = ["flies over a floor", "falls along a wall", "slides over a floor", "lands on a floor"];

    public override string Name => "K7d";

    public override string What => "corner exactly on corner of tiles with gaps: share of the speed along them that is lost; at most 0.01";

    public override int Draws => 120;

    public override IEnumerable<Variation> Grid()
    {
        foreach (Piece piece in Tiles.Pieces)
        {
            foreach (float gap in (float[])[0, 0.125f, 0.25f])
            {
                foreach (float speed in (float[])[0.5f, 2, 8, 20])
                {
                    // Beside a gap what lands may as well meet the side of the next tile.
                    foreach (string way in gap == 0 ? _ways : _ways[..3])
                    {
                        yield return Flight(way, piece, gap, 0.5f, speed, 0);
                        yield return Flight(way, piece, gap, 1, speed, 0.005f);
                        yield return Flight(way, piece, gap, 1, speed, Yard.UsualDepth);
                    }
                }
            }
        }
    }

    /// <summary>Sizes and gaps are multiples of 1/16, so that a float holds the corners exactly; what slides reaches over a gap.</summary>
    public override Variation Draw(Dice dice)
    {
        int size = dice.Whole(4, 16);
        string way = dice.Of(_ways);
        int gap = way == _ways[3] ? 0 : dice.Whole(0, way == _ways[2] ? size / 2 : 32);
        return Flight(way, dice.Of(Tiles.Pieces), gap / 16f, size / 16f, dice.Wide(0.5, 30), dice.Of(0, 0.001f, 0.005f, Yard.UsualDepth));
    }

    private static Variation Flight(string way, Piece piece, float gap, float size, float speed, float depth) => new(
        FormattableString.Invariant($"box of {size} m {way} of {piece} with gaps of {gap} m at {speed} m/s, depth {depth}"),
        Tiles.Limit,
        () => Play(way, piece, gap, size, speed, depth));

    private static double Play(string way, Piece piece, float gap, float size, float speed, float depth)
    {
        bool falls = way == _ways[1];
        bool slides = way == _ways[2];
        bool lands = way == _ways[3];
        using var yard = new Yard(depth, falls || slides ? -10 : 0);
        for (int i = 0; i < TileCount; i++)
        {
            float near = 1 + (i * (1 + gap));
            Vector2 from = falls ? new Vector2(0, -near - 1) : new Vector2(near, 0);
            Vector2 to = falls ? new Vector2(0, -near) : new Vector2(near + 1, 0);
            yard.LayOne(piece, from, to);
        }

        // What slides begins with its front exactly at the second tile; what lands comes to it there at an angle of 45 degrees.
        float half = size / 2;
        float front = slides ? 2 + gap : lands ? 2 + gap - half : 0;
        Body body = Yard.Upright(yard.Box(front - half, lands ? size : half, size, size, 1, 0));
        body.LinearVelocity = speed * (falls ? -Vector2.UnitY : lands ? new Vector2(1, -1) : Vector2.UnitX);
        double lost = double.NegativeInfinity;
        double time = 0;
        int steps = Math.Min(90, (int)((TileCount - 4) / speed / Yard.UsualDt));
        yard.Steps(steps, after: () =>
        {
            time += Yard.UsualDt;
            double now = falls ? -body.LinearVelocity.Y : body.LinearVelocity.X;
            lost = Math.Max(lost, Tiles.Lost(now, speed + (falls ? 10 * time : 0)));
        });
        return yard.Figure(lost);
    }
}
