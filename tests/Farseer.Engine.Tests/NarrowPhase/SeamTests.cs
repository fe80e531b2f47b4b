using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Shapes;
using Xunit;

namespace Farseer.Engine.Tests.NarrowPhase;

public class SeamTests
{
    [Theory]
    [InlineData("box", 0.5f)]
    [InlineData("circle", 0.5f)]
    [InlineData("capsule", 0.25f)]
    [InlineData("rounded", 0.5f)]
    [InlineData("octagon", 0.5f)]
    public void Collide_SlidingOverACollinearChain_FeelsNoJoint(string slider, float half) =>
        Slide(slider, Chain(), Slider(slider), half);

    [Theory]
    [InlineData("box", 0.5f)]
    [InlineData("circle", 0.5f)]
    [InlineData("capsule", 0.25f)]
    [InlineData("rounded", 0.5f)]
    [InlineData("octagon", 0.5f)]
    public void Collide_SlidingOverTheSeamsOfAComb_FeelsNoSeam(string slider, float half) =>
        Slide(slider, Comb(), Slider(slider), half);

    [Fact]
    public void Collide_CircleOverAConvexBend_TurnsItsNormalSmoothly()
    {
        var chain = ShapeBuilder.Chain(new[] { new Vector2(5, -1), new Vector2(0, 0), new Vector2(-5, -1) }, loop: false);
        var pair = new PairFixture(chain, ShapeBuilder.Circle(1));
        for (float x = -2; x <= 2; x += 0.01f)
        {
            float y = 1 - (Math.Abs(x) * 0.2f);
            Manifold[] found = pair.CollideAll(0, 0, new Vector2(x, y), 0.1f);
            Assert.NotEmpty(found);
            foreach (Manifold m in found)
            {
                Assert.True(Math.Abs(m.Normal.X) <= 0.1962f, $"at {x}: {m.Normal}");
            }
        }
    }

    [Fact]
    public void Collide_BoxInACorner_TouchesBothSides()
    {
        var chain = ShapeBuilder.Chain(new[] { new Vector2(5, 0), new Vector2(0, 0), new Vector2(0, 5) }, loop: false);
        var pair = new PairFixture(chain, ShapeBuilder.Box(2, 2));
        Manifold[] found = pair.CollideAll(0, 0, new Vector2(0.99f, 0.99f), 0.1f);
        Assert.Equal(2, found.Length);
        Assert.Equal(new Vector2(0, 1), found[0].Normal);
        Assert.Equal(2, found[0].Count);
        Assert.Equal(new Vector2(1, 0), found[1].Normal);
        Assert.Equal(2, found[1].Count);
    }

    [Fact]
    public void Collide_BehindAOneSidedChain_IsIgnored()
    {
        var pair = new PairFixture(Chain(), ShapeBuilder.Box(1, 1));
        Assert.Empty(pair.CollideAll(0, 0, new Vector2(0, -0.2f), 0.1f));
        Assert.NotEmpty(pair.CollideAll(0, 0, new Vector2(0, 0.2f), 0.1f));
    }

    [Fact]
    public void Collide_TiltedBoxOnASeam_KeepsTheOutlinesNormal()
    {
        var pair = new PairFixture(Comb(), ShapeBuilder.Box(1, 1));
        for (float x = -2; x < 2; x += 0.0137f)
        {
            foreach (double angle in new[] { 1e-5, -1e-3, 0.01 })
            {
                foreach (Manifold m in pair.CollideAll(0, angle, new Vector2(x, 0.495f), 0.02f))
                {
                    Assert.True(Math.Abs(m.Normal.X) <= 0.0101f && m.Normal.Y > 0, $"at {x}, {angle}: {m.Normal}");
                }
            }
        }
    }

    private static void Slide(string name, ShapeGeometry ground, ShapeGeometry slider, float half)
    {
        var pair = new PairFixture(ground, slider);
        var flipped = new PairFixture(slider, ground);
        foreach (float depth in new[] { -0.01f, 0, 0.001f, 0.05f, 0.2f })
        {
            for (float x = -4; x <= 4; x += 0.01f)
            {
                var at = new Vector2(x, half - depth);
                Manifold[] found = pair.CollideAll(0, 0, at, 0.02f);
                Assert.True(found.Length > 0, $"{name} lost the ground at {x}, depth {depth}");
                float deepest = float.MaxValue;
                foreach (Manifold m in found)
                {
                    Assert.True(m.Normal == new Vector2(0, 1), $"{name} at {x}, depth {depth}: {m.Normal}");
                    deepest = Math.Min(deepest, m.Point0.Separation);
                }

                Assert.Equal(-depth, deepest, 2e-6f);
                foreach (Manifold m in flipped.CollideAll(0, 0, -at, 0.02f))
                {
                    Assert.True(m.Normal == new Vector2(0, -1), $"{name} flipped at {x}, depth {depth}: {m.Normal}");
                }
            }
        }
    }

    private static ShapeGeometry Slider(string name) => name switch
    {
        "box" => ShapeBuilder.Box(1, 1),
        "circle" => ShapeBuilder.Circle(0.5f),
        "capsule" => ShapeBuilder.Capsule(new Vector2(-0.5f, 0), new Vector2(0.5f, 0), 0.25f),
        "rounded" => ShapeBuilder.Polygon(new[] { new Vector2(-0.5f, -0.3f), new Vector2(0.5f, -0.3f), new Vector2(0, 0.6f) }, 0.2f),
        _ => ShapeBuilder.Polygon(Octagon()),
    };

    private static ShapeGeometry Chain()
    {
        var points = new List<Vector2>();
        for (int i = 10; i >= -10; i--)
        {
            points.Add(new Vector2(0.73f * i, 0));
        }

        return ShapeBuilder.Chain(points.ToArray(), loop: false);
    }

    // A flat top with teeth below: the top is one edge of the outline, the teeth force seams up to it from all sides.
    private static ShapeGeometry Comb()
    {
        var points = new List<Vector2> { new Vector2(7, -1), new Vector2(7, 0), new Vector2(-7, 0), new Vector2(-7, -1) };
        for (int i = -6; i < 6; i += 2)
        {
            points.Add(new Vector2(i, -1));
            points.Add(new Vector2(i + 0.5f, -3));
            points.Add(new Vector2(i + 1, -1.2f));
        }

        return ShapeBuilder.Polygon(points.ToArray());
    }

    private static Vector2[] Octagon()
    {
        var points = new Vector2[8];
        for (int i = 0; i < 8; i++)
        {
            double angle = (i + 0.5) * Math.PI / 4;
            double radius = 0.5 / Math.Cos(Math.PI / 8);
            points[i] = new Vector2((float)(radius * Math.Cos(angle)), (float)(radius * Math.Sin(angle)));
        }

        return points;
    }
}
