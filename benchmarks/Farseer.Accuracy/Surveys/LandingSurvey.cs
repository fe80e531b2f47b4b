using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>Without restitution nothing goes up from what it lands on, however light that is.</summary>
internal sealed class LandingSurvey : Survey
{
    private const double Limit = 0.01;
    private const float Thick = 0.4f;

    public override string Name => "K4";

    public override string What => "landings without restitution: speed back / speed of impact; at most 0.01";

    public override int Draws => 200;

    public override IEnumerable<Variation> Grid()
    {
        yield return Landing("three boxes", 10, 5, 5, 0.001f, 1);
        foreach (string stands in (string[])["nothing", "one box", "three boxes", "plank on balls", "plank on boxes"])
        {
            foreach (float mass in (float[])[1, 3, 10, 30, 100, 300, 1000, 10000])
            {
                foreach (int iterations in (int[])[5, 10, 20, 40])
                {
                    foreach (float depth in (float[])[0, 0.001f, Yard.UsualDepth])
                    {
                        yield return Landing(stands, mass, 0.5f, iterations, depth, 1);
                        yield return Landing(stands, mass, 5, iterations, depth, 1);
                    }
                }
            }
        }
    }

    public override Variation Draw(Dice dice) => Landing(
        dice.Of("nothing", "one box", "two boxes", "three boxes", "five boxes", "plank on balls", "plank on boxes"), dice.Wide(1, 1e4),
        dice.Wide(0.1, 8), dice.Whole(3, 40), dice.Of(0, 0.001f, 0.005f, Yard.UsualDepth), dice.Of(0.5f, 1, 1, 2));

    private static Variation Landing(string stands, float mass, float height, int iterations, float depth, float size) => new(
        FormattableString.Invariant($"box of {size} m, {mass} kg from {height} m on {stands}, iterations {iterations}, depth {depth}"),
        Limit,
        () => Play(stands, mass, height, iterations, depth, size));

    private static double Play(string stands, float mass, float height, int iterations, float depth, float size)
    {
        using var yard = new Yard(depth, iterations: iterations);
        Yard.Fixed(yard.Box(0, -0.5f, 40, 1));
        float top = Build(yard, stands);
        Body falls = yard.Box(0, top + height + (size / 2), size, size, mass);
        float down = 0;
        float up = 0;
        int steps = (int)((Math.Sqrt(height / 5) + 0.7) / Yard.UsualDt);
        yard.Steps(steps, after: () =>
        {
            down = Math.Max(down, -falls.LinearVelocity.Y);
            up = Math.Max(up, falls.LinearVelocity.Y);
        });
        return yard.Figure(up / down);
    }

    /// <summary>Builds what stands on the ground, of 1 kg each; its height.</summary>
    private static float Build(Yard yard, string stands)
    {
        int boxes = stands switch { "one box" => 1, "two boxes" => 2, "three boxes" => 3, "five boxes" => 5, _ => 0 };
        for (int i = 0; i < boxes; i++)
        {
            yard.Box(0, 0.5f + i, 1, 1);
        }

        if (!stands.StartsWith("plank", StringComparison.Ordinal))
        {
            return boxes;
        }

        foreach (float x in (ReadOnlySpan<float>)[-1.5f, 1.5f])
        {
            _ = stands == "plank on balls" ? yard.Ball(x, 0.5f, 0.5f) : yard.Box(x, 0.5f, 1, 1);
        }

        yard.Box(0, 1 + (Thick / 2), 4, Thick);
        return 1 + Thick;
    }
}
