using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Farseer.Engine.Shapes;
using Xunit;

namespace Farseer.Engine.Tests.Shapes;

/// <summary>What the tree finds of an outline is what a look at all of it finds.</summary>
public class OutlineTreeTests
{
    private const int Outlines = 1000;

    [Fact]
    public void First_OfRandomOutlines_IsWhatAllPairsOfEdgesSay()
    {
        int crossed = 0;
        for (int seed = 0; seed < Outlines; seed++)
        {
            Vector2[] outline = Draw(seed);
            int found = EdgeCrossing.First(outline);

            Assert.Equal((seed, FirstOfAllPairs(outline)), (seed, found));
            crossed += found >= 0 ? 1 : 0;
        }

        // Both must have been tried.
        Assert.InRange(crossed, Outlines / 10, Outlines * 9 / 10);
    }

    [Fact]
    public void Triangles_OfRandomOutlines_AreTheBestEarsFirst()
    {
        for (int seed = 0; seed < Outlines; seed++)
        {
            Vector2[] outline = Outline.Tidy(Draw(seed));
            if (outline.Length >= 3)
            {
                Assert.Equal(EarsOneByOne(outline), Decomposition.Triangles(outline));
            }
        }
    }

    [Fact]
    public void Split_OfRandomOutlines_GivesConvexPiecesOfTheirArea()
    {
        for (int seed = 0; seed < Outlines; seed++)
        {
            Vector2[] outline = Outline.Tidy(Draw(seed));
            if (outline.Length < 3 || EdgeCrossing.First(outline) >= 0)
            {
                continue;
            }

            List<Vector2[]> pieces = Decomposition.Split(outline).ConvertAll(p => p.ConvertAll(i => outline[i]).ToArray());
            double area = MassProperties.SignedArea(outline);
            Assert.Equal(area, pieces.Sum(p => MassProperties.SignedArea(p)), 1e-9 * area);
            Assert.All(pieces.Where(p => p.Length > 3), p => Assert.True(Outline.IsConvex(p), "seed " + seed));
        }
    }

    /// <summary>
    /// A rounded rectangle a million times as long as wide has a core that is a line once what its floats cannot tell is left out.
    /// </summary>
    [Fact]
    public void Polygon_OfARoundedLine_IsOnePieceOfTwoCorners()
    {
        Vector2[] core = [new(-499_999.5f, -1e-6f), new(499_999.5f, -1e-6f), new(499_999.5f, 1e-6f), new(-499_999.5f, 1e-6f)];

        Assert.Equal(2, Outline.Tidy(core).Length);
        Assert.Equal(2, Assert.Single(ShapeBuilder.Polygon(core, 0.5f).Pieces).Vertices.Length);
    }

    /// <summary>Rings, half of them on a lattice, where points lie on lines of others, and half of them crossed.</summary>
    private static Vector2[] Draw(int seed)
    {
        var random = new Random(seed);
        int count = random.Next(3, seed % 4 == 0 ? 120 : 20);
        double roughness = random.NextDouble();
        return Enumerable.Range(0, count).Select(i =>
        {
            double angle = 2 * Math.PI * i / count;
            double radius = 10 * (1 - (roughness * random.NextDouble()));
            double x = radius * Math.Cos(angle);
            double y = radius * Math.Sin(angle);
            return (seed % 5) switch
            {
                0 => new Vector2(random.Next(8), random.Next(8)),
                1 or 2 => new Vector2((float)Math.Round(x), (float)Math.Round(y)),
                _ => new Vector2((float)x, (float)y),
            };
        }).ToArray();
    }

    private static int FirstOfAllPairs(Vector2[] outline)
    {
        int count = outline.Length;
        for (int a = 0; a < count; a++)
        {
            for (int b = a + 1; b < count; b++)
            {
                if (Meet(outline, a, b))
                {
                    return a;
                }
            }
        }

        return -1;
    }

    private static bool Meet(Vector2[] outline, int a, int b)
    {
        int count = outline.Length;
        Vector2 a0 = outline[a];
        Vector2 a1 = outline[(a + 1) % count];
        Vector2 b0 = outline[b];
        Vector2 b1 = outline[(b + 1) % count];
        if ((a + 1) % count == b || (b + 1) % count == a)
        {
            (Vector2 p, Vector2 v, Vector2 q) = (a + 1) % count == b ? (a0, a1, b1) : (b0, b1, a1);
            return Outline.Cross(p, v, q) == 0 && Vector2.Dot(v - p, q - v) < 0;
        }

        return Math.Max(a0.X, a1.X) >= Math.Min(b0.X, b1.X) && Math.Max(b0.X, b1.X) >= Math.Min(a0.X, a1.X)
            && Math.Max(a0.Y, a1.Y) >= Math.Min(b0.Y, b1.Y) && Math.Max(b0.Y, b1.Y) >= Math.Min(a0.Y, a1.Y)
            && Math.Sign(Outline.Cross(a0, a1, b0)) * Math.Sign(Outline.Cross(a0, a1, b1)) <= 0
            && Math.Sign(Outline.Cross(b0, b1, a0)) * Math.Sign(Outline.Cross(b0, b1, a1)) <= 0;
    }

    /// <summary>
    /// Only the neighbours of a cut are looked at again: a corner that was shut in by another stays so until it is a neighbour.
    /// </summary>
    private static List<int[]> EarsOneByOne(Vector2[] outline)
    {
        var triangles = new List<int[]>();
        List<int> ring = Enumerable.Range(0, outline.Length).ToList();
        List<double> quality = ring.ConvertAll(i => Quality(outline, ring, i));
        while (ring.Count > 3)
        {
            int best = quality.IndexOf(quality.Max());
            triangles.Add([ring[(best + ring.Count - 1) % ring.Count], ring[best], ring[(best + 1) % ring.Count]]);
            ring.RemoveAt(best);
            quality.RemoveAt(best);
            foreach (int beside in new[] { (best + ring.Count - 1) % ring.Count, best % ring.Count })
            {
                quality[beside] = Quality(outline, ring, beside);
            }
        }

        triangles.Add(ring.ToArray());
        return triangles;
    }

    private static double Quality(Vector2[] outline, List<int> ring, int at)
    {
        int[] ear = [ring[(at + ring.Count - 1) % ring.Count], ring[at], ring[(at + 1) % ring.Count]];
        (Vector2 a, Vector2 b, Vector2 c) = (outline[ear[0]], outline[ear[1]], outline[ear[2]]);
        double area = Outline.Cross(a, b, c);
        double quality = area / new[] { Square(a, b), Square(b, c), Square(c, a) }.Max();
        return area <= 0 ? quality - 1 : ring.Except(ear).Any(i => IsWithin(outline[i])) ? -1 : quality;

        bool IsWithin(Vector2 p) => Outline.Cross(a, b, p) >= 0 && Outline.Cross(b, c, p) >= 0 && Outline.Cross(c, a, p) >= 0;
    }

    private static double Square(Vector2 a, Vector2 b) =>
        (((double)b.X - a.X) * ((double)b.X - a.X)) + (((double)b.Y - a.Y) * ((double)b.Y - a.Y));
}
