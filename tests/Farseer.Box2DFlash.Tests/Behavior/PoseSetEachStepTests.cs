using System;
using System.Collections.Generic;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Contacts;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Behavior;

/// <summary>Programs that set poses in each frame (editors, buoyancy) hear of contacts as if they did not.</summary>
public class PoseSetEachStepTests
{
    [Fact]
    public void Listener_OfBodiesWhosePosesAreSetToWhatTheyAre_HearsEachPointOnce_AndTheWholeWeight()
    {
        for (int seed = 0; seed < 200; seed++)
        {
            var random = new Random(seed);
            b2World world = Bench.World();
            Log log = new();
            world.SetContactListener(log);
            Bench.Static(world, 0, -10, 50, 10);
            List<b2Body> bodies = Dropped(world, random, restitution: 0);
            float jitter = random.Next(3) == 0 ? 0 : MathF.Pow(10, -4 - (3 * (float)random.NextDouble()));
            double mass = 0;
            foreach (b2Body body in bodies)
            {
                mass += body.GetMass();
            }

            for (int step = 0; step < 300; step++)
            {
                foreach (b2Body body in bodies)
                {
                    b2Vec2 place = body.GetPosition().Copy();
                    place.x += jitter * ((2 * (float)random.NextDouble()) - 1);
                    place.y += jitter * (float)random.NextDouble();
                    Assert.True(body.SetXForm(place, body.GetAngle()));
                }

                log.BeginStep();
                world.Step(Bench.Dt, 10);
                log.EndStep(seed, step);
            }

            // All rest on the floor, which carries them: within a hundredth where nothing shakes them.
            Assert.True(log.Added > 0, $"seed {seed}: nothing was heard");
            if (jitter == 0)
            {
                Assert.Equal(mass * 10 * Bench.Dt, log.NormalImpulse, 0.01 * mass * 10 * Bench.Dt);
            }
        }
    }

    [Fact]
    public void Box_LandingWhileItsPoseIsSet_IsAddedOnce_AndPersists()
    {
        for (int i = 0; i < 120; i++)
        {
            b2World world = Bench.World();
            Log log = new();
            world.SetContactListener(log);
            Bench.Static(world, 0, -10, 50, 10);
            b2Body box = Bench.Dynamic(world, 0, 0.5f + (i / 40f));
            int landed = -1;
            for (int step = 0; step < 240; step++)
            {
                box.SetXForm(box.GetPosition(), box.GetAngle());
                log.BeginStep();
                world.Step(Bench.Dt, 10);
                log.EndStep(i, step);
                landed = landed < 0 && log.Added > 0 ? step : landed;
            }

            Assert.True(landed >= 0, $"drop {i}: nothing was heard");
            Assert.Equal((2, 0), (log.Added, log.Removed));
            Assert.Equal(2 * (239 - landed), log.Persisted);
            Assert.Equal(2 * (240 - landed), log.Results);
        }
    }

    [Fact]
    public void Box_LiftedByHand_PartsAtOnce_AndLandsAnew()
    {
        for (int i = 0; i < 120; i++)
        {
            // From within the reach of the engine's boxes to far beyond.
            float height = 0.02f * MathF.Pow(1.06f, i);
            b2World world = Bench.World(doSleep: false);
            Log log = new();
            world.SetContactListener(log);
            Bench.Static(world, 0, -10, 50, 10);
            b2Body box = Bench.Dynamic(world, 0, 0.5f);
            Bench.Step(world, 30);
            Assert.Equal((2, 0), (log.Added, log.Removed));
            box.SetXForm(new b2Vec2(0, 0.5f + height), 0);
            Assert.Equal(2, log.Removed);
            for (int step = 0; step < 300; step++)
            {
                log.BeginStep();
                world.Step(Bench.Dt, 10);
                log.EndStep(i, step);
            }

            Assert.Equal((4, 2), (log.Added, log.Removed));
            Assert.Equal(0.4975f, box.GetPosition().y, 0.002f);
        }
    }

    [Fact]
    public void Points_OfBodiesPutHereAndThere_BeginGoOnAndEndInOrder()
    {
        for (int seed = 0; seed < 200; seed++)
        {
            var random = new Random(seed);
            b2World world = Bench.World(doSleep: false);
            Log log = new();
            world.SetContactListener(log);
            b2Body ground = Bench.Static(world, 0, -10, 50, 10);
            List<b2Body> bodies = Dropped(world, random, restitution: 0.5f * random.Next(2));
            for (int step = 0; step < 400; step++)
            {
                for (int i = 0; step == 120 && i < bodies.Count; i++)
                {
                    bodies[i].SetXForm(new b2Vec2((3 * i) - 4, 2), 0);
                    bodies[i].SetLinearVelocity(new b2Vec2(0, 0));
                }

                foreach (b2Body body in bodies)
                {
                    // By nothing, by a hair, by less than its boxes reach, by more, or far away and back.
                    float way = random.Next(6) switch { 0 => 0, 1 => 1e-5f, 2 => 0.02f, 3 => 0.5f, 4 => 2, _ => -1 };
                    if (way >= 0 && step < 120)
                    {
                        b2Vec2 place = body.GetPosition().Copy();
                        place.y += way * (float)random.NextDouble();
                        body.SetXForm(place, body.GetAngle());
                        if (random.Next(4) == 0)
                        {
                            place.y = 0.5f + (float)random.NextDouble();
                            body.SetXForm(place, body.GetAngle());
                        }
                    }
                }

                if (random.Next(20) == 0)
                {
                    ground.SetXForm(ground.GetPosition(), 0);
                }

                log.BeginStep();
                world.Step(Bench.Dt, 10);
                log.EndStep(seed, step);
            }

            // At last all lie on the ground.
            Assert.True(log.Added - log.Removed >= bodies.Count, $"seed {seed}: {log.Added} came, {log.Removed} went");
        }
    }

    /// <summary>One to four bodies of all kinds side by side above the floor.</summary>
    private static List<b2Body> Dropped(b2World world, Random random, float restitution)
    {
        List<b2Body> bodies = [];
        int count = random.Next(1, 5);
        for (int i = 0; i < count; i++)
        {
            float size = 0.2f + (0.6f * (float)random.NextDouble());
            b2PolygonDef polygon = new();
            switch (random.Next(3))
            {
                case 0:
                    polygon.SetAsBox(size, 0.2f + (0.6f * (float)random.NextDouble()));
                    break;
                case 1:
                    polygon.vertexCount = 3;
                    polygon.vertices[0].Set(-size, -size / 3);
                    polygon.vertices[1].Set(size, -size / 3);
                    polygon.vertices[2].Set(0, size);
                    break;
                default:
                    polygon.SetAsBox(size, size);
                    break;
            }

            b2ShapeDef shape = random.Next(3) == 0 ? new b2CircleDef { radius = size } : polygon;
            shape.density = 0.5f + (4 * (float)random.NextDouble());
            shape.friction = (float)random.NextDouble();
            shape.restitution = restitution;
            bodies.Add(Bench.Body(world, (3 * i) - 4, 0.8f + (3 * (float)random.NextDouble()), shape));
        }

        return bodies;
    }

    /// <summary>Checks that each point begins, goes on and ends in order.</summary>
    private sealed class Log : b2ContactListener
    {
        private readonly HashSet<(b2Shape, b2Shape, uint)> _there = [];
        private readonly HashSet<(b2Shape, b2Shape, uint)> _told = [];
        private readonly HashSet<(b2Shape, b2Shape, uint)> _solved = [];
        private string? _wrong;

        public int Added { get; private set; }

        public int Persisted { get; private set; }

        public int Removed { get; private set; }

        public int Results { get; private set; }

        public double NormalImpulse { get; private set; }

        public void BeginStep()
        {
            _told.Clear();
            _solved.Clear();
            NormalImpulse = 0;
        }

        public void EndStep(int seed, int step)
        {
            Assert.True(_wrong is null, $"{seed}, step {step}: {_wrong}");
            Assert.True(_told.SetEquals(_there), $"{seed}, step {step}: told of {_told.Count} points, {_there.Count} are there");
            Assert.True(_solved.SetEquals(_there), $"{seed}, step {step}: results of {_solved.Count} points, {_there.Count} are there");
        }

        public override void Add(b2ContactPoint point)
        {
            Added++;
            _told.Add(Name(point));
            _wrong ??= _there.Add(Name(point)) ? null : "added twice";
        }

        public override void Persist(b2ContactPoint point)
        {
            Persisted++;
            _told.Add(Name(point));
            _wrong ??= _there.Contains(Name(point)) ? null : "persists without having come";
        }

        public override void Remove(b2ContactPoint point)
        {
            Removed++;
            _wrong ??= _there.Remove(Name(point)) ? null : "goes without having come";
        }

        public override void Result(b2ContactResult point)
        {
            Results++;
            NormalImpulse += point.normalImpulse;
            _solved.Add((point.shape1, point.shape2, point.id.key));
        }

        private static (b2Shape, b2Shape, uint) Name(b2ContactPoint point) => (point.shape1, point.shape2, point.id.key);
    }
}
