using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Nothing in the library knows a length: a scene in other units is the same scene.</summary>
public class ScalingTests
{
    [Theory]
    [InlineData(1024f)]
    [InlineData(1 / 1024f)]
    [InlineData(1048576f)]
    public void Pile_ScaledByAPowerOfTwo_GoesTheSameWayBitForBit(float scale)
    {
        for (int seed = 1; seed <= 12; seed++)
        {
            var pile = new RandomPile(seed, 30, 1);
            var scaled = new RandomPile(seed, 30, scale);
            Assert.Equal(pile.State(), scaled.State());
            for (int i = 0; i < 30; i++)
            {
                Sandbox.Run(pile.Simulator, 10);
                Sandbox.Run(scaled.Simulator, 10);
                Assert.Equal(pile.State(), scaled.State());
            }

            Assert.True(pile.Simulator.ArbiterList.Count > 30, "The scene was to become a pile.");
        }
    }

    [Theory]
    [InlineData("stack")]
    [InlineData("circle pile")]
    [InlineData("concave")]
    public void Scene_ScaledBy1024_GoesTheSameWayBitForBit(string name)
    {
        PhysicsSimulator simulator = Scene(name, 1);
        PhysicsSimulator scaled = Scene(name, 1024);
        for (int i = 0; i < 20; i++)
        {
            Assert.Equal(State(simulator, 1), State(scaled, 1024));
            Sandbox.Run(simulator, 15);
            Sandbox.Run(scaled, 15);
        }

        Assert.True(simulator.ArbiterList.Count >= 5, "The scene was to come to contacts.");
    }

    [Fact]
    public void ChainSegmentAndKinematic_ScaledByAPowerOfTwo_GoTheSameWayBitForBit()
    {
        double[] first = Slope(1);
        double[] scaled = Slope(1024);
        Assert.Equal(first, scaled);
    }

    /// <summary>Ten boxes on each other, thirty circles in a heap or twelve L-shapes, with friction, bounce and drag.</summary>
    private static PhysicsSimulator Scene(string name, float scale)
    {
        var simulator = new PhysicsSimulator(scale * new Vector2(0, 100));
        simulator.AllowedPenetration *= scale;
        Body ground = BodyFactory.Instance.CreateRectangleBody(simulator, 400 * scale, 20 * scale, 1);
        ground.IsStatic = true;
        ground.Position = scale * new Vector2(0, 10);
        GeomFactory.Instance.CreateRectangleGeom(simulator, ground, 400 * scale, 20 * scale).FrictionCoefficient = 0.5f;
        int count = name == "stack" ? 10 : name == "concave" ? 12 : 30;
        for (int i = 0; i < count; i++)
        {
            Geom geom = name switch
            {
                "stack" => Sandbox.Box(simulator, scale * new Vector2(0.25f * (i % 3), -10 - (20.5f * i)), 20 * scale, 20 * scale),
                "concave" => Angle(simulator, scale * new Vector2(9 * (i % 4), -20 - (32 * i)), 8 * scale),
                _ => Sandbox.Ball(
                    simulator, scale * new Vector2((11 * (i % 5)) + (0.5f * (i / 5)), -8 - (12 * (i / 5))), (4 + (i % 3)) * scale),
            };
            geom.Body.LinearDragCoefficient = 0.001f;

            // A torque for each unit of spin: it has the square of a length in its unit, as the moment of inertia has.
            geom.Body.RotationalDragCoefficient = 0.001f * scale * scale;
            geom.FrictionCoefficient = 0.25f * (i % 4);
            geom.RestitutionCoefficient = 0.3f * (i % 2);
        }

        return simulator;
    }

    private static Geom Angle(PhysicsSimulator simulator, Vector2 place, float size)
    {
        Vertices outline = Sandbox.Outline(0, 0, 3 * size, 0, 3 * size, size, size, size, size, 3 * size, 0, 3 * size);
        Body body = BodyFactory.Instance.CreatePolygonBody(simulator, outline, 1);
        body.Position = place;
        body.Rotation = 0.4f;
        return GeomFactory.Instance.CreatePolygonGeom(simulator, body, outline, 0);
    }

    private static double[] State(PhysicsSimulator simulator, float scale) => simulator.BodyList
        .SelectMany(body => new[]
        {
            body.PositionX / scale, body.PositionY / scale, body.TotalRotation,
            body.LinearVelocity.X / scale, body.LinearVelocity.Y / scale, body.AngularVelocity,
        })
        .ToArray();

    private static double[] Slope(float scale)
    {
        var simulator = new PhysicsSimulator(scale * new Vector2(0, 100));
        simulator.AllowedPenetration *= scale;
        var ground = new Body { IsStatic = true };
        simulator.Add(ground);
        var points = new Vertices();
        for (int i = 0; i <= 20; i++)
        {
            points.Add(scale * new Vector2((10 * i) - 100, 0.05f * (i - 10) * (i - 10) * -1));
        }

        GeomFactory.Instance.CreateChainGeom(simulator, ground, points, false).FrictionCoefficient = 0.3f;
        GeomFactory.Instance.CreateSegmentGeom(simulator, ground, scale * new Vector2(-100, 40), scale * new Vector2(100, 50));
        Body lift = BodyFactory.Instance.CreateRectangleBody(simulator, 30 * scale, 4 * scale, 1);
        lift.IsKinematic = true;
        lift.Position = scale * new Vector2(0, 30);
        lift.LinearVelocity = scale * new Vector2(7, -3);
        GeomFactory.Instance.CreateRectangleGeom(simulator, lift, 30 * scale, 4 * scale);
        var bodies = new Body[12];
        for (int i = 0; i < bodies.Length; i++)
        {
            Body body = BodyFactory.Instance.CreateCircleBody(simulator, 4 * scale, 1);
            Sandbox.WithoutDrag(body);
            body.Position = scale * new Vector2((12 * i) - 70, i % 2 == 0 ? -20 : 15);
            Geom geom = i % 3 == 0
                ? GeomFactory.Instance.CreateRectangleGeom(simulator, body, 7 * scale, 6 * scale)
                : GeomFactory.Instance.CreateCircleGeom(simulator, body, 4 * scale, 12);
            geom.FrictionCoefficient = 0.4f;
            bodies[i] = body;
        }

        Sandbox.Run(simulator, 150);
        var state = new double[bodies.Length * 3];
        for (int i = 0; i < bodies.Length; i++)
        {
            state[3 * i] = bodies[i].PositionX / scale;
            state[(3 * i) + 1] = bodies[i].PositionY / scale;
            state[(3 * i) + 2] = bodies[i].TotalRotation;
        }

        return state;
    }
}
