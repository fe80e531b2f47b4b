using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Shapes;
using Xunit;

namespace Farseer.Engine.Tests.NarrowPhase;

/// <summary>The time of impact against a fine walk along the same ways, which knows nothing of bounds and axes.</summary>
public class TimeOfImpactTests
{
    private const double Tolerance = 1e-4;

    [Fact]
    public void Find_RandomConvexPiecesOnTurningWays_PassesNoOverlap_AndStopsAtNoGap()
    {
        var random = new Random(4711);
        int hits = 0;
        for (int run = 0; run < 400; run++)
        {
            var pair = new PairFixture(RandomShape.Hull(random), RandomShape.Hull(random));
            BodyPath a = Way(random, 0);
            BodyPath b = Way(random, 6);
            var query = new ImpactQuery { Target = 0, Tolerance = Tolerance, From = 0, Until = 1 };
            bool hit = new TimeOfImpact(pair.Store, pair.FirstA, a, pair.FirstB, b).Find(query, out double time, out double separation);
            double until = hit ? time : 1;

            // The walk may step over an overlap that is shallow or short, never the search.
            const int Steps = 2000;
            for (int i = 0; i < Steps; i++)
            {
                double f = until * i / Steps;
                Assert.False(Overlaps(pair, a, b, f, -Tolerance), $"Run {run}: an overlap at {f}, found {hit} at {time}.");
            }

            if (hit && time > 0)
            {
                hits++;
                Assert.InRange(separation, -Tolerance, Tolerance);
                Assert.True(Touches(pair, a, b, time), $"Run {run}: a gap at {time}.");
            }
        }

        Assert.InRange(hits, 50, 400);
    }

    [Fact]
    public void Find_CircleOnAStraightWay_IsWhereTheGapIsUsedUp()
    {
        var pair = new PairFixture(ShapeBuilder.Circle(0.5f), ShapeBuilder.Circle(0.25f));
        var a = new BodyPath { VelocityX = 100 };
        var b = new BodyPath { X = 40, Y = 0.45 };
        var query = new ImpactQuery { Target = 0, Tolerance = 1e-9, From = 0, Until = 1 };
        Assert.True(new TimeOfImpact(pair.Store, pair.FirstA, a, pair.FirstB, b).Find(query, out double time, out _));

        // 0.75² = 0.45² + 0.6².
        Assert.Equal((40 - 0.6) / 100, time, 1e-9);
    }

    private static BodyPath Way(Random random, float place)
    {
        Vector2 start = RandomShape.Point(random);
        Vector2 velocity = RandomShape.Point(random) * 8;
        return new BodyPath
        {
            X = place + start.X,
            Y = start.Y,
            Angle = 3 * random.NextDouble(),
            VelocityX = (place > 0 ? -4 : 4) + velocity.X,
            VelocityY = velocity.Y,
            Spin = 12 * (random.NextDouble() - 0.5),
            AccelerationX = random.NextDouble() - 0.5,
            AccelerationY = random.NextDouble() - 0.5,
            SpinGain = random.NextDouble() - 0.5,
        };
    }

    private static bool Overlaps(PairFixture pair, in BodyPath a, in BodyPath b, double f, double depth)
    {
        Manifold manifold = At(pair, a, b, f, 0);
        return manifold.Count > 0 && (manifold.Point0.Separation < depth || (manifold.Count > 1 && manifold.Point1.Separation < depth));
    }

    private static bool Touches(PairFixture pair, in BodyPath a, in BodyPath b, double f) =>
        At(pair, a, b, f, (float)(4 * Tolerance)).Count > 0;

    private static Manifold At(PairFixture pair, in BodyPath a, in BodyPath b, double f, float margin)
    {
        var offset = new Vector2((float)(b.XAt(f) - a.XAt(f)), (float)(b.YAt(f) - a.YAt(f)));
        return pair.Collide(a.AngleAt(f), b.AngleAt(f), offset, margin);
    }
}
