using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>
/// The manual's chapter "GeomFactory". One test changes the shared factor, so the class runs while no other does. That the
/// overloads add to a simulator or do not: <see cref="FactoryOverloadTests"/> too.
/// </summary>
[Collection(Name)]
[CollectionDefinition(Name, DisableParallelization = true)]
public class GeomFactoryTests
{
    private const string Name = "The shared geom factory";

    private static readonly GeomFactory _factory = GeomFactory.Instance;

    [Fact]
    [ManualRow("F040")]
    [ManualRow("F041")]
    public void Instance_IsOne_AndPicksVerticesAndCell()
    {
        Assert.NotNull(GeomFactory.Instance);
        Assert.Same(GeomFactory.Instance, GeomFactory.Instance);
        Geom geom = _factory.CreateEllipseGeom(new Body(), 20, 10, 24);
        Assert.Equal(Vertices.CreateEllipse(20, 10, 24), geom.LocalVertices);
        Assert.Equal(2, geom.CollisionGridCellSize, 1e-5f);
    }

    [Fact]
    [ManualRow("F042")]
    [ManualRow("F043")]
    [ManualRow("F044")]
    [ManualRow("F045")]
    public void RectangleGeom_HasItsSidesAndItsCell_AndIsAddedWhereASimulatorIsGiven()
    {
        var simulator = new PhysicsSimulator();
        var body = new Body { Position = new Vector2(10, 20) };
        Geom automatic = _factory.CreateRectangleGeom(simulator, body, 40, 20);
        Geom given = _factory.CreateRectangleGeom(simulator, body, 40, 20, 3);
        Geom free = _factory.CreateRectangleGeom(body, 40, 20);
        Geom freeGiven = _factory.CreateRectangleGeom(body, 40, 20, 3);
        foreach (Geom geom in new[] { automatic, given, free, freeGiven })
        {
            Assert.Same(body, geom.Body);
            Assert.Equal(16, geom.LocalVertices.Count);
            Assert.Equal(new Vector2(-10, 10), geom.AABB.Min);
            Assert.Equal(new Vector2(30, 30), geom.AABB.Max);
            Assert.True(geom.Collide(new Vector2(29, 29)));
        }

        Assert.Equal(2, automatic.CollisionGridCellSize, 1e-5f);
        Assert.Equal(2, free.CollisionGridCellSize, 1e-5f);
        Assert.Equal(3, given.CollisionGridCellSize);
        Assert.Equal(3, freeGiven.CollisionGridCellSize);
        simulator.Update(0.01f);
        Assert.Equal(new[] { automatic, given }, simulator.GeomList);
    }

    [Fact]
    [ManualRow("F046")]
    [ManualRow("F047")]
    [ManualRow("F048")]
    public void CircleGeom_HasItsEdgesAndItsCell_AndIsAddedWhereASimulatorIsGiven()
    {
        var simulator = new PhysicsSimulator();
        var body = new Body();
        Geom automatic = _factory.CreateCircleGeom(simulator, body, 64, 20);
        Geom given = _factory.CreateCircleGeom(simulator, body, 64, 20, 3);
        Geom free = _factory.CreateCircleGeom(body, 64, 20);
        foreach (Geom geom in new[] { automatic, given, free })
        {
            Assert.Equal(20, geom.LocalVertices.Count);
            Assert.Equal(20, geom.WorldVertices.Count);
            Assert.All(geom.LocalVertices, vertex => Assert.Equal(64, vertex.Length(), 1e-4f));
            Assert.Equal(128, geom.AABB.Width, 1e-3f);
        }

        Assert.Equal(3, given.CollisionGridCellSize);
        Assert.Equal(12.8f, automatic.CollisionGridCellSize, 1e-4f);
        Assert.Equal(automatic.CollisionGridCellSize, free.CollisionGridCellSize);
        simulator.Update(0.01f);
        Assert.Equal(new[] { automatic, given }, simulator.GeomList);
    }

    [Fact]
    [ManualRow("F049")]
    [ManualRow("F051")]
    public void PolygonGeom_IsMovedToItsCentroid_TogetherWithTheListGiven()
    {
        var simulator = new PhysicsSimulator();
        var body = new Body();
        Vertices first = Sandbox.Outline(0, 0, 30, 0, 0, 60);
        Vertices second = Sandbox.Outline(0, 0, 30, 0, 0, 60);
        Geom added = _factory.CreatePolygonGeom(simulator, body, first, 0);
        Geom free = _factory.CreatePolygonGeom(body, second, 7);
        foreach (Geom geom in new[] { added, free })
        {
            Assert.Equal(3, geom.LocalVertices.Count);
            Assert.Equal(-10, geom.AABB.Min.X, 1e-4f);
            Assert.Equal(-20, geom.AABB.Min.Y, 1e-4f);
            Assert.True(geom.Collide(new Vector2(-9, -19)));
            Assert.False(geom.Collide(new Vector2(15, 30)));
        }

        Assert.Equal(first, second);
        Assert.Equal(first, added.LocalVertices);
        Assert.Equal(3, added.CollisionGridCellSize, 1e-5f);
        Assert.Equal(7, free.CollisionGridCellSize);
        simulator.Update(0.01f);
        Assert.Same(added, Assert.Single(simulator.GeomList));
    }

    [Fact]
    [ManualRow("F050")]
    public void PolygonGeom_WithOffsets_IsMovedAndTurnedAgainstTheBody()
    {
        var simulator = new PhysicsSimulator();
        var body = new Body { Position = new Vector2(100, 0) };
        Vertices outline = Sandbox.Outline(0, 0, 40, 0, 40, 20, 0, 20);
        Geom geom = _factory.CreatePolygonGeom(simulator, body, outline, new Vector2(50, 5), System.MathF.PI / 2, 4);
        Assert.Equal(4, geom.CollisionGridCellSize);
        Assert.Equal(new Vector2(150, 5), geom.Position);
        Assert.Equal(System.MathF.PI / 2, geom.Rotation);
        Assert.Equal(20, geom.AABB.Width, 1e-3f);
        Assert.Equal(40, geom.AABB.Height, 1e-3f);
        Assert.Equal(150, geom.AABB.GetCenter().X, 1e-3f);

        // The body's turn takes the offset along: (50, 5) becomes (-5, 50).
        body.Rotation = System.MathF.PI / 2;
        Assert.Equal(95, geom.Position.X, 1e-3f);
        Assert.Equal(50, geom.Position.Y, 1e-3f);
        Assert.Equal(40, geom.AABB.Width, 1e-3f);
        simulator.Update(0.01f);
        Assert.Same(geom, simulator.Collide(95, 50));
        Assert.Null(simulator.Collide(100, 0));
    }

    [Theory]
    [InlineData(0f)]
    [InlineData(-1f)]
    [InlineData(-1000f)]
    [ManualRow("F052")]
    [ManualRow("F055")]
    public void CellSize_ZeroOrLess_IsATenthOfTheShortestSide(float none)
    {
        var body = new Body();
        Geom automatic = _factory.CreateRectangleGeom(body, 128, 128);
        Assert.Equal(12.8f, automatic.CollisionGridCellSize);
        Assert.Equal(12.8f, _factory.CreateRectangleGeom(body, 128, 128, none).CollisionGridCellSize);
        Assert.Equal(12.8f, _factory.CreateRectangleGeom(body, 128, 256, none).CollisionGridCellSize);
        Assert.Equal(12.8f, new Geom(body, Vertices.CreateRectangle(300, 128), none).CollisionGridCellSize);
        Assert.Equal(12.8f, _factory.CreatePolygonGeom(body, Vertices.CreateRectangle(300, 128), none).CollisionGridCellSize, 1e-4f);
        Geom given = _factory.CreateRectangleGeom(body, 128, 128, 12.8f);
        Assert.Equal(automatic.Grid.Points!.Length, given.Grid.Points!.Length);
    }

    [Fact]
    [ManualRow("F053")]
    [ManualRow("F054")]
    public void GridCellSizeAABBFactor_IsATenth_AndHoldsForGeomsMadeLater()
    {
        Assert.Equal(0.1f, _factory.GridCellSizeAABBFactor);
        Geom before = _factory.CreateRectangleGeom(new Body(), 128, 64);
        try
        {
            _factory.GridCellSizeAABBFactor = 0.25f;
            Assert.Equal(16, _factory.CreateRectangleGeom(new Body(), 128, 64).CollisionGridCellSize);
            Assert.Equal(16, _factory.CalculateGridCellSizeFromAABB(Vertices.CreateRectangle(128, 64)));
            Assert.Equal(6.4f, before.CollisionGridCellSize);
            Assert.Throws<System.ArgumentOutOfRangeException>(() => _factory.GridCellSizeAABBFactor = 0);
            Assert.Equal(0.25f, _factory.GridCellSizeAABBFactor);
        }
        finally
        {
            _factory.GridCellSizeAABBFactor = 0.1f;
        }
    }
}
