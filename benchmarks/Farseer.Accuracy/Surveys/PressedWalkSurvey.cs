using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>
/// What is pressed on tiles while it goes along them, by a force or by a velocity set before each step, goes as along one
/// piece.
/// </summary>
internal sealed class PressedWalkSurvey : Survey
{
    private const int TileCount = 30;

    public override string Name => "K7b";

    public override string What => "pressed along tiles without friction: share of the way along one piece that is lacking; at most 0.01";

    public override int Draws => 150;

    public override IEnumerable<Variation> Grid()
    {
        yield return new Variation("as reported", Tiles.Limit, () => Tiles.Lost(Reported(TileCount), Reported(1)));
        foreach (Piece piece in Tiles.Pieces)
        {
            foreach (bool falls in (bool[])[true, false])
            {
                foreach (bool sets in (bool[])[true, false])
                {
                    foreach (string shape in (string[])["box", "ball"])
                    {
                        yield return Walk(piece, falls, sets, shape, 0.6f, sets ? 2 : 20, 1.5f, 0.005f);
                        yield return Walk(piece, falls, sets, shape, 0.9f, sets ? 5 : 100, 3, Yard.UsualDepth);
                        yield return Walk(piece, falls, sets, shape, 0.9f, sets ? 1 : 5, 1, 0);
                    }
                }
            }
        }
    }

    public override Variation Draw(Dice dice)
    {
        bool sets = dice.Of(true, false);
        return Walk(
            dice.Of(Tiles.Pieces), dice.Of(true, false), sets, dice.Of(Tiles.Shapes), dice.Between(0.3, 1.4),
            sets ? dice.Wide(0.2, 10) : dice.Wide(1, 300), dice.Wide(0.3, 8), dice.Of(0, 0.001f, 0.005f, Yard.UsualDepth));
    }

    private static Variation Walk(
        Piece piece, bool falls, bool sets, string shape, float size, float press, float speed, float depth) => new(
        FormattableString.Invariant(
            $"{shape} of {size} m {(falls ? "falls along a wall" : "goes over a floor")} of {piece} at {speed} m/s, ")
            + FormattableString.Invariant($"pressed by {press} {(sets ? "m/s set each step" : "N")}, depth {depth}"),
        Tiles.Limit,
        () => Tiles.Lost(
            Way(piece, TileCount, falls, sets, shape, size, press, speed, depth),
            Way(piece, 1, falls, sets, shape, size, press, speed, depth)));

    /// <summary>How far a body comes in a second along a row of tiles, or one piece as long.</summary>
    private static double Way(
        Piece piece, int tiles, bool falls, bool sets, string shape, float size, float press, float speed, float depth)
    {
        using var yard = new Yard(depth);
        Vector2 along = falls ? -Vector2.UnitY : Vector2.UnitX;
        Vector2 into = falls ? Vector2.UnitX : -Vector2.UnitY;

        // A wall from top to bottom would hold up what is on its right: it is laid from bottom to top.
        Vector2 start = falls ? new Vector2(0, -(TileCount - 3.5f)) : new Vector2(-3.5f, 0);
        Vector2 step = falls ? Vector2.UnitY : Vector2.UnitX;
        yard.Lay(piece, Tiles.Row(start, step * TileCount / tiles, tiles));
        Body body = Tiles.Upright(yard, shape, 0.15f, 0, size);
        if (falls)
        {
            body.Position = new Vector2(-size / 2, 0.15f);
        }

        Vector2 from = body.Position;
        body.LinearVelocity = speed * along;
        yard.Steps(60, before: () =>
        {
            if (sets)
            {
                Vector2 velocity = body.LinearVelocity;
                body.LinearVelocity = velocity + ((press - Vector2.Dot(velocity, into)) * into);
            }
            else
            {
                body.ApplyForce(press * into);
            }
        });
        return yard.Figure(Vector2.Dot(body.Position - from, along));
    }

    private static double Reported(int walls)
    {
        using var yard = new Yard(0.005f);
        for (int i = 0; i < walls; i++)
        {
            Yard.Fixed(yard.Box(0.5f, walls == 1 ? -4.5f : 10 - i, 1, walls == 1 ? TileCount : 1, 1, 0));
        }

        Body body = Yard.Upright(yard.Box(-0.301f, 2.2f, 0.6f, 0.9f, 1, 0));
        yard.Steps(60, before: () => body.LinearVelocity.X = 2);
        return 2.2 - body.PositionY;
    }
}
