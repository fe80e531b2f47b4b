using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>
/// A column of boxes without restitution, in pixels, with gaps between them, falls on a floor and none of them goes up
/// again.
/// </summary>
internal sealed class ColumnSurvey : Survey
{
    private const double Limit = 0.01;

    public override string Name => "F07";

    public override string What => "falling columns without restitution: speed upwards at the most / speed of the fall; at most 0.01";

    public override int Draws => 150;

    public override IEnumerable<Variation> Grid()
    {
        yield return Fall(5, 25, 3, 300, 0, 0.01f, 5, 1, Yard.UsualDepth, 10);
        foreach (int count in (int[])[1, 2, 3, 4, 5, 8])
        {
            foreach (float gap in (float[])[0, 1, 3, 10])
            {
                foreach (float speed in (float[])[50, 300, 1000])
                {
                    yield return Fall(count, 25, gap, speed, 0, 0.01f, 5, 1, Yard.UsualDepth, 100);
                }
            }
        }
    }

    public override Variation Draw(Dice dice)
    {
        float size = dice.Between(10, 60);
        return Fall(
            dice.Whole(1, 8), size, size * dice.Between(0, 0.5), dice.Wide(20, 1500), dice.Of(0, -100, -500),
            dice.Of(0.01f, Yard.UsualDt, 0.02f), dice.Of(5, 10, 20), dice.Of(1f, 1, 0.5f, 2), dice.Of(0.01f, Yard.UsualDepth, 0.5f),
            dice.Between(1, 200));
    }

    private static Variation Fall(
        int count, float size, float gap, float speed, float gravity, float dt, int iterations, float heavier, float depth,
        float lift) => new(
        FormattableString.Invariant($"{count} boxes of {size} with gaps of {gap} from {lift} at {speed}/s, gravity {gravity}, {dt:G4} s, ")
            + FormattableString.Invariant($"iterations {iterations}, each {heavier} times the one below, depth {depth}"),
        Limit,
        () =>
        {
            using var yard = new Yard(depth, gravity, iterations, dt);
            Yard.Fixed(yard.Box(0, -50, 2000, 100));
            var boxes = new List<Body>();
            float mass = 1;
            for (int i = 0; i < count; i++)
            {
                Body box = yard.Box(0, (size / 2) + lift + (i * (size + gap)), size, size, mass);
                box.LinearVelocity = new Vector2(0, -speed);
                boxes.Add(box);
                mass *= heavier;
            }

            double up = 0;
            double fall = Math.Sqrt((speed * speed) + (2 * lift * -gravity));
            int steps = (int)((lift + (count * (size + gap))) / speed / dt) + 30;
            yard.Steps(steps, after: () =>
            {
                foreach (Body box in boxes)
                {
                    up = Math.Max(up, box.LinearVelocity.Y);
                }
            });
            return yard.Figure(up / fall);
        });
}
