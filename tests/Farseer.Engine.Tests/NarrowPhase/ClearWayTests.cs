using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Continuous;
using Farseer.Engine.NarrowPhase;
using Xunit;

namespace Farseer.Engine.Tests.NarrowPhase;

/// <summary>The look at one edge against the search for a time of impact, which it is to spare.</summary>
public class ClearWayTests
{
    private const double Gap = 0.02;

    [Fact]
    public void HoldsForEither_RandomPiecesOnTurningWays_FindsNoImpactWhereItHolds()
    {
        var random = new Random(31);
        int clear = 0;
        for (int run = 0; run < 4000; run++)
        {
            var pair = new PairFixture(RandomShape.Any(random), RandomShape.Any(random));
            ContactRecord record = default;
            record.PieceA = pair.FirstA;
            record.PieceB = pair.FirstB;
            BodyPath a = Way(random, 0);
            BodyPath b = Way(random, 4);
            bool either = ClearWay.HoldsForEither(pair.Store, record, a, b, Gap);
            bool ofA = ClearWay.Holds(pair.Store, record, a, b, ofA: true, Gap);
            bool ofB = ClearWay.Holds(pair.Store, record, a, b, ofA: false, Gap);
            Assert.Equal(ofA || ofB, either);
            if (either)
            {
                clear++;

                // The search ends at a separation within the tolerance of its target.
                var query = new ImpactQuery { Target = Gap - 1e-6, Tolerance = 1e-6, From = 0, Until = 1 };
                Assert.False(
                    new TimeOfImpact(pair.Store, pair.FirstA, a, pair.FirstB, b).Find(query, out double time, out _),
                    $"Run {run}: within the gap at {time}.");
            }
        }

        Assert.InRange(clear, 500, 3500);
    }

    private static BodyPath Way(Random random, float place)
    {
        Vector2 start = RandomShape.Point(random) * 2;
        Vector2 velocity = RandomShape.Point(random) * 4;
        return new BodyPath
        {
            X = place + start.X,
            Y = start.Y,
            Angle = 20 * (random.NextDouble() - 0.5),
            VelocityX = velocity.X,
            VelocityY = velocity.Y,
            Spin = random.Next(3) == 0 ? 0 : 2 * (random.NextDouble() - 0.5),
            AccelerationX = random.NextDouble() - 0.5,
            AccelerationY = random.NextDouble() - 0.5,
            SpinGain = random.Next(2) == 0 ? 0 : 0.2 * (random.NextDouble() - 0.5),
        };
    }
}
