using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>When contacts are told, and what a refusal leaves.</summary>
public class ContactEventTests
{
    private const float Dt = 0.01f;
    private const float Radius = 15f;

    /// <summary>A fast elastic impact begins and ends within one update, wherever in the update it falls.</summary>
    [Fact]
    public void ElasticImpact_WithinAStep_IsToldOnce()
    {
        for (int phase = 0; phase < 64; phase++)
        {
            PhysicsSimulator simulator = new();
            Geom left = Circle(simulator, new Vector2(-60f - (phase * 1.5f / 64f), 0f), new Vector2(100f, 0f));
            Geom right = Circle(simulator, new Vector2(60f, 1f), new Vector2(-50f, 0f));
            int collisions = 0;
            int separations = 0;
            int first = 0;
            int bounced = 0;
            int step = 0;
            left.OnCollision += (_, _, contacts) =>
            {
                collisions++;
                first = first == 0 ? step : first;
                Assert.NotEmpty(contacts);
                return true;
            };
            left.OnSeparation += (_, _) => separations++;
            for (step = 1; step <= 120; step++)
            {
                simulator.Update(Dt);
                bounced = bounced == 0 && left.Body.LinearVelocity.X < 0 ? step : bounced;
            }

            Assert.True(right.Body.LinearVelocity.X > 0, "They passed through each other at phase " + phase);
            Assert.InRange(collisions, 1, 2);
            Assert.Equal(1, separations);

            // The handler is asked before the impulse acts, or it could not refuse it.
            Assert.InRange(first, bounced - 1, bounced);
        }
    }

    [Fact]
    public void Refusal_OfEveryContact_LeavesFreeFlightExact()
    {
        PhysicsSimulator simulator = new(new Vector2(0f, 100f)) { Iterations = 100 };
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 600f, 40f, 1f);
        floor.IsStatic = true;
        floor.Position = new Vector2(0f, 120f);
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 600f, 40f);
        Geom ball = Circle(simulator, Vector2.Zero, Vector2.Zero);
        Geom beside = Circle(simulator, new Vector2(1000f, 0f), Vector2.Zero);
        int asked = 0;
        ball.OnCollision += (_, _, _) =>
        {
            asked++;
            return false;
        };
        for (int i = 0; i < 200; i++)
        {
            simulator.Update(Dt);
        }

        Assert.True(asked > 20);
        Assert.True(ball.Body.Position.Y > 150f);

        // Only in the steps before the first question does the solver carry it, in single precision: some ulps of 200.
        Assert.Equal(beside.Body.Position.Y, ball.Body.Position.Y, 2e-3f);
        Assert.Equal(beside.Body.LinearVelocity.Y, ball.Body.LinearVelocity.Y, 2e-3f);
    }

    [Fact]
    public void Refusal_ThatEnds_LetsTheFloorHoldAgain()
    {
        PhysicsSimulator simulator = new(new Vector2(0f, 100f));
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 600f, 40f, 1f);
        floor.IsStatic = true;
        floor.Position = new Vector2(0f, 120f);
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 600f, 40f);
        Geom ball = Circle(simulator, Vector2.Zero, Vector2.Zero);
        ball.RestitutionCoefficient = 0f;
        bool refuses = true;
        ball.OnCollision += (_, _, _) => !refuses;
        while (ball.Body.Position.Y < 88f)
        {
            simulator.Update(Dt);
        }

        refuses = false;
        for (int i = 0; i < 300; i++)
        {
            simulator.Update(Dt);
        }

        // On the floor's top at 100, pushed out of the 3 units it had sunk in, less its sag.
        Assert.Equal(85f, ball.Body.Position.Y, 1e-3f);
    }

    private static Geom Circle(PhysicsSimulator simulator, Vector2 position, Vector2 velocity)
    {
        Body body = BodyFactory.Instance.CreateCircleBody(simulator, Radius, 1f);
        body.Position = position;
        body.LinearVelocity = velocity;
        body.LinearDragCoefficient = 0f;
        Geom geom = GeomFactory.Instance.CreateCircleGeom(simulator, body, Radius, 32);
        geom.RestitutionCoefficient = 1f;
        return geom;
    }
}
