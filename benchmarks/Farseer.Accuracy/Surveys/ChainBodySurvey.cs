using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>
/// A body whose outline is a chain, thrown on a floor, behaves as the polygon of that outline: it gains no energy and
/// stays above.
/// </summary>
internal sealed class ChainBodySurvey : Survey
{
    /// <summary>Energy is that above the floor; a hundredth of it leaves room for the depth of rest.</summary>
    private const double Limit = 0.01;

    private const double Seconds = 10;

    public override string Name => "F20";

    public override string What =>
        "chains on dynamic bodies: energy gained at the most / energy at first, infinite below the floor; at most 0.01";

    public override int Draws => 300;

    public override IEnumerable<Variation> Grid()
    {
        for (int seed = 1; seed <= 25; seed++)
        {
            foreach (float dt in (float[])[Yard.UsualDt, 1 / 30f, 0.1f])
            {
                yield return Throw(seed, dt, 0.005f);
            }
        }
    }

    public override Variation Draw(Dice dice) => Throw(
        dice.Whole(26, 100000), dice.Of(Yard.UsualDt, Yard.UsualDt, 1 / 30f, 0.1f), dice.Of(0.001f, 0.005f, Yard.UsualDepth));

    private static Variation Throw(int seed, float dt, float depth)
    {
        var dice = new Dice((uint)seed, "chain");
        int count = dice.Whole(3, 8);
        bool loop = dice.Of(true, false);
        var outline = new Vertices();
        float phase = dice.Between(0, 6.28);
        for (int i = 0; i < count; i++)
        {
            float angle = phase + (2 * MathF.PI * i / count);
            outline.Add(dice.Between(0.7, 1.3) * new Vector2(MathF.Cos(angle), MathF.Sin(angle)));
        }

        outline.Translate(-outline.GetCentroid());
        float bounce = dice.Between(0, 0.8);
        float height = dice.Between(2, 5);
        float speed = dice.Between(0, 7);
        float way = dice.Between(0, 6.28);
        float spin = dice.Between(-4, 4);
        string what = FormattableString.Invariant(
            $"{(loop ? "closed" : "open")} chain of {count}, restitution {bounce}, {speed} m/s, spin {spin}, ")
            + FormattableString.Invariant($"1/{1 / dt:F0} s, depth {depth}, seed {seed}");
        return new Variation(what, Limit, () =>
        {
            using var yard = new Yard(depth, dt: dt);
            Yard.Fixed(yard.Box(0, -10, 400, 20, 1, 0.5f, bounce));
            Body body = yard.Chain(0, height, outline, loop, bounce);
            body.LinearVelocity = speed * new Vector2(MathF.Cos(way), MathF.Sin(way));
            body.AngularVelocity = spin;
            double before = Yard.Energy(body) + (10 * height);
            double most = before;
            yard.Steps((int)(Seconds / dt), after: () =>
                most = body.PositionY < 0 ? double.PositiveInfinity : Math.Max(most, Yard.Energy(body) + (10 * body.PositionY)));
            return yard.Figure((most / before) - 1);
        });
    }
}
