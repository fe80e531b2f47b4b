using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Text.Json;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Mathematics;
using Xunit;

namespace Farseer.Tests.Api;

public class GridTests
{
    /// <summary>The recorded interpolations carry single-precision rounding of coordinates up to 24.</summary>
    private const double Tolerance = 1e-5;

    [Theory]
    [InlineData("c1", 1f)]
    [InlineData("c4", 4f)]
    [InlineData("c10", 10f)]
    [InlineData("circle", 0f)]
    [ManualRow("F241")]
    [ManualRow("F243")]
    public void Intersect_AtRecordedPoints_GivesRecordedFeature(string id, float cellSize)
    {
        var outline = id == "circle" ? Vertices.CreateCircle(15, 16) : Vertices.CreateRectangle(40, 20);
        cellSize = cellSize > 0f ? cellSize : 0.1f * new AABB(outline).GetShortestSide();
        var grid = Computed(outline, cellSize);
        var compared = 0;
        foreach (var (point, expected) in Recorded(id))
        {
            var position = point;
            var hit = grid.Intersect(ref position, out var feature);
            Assert.Equal(expected.GetProperty("hit").GetBoolean(), hit);
            compared++;
            if (!hit)
            {
                Assert.Equal(default, feature);
                continue;
            }

            var normal = expected.GetProperty("normal");
            Assert.Equal(point, feature.Position);
            Assert.Equal(expected.GetProperty("distance").GetDouble(), feature.Distance, Tolerance);
            Assert.Equal(normal[0].GetDouble(), feature.Normal.X, Tolerance);
            Assert.Equal(normal[1].GetDouble(), feature.Normal.Y, Tolerance);
        }

        Assert.True(compared >= 20, $"Only {compared} recorded points for {id}.");
    }

    [Theory]
    [InlineData(4f)]
    [InlineData(2f)]
    [InlineData(1f)]
    [InlineData(0.5f)]
    public void Intersect_OfSmallerCells_IsNearerToTheExactDistance(float cellSize)
    {
        var outline = Vertices.CreateEllipse(20, 10, 24);
        var grid = Computed(outline, cellSize);
        var random = new Random(3);
        for (var i = 0; i < 2000; i++)
        {
            var point = new Vector2((float)(random.NextDouble() - 0.5) * 40, (float)(random.NextDouble() - 0.5) * 20);
            if (grid.Intersect(ref point, out var feature))
            {
                // The distance changes by at most 1 for every unit of way, and no node of the cell is further than its diagonal.
                Assert.InRange(feature.Distance - Distance(outline, point), -1.5f * cellSize, 1.5f * cellSize);
                Assert.Equal(1f, feature.Normal.Length(), 1e-5f);
            }
            else
            {
                // Missed points are near the outline or, where all ways out are as long, near the middle line.
                var distance = Distance(outline, point);
                Assert.True(distance > -1.5f * cellSize || Math.Abs(point.Y) < cellSize);
            }
        }
    }

    [Fact]
    public void Intersect_OnTheUpperSides_StaysWithinTheTable()
    {
        var grid = Computed(Vertices.CreateRectangle(40, 20), 10);
        var side = new Vector2(20, 5);
        Assert.True(grid.Intersect(ref side, out var feature));
        Assert.Equal(0f, feature.Distance);
        Assert.Equal(Vector2.UnitX, feature.Normal);
        var corner = new Vector2(20, 10);
        Assert.False(grid.Intersect(ref corner, out _), "All ways along the sides are level.");
        var outside = new Vector2(float.NaN, 0);
        Assert.False(grid.Intersect(ref outside, out _));
    }

    [Fact]
    public void Clone_OfGrid_IsIndependent()
    {
        var grid = Computed(Vertices.CreateRectangle(40, 20), 10);
        var copy = grid.Clone();
        Assert.Equal(5 * 3, grid.Points!.Length);
        Assert.Equal(new Vector2(-20, -10), grid.Points[0]);
        Assert.Equal(new Vector2(-20, 0), grid.Points[1]);
        Assert.Equal(grid.Points, copy.Points);
        var small = Vertices.CreateRectangle(2, 2);
        grid.Compute(small, 1, point => Distance(small, point));
        Assert.Equal(15, copy.Points!.Length);
        var inside = new Vector2(15, 0);
        Assert.True(copy.Intersect(ref inside, out _));
        Assert.False(grid.Intersect(ref inside, out _));
    }

    [Fact]
    public void Grid_WithoutContentOrOfBadCell_Throws()
    {
        var grid = new Grid();
        var point = Vector2.Zero;
        Assert.Null(grid.Points);
        Assert.Throws<InvalidOperationException>(() => grid.Intersect(ref point, out _));
        Assert.Null(grid.Clone().Points);
        foreach (var cell in new[] { 0f, -1f, float.NaN, 1e-6f })
        {
            var error = Assert.Throws<ArgumentOutOfRangeException>(() => Computed(Vertices.CreateRectangle(40, 20), cell));
            Assert.Equal("gridCellSize", error.ParamName);
            Assert.Equal(cell, error.ActualValue);
        }
    }

    [Fact]
    [ManualRow("F244")]
    public void Compute_OfSmallerCell_CostsMoreDistances()
    {
        var outline = Vertices.CreateRectangle(40, 20);
        Assert.Equal(41 * 21, Calls(1f));
        Assert.Equal(5 * 3, Calls(10f));

        int Calls(float cellSize)
        {
            var calls = 0;
            new Grid().Compute(outline, cellSize, point =>
            {
                calls++;
                return Distance(outline, point);
            });
            return calls;
        }
    }

    [Fact]
    [ManualRow("F310")]
    public void Grid_OfTheSubdividedSquareOfTheManual_IsThatOfTheSquare()
    {
        var square = new Vertices
        {
            new Vector2(-64, -64),
            new Vector2(64, -64),
            new Vector2(64, 64),
            new Vector2(-64, 64),
        };
        var divided = new Vertices(square);
        divided.SubDivideEdges(10);
        Assert.Equal(52, divided.Count);
        Assert.True(divided.IsSimple());
        Assert.True(divided.IsConvex());
        var first = Computed(square, 11);
        var second = Computed(divided, 11);
        for (var x = -60f; x <= 60f; x += 7f)
        {
            var point = new Vector2(x, 3f);
            Assert.True(first.Intersect(ref point, out var a));
            Assert.True(second.Intersect(ref point, out var b));
            Assert.Equal(a.Distance, b.Distance, 1e-4f);
        }
    }

    private static Grid Computed(Vertices outline, float cellSize)
    {
        var grid = new Grid();
        grid.Compute(outline, cellSize, point => Distance(outline, point));
        return grid;
    }

    private static float Distance(Vertices outline, Vector2 point)
    {
        var nearest = float.MaxValue;
        var inside = false;
        for (var i = 0; i < outline.Count; i++)
        {
            var a = outline[i];
            var b = outline[outline.NextIndex(i)];
            nearest = Math.Min(nearest, Calculator.DistanceBetweenPointAndLineSegment(point, a, b));
            if ((a.Y > point.Y) != (b.Y > point.Y) && point.X < a.X + ((b.X - a.X) * (point.Y - a.Y) / (b.Y - a.Y)))
            {
                inside = !inside;
            }
        }

        return inside ? -nearest : nearest;
    }

    private static IEnumerable<(Vector2 Point, JsonElement Expected)> Recorded(string id)
    {
        var root = JsonDocument.Parse(TestData.Read("nearest_distance.json")).RootElement;
        var queries = root.GetProperty("queries").EnumerateArray().ToArray();
        var results = root.GetProperty("queryResults").GetProperty("5").EnumerateArray().ToArray();
        for (var i = 0; i < queries.Length; i++)
        {
            if (queries[i].TryGetProperty("target", out var target) && target.GetString() == id
                && queries[i].TryGetProperty("call", out var call) && call.GetString() == "Intersect")
            {
                var point = queries[i].GetProperty("args")[0];
                yield return (new Vector2(point[0].GetSingle(), point[1].GetSingle()), results[i]);
            }
        }
    }
}
