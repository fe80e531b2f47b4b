using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>A symmetric body that falls in the middle of symmetric supports is not turned, however fast it is.</summary>
internal sealed class SupportSurvey : Survey
{
    /// <summary>0 by symmetry: what one row after another leaves of it is to be no more than what landings may leave of a speed.</summary>
    private const double Limit = 0.01;

    private const float Gap = 0.1f;

    /// <summary>Steps after the landing.</summary>
    private const int Watched = 15;

    public override string Name => "K11";

    public override string What => "symmetric bodies on 2 to 4 supports at once: spin × size / speed of impact; at most 0.01";

    public override int Draws => 200;

    public override IEnumerable<Variation> Grid()
    {
        yield return Landing("box", 0.2f, 2, Gap, 0.6f, 6, 0.5f, 0);
        foreach (string shape in (string[])["box", "hexagon", "two balls"])
        {
            foreach (int supports in (int[])[2, 3, 4])
            {
                foreach (float bounce in (float[])[0, 0.3f, 0.5f, 1])
                {
                    foreach (float speed in (float[])[0.5f, 2, 6, 20, 100])
                    {
                        yield return Landing(shape, 0.2f, supports, supports == 2 ? 0.08f : 0.02f, 0.6f, speed, bounce, 0);
                    }
                }
            }
        }
    }

    public override Variation Draw(Dice dice)
    {
        float size = dice.Wide(0.1, 2);
        int supports = dice.Whole(2, 4);
        return Landing(
            dice.Of("box", "hexagon", "two balls"), size, supports, size * dice.Between(0.05, supports == 2 ? 0.45 : 0.12),
            size * dice.Between(1, 6),
            dice.Wide(0.5, 100), dice.Of(0, 0.3f, 0.5f, 1), dice.Of(0, 0.001f, Yard.UsualDepth));
    }

    private static Variation Landing(
        string shape, float size, int supports, float gap, float height, float speed, float bounce, float depth) => new(
        FormattableString.Invariant(
            $"{shape} of {size} m at {speed} m/s from {height} m on {supports} supports ")
            + FormattableString.Invariant($"{gap} m apart, restitution {bounce}, depth {depth}"),
        Limit,
        () => Play(shape, size, supports, gap, height, speed, bounce, depth));

    private static double Play(string shape, float size, int supports, float gap, float height, float speed, float bounce, float depth)
    {
        using var yard = new Yard(depth);
        Build(yard, supports, gap, size, bounce);
        Body body = shape switch
        {
            "hexagon" => yard.Regular(0, height, 6, size / 2, 0, bounce),
            "two balls" => yard.BallPair(0, height, 0.6f * size, 0.2f * size, 0, bounce),
            _ => yard.Box(0, height, size, size, 1, 0, bounce),
        };
        body.LinearVelocity = new Vector2(0, -speed);
        float bottom = shape switch { "hexagon" => size / 2 * MathF.Sqrt(0.75f), "two balls" => 0.2f * size, _ => size / 2 };

        // The first landing alone: a second begins with what floats have rounded off, and goes one corner first.
        double impact = Math.Sqrt((speed * speed) + (20 * (height - bottom)));
        double landing = (impact - speed) / 10 / Yard.UsualDt;
        double next = 2 * bounce * impact / 10 / Yard.UsualDt;
        int after = bounce > 0 ? Math.Clamp((int)next - 1, 2, Watched) : Watched;
        double spin = 0;
        yard.Steps((int)Math.Ceiling(landing) + after, after: () => spin = Math.Max(spin, Math.Abs(body.AngularVelocity)));
        return yard.Figure(spin * size / impact);
    }

    /// <summary>Two long supports; between them none, one in the middle or two, so narrow that the body reaches over all of them.</summary>
    private static void Build(Yard yard, int supports, float gap, float size, float bounce)
    {
        float inner = 0.15f * size;
        int narrow = supports - 2;
        float half = ((narrow * inner) + ((narrow + 1) * gap)) / 2;
        Yard.Fixed(yard.Box(-half - 5, -0.5f, 10, 1, 1, 0, bounce));
        Yard.Fixed(yard.Box(half + 5, -0.5f, 10, 1, 1, 0, bounce));
        for (int i = 0; i < narrow; i++)
        {
            float x = (i - ((narrow - 1) / 2f)) * (inner + gap);
            Yard.Fixed(yard.Box(x, -0.5f, inner, 1, 1, 0, bounce));
        }
    }
}
