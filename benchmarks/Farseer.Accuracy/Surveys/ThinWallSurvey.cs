using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>A ball shot at a thin wall, a line or another ball stays before it, however small it is.</summary>
internal sealed class ThinWallSurvey : Survey
{
    private static readonly string[] _targets =
        ["static wall", "kinematic wall", "dynamic wall", "segment", "static ball", "dynamic ball"];

    public override string Name => "K8a";

    public override string What => "small balls shot at thin things: metres beyond the middle of the target at the end; at most 0";

    public override int Draws => 200;

    public override IEnumerable<Variation> Grid()
    {
        yield return Shot("static wall", 0.03f, 0.06f, 100, -10.3f, true, Yard.UsualDepth);
        foreach (string target in _targets)
        {
            foreach (float radius in (float[])[0.005f, 0.01f, 0.02f, 0.04f, 0.06f])
            {
                foreach (float speed in (float[])[5, 20, 100, 300, 1000])
                {
                    foreach (bool bullet in (bool[])[true, false])
                    {
                        yield return Shot(target, radius, 0.04f, speed, -10.3f, bullet, Yard.UsualDepth);
                        yield return Shot(target, radius, 0.02f, speed, -3.1f, bullet, 0.01f);
                    }
                }
            }
        }
    }

    public override Variation Draw(Dice dice) => Shot(
        dice.Of(_targets), dice.Wide(0.005, 0.12), dice.Between(0.02, 0.06), dice.Wide(5, 1000), -dice.Between(2, 12), dice.Of(true, false),
        dice.Of(0, 0.001f, 0.005f, 0.01f, Yard.UsualDepth, Yard.UsualDepth));

    private static Variation Shot(string target, float radius, float thick, float speed, float from, bool bullet, float depth) => new(
        FormattableString.Invariant(
            $"{(bullet ? "bullet" : "ball")} of radius {radius} at {speed} m/s from {from} at a {target} of {thick}, depth {depth}"),
        0,
        () => Play(target, radius, thick, speed, from, bullet, depth));

    private static double Play(string target, float radius, float thick, float speed, float from, bool bullet, float depth)
    {
        using var yard = new Yard(depth, 0);
        Body ball = yard.Ball(from, 0, radius);
        ball.IsBullet = bullet;
        ball.LinearVelocity = new Vector2(speed, 0);
        Body? other = Target(yard, target, thick);
        yard.Steps((int)(-from / speed / Yard.UsualDt) + 6);
        return yard.Figure(ball.PositionX - (other?.PositionX ?? 0));
    }

    private static Body? Target(Yard yard, string target, float thick)
    {
        switch (target)
        {
            case "segment":
                yard.LayOne(Piece.Segment, new Vector2(0, -1), new Vector2(0, 1));
                return null;
            case "static ball":
                return Yard.Fixed(yard.Ball(0, 0, thick));
            case "dynamic ball":
                return yard.Ball(0, 0, thick);
            case "dynamic wall":
                return yard.Box(0, 0, thick, 2);
            case "kinematic wall":
                Body wall = yard.Box(0, 0, thick, 2);
                wall.IsKinematic = true;
                wall.LinearVelocity = new Vector2(-0.5f, 0);
                return wall;
            default:
                return Yard.Fixed(yard.Box(0, 0, thick, 2));
        }
    }
}
