using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>Piles of what bounces a little come to rest, no deeper in each other than those of what does not bounce.</summary>
internal sealed class PileSurvey : Survey
{
    private const float Depth = 0.002f;

    /// <summary>
    /// Without restitution the points of piles rest at the allowed depth; twice that leaves room for those that are wedged
    /// in.
    /// </summary>
    private const double DeepestAtRest = 2 * Depth;

    /// <summary>A disc that moves by its own size in half a minute rests to the eye.</summary>
    private const double FastestAtRest = 0.02;

    private const double UsualSeconds = 15;
    private const double Watched = 4;

    public override string Name => "K3";

    public override string What =>
        "piles with restitution: the larger of depth / 4 mm and speed / 0.02 m/s in the last 4 of 15 s; at most 1";

    public override int Draws => 160;

    public override IEnumerable<Variation> Grid()
    {
        yield return Pile("disc", 50, 0.3f, 5, Yard.UsualDt, 1, 25);
        foreach (float bounce in (float[])[0, 0.05f, 0.1f, 0.3f, 0.5f])
        {
            foreach (int count in (int[])[20, 30, 50])
            {
                yield return Pile("disc", count, bounce, 5, Yard.UsualDt, 2);
            }

            foreach (int count in (int[])[15, 30])
            {
                yield return Pile("box", count, bounce, 5, Yard.UsualDt, 1);
                yield return Pile("triangle", count, bounce, 5, Yard.UsualDt, 1);
            }
        }

        foreach (float bounce in (float[])[0, 0.1f, 0.3f])
        {
            yield return Pile("disc", 50, bounce, 3, Yard.UsualDt, 1);
            yield return Pile("disc", 50, bounce, 10, Yard.UsualDt, 1);
            yield return Pile("disc", 50, bounce, 20, Yard.UsualDt, 1);
            yield return Pile("disc", 50, bounce, 5, 1 / 30f, 1);
            yield return Pile("disc", 50, bounce, 5, 1 / 120f, 1);
        }

        yield return Pile("disc", 100, 0.3f, 5, Yard.UsualDt, 1, 25);
    }

    public override Variation Draw(Dice dice) => Pile(
        dice.Of("disc", "disc", "disc", "box", "triangle"), dice.Whole(5, 45), dice.Between(0.02, 0.5), dice.Of(5, 5, 5, 10),
        dice.Of(Yard.UsualDt, Yard.UsualDt, 1 / 50f, 1 / 90f), dice.Whole(1, 1000));

    private static Variation Pile(
        string shape, int count, float bounce, int iterations, float dt, int seed, double seconds = UsualSeconds) => new(
        FormattableString.Invariant($"{count} of {shape}, restitution {bounce}, iterations {iterations}, 1/{1 / dt:F0} s, seed {seed}"),
        1,
        () => Play(shape, count, bounce, iterations, dt, seed, seconds));

    private static double Play(string shape, int count, float bounce, int iterations, float dt, int seed, double seconds)
    {
        using var yard = new Yard(Depth, iterations: iterations, dt: dt);
        Yard.Fixed(yard.Box(0, -0.5f, 40, 1, 1, 0.2f, bounce));
        Yard.Fixed(yard.Box(-3.5f, 19, 1, 40, 1, 0.2f, bounce));
        Yard.Fixed(yard.Box(3.5f, 19, 1, 40, 1, 0.2f, bounce));
        var random = new Random(seed);
        var bodies = new List<Body>();
        for (int i = 0; i < count; i++)
        {
            float radius = 0.25f + (0.1f * (float)random.NextDouble());
            float x = (float)((random.NextDouble() * 5) - 2.5);
            float y = 0.5f + (0.7f * i);
            bodies.Add(shape switch
            {
                "box" => yard.Box(x, y, 1.6f * radius, 1.6f * radius, 1, 0.5f, bounce),
                "triangle" => yard.Regular(x, y, 3, radius, 0.5f, bounce),
                _ => yard.Ball(x, y, radius, 1, 0.5f, bounce),
            });
        }

        yard.Steps((int)Math.Round((seconds - Watched) / dt));
        double worst = 0;
        yard.Steps((int)Math.Round(Watched / dt), after: () =>
        {
            worst = Math.Max(worst, yard.Simulator.LargestPenetration / DeepestAtRest);
            foreach (Body body in bodies)
            {
                worst = Math.Max(worst, body.LinearVelocity.Length() / FastestAtRest);
            }
        });
        return yard.Figure(worst);
    }
}
