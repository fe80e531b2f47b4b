using System;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Shapes;
using Xunit;

namespace Farseer.Engine.Tests.NarrowPhase;

public unsafe class WideBoxBoxTests
{
    [Fact]
    public void Collide_RandomBoxes_GivesTheBitsOfTheScalarCode()
    {
        var random = new Random(11);
        var lanes = new LanesFixture();
        var expected = new Manifold[PairLanes.Lanes];
        int two = 0;
        int corners = 0;
        for (int i = 0; i < 8000; i++)
        {
            for (int lane = 0; lane < PairLanes.Lanes; lane++)
            {
                ShapeGeometry a = ShapeBuilder.Box(RandomShape.Between(random, 0.3, 2), RandomShape.Between(random, 0.3, 2));
                ShapeGeometry b = ShapeBuilder.Box(RandomShape.Between(random, 0.3, 2), RandomShape.Between(random, 0.3, 2));
                var pair = new PairFixture(a, b);
                double angleA = random.NextDouble() * 7;
                double angleB = random.Next(2) == 0 ? angleA + (0.02 * random.NextDouble()) : random.NextDouble() * 7;
                PairInput input = pair.Input(pair.FirstA, pair.FirstB, angleA, angleB, 1.6f * RandomShape.Point(random), 0.1f);
                BoxBox.Collide(input, out expected[lane]);
                lanes.Set(lane, input);
                GC.KeepAlive(pair);
            }

            int corner = WideBoxBox.Collide(lanes.Pairs);
            for (int lane = 0; lane < PairLanes.Lanes; lane++)
            {
                if ((corner & (1 << lane)) != 0)
                {
                    // The scalar code hands these on, and so does the caller of the wide code.
                    corners++;
                    continue;
                }

                two += expected[lane].Count == 2 ? 1 : 0;
                lanes.AssertSame(lane, expected[lane]);
            }
        }

        Assert.InRange(two, 5000, int.MaxValue);
        Assert.InRange(corners, 100, int.MaxValue);
    }
}
