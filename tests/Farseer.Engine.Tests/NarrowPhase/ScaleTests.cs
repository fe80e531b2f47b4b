using System;
using System.Numerics;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Shapes;
using Farseer.Engine.Tests.Shapes;
using Xunit;

namespace Farseer.Engine.Tests.NarrowPhase;

public class ScaleTests
{
    [Fact]
    public void Collide_EveryKindScaledByAPowerOfTwo_ScalesBitForBit()
    {
        var random = new Random(41);
        foreach (float k in new[] { 1024f, 1 / 64f })
        {
            for (int n = 0; n < 500; n++)
            {
                int seed = random.Next();
                var small = new PairFixture(Make(seed, 1), Make(seed + 1, 1));
                var large = new PairFixture(Make(seed, k), Make(seed + 1, k));
                Vector2 offset = 1.5f * RandomShape.Point(random);
                Manifold[] a = small.CollideAll(0.2, n, offset, 0.1f);
                Manifold[] b = large.CollideAll(0.2, n, offset * k, 0.1f * k);
                Assert.Equal(a.Length, b.Length);
                for (int i = 0; i < a.Length; i++)
                {
                    Assert.Equal(a[i].Count, b[i].Count);
                    Assert.Equal(a[i].Normal, b[i].Normal);
                    AssertScaled(a[i].Point0, b[i].Point0, k);
                    AssertScaled(a[i].Point1, b[i].Point1, k);
                }
            }
        }
    }

    [Fact]
    public void Collide_BoxOnAFloorAMillionTimesItsSize_LiesFlat()
    {
        var pair = new PairFixture(ShapeBuilder.Box(1 << 20, 64), ShapeBuilder.Box(1, 1));
        for (float x = -400000; x <= 400000; x += 100000)
        {
            Manifold m = pair.Collide(0, 0, new Vector2(x, 32.49f), 0.1f);
            Assert.Equal(2, m.Count);
            Assert.Equal(new Vector2(0, 1), m.Normal);

            // One ulp of 32.
            Assert.Equal(-0.01f, m.Point0.Separation, 4e-6f);
            Assert.Equal(-0.01f, m.Point1.Separation, 4e-6f);
            Assert.Equal(1, Math.Abs(m.Point1.Anchor.X - m.Point0.Anchor.X), 0.07f);
        }
    }

    private static void AssertScaled(ManifoldPoint a, ManifoldPoint b, float k)
    {
        Assert.Equal(a.Separation * k, b.Separation);
        Assert.Equal(a.Anchor * k, b.Anchor);
        Assert.Equal(a.Id, b.Id);
    }

    private static ShapeGeometry Make(int seed, float k)
    {
        var random = new Random(seed);
        return random.Next(5) switch
        {
            0 => ShapeBuilder.Circle(k * RandomShape.Between(random, 0.2, 1)),
            1 => ShapeBuilder.Capsule(
                k * RandomShape.Point(random), k * RandomShape.Point(random), k * RandomShape.Between(random, 0.1, 0.5)),
            2 => ShapeBuilder.Box(k * RandomShape.Between(random, 0.3, 2), k * RandomShape.Between(random, 0.3, 2)),
            3 => ShapeBuilder.Chain(Array.ConvertAll(RandomShape.Convex(random), p => k * p), loop: true),
            _ => ShapeBuilder.Polygon(Array.ConvertAll(ShapeBuilderTests.Star(random, 9), p => k * p)),
        };
    }
}
