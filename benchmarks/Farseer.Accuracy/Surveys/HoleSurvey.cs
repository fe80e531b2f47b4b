using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.Surveys;

/// <summary>A box over a hole narrower than itself stays above it.</summary>
internal sealed class HoleSurvey : Survey
{
    /// <summary>What a contact may sink in beyond the allowed depth.</summary>
    private const double Slack = 1e-3;

    public override string Name => "K8b";

    public override string What =>
        "boxes dropped on a hole narrower than they are: metres below the edges at the end; at most AllowedPenetration + 0.001";

    public override int Draws => 120;

    public override IEnumerable<Variation> Grid()
    {
        yield return Drop(1, 0.9f, 1, 0, Yard.UsualDepth);
        foreach (float width in (float[])[0.2f, 0.5f, 1, 3])
        {
            foreach (float share in (float[])[0.5f, 0.8f, 0.9f, 0.95f, 0.99f])
            {
                foreach (float depth in (float[])[0, 0.001f, 0.005f, Yard.UsualDepth])
                {
                    yield return Drop(width, share, 1, 0, depth);
                    yield return Drop(width, share, 0.1f, 0, depth);
                }
            }
        }
    }

    public override Variation Draw(Dice dice)
    {
        float width = dice.Wide(0.1, 4);
        float share = dice.Between(0.5, 0.99);
        float height = dice.Between(0, 5);
        float aside = width * (1 - share) / 2 * dice.Between(-0.8, 0.8);
        return Drop(width, share, height, aside, dice.Of(0, 0.001f, 0.005f, Yard.UsualDepth));
    }

    private static Variation Drop(float width, float share, float height, float aside, float depth) => new(
        FormattableString.Invariant($"box of {width} m over a hole of {share} of it from {height} m, {aside:G4} m aside, depth {depth}"),
        depth + Slack,
        () =>
        {
            using var yard = new Yard(depth);
            float centre = (share * width / 2) + 5;
            Yard.Fixed(yard.Box(-centre, -0.5f, 10, 1));
            Yard.Fixed(yard.Box(centre, -0.5f, 10, 1));
            var box = yard.Box(aside, height + (width / 2), width, width);
            yard.Steps(120);
            return yard.Figure((width / 2) - box.PositionY);
        });
}
