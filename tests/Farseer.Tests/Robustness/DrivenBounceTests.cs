using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Robustness;

/// <summary>Restitutions above 1 make energy at each bounce: bodies get fast, but stay what and where they are.</summary>
public class DrivenBounceTests
{
    /// <summary>Inner half width of the room, and a sixth of its walls.</summary>
    private const float Room = 100;

    [Fact]
    public void BodiesThatBounceHigherEachTime_StayInTheirRoom()
    {
        for (int seed = 0; seed < 200; seed++)
        {
            PhysicsSimulator simulator = World(seed, out List<Body> bodies, out int[] frozen);
            for (int step = 0; step < 900; step++)
            {
                simulator.Update(1 / 60f);
                foreach (Body body in bodies)
                {
                    // A centre in the wall is a body that has been pushed in by more than a half of itself.
                    Assert.True(
                        Math.Abs(body.Position.X) < Room + 1 && Math.Abs(body.Position.Y) < Room + 1,
                        $"seed {seed}, step {step}: at {body.Position}, {body.LinearVelocity.Length()} units/s, {body.AngularVelocity} "
                            + $"rad/s");

                    // Two and a half half sides in a step of the largest (half of one in each of five substeps), and what falls in.
                    Assert.True(body.LinearVelocity.Length() < 2.5f * 6.5f * 60 * 1.2f, $"seed {seed}, step {step}: {body.LinearVelocity}");
                }
            }

            Assert.Equal(0, frozen[0]);
        }
    }

    [Fact]
    public void BulletBesideSuchAWorld_KeepsItsSpeed()
    {
        var simulator = new PhysicsSimulator(Vector2.Zero);
        Body trampoline = BodyFactory.Instance.CreateRectangleBody(simulator, 10, 10, 1);
        GeomFactory.Instance.CreateRectangleGeom(simulator, trampoline, 10, 10).RestitutionCoefficient = 3;
        Body bullet = BodyFactory.Instance.CreateCircleBody(simulator, 1, 1);
        GeomFactory.Instance.CreateCircleGeom(simulator, bullet, 1, 12);
        bullet.LinearDragCoefficient = 0;
        bullet.Position = new Vector2(0, 100);
        bullet.LinearVelocity = new Vector2(1e5f, 0);
        Body faller = BodyFactory.Instance.CreateCircleBody(simulator, 1, 1);
        faller.LinearDragCoefficient = 0;
        faller.Position = new Vector2(0, -100);
        simulator.Gravity = new Vector2(0, -1e4f);
        for (int step = 0; step < 100; step++)
        {
            simulator.Update(0.01f);
        }

        Assert.Equal(1e5f, bullet.LinearVelocity.X, 0.1f);
        Assert.Equal(-1e4f, faller.LinearVelocity.Y, 0.1f);
    }

    [Fact]
    public void OneBounce_OfATrampoline_GivesWhatItsRestitutionSays()
    {
        for (int i = 1; i <= 100; i++)
        {
            float restitution = 1 + (i / 50f);
            var simulator = new PhysicsSimulator(Vector2.Zero);
            Body wall = BodyFactory.Instance.CreateRectangleBody(simulator, 10, 100, 1);
            wall.IsStatic = true;
            GeomFactory.Instance.CreateRectangleGeom(simulator, wall, 10, 100).RestitutionCoefficient = restitution;
            Body ball = BodyFactory.Instance.CreateCircleBody(simulator, 5, 1);
            GeomFactory.Instance.CreateCircleGeom(simulator, ball, 5, 12).RestitutionCoefficient = restitution;
            ball.LinearDragCoefficient = 0;
            ball.Position = new Vector2(-30, 0);
            ball.LinearVelocity = new Vector2(10 + i, 0);
            for (int step = 0; step < 200; step++)
            {
                simulator.Update(0.01f);
            }

            Assert.Equal(-restitution * (10 + i), ball.LinearVelocity.X, 1e-3f * (10 + i));
        }
    }

    /// <summary>Other units, walls, shapes, masses, steps and dials than those above, with rods between some bodies.</summary>
    [Fact]
    public void RoomsOfAllKinds_KeepTheirBodies_AndTheseStayFinite()
    {
        for (int seed = 0; seed < 200; seed++)
        {
            PhysicsSimulator simulator = AnyRoom(seed, out List<Body> bodies, out float within, out float dt);
            int cast = 0;
            simulator.BodyQuarantined += (_, _) => cast++;
            for (int step = 0; step < 600; step++)
            {
                simulator.Update(dt);
                foreach (Body body in bodies)
                {
                    float speed = body.LinearVelocity.Length();
                    string what = $"seed {seed}, step {step}: at {body.Position} of {within}, {speed} units/s, {body.AngularVelocity}";
                    Assert.True(Math.Abs(body.Position.X) < within && Math.Abs(body.Position.Y) < within, what);
                    Assert.True(float.IsFinite(speed + body.AngularVelocity), what);
                }
            }

            Assert.True(cast == 0, $"seed {seed}: {cast} bodies were cast out");
        }
    }

    private static PhysicsSimulator AnyRoom(int seed, out List<Body> bodies, out float within, out float dt)
    {
        var random = new Random(seed);
        float Number(float from, float to) => from + ((to - from) * (float)random.NextDouble());
        float unit = MathF.Pow(10, Number(-2, 2));
        float room = 10 * unit;
        float wall = room * Number(0.02f, 0.3f);
        var simulator = new PhysicsSimulator(new Vector2(0, random.Next(3) == 0 ? 0 : 10 * unit))
        {
            AllowedPenetration = unit * Number(0, 0.01f),
            Iterations = new[] { 1, 3, 5, 8, 20 }[random.Next(5)],
        };
        dt = new[] { 1 / 30f, 1 / 60f, 1 / 120f, 0.01f }[random.Next(4)];
        within = room + wall;
        float restitution = Number(1.05f, 2.55f);
        foreach (Vector2 side in new[] { Vector2.UnitX, -Vector2.UnitX, Vector2.UnitY, -Vector2.UnitY })
        {
            Vector2 size = side.X != 0 ? new Vector2(wall, 2 * within) : new Vector2(2 * within, wall);
            Body body = BodyFactory.Instance.CreateRectangleBody(simulator, size.X, size.Y, 1);
            body.IsStatic = true;
            body.Position = (room + (wall / 2)) * side;
            GeomFactory.Instance.CreateRectangleGeom(simulator, body, size.X, size.Y).RestitutionCoefficient = restitution;
        }

        bodies = [];
        int count = random.Next(1, 13);
        for (int i = 0; i < count; i++)
        {
            Geom geom = AnyShape(simulator, random, unit * Number(0.3f, 2.3f), unit * Number(0.3f, 2.3f));
            geom.RestitutionCoefficient = restitution;
            geom.FrictionCoefficient = Number(0, 1);
            Body body = geom.Body;
            body.Position = room * new Vector2(Number(-0.8f, 0.8f), Number(-0.8f, 0.8f));
            body.LinearVelocity = unit * new Vector2(Number(-20, 20), Number(-20, 20));
            body.AngularVelocity = Number(-10, 10);
            body.IsBullet = random.Next(3) == 0;
            body.Mass *= MathF.Pow(10, Number(-1, 1));
            bodies.Add(body);
        }

        for (int i = 0; i + 1 < bodies.Count && random.Next(3) == 0; i += 2)
        {
            simulator.Add(new DistanceJoint(bodies[i], Vector2.Zero, bodies[i + 1], Vector2.Zero));
        }

        return simulator;
    }

    private static Geom AnyShape(PhysicsSimulator simulator, Random random, float width, float height)
    {
        int kind = random.Next(4);
        if (kind == 0)
        {
            Body ball = BodyFactory.Instance.CreateCircleBody(simulator, width / 2, 1);
            return GeomFactory.Instance.CreateCircleGeom(simulator, ball, width / 2, 16);
        }

        if (kind == 1)
        {
            Body box = BodyFactory.Instance.CreateRectangleBody(simulator, width, height, 1);
            return GeomFactory.Instance.CreateRectangleGeom(simulator, box, width, height);
        }

        var outline = new Vertices();
        int corners = random.Next(3, 7);
        for (int k = 0; k < corners; k++)
        {
            double angle = 2 * Math.PI * k / corners;
            outline.Add(new Vector2((float)Math.Cos(angle) * width / 2, (float)Math.Sin(angle) * height / 2));
        }

        if (kind == 3)
        {
            outline = Sandbox.Outline(0, 0, width, 0, width, width / 3, width / 3, width / 3, width / 3, width, 0, width);
        }

        return GeomFactory.Instance.CreatePolygonGeom(simulator, BodyFactory.Instance.CreatePolygonBody(simulator, outline, 1), outline, 0);
    }

    private static PhysicsSimulator World(int seed, out List<Body> bodies, out int[] frozen)
    {
        var random = new Random(seed);
        var simulator = new PhysicsSimulator(new Vector2(0, seed % 3 == 0 ? 0 : 100));
        int[] count = [0];
        simulator.BodyQuarantined += (_, _) => count[0]++;
        frozen = count;
        foreach (Vector2 side in new[] { Vector2.UnitX, -Vector2.UnitX, Vector2.UnitY, -Vector2.UnitY })
        {
            Vector2 size = side.X != 0 ? new Vector2(20, 240) : new Vector2(240, 20);
            Body wall = BodyFactory.Instance.CreateRectangleBody(simulator, size.X, size.Y, 1);
            wall.IsStatic = true;
            wall.Position = (Room + 10) * side;
            GeomFactory.Instance.CreateRectangleGeom(simulator, wall, size.X, size.Y).RestitutionCoefficient = 1.4f;
        }

        bodies = [];
        for (int i = 0; i <= seed % 10; i++)
        {
            float width = 3 + (10 * (float)random.NextDouble());
            float height = 3 + (10 * (float)random.NextDouble());
            bool round = random.Next(2) == 0;
            Body body = round
                ? BodyFactory.Instance.CreateCircleBody(simulator, width / 2, 1)
                : BodyFactory.Instance.CreateRectangleBody(simulator, width, height, 1);
            Geom geom = round
                ? GeomFactory.Instance.CreateCircleGeom(simulator, body, width / 2, 20)
                : GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, height);
            geom.RestitutionCoefficient = 1.2f + (float)random.NextDouble();
            geom.FrictionCoefficient = 0.5f * (float)random.NextDouble();
            body.Position = new Vector2((160 * (float)random.NextDouble()) - 80, (160 * (float)random.NextDouble()) - 80);
            body.LinearVelocity = new Vector2(100 * (float)random.NextDouble(), 100 * (float)random.NextDouble());
            bodies.Add(body);
        }

        return simulator;
    }
}
