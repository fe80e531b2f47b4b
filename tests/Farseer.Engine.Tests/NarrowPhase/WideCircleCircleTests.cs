using System;
using System.Numerics;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Shapes;
using Xunit;

namespace Farseer.Engine.Tests.NarrowPhase;

public unsafe class WideCircleCircleTests
{
    [Fact]
    public void Collide_RandomCircles_GivesTheBitsOfTheScalarCode()
    {
        var random = new Random(12);
        var lanes = new LanesFixture();
        var expected = new Manifold[PairLanes.Lanes];
        int touching = 0;
        for (int i = 0; i < 2000; i++)
        {
            for (int lane = 0; lane < PairLanes.Lanes; lane++)
            {
                var pair = new PairFixture(
                    ShapeBuilder.Circle((float)(0.1 + random.NextDouble())), ShapeBuilder.Circle((float)(0.1 + random.NextDouble())));

                // Every twentieth pair has one centre: there the direction is chosen, not computed.
                Vector2 offset = random.Next(20) == 0 ? Vector2.Zero : 1.6f * RandomShape.Point(random);
                PairInput input = pair.Input(pair.FirstA, pair.FirstB, random.NextDouble(), random.NextDouble(), offset, 0.1f);
                CirclePairs.CircleCircle(input, out expected[lane]);
                lanes.Set(lane, input);
                GC.KeepAlive(pair);
            }

            WideCircleCircle.Collide(lanes.Pairs);
            for (int lane = 0; lane < PairLanes.Lanes; lane++)
            {
                lanes.AssertSame(lane, expected[lane]);
                touching += expected[lane].Count;
            }
        }

        Assert.InRange(touching, 4000, 15000);
    }
}
