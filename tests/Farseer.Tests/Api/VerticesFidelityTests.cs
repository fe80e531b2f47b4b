using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Text.Json;
using FarseerGames.FarseerPhysics.Collisions;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>Compares Vertices with what version 2.0.1 did (tests/data/fidelity/vertices.json).</summary>
public class VerticesFidelityTests
{
    // The largest coordinate in the data is 120 and the recorded numbers carry single-precision rounding of a few operations.
    private const double RelativeTolerance = 1e-6;

    public static IEnumerable<object[]> Queries()
    {
        using var document = JsonDocument.Parse(TestData.Read("vertices.json"));
        var count = document.RootElement.GetProperty("queries").GetArrayLength();
        for (var i = 0; i < count; i++)
        {
            var text = document.RootElement.GetProperty("queries")[i].GetRawText();

            // Outlines of bitmaps are not made by this class yet.
            if (!text.Contains("CreatePolygon", StringComparison.Ordinal))
            {
                yield return new object[] { i };
            }
        }
    }

    [Theory]
    [MemberData(nameof(Queries))]
    public void Query_OfRecordedData_GivesRecordedResult(int index)
    {
        using var document = JsonDocument.Parse(TestData.Read("vertices.json"));
        var root = document.RootElement;
        var query = root.GetProperty("queries")[index];
        var expected = root.GetProperty("queryResults").GetProperty("5")[index];
        var args = query.GetProperty("args").EnumerateArray().ToArray();
        var isFactory = query.TryGetProperty("static", out var factory);
        var result = isFactory
            ? Create(factory.GetString()!, args)
            : Call(root.GetProperty("vertices").GetProperty(query.GetProperty("vertices").GetString()!), query, args);
        var want = Flatten(expected).ToArray();
        Assert.Equal(want.Length, result.Length);

        // The size of the whole answer, so that a coordinate that should be 0 is judged by the others.
        var size = Math.Max(20d, want.Max(Math.Abs));
        for (var i = 0; i < want.Length; i++)
        {
            if (isFactory)
            {
                // Factories give the very floats.
                Assert.Equal((float)want[i], (float)result[i]);
            }
            else
            {
                Assert.InRange(result[i], want[i] - (RelativeTolerance * size), want[i] + (RelativeTolerance * size));
            }
        }
    }

    [Fact]
    public void GetMomentOfInertia_OfConcaveOutline_IsThatOfItsParts()
    {
        // An L of a 60 x 20 and a 20 x 40 rectangle: areas 1200 and 800, centres (30, 10) and (10, 40), centroid (22, 22).
        var outline = new Vertices(new[]
        {
            new Vector2(0, 0), new Vector2(60, 0), new Vector2(60, 20),
            new Vector2(20, 20), new Vector2(20, 60), new Vector2(0, 60),
        });
        var first = 1200d * ((((60d * 60d) + (20d * 20d)) / 12d) + (8d * 8d) + (12d * 12d));
        var second = 800d * ((((20d * 20d) + (40d * 40d)) / 12d) + (12d * 12d) + (18d * 18d));
        Assert.Equal((first + second) / 2000d, outline.GetMomentOfInertia(), 3);
        Assert.Equal(552.8889f, outline.GetMomentOfInertiaOfAbsoluteTriangles(), 3);
    }

    private static double[] Create(string name, JsonElement[] args)
    {
        var vertices = name switch
        {
            "Vertices.CreateRectangle" => Vertices.CreateRectangle(args[0].GetSingle(), args[1].GetSingle()),
            "Vertices.CreateCircle" => Vertices.CreateCircle(args[0].GetSingle(), args[1].GetInt32()),
            "Vertices.CreateEllipse" =>
                Vertices.CreateEllipse(args[0].GetSingle(), args[1].GetSingle(), args[2].GetInt32()),
            _ => throw new NotSupportedException(name),
        };
        return Flatten(vertices);
    }

    private static double[] Call(JsonElement points, JsonElement query, JsonElement[] args)
    {
        var vertices = new Vertices(points.EnumerateArray().Select(Vector).ToArray());
        switch (query.GetProperty("call").GetString())
        {
            case "GetArea": return new double[] { vertices.GetArea() };
            case "GetCentroid": return Flatten(vertices.GetCentroid());
            case "GetShortestEdge": return new double[] { vertices.GetShortestEdge() };
            case "NextIndex": return new double[] { vertices.NextIndex(args[0].GetInt32()) };
            case "PreviousIndex": return new double[] { vertices.PreviousIndex(args[0].GetInt32()) };
            case "GetEdge": return Flatten(vertices.GetEdge(args[0].GetInt32()));
            case "GetEdgeMidPoint": return Flatten(vertices.GetEdgeMidPoint(args[0].GetInt32()));
            case "GetEdgeNormal": return Flatten(vertices.GetEdgeNormal(args[0].GetInt32()));
            case "GetVertexNormal": return Flatten(vertices.GetVertexNormal(args[0].GetInt32()));
            case "GetMomentOfInertia":
                // The original is wrong where an edge is seen from the centroid on its outer side; then the variant counts.
                return new double[] { vertices.GetMomentOfInertiaOfAbsoluteTriangles() };
            case "ProjectToAxis":
                var axis = Vector(args[0]);
                vertices.ProjectToAxis(ref axis, out var min, out var max);
                return new double[] { min, max };
            case "ForceCounterClockWiseOrder":
                vertices.ForceCounterClockWiseOrder();
                return Flatten(vertices);
            case "SubDivideEdges":
                vertices.SubDivideEdges(args[0].GetSingle());
                return Flatten(vertices);
            case "Translate":
                vertices.Translate(Vector(args[0]));
                return Flatten(vertices);
            case "Scale":
                vertices.Scale(Vector(args[0]));
                return Flatten(vertices);
            default:
                throw new NotSupportedException(query.GetRawText());
        }
    }

    private static Vector2 Vector(JsonElement pair) => new(pair[0].GetSingle(), pair[1].GetSingle());

    private static double[] Flatten(Vector2 vector) => new double[] { vector.X, vector.Y };

    private static double[] Flatten(Vertices vertices) => vertices.SelectMany(Flatten).ToArray();

    private static IEnumerable<double> Flatten(JsonElement element) => element.ValueKind == JsonValueKind.Array
        ? element.EnumerateArray().SelectMany(Flatten)
        : new[] { element.GetDouble() };
}
