using System;
using System.Numerics;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Xunit;

namespace Farseer.Engine.Tests.NarrowPhase;

public class ConvexConvexTests
{
    // Shapes are of size 1, coordinates up to 4: a few ulp of 4 through one rotation and two dot products.
    private const float Tolerance = 4e-6f;

    /// <summary>The bias towards A's axis may cost this much of the smaller extent (see ConvexConvex).</summary>
    private const float Bias = 1.01e-3f;

    [Fact]
    public void Collide_RandomPairs_SeparationMatchesBruteForce()
    {
        var random = new Random(1);
        int contacts = 0;
        for (int i = 0; i < 30000; i++)
        {
            PairFixture pair = Make(random, out double angleA, out double angleB, out Vector2 offset);
            const float margin = 0.5f;
            Manifold m = pair.Collide(angleA, angleB, offset, margin);
            double expected = Expected(pair, angleA, angleB, offset, out float extent);
            float least = Least(m);
            float slack = Tolerance + (Bias * extent);
            if (m.Count == 0)
            {
                Assert.True(expected > margin - slack, $"seed case {i}: missed {expected}");
                continue;
            }

            contacts++;
            Assert.InRange(m.Normal.Length(), 1 - 1e-6f, 1 + 1e-6f);
            Assert.True(least <= margin, $"case {i}");
            Assert.True(least <= expected + slack && least >= expected - slack, $"case {i}: {least} for {expected}");
            Assert.NotEqual(0u, m.Point0.Id);
            Assert.True(m.Count == 1 || m.Point0.Id != m.Point1.Id);
        }

        Assert.True(contacts > 10000);
    }

    [Fact]
    public void Collide_Flipped_MirrorsTheManifold()
    {
        var random = new Random(2);
        for (int i = 0; i < 20000; i++)
        {
            PairFixture pair = Make(random, out double angleA, out double angleB, out Vector2 offset);
            Manifold m = pair.Collide(angleA, angleB, offset, 0.2f);
            Manifold f = pair.Flipped().Collide(angleB, angleA, -offset, 0.2f);
            double expected = Expected(pair, angleA, angleB, offset, out float extent);
            if (m.Count == 0 || f.Count == 0)
            {
                Assert.True(m.Count == f.Count || expected > 0.2f - (Bias * extent) - Tolerance, $"case {i}");
                continue;
            }

            Assert.InRange(Least(f), Least(m) - Tolerance - (Bias * extent), Least(m) + Tolerance + (Bias * extent));
        }
    }

    [Fact]
    public void Collide_Scaled1024_ScalesBitForBit()
    {
        var random = new Random(3);
        const float k = 1024;
        for (int i = 0; i < 5000; i++)
        {
            Vector2[] a = RandomShape.Convex(random);
            Vector2[] b = RandomShape.Convex(random);
            float radius = i % 2 == 0 ? 0 : 0.1f;
            var small = new PairFixture(ShapeBuilder.Polygon(a, radius), ShapeBuilder.Polygon(b));
            var large = new PairFixture(ShapeBuilder.Polygon(Scale(a, k), radius * k), ShapeBuilder.Polygon(Scale(b, k)));
            Vector2 offset = 1.5f * RandomShape.Point(random);
            Manifold m = small.Collide(0.3, i, offset, 0.1f);
            Manifold n = large.Collide(0.3, i, offset * k, 0.1f * k);
            Assert.Equal(m.Count, n.Count);
            Assert.Equal(m.Normal, n.Normal);
            Assert.Equal(m.Point0.Separation * k, n.Point0.Separation);
            Assert.Equal(m.Point0.Anchor * k, n.Point0.Anchor);
            Assert.Equal(m.Point1.Separation * k, n.Point1.Separation);
            Assert.Equal(m.Point1.Anchor * k, n.Point1.Anchor);
            Assert.Equal(m.Point0.Id, n.Point0.Id);
            Assert.Equal(m.Point1.Id, n.Point1.Id);
        }
    }

    [Fact]
    public void Collide_WholePairTurned_TurnsTheManifold()
    {
        var random = new Random(4);
        for (int i = 0; i < 5000; i++)
        {
            PairFixture pair = Make(random, out double angleA, out double angleB, out Vector2 offset);
            Manifold m = pair.Collide(angleA, angleB, offset, 0.2f);
            Vector2 turned = PairFixture.Turn(1).Rotate(offset);
            Manifold n = pair.Collide(angleA + 1, angleB + 1, turned, 0.2f);
            if (m.Count == 0 || n.Count == 0)
            {
                continue;
            }

            Assert.InRange(Least(n), Least(m) - 1e-3f, Least(m) + 1e-3f);
        }
    }

    [Fact]
    public void Collide_BoxFlatOnFloor_KeepsIdsWhileItRocks()
    {
        var pair = new PairFixture(ShapeBuilder.Box(100, 10), ShapeBuilder.Box(2, 2));
        Manifold flat = pair.Collide(0, 0, new Vector2(3, 5.99f), 0.1f);
        Assert.Equal(2, flat.Count);
        foreach (double angle in new[] { 1e-6, -1e-6, 1e-4, -1e-4, 0.01, -0.01 })
        {
            Manifold tilted = pair.Collide(0, angle, new Vector2(3.1f, 5.99f), 0.1f);
            Assert.Equal(2, tilted.Count);
            Assert.Equal(flat.Point0.Id, tilted.Point0.Id);
            Assert.Equal(flat.Point1.Id, tilted.Point1.Id);
            Manifold flipped = pair.Flipped().Collide(angle, 0, new Vector2(-3.1f, -5.99f), 0.1f);
            Assert.Equal(2, flipped.Count);
        }
    }

    [Fact]
    public void Collide_EqualBoxesStacked_KeepIdsWhenTheTopOneShifts()
    {
        var pair = new PairFixture(ShapeBuilder.Box(2, 2), ShapeBuilder.Box(2, 2));
        Manifold centered = pair.Collide(0, 0, new Vector2(0, 1.99f), 0.1f);
        foreach (float shift in new[] { -0.3f, -1e-6f, 1e-6f, 0.3f })
        {
            Manifold shifted = pair.Collide(0, 0, new Vector2(shift, 1.99f), 0.1f);
            Assert.Equal(2, shifted.Count);
            Assert.Equal(new Vector2(0, 1), shifted.Normal);
            Assert.Equal(centered.Point0.Id, shifted.Point0.Id);
            Assert.Equal(centered.Point1.Id, shifted.Point1.Id);
            Assert.Equal(-0.01f, shifted.Point0.Separation, 1e-6f);
            Assert.Equal(0.995f, shifted.Point0.Anchor.Y, 1e-6f);
        }
    }

    [Fact]
    public void Collide_BoxesCornerToCorner_MeasuresTheCorners()
    {
        var pair = new PairFixture(ShapeBuilder.Box(2, 2), ShapeBuilder.Box(2, 2));
        Assert.Equal(0, pair.Collide(0, 0, new Vector2(2.09f, 2.09f), 0.1f).Count);
        Manifold near = pair.Collide(0, 0, new Vector2(2.03f, 2.04f), 0.1f);
        Assert.Equal(1, near.Count);
        Assert.Equal(0.05f, near.Point0.Separation, 1e-6f);
        Assert.Equal(0.6f, near.Normal.X, 1e-4f);
    }

    [Theory]
    [InlineData(0, 0, 0, 0)]
    [InlineData(0, 0, 0, 1)]
    [InlineData(2, 0, 0, 0)]
    [InlineData(2, 2, 0, 0)]
    [InlineData(0.001, 0, 0, 0.5)]
    public void Collide_DegenerateOverlap_GivesAFiniteUnitNormal(double x, double y, double angleA, double angleB)
    {
        ShapeGeometry[] shapes =
        {
            ShapeBuilder.Circle(1), ShapeBuilder.Box(2, 2), ShapeBuilder.Capsule(new Vector2(-1, 0), new Vector2(1, 0), 0.5f),
            ShapeBuilder.Segment(new Vector2(-1, 0), new Vector2(1, 0)), ShapeBuilder.Box(0.01f, 0.01f), ShapeBuilder.Box(1000, 1000),
            ShapeBuilder.Polygon(new[] { new Vector2(-1, 0), new Vector2(1, 0), new Vector2(0, 1e-3f) }),
        };
        foreach (ShapeGeometry a in shapes)
        {
            foreach (ShapeGeometry b in shapes)
            {
                Manifold m = new PairFixture(a, b).Collide(angleA, angleB, new Vector2((float)x, (float)y), 0.1f);
                if (m.Count > 0)
                {
                    Assert.InRange(m.Normal.Length(), 1 - 1e-6f, 1 + 1e-6f);
                    Assert.True(float.IsFinite(m.Point0.Separation) && float.IsFinite(m.Point0.Anchor.Length()));
                    Assert.True(float.IsFinite(m.Point1.Separation) && float.IsFinite(m.Point1.Anchor.Length()));
                }
            }
        }
    }

    [Fact]
    public void Collide_ManyPairs_AllocatesNothing()
    {
        var pair = new PairFixture(ShapeBuilder.Polygon(RandomShape.Convex(new Random(5))), ShapeBuilder.Box(1, 1));
        PairInput input = pair.Input(pair.FirstA, pair.FirstB, 0, 0.3, new Vector2(0.5f, 0.5f), 0.1f);
        Collision.Collide(input, out _);
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 1000; i++)
        {
            Collision.Collide(input, out _);
        }

        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
        GC.KeepAlive(pair);
    }

    private static PairFixture Make(Random random, out double angleA, out double angleB, out Vector2 offset)
    {
        angleA = random.Next(3) == 0 ? 0 : random.NextDouble() * 7;
        angleB = random.Next(3) == 0 ? angleA : random.NextDouble() * 7;
        offset = 2 * RandomShape.Point(random);
        return new PairFixture(RandomShape.Any(random), RandomShape.Any(random));
    }

    private static Vector2[] Scale(Vector2[] points, float k) => Array.ConvertAll(points, p => p * k);

    private static float Least(in Manifold m) =>
        m.Count == 2 ? Math.Min(m.Point0.Separation, m.Point1.Separation) : m.Point0.Separation;

    private static unsafe double Expected(PairFixture pair, double angleA, double angleB, Vector2 offset, out float extent)
    {
        Piece a = pair.Store.Pieces[pair.FirstA];
        Piece b = pair.Store.Pieces[pair.FirstB];
        Rotation ra = PairFixture.Turn(angleA);
        Rotation rb = PairFixture.Turn(angleB);
        extent = Math.Min(a.Extent, b.Extent);
        var va = new ReadOnlySpan<Vector2>(pair.Store.Vertices.Pointer + a.VertexStart, a.VertexCount);
        var vb = new ReadOnlySpan<Vector2>(pair.Store.Vertices.Pointer + b.VertexStart, b.VertexCount);
        double distance = ReferenceDistance.Signed(
            ReferenceDistance.Place(va, ra.Cos, ra.Sin, Vector2.Zero), ReferenceDistance.Place(vb, rb.Cos, rb.Sin, offset));
        GC.KeepAlive(pair);
        return distance - a.Radius - b.Radius;
    }
}
