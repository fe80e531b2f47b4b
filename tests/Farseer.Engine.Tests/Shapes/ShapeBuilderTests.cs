using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Farseer.Engine.Shapes;
using Xunit;

namespace Farseer.Engine.Tests.Shapes;

public class ShapeBuilderTests
{
    [Fact]
    public void Polygon_OfRandomStars_SplitsIntoConvexPiecesThatFillIt()
    {
        var random = new Random(11);
        for (int n = 0; n < 300; n++)
        {
            Vector2[] star = Star(random, random.Next(4, 60));
            if (random.Next(2) == 0)
            {
                Array.Reverse(star);
            }

            Assert.Equal(OutlineProblem.None, Outline.Check(star, out _));
            AssertFills(star, ShapeBuilder.Polygon(star));
        }
    }

    [Theory]
    [InlineData("L")]
    [InlineData("U")]
    [InlineData("plus")]
    [InlineData("spiral")]
    public void Polygon_OfConcaveShapes_SplitsIntoFewPieces(string name)
    {
        Vector2[] outline = Named(name);
        ShapeGeometry shape = ShapeBuilder.Polygon(outline);
        AssertFills(outline, shape);

        // Hertel and Mehlhorn: at most twice the number of reflex corners plus one.
        int reflex = Enumerable.Range(0, outline.Length).Count(i => Cross(outline, i) < 0);
        Assert.InRange(shape.Pieces.Length, 2, (2 * reflex) + 1);
    }

    [Fact]
    public void Polygon_WithRepeatedAndCollinearPoints_DropsThem()
    {
        var points = new List<Vector2>();
        Vector2[] box = { new(0, 0), new(4, 0), new(4, 2), new(0, 2) };
        for (int i = 0; i < 4; i++)
        {
            for (int k = 0; k < 4; k++)
            {
                points.Add(box[i] + ((box[(i + 1) % 4] - box[i]) * (k / 4f)));
            }

            points.Add(points[^1]);
        }

        PieceGeometry piece = Assert.Single(ShapeBuilder.Polygon(points.ToArray()).Pieces);
        Assert.Equal(ShapeKind.Box, piece.Kind);
        Assert.Equal(4, piece.Vertices.Length);
        points.Reverse();
        Assert.Equal(ShapeKind.Box, ShapeBuilder.Polygon(points.ToArray()).Pieces[0].Kind);
        Assert.Equal(ShapeKind.Polygon, ShapeBuilder.Polygon(points.ToArray(), 0.1f).Pieces[0].Kind);
    }

    [Fact]
    public void Polygon_OfAThousandCorners_KeepsThemAll()
    {
        var points = new Vector2[1000];
        for (int i = 0; i < points.Length; i++)
        {
            points[i] = new Vector2((float)Math.Cos(i * Math.PI / 500), (float)Math.Sin(i * Math.PI / 500));
        }

        Assert.Equal(1000, Assert.Single(ShapeBuilder.Polygon(points).Pieces).Vertices.Length);
    }

    [Fact]
    public void Chain_ClosedLoop_KnowsItsNeighbours()
    {
        ShapeGeometry chain = ShapeBuilder.Chain(Named("L"), loop: true);
        Assert.Equal(6, chain.Pieces.Length);
        for (int i = 0; i < 6; i++)
        {
            PieceGeometry piece = chain.Pieces[i];
            Assert.True(piece.OneSided);
            Assert.Equal(chain.Pieces[(i + 5) % 6].OutlineNormalAfter![0], piece.OutlineNormalBefore![0]);
            Assert.Equal(chain.Pieces[(i + 1) % 6].OutlineNormalAfter![0], piece.OutlineNormalAfter![1]);
        }
    }

    public static TheoryData<string, float[], int> BadOutlines => new()
    {
        { nameof(OutlineProblem.TooFewPoints), new float[] { 0, 0, 1, 1 }, -1 },
        { nameof(OutlineProblem.TooFewPoints), new float[] { 0, 0, 1, 1, 1, 1, 0, 0 }, -1 },
        { nameof(OutlineProblem.NotFinite), new float[] { 0, 0, 1, float.NaN, 2, 0 }, 1 },
        { nameof(OutlineProblem.NoArea), new float[] { 0, 0, 1, 1, 2, 2, 3, 3 }, -1 },
        { nameof(OutlineProblem.NoArea), new float[] { 0, 0, 3, 3, 1, 1 }, -1 },
        { nameof(OutlineProblem.SelfIntersecting), new float[] { 0, 0, 2, 2, 2, 0, 0, 2 }, 0 },
        { nameof(OutlineProblem.SelfIntersecting), new float[] { 0, 0, 4, 0, 4, 4, 2, 0, 0, 4 }, 0 },
        { nameof(OutlineProblem.SelfIntersecting), new float[] { 0, 0, 4, 0, 4, 4, 8, 4, 4, 4, 0, 4 }, 1 },
    };

    [Theory]
    [MemberData(nameof(BadOutlines))]
    public void Check_OfABadOutline_NamesTheProblem(string problem, float[] coordinates, int index)
    {
        var points = new Vector2[coordinates.Length / 2];
        for (int i = 0; i < points.Length; i++)
        {
            points[i] = new Vector2(coordinates[2 * i], coordinates[(2 * i) + 1]);
        }

        Assert.Equal(problem, Outline.Check(points, out int found).ToString());
        Assert.Equal(index, found);
    }

    internal static Vector2[] Star(Random random, int count)
    {
        var star = new Vector2[count];
        for (int i = 0; i < count; i++)
        {
            double angle = (i + (0.8 * random.NextDouble())) * 2 * Math.PI / count;
            double radius = 0.2 + random.NextDouble();
            star[i] = new Vector2((float)(radius * Math.Cos(angle)), (float)(radius * Math.Sin(angle)));
        }

        return star;
    }

    internal static Vector2[] Named(string name) => name switch
    {
        "L" => new Vector2[] { new(0, 0), new(2, 0), new(2, 1), new(1, 1), new(1, 2), new(0, 2) },
        "U" => new Vector2[] { new(0, 0), new(3, 0), new(3, 3), new(2, 3), new(2, 1), new(1, 1), new(1, 3), new(0, 3) },
        "plus" => new Vector2[]
        {
            new(-3, -1), new(-1, -1), new(-1, -3), new(1, -3), new(1, -1), new(3, -1),
            new(3, 1), new(1, 1), new(1, 3), new(-1, 3), new(-1, 1), new(-3, 1),
        },
        _ => new Vector2[]
        {
            new(0, 0), new(5, 0), new(5, 5), new(1, 5), new(1, 2), new(3, 2), new(3, 3), new(2, 3),
            new(2, 4), new(4, 4), new(4, 1), new(0, 1),
        },
    };

    private static void AssertFills(Vector2[] outline, ShapeGeometry shape)
    {
        double total = 0;
        var seams = new HashSet<(Vector2, Vector2)>();
        int real = 0;
        foreach (PieceGeometry piece in shape.Pieces)
        {
            Assert.True(Outline.IsConvex(piece.Vertices));
            total += MassProperties.SignedArea(piece.Vertices);
            for (int i = 0; i < piece.Vertices.Length; i++)
            {
                if (piece.SeamEdges == null || !piece.SeamEdges[i])
                {
                    real++;
                    continue;
                }

                (Vector2, Vector2) seam = (piece.Vertices[i], piece.Vertices[(i + 1) % piece.Vertices.Length]);
                if (!seams.Remove((seam.Item2, seam.Item1)))
                {
                    seams.Add(seam);
                }
            }
        }

        Assert.Empty(seams);
        Assert.Equal(Outline.Tidy(outline).Length, real);

        // Corners are shared exactly, so only the summation rounds.
        Assert.Equal(Math.Abs(MassProperties.SignedArea(outline)), total, 1e-12 * outline.Length * total);
    }

    private static double Cross(Vector2[] points, int i) =>
        Outline.Cross(points[(i + points.Length - 1) % points.Length], points[i], points[(i + 1) % points.Length]);
}
