using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>What lands on level tiles goes on along them as over one floor.</summary>
internal sealed class TileLandingSurvey : Survey
{
    public override string Name => "K7a";

    public override string What => "landings on level tiles without friction: share of the speed along them that is lost; at most 0.01";

    public override int Draws => 300;

    public override IEnumerable<Variation> Grid()
    {
        yield return new Variation("as reported", Tiles.Limit, Reported);
        foreach (Piece piece in Tiles.Pieces)
        {
            foreach (string shape in Tiles.Shapes)
            {
                foreach (float depth in (float[])[0, 0.005f, Yard.UsualDepth])
                {
                    yield return Landing(piece, false, shape, 0.953f, 0.4937f, new Vector2(2.4f, -3.5f), 1.0197f, depth);
                    yield return Landing(piece, false, shape, 0.5f, 0.31f, new Vector2(6, -10), 1.3f, depth);
                    yield return Landing(piece, true, shape, 0.4f, 0.77f, new Vector2(1, -1), 0.6f, depth);
                }
            }
        }
    }

    public override Variation Draw(Dice dice) => Landing(
        dice.Of(Tiles.Pieces), dice.Of(true, false), dice.Of(Tiles.Shapes), dice.Between(0.2, 1.5), dice.Between(0, 3),
        new Vector2(dice.Wide(0.5, 10), -dice.Between(0, 15)), dice.Between(0.1, 2), dice.Of(0, 0.001f, 0.005f, Yard.UsualDepth));

    private static Variation Landing(
        Piece piece, bool oneBody, string shape, float size, float x, Vector2 velocity, float height, float depth) => new(
        FormattableString.Invariant(
            $"{shape} of {size} m at x {x} with velocity {velocity.X} {velocity.Y} from {height} m ")
            + FormattableString.Invariant($"on tiles ({piece}{(oneBody ? ", one body" : "")}), depth {depth}"),
        Tiles.Limit,
        () =>
        {
            using var yard = new Yard(depth);
            yard.Lay(piece, Tiles.Row(new Vector2(-1.5f, 0), Vector2.UnitX, 40), oneBody);
            Body body = Tiles.Upright(yard, shape, x, height, size);
            body.LinearVelocity = velocity;
            return Slowest(yard, body, velocity.X, 90);
        });

    private static double Reported()
    {
        using var yard = new Yard(0.005f);
        for (int i = 0; i < 30; i++)
        {
            Yard.Fixed(yard.Box(i, -0.5f, 1, 1, 1, 0));
        }

        Body body = Yard.Upright(yard.Box(0.4937f, 1.4962f, 0.953f, 0.953f, 1, 0));
        body.LinearVelocity = new Vector2(2.4f, -3.5f);
        return Slowest(yard, body, 2.4, 30);
    }

    /// <summary>Steps a world and tells the largest share of its speed along x that a body lacked after one of the steps.</summary>
    public static double Slowest(Yard yard, Body body, double speed, int steps)
    {
        double lost = double.NegativeInfinity;
        yard.Steps(steps, after: () => lost = Math.Max(lost, Tiles.Lost(body.LinearVelocity.X, speed)));
        return yard.Figure(lost);
    }
}
