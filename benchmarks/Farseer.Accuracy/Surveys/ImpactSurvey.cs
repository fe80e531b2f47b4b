using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>
/// A body of restitution 1 that meets a floor without friction and gravity keeps its energy, whatever its shape and
/// spin.
/// </summary>
internal sealed class ImpactSurvey : Survey
{
    /// <summary>A share that no eye sees and float rounding never makes.</summary>
    private const double Limit = 1e-3;

    private static readonly string[] _shapes = ["box", "square", "triangle", "capsule", "rounded box", "hexagon"];

    public override string Name => "K5a";

    public override string What => "one elastic impact on a floor, without gravity: change of kinetic energy / energy; at most 0.001";

    public override int Draws => 600;

    public override IEnumerable<Variation> Grid()
    {
        yield return Impact("box", 2, -8, 0.3f, 1.5f, 5, 1 / 30f, 45);
        foreach (string shape in _shapes)
        {
            foreach (float speed in (float[])[0.5f, 2, 10, 40])
            {
                foreach (float spin in (float[])[-8, -3, 0, 3, 8])
                {
                    foreach (int iterations in (int[])[5, 20])
                    {
                        yield return Impact(shape, speed, spin, 0.3f, 1.5f, iterations, Yard.UsualDt);
                    }
                }
            }
        }
    }

    public override Variation Draw(Dice dice) => Impact(
        dice.Of(_shapes), dice.Wide(0.5, 40), dice.Between(-12, 12), dice.Between(-3.1, 3.1), dice.Between(1.2, 3), dice.Of(5, 5, 10, 20),
        dice.Of(Yard.UsualDt, Yard.UsualDt, 1 / 30f, 1 / 240f));

    private static Variation Impact(
        string shape, float speed, float spin, float turn, float height, int iterations, float dt, int? steps = null) => new(
        FormattableString.Invariant(
            $"{shape} at {speed} m/s, spin {spin}, turned by {turn}, from {height} m, iterations {iterations}, 1/{1 / dt:F0} s"),
        Limit,
        () => Play(shape, speed, spin, turn, height, iterations, dt, steps ?? (int)Math.Ceiling(1.5 * height / speed / dt)));

    private static double Play(string shape, float speed, float spin, float turn, float height, int iterations, float dt, int steps)
    {
        using var yard = new Yard(Yard.UsualDepth, 0, iterations, dt);
        Yard.Fixed(yard.Box(0, -1, 40, 2, 1, 0, 1));
        Body body = Shape(yard, shape, height);
        body.Rotation = turn;
        body.LinearVelocity = new Vector2(0, -speed);
        body.AngularVelocity = spin;
        double before = Yard.Energy(body);
        yard.Steps(steps);
        return yard.Figure(Math.Abs((Yard.Energy(body) / before) - 1));
    }

    public static Body Shape(Yard yard, string shape, float y) => shape switch
    {
        "square" => yard.Box(0, y, 1, 1, 1, 0, 1),
        "triangle" => yard.Regular(0, y, 3, 0.6f, 0, 1),
        "hexagon" => yard.Regular(0, y, 6, 0.5f, 0, 1),
        "capsule" => yard.Capsule(0, y, 0.6f, 0.2f, 0, 1),
        "rounded box" => yard.RoundedBox(0, y, 1, 0.5f, 0.1f, 0, 1),
        _ => yard.Box(0, y, 1, 0.5f, 1, 0, 1),
    };
}
