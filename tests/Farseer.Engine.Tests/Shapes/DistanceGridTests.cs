using System;
using System.IO;
using System.Numerics;
using System.Text.Json;
using Farseer.Engine.Shapes;
using Farseer.Tests.Shared;
using Xunit;

namespace Farseer.Engine.Tests.Shapes;

public class DistanceGridTests
{
    // The original works in single precision on coordinates up to 24.
    private const float Tolerance = 1e-5f;

    [Fact]
    public void Intersect_AndNearestDistance_MatchTheOriginal()
    {
        using JsonDocument scene =
            JsonDocument.Parse(File.ReadAllText(Path.Combine(Clone.Root, "tests", "data", "fidelity", "nearest_distance.json")));
        JsonElement results = scene.RootElement.GetProperty("queryResults").GetProperty("5");
        int index = -1;
        int compared = 0;
        foreach (JsonElement query in scene.RootElement.GetProperty("queries").EnumerateArray())
        {
            index++;
            string call = query.TryGetProperty("call", out JsonElement c) ? c.GetString()! : "";
            if (call is not ("Intersect" or "GetNearestDistance"))
            {
                continue;
            }

            DistanceGrid grid = Grid(query.GetProperty("target").GetString()!);
            JsonElement at = query.GetProperty("args")[0];
            var point = new Vector2(at[0].GetSingle(), at[1].GetSingle());
            JsonElement expected = results[index];
            compared++;
            if (call == "GetNearestDistance")
            {
                Assert.Equal(expected.GetSingle(), grid.NearestDistance(point), Tolerance);
                continue;
            }

            bool hit = grid.Intersect(point, out float distance, out Vector2 normal);
            Assert.Equal(expected.GetProperty("hit").GetBoolean(), hit);
            if (hit)
            {
                Assert.Equal(expected.GetProperty("distance").GetSingle(), distance, Tolerance);
                Assert.Equal(expected.GetProperty("normal")[0].GetSingle(), normal.X, Tolerance);
                Assert.Equal(expected.GetProperty("normal")[1].GetSingle(), normal.Y, Tolerance);
            }
        }

        Assert.True(compared > 200);
    }

    [Fact]
    public void Intersect_OnTheFarCorner_StaysInTheGrid()
    {
        DistanceGrid grid = DistanceGrid.Compute(Rectangle(40, 20), 7);
        Assert.False(grid.Intersect(new Vector2(20, 10), out _, out _));
        Assert.True(grid.Intersect(new Vector2(19.9f, 0), out _, out Vector2 normal));
        Assert.True(normal.X > 0.9f);
        Assert.Equal(7, grid.Columns);
        Assert.Equal(4, grid.Rows);
        Assert.Equal(28, DistanceGrid.NodeCount(Rectangle(40, 20), 7));
    }

    [Fact]
    public void NearestOnEdge_BesideAnEdge_GivesFootAndNormal()
    {
        float distance = DistanceGrid.NearestOnEdge(Rectangle(40, 20), 1, new Vector2(25, 3), out Vector2 position, out Vector2 normal);
        Assert.Equal(5, distance);
        Assert.Equal(new Vector2(20, 3), position);
        Assert.Equal(new Vector2(1, 0), normal);
    }

    private static DistanceGrid Grid(string geom)
    {
        if (geom != "circle")
        {
            return DistanceGrid.Compute(Rectangle(40, 20), geom == "c1" ? 1 : geom == "c4" ? 4 : 10);
        }

        var points = new Vector2[16];
        for (int i = 0; i < 16; i++)
        {
            points[i] = new Vector2((float)(15 * Math.Cos(i * Math.PI / 8)), (float)(-15 * Math.Sin(i * Math.PI / 8)));
        }

        return DistanceGrid.Compute(points, 3);
    }

    private static Vector2[] Rectangle(float w, float h) => ShapeBuilder.Box(w, h).Pieces[0].Vertices;
}
