using System;
using System.Linq;
using System.Numerics;
using System.Reflection;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Api;

/// <summary>The chapter "Known issues".</summary>
public class KnownIssuesTests
{
    [Theory]
    [InlineData(300)]
    [InlineData(1000)]
    [InlineData(10000)]
    [InlineData(1000000)]
    [ManualRow("F303")]
    public void FastBall_ThatVersion201LetThroughAThinWall_IsStopped(float speed)
    {
        // Up to 10000 lengths a step against a wall of 2. The manual's limit is gone: contacts are made before surfaces meet, as far
        // ahead as the bodies move. The ball ends on the near side, at x = 100 - 10; 0.1 is more than AllowedPenetration.
        Assert.InRange(Shoot(speed, 2, Step), 89, 90.1f);
    }

    [Theory]
    [InlineData(1000)]
    [InlineData(100000)]
    [ManualRow("F303")]
    public void FastBall_AgainstAThinWallThatMoves_TakesItAlong(float speed)
    {
        // Wherever in a step the hit falls.
        for (int shift = 0; shift < 10; shift++)
        {
            var simulator = new PhysicsSimulator();
            Geom wall = Box(simulator, new Vector2(100, 0), 2, 400, 3);
            Geom ball = Ball(simulator, new Vector2(-20 - (speed * Step * shift / 10), 0), 10);
            ball.Body.LinearVelocity = new Vector2(speed, 0);
            Run(simulator, 40);

            // Inelastic and central: both go on with a quarter of the speed, 11 apart. Single precision keeps the sum to 1e-4 of it.
            Assert.Equal(speed / 4, ball.Body.LinearVelocity.X, 1e-3f * speed);
            Assert.Equal(speed, ball.Body.LinearVelocity.X + (3 * wall.Body.LinearVelocity.X), 1e-4f * speed);
            Assert.True(wall.Position.X - ball.Position.X > 10.9f);
        }
    }

    [Theory]
    [InlineData(1000, 215)]
    [InlineData(3000, 230)]
    [InlineData(10000, 300)]
    [ManualRow("F303")]
    public void FastBall_BesideTheWall_FliesOn(float speed, float y)
    {
        // The wall ends at y = 200 and the ball's lower edge is at y - 10. Single precision keeps 30 + 2500 to 2e-4.
        Assert.Equal(30 + (speed * 25 * Step), Shoot(speed, 2, Step, y), 1e-3f);
    }

    [Fact]
    [ManualRow("F304")]
    public void Tunneling_IsAvoidedByLessSpeed_ALargerWall_OrASmallerStep()
    {
        Assert.True(Shoot(1000, 2, Step) < 100);
        Assert.True(Shoot(10000, 200, Step) < 150);
        Assert.True(Shoot(10000, 2, Step / 16) < 100);
    }

    [Fact]
    [ManualRow("F304")]
    public void Tunneling_IsFoundByTestingThePointsOfThePath()
    {
        var simulator = new PhysicsSimulator();
        Body wall = BodyFactory.Instance.CreateRectangleBody(simulator, 2, 200, 1);
        wall.IsStatic = true;
        wall.Position = new Vector2(100, 0);
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(simulator, wall, 2, 200);
        simulator.Update(Step);
        Geom? hit = null;
        for (int i = 0; i <= 100 && hit is null; i++)
        {
            hit = simulator.Collide(new Vector2(50 + i, 0));
        }

        Assert.Same(geom, hit);
        Assert.Null(simulator.Collide(50, 0));
        Assert.Null(simulator.Collide(150, 0));
    }

    [Fact]
    [ManualRow("F305")]
    public void SharpPoint_IsMissedByALargeCell_AndFoundByASmallOne_AndCollidesInAnyCase()
    {
        var needle = new Vertices { new Vector2(0, -60), new Vector2(4, 60), new Vector2(-4, 60) };
        Geom coarse = new Geom(new Body(), needle, 40);
        Geom fine = new Geom(new Body(), needle, 0.5f);
        var tip = new Vector2(0, -50);
        Assert.True(coarse.GetNearestDistance(tip) < 0);
        Assert.False(coarse.Intersect(ref tip, out _));
        Assert.True(fine.Intersect(ref tip, out Feature feature));
        Assert.Equal(fine.GetNearestDistance(tip), feature.Distance, 1);

        // The simulation does not depend on the cell: the needle stands on its tip on the floor, balanced.
        foreach (float cell in new[] { 0.5f, 40f })
        {
            PhysicsSimulator simulator = WithFloor(out _);
            Body body = BodyFactory.Instance.CreateBody(simulator, 1, 1000);
            body.Position = new Vector2(0, -70);
            simulator.Add(new Geom(body, needle, Vector2.Zero, MathF.PI, cell));
            Run(simulator, 60);
            Assert.InRange(body.Position.Y, -60.1f, -59.8f);
        }
    }

    [Fact]
    [ManualRow("F306")]
    public void LongStraightEdge_WithoutPointsOnIt_StillCarriesASpike()
    {
        // In version 2.0.1 only vertices were looked up: a spike between two far vertices of the other could slip in.
        foreach (bool divided in new[] { false, true })
        {
            var simulator = new PhysicsSimulator(new Vector2(0, 100));
            var plank = new Vertices { new Vector2(-200, 10), new Vector2(-200, -10), new Vector2(200, -10), new Vector2(200, 10) };
            if (divided)
            {
                plank.SubDivideEdges(10);
                Assert.Equal(2 * (40 + 2), plank.Count);
            }

            Body floor = BodyFactory.Instance.CreateBody(simulator, 1, 1);
            floor.IsStatic = true;
            simulator.Add(new Geom(floor, plank, 0));
            Body spike = BodyFactory.Instance.CreateBody(simulator, 1, 100);
            spike.Position = new Vector2(3, -40);
            simulator.Add(new Geom(spike, new Vertices { new Vector2(0, 10), new Vector2(-5, -10), new Vector2(5, -10) }, 0));
            Run(simulator, 70);
            Assert.InRange(spike.Position.Y, -20.1f, -19.8f);
        }
    }

    [Fact]
    [ManualRow("F309")]
    public void CellSize_IsAnArgumentOfCreatePolygonGeom_NotOfCreatePolygonBody()
    {
        Assert.DoesNotContain(
            typeof(BodyFactory).GetMethods().Where(m => m.Name == nameof(BodyFactory.CreatePolygonBody)).SelectMany(m => m.GetParameters()),
            p => p.Name == "collisionGridCellSize");
        MethodInfo[] geoms = typeof(GeomFactory).GetMethods().Where(m => m.Name == nameof(GeomFactory.CreatePolygonGeom)).ToArray();
        Assert.NotEmpty(geoms);
        Assert.All(geoms, m => Assert.Contains(m.GetParameters(), p => p.Name == "collisionGridCellSize"));
        var vertices = Vertices.CreateRectangle(128, 128);
        Body body = BodyFactory.Instance.CreatePolygonBody(vertices, 1);
        Assert.Equal(11, GeomFactory.Instance.CreatePolygonGeom(body, vertices, 11).CollisionGridCellSize);
    }

    [Fact]
    [ManualRow("F310")]
    public void ManualsExample_OfASubDividedSquare_Collides()
    {
        PhysicsSimulator simulator = WithFloor(out _);
        var vertices = new Vertices { new Vector2(0, 0), new Vector2(128, 0), new Vector2(128, 128), new Vector2(0, 128) };
        vertices.SubDivideEdges(10);
        Assert.Equal(4 * 13, vertices.Count);
        Body body = BodyFactory.Instance.CreatePolygonBody(vertices, 1);
        Geom geom = GeomFactory.Instance.CreatePolygonGeom(body, vertices, 11);
        simulator.Add(body);
        simulator.Add(geom);
        Assert.Equal(new Vector2(64, 64), body.Position);
        body.Position = new Vector2(0, -70);
        Run(simulator, 150);
        Assert.InRange(body.Position.Y, -64.1f, -63.9f);
        Assert.Equal(0, body.TotalRotation, 3);
    }

    [Fact]
    [ManualRow("F311")]
    public void PolygonGeom_IsCentred_ButNotByTheConstructorOfGeom()
    {
        Vertices Outline() => new Vertices { new Vector2(10, 10), new Vector2(10, 40), new Vector2(70, 40), new Vector2(70, 10) };
        Vertices given = Outline();
        Geom centred = GeomFactory.Instance.CreatePolygonGeom(new Body(), given, 0);
        Assert.Equal(Vector2.Zero, centred.LocalVertices.GetCentroid());
        Assert.Equal(new AABB(new Vector2(-30, -15), new Vector2(30, 15)).Min, centred.AABB.Min);

        // The list given is moved too, as programs that draw from it expect.
        Assert.Equal(centred.LocalVertices, given);
        var kept = new Geom(new Body(), Outline(), 0);
        Assert.Equal(new Vector2(40, 25), kept.LocalVertices.GetCentroid());
        Assert.Equal(new Vector2(10, 10), kept.AABB.Min);
    }

    [Fact]
    [ManualRow("F312")]
    public void PolygonGeomOffset_PutsItWhereTheVerticesWere()
    {
        var vertices = new Vertices { new Vector2(0, 0), new Vector2(60, 0), new Vector2(60, 30), new Vector2(0, 30) };
        Vector2 offset = vertices.GetCentroid();
        PhysicsSimulator simulator = WithFloor(out _);
        Body body = BodyFactory.Instance.CreateBody(simulator, 1, 1e9f);
        body.Position = new Vector2(0, -50);
        Geom geom = GeomFactory.Instance.CreatePolygonGeom(simulator, body, vertices, offset, 0, 0);
        Assert.Equal(new Vector2(0, -50), geom.AABB.Min);
        Assert.Equal(new Vector2(60, -20), geom.AABB.Max);
        Assert.Equal(new Vector2(30, -35), geom.Position);
        body.Rotation = MathF.PI / 2;
        Assert.Equal(-15, geom.Position.X, 4);
        Assert.Equal(-20, geom.Position.Y, 4);
        body.Rotation = 0;
        Run(simulator, 100);

        // It rests on the lower side of where the vertices are, not on the body's place.
        Assert.InRange(body.Position.Y, -30.1f, -29.8f);
    }

    private static float Shoot(float speed, float thickness, float dt, float y = 0)
    {
        var simulator = new PhysicsSimulator();
        Body wall = BodyFactory.Instance.CreateRectangleBody(simulator, thickness, 400, 1);
        wall.IsStatic = true;
        wall.Position = new Vector2(100 + (thickness / 2), 0);
        GeomFactory.Instance.CreateRectangleGeom(simulator, wall, thickness, 400);
        Geom ball = Ball(simulator, new Vector2(30, y), 10);
        ball.Body.LinearVelocity = new Vector2(speed, 0);
        Run(simulator, 25, dt);
        return ball.Body.Position.X;
    }
}
