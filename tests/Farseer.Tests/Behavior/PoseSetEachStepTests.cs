using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Programs that set poses in each frame hear of contacts as if they did not.</summary>
public class PoseSetEachStepTests
{
    [Fact]
    public void Handlers_OfBodiesWhosePosesAreSetToWhatTheyAre_HearOfEachUpdate_AndOfTheWholeWeight()
    {
        for (int seed = 0; seed < 200; seed++)
        {
            var random = new Random(seed);
            bool inMetres = random.Next(2) == 0;
            float unit = inMetres ? 1 : 20;
            float gravity = inMetres ? 10 : 100;
            float dt = inMetres ? 1 / 60f : 0.01f;
            int way = random.Next(4);
            bool near = random.Next(2) == 0;
            var simulator = new PhysicsSimulator(new Vector2(0, gravity)) { AllowedPenetration = 0.002f * unit };
            Body ground = BodyFactory.Instance.CreateRectangleBody(simulator, 100 * unit, 20 * unit, 1);
            ground.IsStatic = true;
            ground.Position = new Vector2(0, 10 * unit);
            GeomFactory.Instance.CreateRectangleGeom(simulator, ground, 100 * unit, 20 * unit);
            var touches = new Dictionary<Geom, int>();
            int ends = 0;
            double weight = 0;
            var bodies = new List<Body>();
            int count = random.Next(1, 5);
            for (int i = 0; i < count; i++)
            {
                float height = near ? 0 : 3 * unit * (float)random.NextDouble();
                Geom geom = Dropped(simulator, random, unit, new Vector2(3 * i * unit, -height));
                touches[geom] = 0;
                geom.OnCollision += (one, _, contacts) =>
                {
                    touches[one]++;
                    return contacts.Count > 0;
                };
                geom.OnSeparation += (_, _) => ends++;
                weight += geom.Body.Mass * gravity;
                bodies.Add(geom.Body);
            }

            for (int step = 0; step < 300; step++)
            {
                Set(bodies, way);
                simulator.Update(dt);
            }

            // All rest: from here on each is told of once an update, and nobody parts.
            var before = new Dictionary<Geom, int>(touches);
            int endsBefore = ends;
            double impulse = 0;
            for (int step = 0; step < 60; step++)
            {
                Set(bodies, way);
                simulator.Update(dt);
                impulse += NormalImpulses(simulator);
            }

            foreach ((Geom geom, int times) in touches)
            {
                Assert.True(times - before[geom] == 60, $"seed {seed}, way {way}: told {times - before[geom]} times in 60 updates");
            }

            Assert.True(ends == endsBefore, $"seed {seed}, way {way}: {ends - endsBefore} ends while all rest");

            // Within a hundredth: the impulse of a step is that of its last substep, taken for all.
            Assert.Equal(weight * 60 * dt, impulse, 0.01 * weight * 60 * dt);
        }
    }

    private static void Set(List<Body> bodies, int way)
    {
        foreach (Body body in bodies)
        {
            switch (way)
            {
                case 0:
                    body.Position = body.Position;
                    break;
                case 1:
                    body.Rotation = body.Rotation;
                    body.Position = body.Position;
                    break;
                case 2:
                    body.SetPosition(body.PositionX, body.PositionY);
                    break;
                default:
                    body.PositionX = body.PositionX;
                    body.Rotation = body.TotalRotation;
                    break;
            }
        }
    }

    private static double NormalImpulses(PhysicsSimulator simulator)
    {
        double sum = 0;
        foreach (Arbiter arbiter in simulator.ArbiterList)
        {
            foreach (Contact contact in arbiter.ContactList)
            {
                sum += contact.NormalImpulse;
            }
        }

        return sum;
    }

    /// <summary>A box, circle or triangle whose lowest point is at a place.</summary>
    private static Geom Dropped(PhysicsSimulator simulator, Random random, float unit, Vector2 place)
    {
        float size = unit * (0.3f + (0.5f * (float)random.NextDouble()));
        float mass = 0.1f + (10 * (float)random.NextDouble());
        Body body;
        Geom geom;
        switch (random.Next(3))
        {
            case 0:
                body = BodyFactory.Instance.CreateRectangleBody(simulator, 2 * size, size, mass);
                geom = GeomFactory.Instance.CreateRectangleGeom(simulator, body, 2 * size, size);
                body.Position = place - new Vector2(0, size / 2);
                break;
            case 1:
                body = BodyFactory.Instance.CreateCircleBody(simulator, size, mass);
                geom = GeomFactory.Instance.CreateCircleGeom(simulator, body, size, 20);
                body.Position = place - new Vector2(0, size);
                break;
            default:
                Vertices corners = Sandbox.Outline(-size, size / 2, size, size / 2, 0, -size);
                body = BodyFactory.Instance.CreatePolygonBody(simulator, corners, mass);
                geom = GeomFactory.Instance.CreatePolygonGeom(simulator, body, corners, 0);
                body.Position = place - new Vector2(0, size / 2);
                break;
        }

        Sandbox.WithoutDrag(body);
        geom.FrictionCoefficient = (float)random.NextDouble();
        return geom;
    }
}
