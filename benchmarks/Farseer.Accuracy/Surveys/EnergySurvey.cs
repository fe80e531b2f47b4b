using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>What goes on bouncing without loss keeps its energy for long: in a room without gravity, and on a floor with it.</summary>
internal sealed class EnergySurvey : Survey
{
    /// <summary>
    /// Hundreds of impacts, each of which may be wrong by what a float rounds off, and the fall between two under
    /// gravity.
    /// </summary>
    private const double Limit = 0.01;

    private static readonly string[] _shapes = ["box", "square", "triangle", "capsule", "rounded box", "hexagon"];

    public override string Name => "K5b";

    public override string What => "elastic bounces for 30 s in a room or 60 s on a floor: change of energy / energy; at most 0.01";

    public override int Draws => 60;

    public override IEnumerable<Variation> Grid()
    {
        foreach (string shape in _shapes)
        {
            foreach (float speed in (float[])[1, 5, 20])
            {
                foreach (int iterations in (int[])[5, 20])
                {
                    yield return Room(shape, speed, 0.3f, 2, iterations);
                }
            }

            foreach (float tilt in (float[])[0, 0.1f, 0.5f])
            {
                foreach (int iterations in (int[])[5, 20])
                {
                    yield return Floor(shape, 3, tilt, iterations);
                }
            }
        }
    }

    public override Variation Draw(Dice dice)
    {
        string shape = dice.Of(_shapes);
        int iterations = dice.Of(5, 5, 10, 20);
        float turn = dice.Between(-3, 3);
        return dice.Of(true, false)
            ? Room(shape, dice.Wide(1, 30), turn, dice.Between(-8, 8), iterations)
            : Floor(shape, dice.Between(1.5, 5), turn, iterations);
    }

    private static Variation Room(string shape, float speed, float turn, float spin, int iterations) => new(
        FormattableString.Invariant($"room: {shape} at {speed} m/s, turned by {turn}, spin {spin}, iterations {iterations}"),
        Limit,
        () =>
        {
            using var yard = new Yard(Yard.UsualDepth, 0, iterations);
            Yard.Fixed(yard.Box(0, -6, 14, 2, 1, 0, 1));
            Yard.Fixed(yard.Box(0, 6, 14, 2, 1, 0, 1));
            Yard.Fixed(yard.Box(-6, 0, 2, 14, 1, 0, 1));
            Yard.Fixed(yard.Box(6, 0, 2, 14, 1, 0, 1));
            Body body = ImpactSurvey.Shape(yard, shape, 0);
            body.Rotation = turn;
            body.LinearVelocity = speed * new Vector2(0.8f, -0.6f);
            body.AngularVelocity = spin;
            double before = Yard.Energy(body);
            yard.Steps(1800);
            return yard.Figure(Math.Abs((Yard.Energy(body) / before) - 1));
        });

    private static Variation Floor(string shape, float height, float tilt, int iterations) => new(
        FormattableString.Invariant($"floor: {shape} from {height} m, tilted by {tilt}, iterations {iterations}"),
        Limit,
        () =>
        {
            using var yard = new Yard(Yard.UsualDepth, -10, iterations);
            Yard.Fixed(yard.Box(0, -1, 40, 2, 1, 0, 1));
            Body body = ImpactSurvey.Shape(yard, shape, height);
            body.Rotation = tilt;
            yard.Steps(3600);
            return yard.Figure(Math.Abs(((Yard.Energy(body) + (10 * body.PositionY)) / (10 * height)) - 1));
        });
}
