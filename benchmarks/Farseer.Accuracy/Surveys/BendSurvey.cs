using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>What slides over tiles that bend down from each other never gets slower: each face pushes it ahead, if at all.</summary>
internal sealed class BendSurvey : Survey
{
    private const int Longest = 300;

    public override string Name => "K7c";

    public override string What => "over tiles that bend down, without friction: share of the speed along x that is lost; at most 0.01";

    public override int Draws => 150;

    public override IEnumerable<Variation> Grid()
    {
        yield return new Variation("as reported", Tiles.Limit, Reported);
        foreach (Piece piece in Tiles.Pieces)
        {
            foreach (float bend in (float[])[1, 2, 3, 5, 8, 10, 15, 20, 30, 45])
            {
                foreach (string shape in (string[])["box", "ball"])
                {
                    yield return Slide(piece, bend, 1, 4, shape, 0.5f, 2, 0);
                    yield return Slide(piece, bend, 1, 4, shape, 0.5f, 6, 0.005f);
                    yield return Slide(piece, bend / 3, 3, 1, shape, 0.5f, 1, Yard.UsualDepth);
                }
            }
        }
    }

    public override Variation Draw(Dice dice)
    {
        int bends = dice.Whole(1, 4);
        return Slide(
            dice.Of(Tiles.Pieces), dice.Between(1, 45.0 / bends), bends, dice.Between(0.7, 3), dice.Of(Tiles.Shapes),
            dice.Between(0.2, 1), dice.Wide(0.5, 10), dice.Of(0, 0.001f, 0.005f, Yard.UsualDepth));
    }

    private static Variation Slide(
        Piece piece, float bend, int bends, float length, string shape, float size, float speed, float depth) => new(
        FormattableString.Invariant(
            $"{shape} of {size} m at {speed} m/s over {bends + 1} tiles of {length} m ({piece}) ")
            + FormattableString.Invariant($"that bend down by {bend:G4}° each, depth {depth}"),
        Tiles.Limit,
        () =>
        {
            using var yard = new Yard(depth);
            var points = new List<Vector2> { new(-3, 0), new(0, 0) };
            for (int i = 1; i <= bends; i++)
            {
                float angle = -i * bend * MathF.PI / 180;
                points.Add(points[^1] + (length * new Vector2(MathF.Cos(angle), MathF.Sin(angle))));
            }

            yard.Lay(piece, points);
            Body body = Tiles.Free(yard, shape, -1, 0, size);
            body.LinearVelocity = new Vector2(speed, 0);
            int steps = (int)((1 + (bends * length)) / speed / Yard.UsualDt);
            return TileLandingSurvey.Slowest(yard, body, speed, Math.Min(steps, Longest));
        });

    private static double Reported()
    {
        using var yard = new Yard(0);
        Yard.Fixed(yard.Box(-1.5f, -0.5f, 3, 1, 1, 0));
        const float Turn = -MathF.PI / 180;
        float cos = MathF.Cos(Turn);
        float sin = MathF.Sin(Turn);
        Yard.Fixed(yard.Box((2 * cos) + (0.5f * sin), (2 * sin) - (0.5f * cos), 4, 1, 1, 0)).Rotation = Turn;
        Body body = yard.Box(-1, 0.25f, 0.5f, 0.5f, 1, 0);
        body.LinearVelocity = new Vector2(2, 0);
        return TileLandingSurvey.Slowest(yard, body, 2, 60);
    }
}
