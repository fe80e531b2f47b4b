using System;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Robustness;

/// <summary>Outlines that cannot be shapes are refused wherever they come in; those that can be put right are.</summary>
public class OutlineDoorTests
{
    private static readonly Vector2[] _square = { new Vector2(-10, -10), new Vector2(-10, 10), new Vector2(10, 10), new Vector2(10, -10) };

    public static TheoryData<string, float[]> BadOutlines() => new TheoryData<string, float[]>
    {
        { "0 different", Array.Empty<float>() },
        { "1 different", new float[] { 1, 2 } },
        { "2 different", new float[] { 0, 0, 5, 5 } },
        { "1 different", new float[] { 3, 3, 3, 3, 3, 3, 3, 3 } },
        { "2 different", new float[] { 0, 0, 0, 0, 5, 5, 5, 5, 0, 0 } },
        { "no area", new float[] { 0, 0, 5, 5, 9, 9 } },
        { "no area", new float[] { 0, 0, 9, 0, 4, 0, 2, 0 } },
        { "no area", new float[] { 0, 0, 10, 10, 10, 0, 0, 10 } },
        { "crosses itself", new float[] { 0, 0, 10, 10, 20, 0, 0, 12 } },
        { "crosses itself", new float[] { 0, 0, 4, 0, 4, 4, 2, 0, 0, 4 } },
        { "crosses itself", new float[] { 0, 0, 10, 0, 10, 10, 5, 10, 5, 20, 5, 10, 0, 10 } },
        { "NaN", new float[] { 0, 0, 0, 10, 10, float.NaN } },
        { "Infinity", new float[] { 0, 0, 0, 10, float.PositiveInfinity, 10 } },
        { "no area", new float[] { 0, 0, 1e6f, 0, 5e5f, 1e-3f } },
    };

    [Theory]
    [MemberData(nameof(BadOutlines))]
    public void BadOutline_IsRefusedEverywhere_AndChangesNothing(string words, float[] coordinates)
    {
        Vertices bad = Make(coordinates);
        string before = bad.ToString();
        Action<Bench>[] ways =
        {
            b => _ = new Geom(b.Box, bad, 0),
            b => _ = new Geom(b.Box, bad, Vector2.One, 1, 2),
            b => b.BoxGeom.SetVertices(bad),
            b => GeomFactory.Instance.CreatePolygonGeom(b.Box, bad, 0),
            b => GeomFactory.Instance.CreatePolygonGeom(b.Simulator, b.Box, bad, 0),
            b => GeomFactory.Instance.CreatePolygonGeom(b.Simulator, b.Box, bad, Vector2.One, 1, 0),
            _ => BodyFactory.Instance.CreatePolygonBody(bad, 1),
            b => BodyFactory.Instance.CreatePolygonBody(b.Simulator, bad, 1),
        };
        ulong undisturbed = new Bench().HashLater();
        foreach (Action<Bench> way in ways)
        {
            var bench = new Bench();
            var refusal = Assert.ThrowsAny<ArgumentException>(() => way(bench));
            Assert.Equal("vertices", refusal.ParamName);
            Assert.Contains(words, refusal.Message, StringComparison.Ordinal);
            Assert.Equal(before, bad.ToString());
            Assert.Equal(1, bench.Box.GeomCount);
            Assert.Equal(undisturbed, bench.HashLater());
        }
    }

    [Fact]
    public void RepeatedCollinearAndClockwiseVertices_ArePutRight()
    {
        Vertices plain = Make(_square);
        var repeated = new Vertices { _square[0], _square[0], _square[1], _square[2], _square[2], _square[2], _square[3], _square[0] };
        var collinear =
            new Vertices { _square[0], new Vector2(-10, 3), _square[1], new Vector2(0, 10), _square[2], _square[3], new Vector2(7, -10) };
        Vertices clockwise = Make(_square.Reverse().ToArray());
        Assert.Equal(Rest(plain), Rest(repeated));
        Assert.Equal(Rest(plain), Rest(collinear), 1e-4f);
        Assert.Equal(Rest(plain), Rest(clockwise), 1e-4f);
        var geom = new Geom(new Body(), clockwise, 0);
        Assert.True(geom.LocalVertices.IsCounterClockWise());
        Assert.Equal(4, new Geom(new Body(), repeated, 0).LocalVertices.Count);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void ChainWithTooFewPoints_IsRefused(int count)
    {
        var bench = new Bench();
        Vertices points = Make(_square.Take(count).ToArray());
        bool loop = count == 2;
        var refusal =
            Assert.Throws<ArgumentException>(() => GeomFactory.Instance.CreateChainGeom(bench.Simulator, bench.Box, points, loop));
        Assert.Equal("points", refusal.ParamName);
        Assert.Equal(1, bench.Box.GeomCount);
    }

    [Fact]
    public void LineWithoutLength_IsRefused()
    {
        var bench = new Bench();
        var place = new Vector2(3, 4);
        Assert.Equal(
            "end", Assert.Throws<ArgumentException>(() => GeomFactory.Instance.CreateSegmentGeom(bench.Box, place, place)).ParamName);
        Assert.Equal(
            "end", Assert.Throws<ArgumentException>(() => GeomFactory.Instance.CreateCapsuleGeom(bench.Box, place, place, 1)).ParamName);
        Assert.Equal(1, bench.Box.GeomCount);
    }

    [Theory]
    [InlineData(1e-30f)]
    [InlineData(1e-18f)]
    [InlineData(1e-3f)]
    [InlineData(1e6f)]
    [InlineData(1e17f)]
    [InlineData(1e38f)]
    public void ShapeOfAnySize_IsRefusedOrSimulates(float size)
    {
        Action<PhysicsSimulator, Body>[] shapes =
        {
            (s, b) => GeomFactory.Instance.CreateRectangleGeom(s, b, size, size / 2),
            (s, b) => GeomFactory.Instance.CreateCircleGeom(s, b, size, 12),
            (s, b) => GeomFactory.Instance.CreateEllipseGeom(s, b, size, size / 2, 12),
            (s, b) => GeomFactory.Instance.CreateCapsuleGeom(s, b, new Vector2(-size, 0), new Vector2(size, 0), size / 3),
            (s, b) => GeomFactory.Instance.CreateRoundedRectangleGeom(s, b, size, size / 2, size / 3),
            (s, b) => GeomFactory.Instance.CreateSegmentGeom(s, b, new Vector2(-size, 0), new Vector2(size, 0)),
            (s, b) =>
                GeomFactory.Instance.CreatePolygonGeom(s, b, Make(new[] { -size, -size, -size, size, 0, 0, size, size, size, -size }), 0),
            (s, b) => GeomFactory.Instance.CreateRectangleGeom(s, b, 1, 1, new Vector2(size, 0), 0.3f),
        };
        foreach (Action<PhysicsSimulator, Body> shape in shapes)
        {
            var simulator =
                new PhysicsSimulator(new Vector2(0, size < 1 ? size * 10 : 10)) { AllowedPenetration = size < 1 ? size * 0.01f : 0.01f };
            for (int i = 0; i < 3; i++)
            {
                Body body = BodyFactory.Instance.CreateBody(simulator, 1, 1);
                body.IsStatic = i == 0;
                body.Position = new Vector2(0, -Math.Min(size, 1e17f) * i);
                try
                {
                    shape(simulator, body);
                }
                catch (ArgumentException)
                {
                    Assert.True(size is < 1e-15f or > 1e15f, "a size of " + size + " must be possible");
                }
            }

            for (int i = 0; i < 20; i++)
            {
                simulator.Update(0.01f);
                Assert.All(simulator.BodyList, b => Assert.True(float.IsFinite(b.Position.Y + b.LinearVelocity.Y + b.AngularVelocity)));
                Assert.True(size is < 1e-15f or > 1e15f || simulator.BodyList.All(b => !b.IsQuarantined), "quarantined at " + size);
            }
        }
    }

    private static Vertices Make(float[] coordinates) =>
        Make(Enumerable.Range(0, coordinates.Length / 2).Select(i => new Vector2(coordinates[2 * i], coordinates[(2 * i) + 1])).ToArray());

    private static Vertices Make(Vector2[] points) => new Vertices(points);

    /// <summary>How high a body of that outline rests on a floor whose surface is at 0.</summary>
    private static float Rest(Vertices outline)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 100));
        var floor = new Body { IsStatic = true, Position = new Vector2(0, 10) };
        simulator.Add(floor);
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 400, 20);
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 20, 20, 1);
        body.Position = new Vector2(0, -12);
        simulator.Add(new Geom(body, outline, 0));
        for (int i = 0; i < 100; i++)
        {
            simulator.Update(0.01f);
        }

        return body.Position.Y;
    }
}
