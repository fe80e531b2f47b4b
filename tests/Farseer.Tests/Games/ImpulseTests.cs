using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Games;

/// <summary>What contacts give is what bodies get: the impulses of an update against the momentum and the weight.</summary>
public sealed class ImpulseTests
{
    private const float Step = 1f / 60;
    private const float Gravity = 10;

    /// <summary>
    /// Share of the largest momentum in play: velocities and rows are floats, each of which rounds by 6·10⁻⁸ some hundred times an update.
    /// </summary>
    private const double Rounding = 1e-5;

    private static readonly Dictionary<string, Action<PhysicsSimulator>> _scenes = new()
    {
        ["a stack"] = s => Stack(s, 8, 0, 0),
        ["a stack that lands"] = s => Stack(s, 5, 0.4f, 0),
        ["a stack that bounces"] = s => Stack(s, 5, 0.4f, 0.6f),
        ["a box that slides"] = Slide,
        ["balls that roll into each other"] = Roll,
        ["a heap"] = Heap,
        ["a bullet at a wall"] = Bullet,
        ["two fast balls"] = FastPair,
        ["a heavy box on light ones"] = HeavyOnLight,
        ["boxes that overlap"] = Overlap,
        ["boxes on a moving floor"] = Lift,
    };

    public static TheoryData<string> Scenes => new(_scenes.Keys);

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Pushes_OfEachBody_AreItsChangeOfMomentum(string scene)
    {
        PhysicsSimulator simulator = Simulator();
        _scenes[scene](simulator);
        double worst = 0;
        double largest = 0;
        var before = new Dictionary<Body, Vector2>();
        for (int step = 0; step < 240; step++)
        {
            foreach (Body body in simulator.BodyList)
            {
                before[body] = body.LinearVelocity;
            }

            simulator.Update(Step);
            foreach (Body body in simulator.BodyList)
            {
                if (body.IsStatic || body.IsKinematic || !before.TryGetValue(body, out Vector2 start))
                {
                    continue;
                }

                Vector2 given = GivenTo(simulator, body);
                Vector2 gained = (body.Mass * (body.LinearVelocity - start)) - (body.Mass * Step * simulator.Gravity);
                worst = Math.Max(worst, (gained - given).Length());
                largest = Math.Max(largest, Math.Max(given.Length(), body.Mass * Math.Max(start.Length(), 1)));
            }
        }

        Assert.InRange(worst / largest, 0, Rounding);
    }

    [Fact]
    public void Pushes_OfJointedBodies_AreTheirChangeOfMomentumTogether()
    {
        PhysicsSimulator simulator = Simulator();
        Floor(simulator);
        Body? last = null;
        var all = new List<Body>();
        for (int i = 0; i < 6; i++)
        {
            Body link = Box(simulator, i * 0.8f, 3 + (0.4f * i), 0.7f, 0.3f, 1 + i, 0.3f);
            all.Add(link);
            if (last is not null)
            {
                JointFactory.Instance.CreateRevoluteJoint(simulator, last, link, (last.Position + link.Position) / 2);
            }

            last = link;
        }

        double worst = 0;
        double largest = 0;
        for (int step = 0; step < 240; step++)
        {
            Vector2 start = Momentum(all);
            float mass = 0;
            simulator.Update(Step);
            Vector2 given = Vector2.Zero;
            foreach (Body body in all)
            {
                mass += body.Mass;
                given += GivenTo(simulator, body);
            }

            if (step > 0)
            {
                Vector2 gained = Momentum(all) - start - (mass * Step * simulator.Gravity);
                worst = Math.Max(worst, (gained - given).Length());
                largest = Math.Max(largest, Math.Max(given.Length(), start.Length()));
            }
        }

        Assert.InRange(worst / largest, 0, Rounding);
    }

    [Fact]
    public void ContactImpulses_AtRest_AreWeightTimesTime()
    {
        PhysicsSimulator simulator = Simulator();
        Stack(simulator, 3, 0, 0);
        for (int i = 0; i < 300; i++)
        {
            simulator.Update(Step);
        }

        double sum = 0;
        foreach (Arbiter arbiter in simulator.ArbiterList)
        {
            foreach (Contact contact in arbiter.ContactList)
            {
                sum += arbiter.GeomA.Body.IsStatic ? contact.NormalImpulse : 0;
            }
        }

        double weight = 3 * Gravity * Step;
        Assert.InRange(Math.Abs(sum - weight) / weight, 0, Rounding);
    }

    [Fact]
    public void ContactImpulses_OfABallThatBounces_TellOfTheBlow()
    {
        // 2·m·v of a blow that is over by the update's end, and whose contact is too: the sum is in the hit.
        PhysicsSimulator simulator = Simulator();
        simulator.Gravity = Vector2.Zero;
        Floor(simulator, 1);
        Body ball = Ball(simulator, 0, 1, 0.5f, 2, 1);
        ball.LinearVelocity = new Vector2(0, -3);
        HitEvent hit = default;
        int hits = 0;
        for (int i = 0; i < 60; i++)
        {
            simulator.Update(Step);
            foreach (HitEvent found in simulator.Events.Hits)
            {
                hit = found;
                hits++;
            }
        }

        Assert.Equal(1, hits);
        Assert.Equal(12, hit.NormalImpulse, 12 * Rounding);
        Assert.Equal(3, hit.ApproachSpeed, 3 * Rounding);
        Assert.Equal(new Vector2(0, 1), hit.Normal);
        Assert.Equal(0, hit.Point.X, 1e-5);
        Assert.Equal(0, hit.Point.Y, 1e-3);
    }

    [Fact]
    public void Impulses_SummedOrNot_LeaveEveryBitOfTheMotion()
    {
        foreach (KeyValuePair<string, Action<PhysicsSimulator>> scene in _scenes)
        {
            PhysicsSimulator with = Simulator();
            var without = new PhysicsSimulator(new Vector2(0, -Gravity));
            scene.Value(with);
            scene.Value(without);
            for (int step = 0; step < 120; step++)
            {
                with.Update(Step);
                without.Update(Step);
            }

            for (int i = 0; i < with.BodyList.Count; i++)
            {
                Assert.Equal(without.BodyList[i].PositionX, with.BodyList[i].PositionX);
                Assert.Equal(without.BodyList[i].PositionY, with.BodyList[i].PositionY);
                Assert.Equal(without.BodyList[i].AngularVelocity, with.BodyList[i].AngularVelocity);
            }
        }
    }

    private static PhysicsSimulator Simulator() => new PhysicsSimulator(new Vector2(0, -Gravity))
    {
        RecordedEvents = StepEventKinds.Pushes | StepEventKinds.Hits,
    };

    private static Vector2 GivenTo(PhysicsSimulator simulator, Body body)
    {
        double x = 0;
        double y = 0;
        foreach (PushEvent push in simulator.Events.Pushes)
        {
            double sign = ReferenceEquals(push.GeomB.Body, body) ? 1 : ReferenceEquals(push.GeomA.Body, body) ? -1 : 0;
            x += sign * push.Impulse.X;
            y += sign * push.Impulse.Y;
        }

        return new Vector2((float)x, (float)y);
    }

    private static Vector2 Momentum(List<Body> bodies)
    {
        Vector2 sum = Vector2.Zero;
        bodies.ForEach(b => sum += b.Mass * b.LinearVelocity);
        return sum;
    }

    private static void Stack(PhysicsSimulator simulator, int boxes, float gap, float restitution)
    {
        Floor(simulator, restitution);
        for (int i = 0; i < boxes; i++)
        {
            Box(simulator, 0.01f * i, 0.5f + (i * (1 + gap)) + gap, 1, 1, 1, 0.5f, restitution);
        }
    }

    private static void Slide(PhysicsSimulator simulator)
    {
        Floor(simulator);
        Box(simulator, 0, 0.5f, 1, 1, 2, 0.4f).LinearVelocity = new Vector2(6, 0);
    }

    private static void Roll(PhysicsSimulator simulator)
    {
        Floor(simulator);
        for (int i = 0; i < 6; i++)
        {
            Body ball = Ball(simulator, i * 1.3f, 0.5f, 0.5f, 1 + i, 0.3f);
            ball.LinearVelocity = new Vector2(i % 2 == 0 ? 4 : -4, 0);
        }
    }

    private static void Heap(PhysicsSimulator simulator)
    {
        Floor(simulator);
        for (int i = 0; i < 40; i++)
        {
            Box(simulator, (i % 5) - 2 + (0.1f * (i % 3)), 1 + (i / 5 * 1.2f), 0.8f, 0.6f, 1 + (i % 4), 0.4f, i % 2 * 0.3f).Rotation =
                0.3f * i;
        }
    }

    private static void Bullet(PhysicsSimulator simulator)
    {
        simulator.Gravity = Vector2.Zero;
        Body wall = Box(simulator, 5, 0, 0.1f, 20, 1, 0.3f);
        wall.IsStatic = true;
        Body shot = Ball(simulator, -5, 0, 0.1f, 0.5f, 0.5f);
        shot.LinearVelocity = new Vector2(200, 30);
    }

    private static void FastPair(PhysicsSimulator simulator)
    {
        simulator.Gravity = Vector2.Zero;
        Ball(simulator, -3, 0, 0.1f, 1, 0.5f).LinearVelocity = new Vector2(90, 0);
        Ball(simulator, 3, 0.05f, 0.1f, 3, 0.5f).LinearVelocity = new Vector2(-60, 0);
    }

    private static void HeavyOnLight(PhysicsSimulator simulator)
    {
        Floor(simulator);
        Box(simulator, 0, 0.5f, 1, 1, 1, 0.5f);
        Box(simulator, 0, 1.5f, 1, 1, 1, 0.5f);
        Box(simulator, 0, 2.7f, 1, 1, 100, 0.5f);
    }

    private static void Overlap(PhysicsSimulator simulator)
    {
        Floor(simulator);
        for (int i = 0; i < 5; i++)
        {
            Box(simulator, 0.05f * i, 0.3f + (0.7f * i), 1, 1, 1, 0.5f);
        }
    }

    private static void Lift(PhysicsSimulator simulator)
    {
        Body lift = Box(simulator, 0, -0.5f, 6, 1, 1, 0.8f);
        lift.IsKinematic = true;
        lift.LinearVelocity = new Vector2(0.5f, 1);
        Box(simulator, 0, 0.5f, 1, 1, 1, 0.8f);
        Box(simulator, 0.2f, 1.5f, 1, 1, 2, 0.8f);
    }

    private static void Floor(PhysicsSimulator simulator) => Floor(simulator, 0);

    private static void Floor(PhysicsSimulator simulator, float restitution)
    {
        Body floor = Box(simulator, 0, -1, 100, 2, 1, 0.5f, restitution);
        floor.IsStatic = true;
    }

    private static Body Box(
        PhysicsSimulator simulator, float x, float y, float width, float height, float mass, float friction, float restitution = 0)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, width, height, mass);
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, height);
        return Finish(body, geom, x, y, friction, restitution);
    }

    private static Body Ball(PhysicsSimulator simulator, float x, float y, float radius, float mass, float restitution)
    {
        Body body = BodyFactory.Instance.CreateCircleBody(simulator, radius, mass);
        Geom geom = GeomFactory.Instance.CreateCircleGeom(simulator, body, radius, 16);
        return Finish(body, geom, x, y, 0.4f, restitution);
    }

    private static Body Finish(Body body, Geom geom, float x, float y, float friction, float restitution)
    {
        body.Position = new Vector2(x, y);
        body.LinearDragCoefficient = 0;
        body.RotationalDragCoefficient = 0;
        geom.FrictionCoefficient = friction;
        geom.RestitutionCoefficient = restitution;
        return body;
    }
}
