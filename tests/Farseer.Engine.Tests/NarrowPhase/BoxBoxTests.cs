using System;
using System.Numerics;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Shapes;
using Xunit;

namespace Farseer.Engine.Tests.NarrowPhase;

public class BoxBoxTests
{
    [Fact]
    public void Collide_RandomBoxes_AgreesWithConvexConvex()
    {
        var random = new Random(7);
        int two = 0;
        int same = 0;
        int contacts = 0;
        for (int i = 0; i < 50000; i++)
        {
            ShapeGeometry a = ShapeBuilder.Box(RandomShape.Between(random, 0.3, 2), RandomShape.Between(random, 0.3, 2));
            Vector2[] turned = new Vector2[4];
            double tilt = random.Next(2) == 0 ? 0 : random.NextDouble() * 7;
            ShapeGeometry plain = ShapeBuilder.Box(RandomShape.Between(random, 0.3, 2), RandomShape.Between(random, 0.3, 2));
            for (int k = 0; k < 4; k++)
            {
                turned[k] = PairFixture.Turn(tilt).Rotate(plain.Pieces[0].Vertices[k]) + new Vector2(0.3f, -0.2f);
            }

            ShapeGeometry b = ShapeBuilder.Polygon(turned);
            Assert.Equal(ShapeKind.Box, b.Pieces[0].Kind);
            var pair = new PairFixture(a, b);
            double angleA = random.NextDouble() * 7;
            double angleB = random.Next(2) == 0 ? angleA - tilt + (0.02 * random.NextDouble()) : random.NextDouble() * 7;
            PairInput input = pair.Input(pair.FirstA, pair.FirstB, angleA, angleB, 1.6f * RandomShape.Point(random), 0.1f);
            BoxBox.Collide(input, out Manifold fast);
            ConvexConvex.Collide(input, out Manifold slow);
            GC.KeepAlive(pair);
            if (fast.Count != slow.Count)
            {
                // Only where a point lies within rounding of the margin.
                Manifold more = fast.Count > slow.Count ? fast : slow;
                float last = more.Count == 2 ? Math.Max(more.Point0.Separation, more.Point1.Separation) : more.Point0.Separation;
                Assert.True(Math.Abs(last - 0.1f) < 1e-5f, $"case {i}: {fast.Count} and {slow.Count}, {last}");
                continue;
            }

            contacts += fast.Count > 0 ? 1 : 0;
            two += fast.Count == 2 ? 1 : 0;
            if (fast.Count == 0 || Vector2.Dot(fast.Normal, slow.Normal) < 0.99999f)
            {
                continue;
            }

            same++;
            Assert.Equal(slow.Point0.Id, fast.Point0.Id);
            Assert.Equal(slow.Point1.Id, fast.Point1.Id);
            AssertNear(slow.Point0, fast.Point0);
            AssertNear(slow.Point1, fast.Point1);
        }

        Assert.True(two > 10000);

        // Axes within rounding of each other may be chosen differently; that is rare.
        Assert.True(same > 0.999 * contacts, $"{same} of {contacts}");
    }

    private static void AssertNear(ManifoldPoint expected, ManifoldPoint actual)
    {
        // A few ulp of coordinates up to 3; on a slope up to 1 the clip passes them on undiminished.
        Assert.Equal(expected.Separation, actual.Separation, 1e-5f);
        Assert.True(
            (expected.Anchor - actual.Anchor).Length() < 1e-5f,
            $"{expected.Anchor} and {actual.Anchor}, {expected.Separation} and {actual.Separation}");
    }
}
