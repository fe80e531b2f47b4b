using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>Outlines from bitmaps, hulls and simplified outlines.</summary>
public class TextureTests
{
    private static readonly string[] Ring =
    [
        "..........",
        ".########.",
        ".########.",
        ".###..###.",
        ".###..###.",
        ".########.",
        ".########.",
        "..........",
    ];

    [Fact]
    public void CreatePolygon_OfARectangle_GoesThroughItsOuterPixels()
    {
        uint[] bits = Bits("......", ".####.", ".####.", ".####.", ".####.", ".####.", "......");
        Vertices outline = Vertices.CreatePolygon(bits, 6, 7, Vector2.Zero, 20, 0.4f);
        Assert.Equal([new(1, 1), new(4, 1), new(4, 5), new(1, 5)], outline);
        Vertices moved = Vertices.CreatePolygon(bits, 6, 7, new Vector2(3, 2), 20, 0.4f);
        Assert.Equal(outline.Select(v => v - new Vector2(3, 2)), moved);
        Assert.True(Vertices.CreatePolygon(bits, 6, 7).Count > 1);
        Assert.Single(Vertices.CreatePolygon(Bits("...", ".#.", "..."), 3, 3));
    }

    [Fact]
    public void CreatePolygon_TakesPixelsFromTheAlphaToleranceOn()
    {
        uint[] bits = Bits("......", ".##++.", ".##++.", ".##++.", "......");
        Assert.Equal(4, Vertices.CreatePolygon(bits, 6, 5, Vector2.Zero, 0x60, 0.4f).Max(v => v.X));
        Assert.Equal(2, Vertices.CreatePolygon(bits, 6, 5, Vector2.Zero, 0x61, 0.4f).Max(v => v.X));
        Assert.Throws<ArgumentException>("textureBits", () => Vertices.CreatePolygon(Bits("..", ".."), 2, 2));
    }

    [Fact]
    public void CreateOutlines_FollowsTheEdgesOfPixels_WithHolesAndIslands()
    {
        List<TextureOutline> islands = Vertices.CreateOutlines(Bits([.. Ring, "##......#."]), 10, 9, Vector2.Zero, 20, 0);
        Assert.Equal(3, islands.Count);
        Assert.Equal([new(9, 1), new(9, 7), new(1, 7), new(1, 1)], islands[0].Outline);
        Assert.Equal(48, islands[0].Outline.GetArea());
        Assert.True(islands[0].Outline.GetSignedArea() > 0);
        Vertices hole = Assert.Single(islands[0].Holes);
        Assert.Equal(-4, hole.GetSignedArea());
        Assert.Equal(2, islands[1].Outline.GetArea());
        Assert.Empty(islands[1].Holes);
        Assert.Equal(1, islands[2].Outline.GetArea());
        Assert.Empty(Vertices.CreateOutlines(Bits("..", ".."), 2, 2, Vector2.Zero, 20, 0));
    }

    [Fact]
    public void CreateOutlines_OfPixelsThatTouchDiagonally_ArePolygonsThatDoNotTouchThemselves()
    {
        List<TextureOutline> apart = Vertices.CreateOutlines(Bits("#.", ".#"), 2, 2, Vector2.Zero, 20, 0);
        Assert.Equal(2, apart.Count);
        List<TextureOutline> joined = Vertices.CreateOutlines(Bits("###", "#.#", "##."), 3, 3, Vector2.Zero, 20, 0);
        Assert.Single(joined);
        Assert.Equal(PolygonFault.None, joined[0].Outline.CheckPolygon());
        Assert.InRange(joined[0].Outline.GetArea(), 6.9f, 7.1f);
    }

    [Fact]
    public void CreatePolygons_CutsThroughHoles_AndCoversTheSameArea()
    {
        List<Vertices> parts = Vertices.CreatePolygons(Bits(Ring), 10, 8, new Vector2(5, 4), 20, 0);
        Assert.True(parts.Count > 1);
        Assert.Equal(44, parts.Sum(p => p.GetArea()));
        Assert.All(parts, p => Assert.True(p.IsSimple()));

        // They make geoms of one body, and a ball falls into the hole.
        var simulator = new PhysicsSimulator(new Vector2(0, 10));
        var body = new Body { IsStatic = true };
        simulator.Add(body);
        foreach (Vertices part in parts)
        {
            simulator.Add(new Geom(body, part, 0));
        }

        Geom ball = Sandbox.Ball(simulator, new Vector2(0, -0.4f), 0.3f);
        simulator.AllowedPenetration = 0.01f;
        Sandbox.Run(simulator, 300);
        Assert.InRange(ball.Body.PositionY, 0.65, 0.75);
    }

    [Fact]
    public void CreatePolygons_OfRandomBitmaps_AreSimpleAndCoverThePixels()
    {
        var random = new Random(5);
        for (int i = 0; i < 40; i++)
        {
            int width = random.Next(1, 14);
            int height = random.Next(1, 14);
            uint[] bits = new uint[width * height];
            for (int k = 0; k < bits.Length; k++)
            {
                bits[k] = random.Next(3) > 0 ? uint.MaxValue : 0;
            }

            List<Vertices> exact = Vertices.CreatePolygons(bits, width, height, Vector2.Zero, 20, 0);
            Assert.All(exact, p => Assert.Equal(PolygonFault.None, p.CheckPolygon()));

            // A thirtieth of a pixel goes at each corner where pixels touch diagonally.
            float area = exact.Sum(p => p.GetArea());
            int solid = bits.Count(b => b != 0);
            Assert.InRange(area, solid - (0.0625f * solid), solid + (0.0625f * solid));
            Assert.All(
                Vertices.CreatePolygons(bits, width, height, Vector2.Zero, 20, 1.5f),
                p => Assert.True(p.Count < 3 || p.CheckPolygon() == PolygonFault.None));
            Assert.All(
                Vertices.CreateOutlines(bits, width, height, Vector2.Zero, 20, 0),
                o => Assert.Equal(PolygonFault.None, o.Outline.CheckPolygon()));
        }
    }

    [Fact]
    public void CreatePolygons_OfADisc_NeedsFewVerticesAtATolerance()
    {
        const int Size = 64;
        uint[] bits = new uint[Size * Size];
        for (int i = 0; i < bits.Length; i++)
        {
            float x = (i % Size) + 0.5f - 32;
            float y = (i / Size) + 0.5f - 32;
            bits[i] = (x * x) + (y * y) < 900 ? uint.MaxValue : 0;
        }

        Vertices rough = Assert.Single(Vertices.CreatePolygons(bits, Size, Size, new Vector2(32, 32), 20, 1));
        Assert.InRange(rough.Count, 8, 40);
        Assert.InRange(rough.GetArea(), MathF.PI * 900 * 0.96f, MathF.PI * 900 * 1.04f);
        Assert.InRange(rough.GetCentroid().Length(), 0, 0.5f);
    }

    [Fact]
    public void GetConvexHull_IsTheOutlineOfARubberBand()
    {
        Vertices hull = Sandbox.Outline(0, 0, 4, 0, 2, 1, 4, 4, 2, 4, 0, 4, 1, 2).GetConvexHull();
        Assert.Equal(4, hull.Count);
        Assert.Equal(16, hull.GetArea());
        Assert.True(hull.IsCounterClockWise());
        Assert.True(hull.IsConvex());
        Assert.Equal(2, Sandbox.Outline(0, 0, 1, 1, 2, 2, 3, 3).GetConvexHull().Count);
        Assert.Single(Sandbox.Outline(1, 1, 1, 1).GetConvexHull());
        Assert.Empty(new Vertices().GetConvexHull());
    }

    [Fact]
    public void GetConvexHull_OfRandomPoints_HoldsThemAll()
    {
        var random = new Random(3);
        for (int i = 0; i < 100; i++)
        {
            var points = new Vertices();
            for (int k = 0; k < 3 + (i % 30); k++)
            {
                points.Add(new Vector2(random.Next(-20, 20), random.Next(-20, 20)));
            }

            Vertices hull = points.GetConvexHull();
            for (int k = 0; k < hull.Count && hull.Count > 2; k++)
            {
                Vector2 edge = hull.GetEdge(k);
                Assert.All(points, p => Assert.True((edge.X * (p.Y - hull[k].Y)) - (edge.Y * (p.X - hull[k].X)) <= 0));
            }
        }
    }

    [Fact]
    public void Simplify_DropsVerticesWithinTheTolerance()
    {
        Vertices outline = Sandbox.Outline(0, 0, 2, 0.1f, 4, 0, 4, 2, 4, 4, 0, 4);
        Assert.Equal([new(0, 0), new(2, 0.1f), new(4, 0), new(4, 4), new(0, 4)], outline.Simplify(0));
        Assert.Equal([new(0, 0), new(4, 0), new(4, 4), new(0, 4)], outline.Simplify(0.2f));
        Assert.Equal(6, outline.Count);
        Assert.Throws<ArgumentOutOfRangeException>("tolerance", () => outline.Simplify(-1));
        Vertices circle = Vertices.CreateCircle(100, 360);
        Vertices coarse = circle.Simplify(1);
        Assert.InRange(coarse.Count, 15, 60);
        Assert.InRange(coarse.GetArea(), circle.GetArea() * 0.97f, circle.GetArea());
    }

    [Fact]
    public void BadInput_IsRefusedByName()
    {
        Assert.Throws<ArgumentNullException>("textureBits", () => Vertices.CreatePolygon(null!, 1, 1));
        Assert.Throws<ArgumentException>("textureBits", () => Vertices.CreatePolygon(new uint[5], 2, 2));
        Assert.Throws<ArgumentOutOfRangeException>("textureWidth", () => Vertices.CreatePolygon([], 0, 2));
        Assert.Throws<ArgumentOutOfRangeException>("textureHeight", () => Vertices.CreatePolygons([], 2, -1, Vector2.Zero, 1, 1));
        Assert.Throws<ArgumentOutOfRangeException>(
            "textureOrigin", () => Vertices.CreateOutlines(new uint[1], 1, 1, new Vector2(float.NaN), 1, 1));
        Assert.Throws<ArgumentOutOfRangeException>(
            "hullTolerance", () => Vertices.CreatePolygon(new uint[1], 1, 1, Vector2.Zero, 1, float.PositiveInfinity));
    }

    private static uint[] Bits(params string[] rows) =>
        string.Concat(rows).Select(c => c == '#' ? 0xFFFFFFFFu : c == '+' ? 0x60FFFFFFu : 0u).ToArray();
}
