using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Accuracy.Surveys;

/// <summary>What wishes a body through a wall presses it on the wall and no farther, however hard it wishes.</summary>
internal sealed class DragSurvey : Survey
{
    private const float WallFace = 4.5f;
    private const float Beyond = 9;

    /// <summary>Set before each step this is a push of 1,200 m/s², and more than a walker of a game is given.</summary>
    private const float FastestSet = 20;

    /// <summary>What a contact may sink in beyond the allowed depth.</summary>
    private const double Slack = 1e-3;

    private static readonly string[] _wishes =
        ["target joint", "motor joint", "slide with a motor", "velocity set each step", "spring", "force"];

    public override string Name => "K1a";

    public override string What =>
        "drawn at a static wall: metres beyond its face in the last 2 of 10 s; at most AllowedPenetration + 0.001";

    public override int Draws => 150;

    public override IEnumerable<Variation> Grid()
    {
        yield return Drag("target joint", "box", 1, 1, 100, 5, 0.001f, false);
        foreach (float thick in (float[])[0.02f, 0.2f, 1])
        {
            foreach (float force in (float[])[15, 50, 100, 1000, 1e5f, float.MaxValue])
            {
                foreach (int iterations in (int[])[1, 2, 5, 10, 20])
                {
                    yield return Drag("target joint", "box", thick, 1, force, iterations, 0.001f, false);
                }

                yield return Drag("target joint", "ball", thick, 1, force, 5, 0.005f, false);
                yield return Drag("target joint", "box", thick, 1, force, 5, 0.001f, true);
            }

            foreach (string wish in _wishes[1..])
            {
                foreach (float force in (float[])[15, 100, 1000])
                {
                    yield return Drag(wish, "box", thick, 1, force, 5, 0.001f, false);
                    yield return Drag(wish, "ball", thick, 1, force, 5, 0.005f, false);
                }
            }
        }
    }

    public override Variation Draw(Dice dice) => Drag(
        dice.Of(["target joint", "target joint", .. _wishes]), dice.Of("box", "ball"), dice.Wide(0.02, 1), dice.Wide(0.2, 20),
        dice.Wide(15, 1e4),
        dice.Whole(1, 20), dice.Of(0, 0.001f, 0.005f, Yard.UsualDepth), dice.Of(true, false));

    private static Variation Drag(
        string wish, string shape, float thick, float mass, float force, int iterations, float depth, bool bullet) => new(
        FormattableString.Invariant($"{wish} of {force} on a {(bullet ? "bullet, " : "")}{shape} of {mass} kg, wall of {thick} m, ")
            + FormattableString.Invariant($"iterations {iterations}, depth {depth}"),
        depth + Slack,
        () => Play(wish, shape, thick, mass, force, iterations, depth, bullet));

    private static double Play(string wish, string shape, float thick, float mass, float force, int iterations, float depth, bool bullet)
    {
        using var yard = new Yard(depth, iterations: iterations);
        Body ground = Yard.Fixed(yard.Box(0, -0.5f, 40, 1));
        Yard.Fixed(yard.Box(WallFace + (thick / 2), 2, thick, 6));
        Body body = shape == "ball" ? yard.Ball(0, 0.5f, 0.5f, mass) : yard.Box(0, 0.5f, 1, 1, mass);
        body.IsBullet = bullet;
        yard.Step();
        Action before = Wish(yard, wish, ground, body, force);
        double farthest = 0;
        yard.Steps(480, before);
        yard.Steps(120, before, () => farthest = Math.Max(farthest, body.PositionX));
        return yard.Figure(farthest + 0.5 - WallFace);
    }

    /// <summary>Makes what draws the body to a place beyond the wall; what is to be done before each step.</summary>
    private static Action Wish(Yard yard, string wish, Body ground, Body body, float force)
    {
        var place = new Vector2(Beyond, 0.6f);
        switch (wish)
        {
            case "motor joint":
                var motor = new MotorJoint(ground, body) { MaxForce = force, MaxTorque = force };
                yard.Simulator.Add(motor);
                return () => motor.Offset = place - ground.Position;
            case "slide with a motor":
                var slide = new FixedPrismaticJoint(body, body.Position, Vector2.UnitX) { IsMotorEnabled = true, MotorSpeed = 3 };
                slide.MaxMotorForce = force;
                yard.Simulator.Add(slide);
                return () => { };
            case "velocity set each step":
                return () => body.LinearVelocity.X = Math.Min(force / 50, FastestSet);
            case "spring":
                SpringFactory.Instance.CreateFixedLinearSpring(yard.Simulator, body, Vector2.Zero, place, force / 10, 1).RestLength = 0;
                return () => { };
            case "force":
                return () => body.ApplyForce(new Vector2(force, 0));
            default:
                var target = new TargetJoint(body, body.Position) { MaxForce = force };
                yard.Simulator.Add(target);
                return () => target.Target = place;
        }
    }
}
