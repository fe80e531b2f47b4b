using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Interfaces;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Api;

/// <summary>The chapter "Collision Events".</summary>
public class CollisionEventTests
{
    public static TheoryData<string> Colliders => new TheoryData<string> { "sweep", "prune", "brute", "grid" };

    [Fact]
    [ManualRow("F260")]
    public void OnCollision_OnEachStepOfAContact_TellsWhoAndWhere()
    {
        PhysicsSimulator simulator = WithFloor(out Geom floor);
        Geom box = Box(simulator, new Vector2(3, -30));
        int calls = 0;
        Geom.CollisionEventHandler handler = (a, b, contacts) =>
        {
            Assert.Same(box, a);
            Assert.Same(floor, b);
            Assert.Equal(2, contacts.Count);
            foreach (Contact contact in contacts)
            {
                // The corners of the box on the surface at y = 0; the normal from the box, whose handler it is, to the floor.
                Assert.Equal(0, contact.Position.Y, 0);
                Assert.Equal(10, Math.Abs(contact.Position.X - 3), 2);
                Assert.Equal(1, contact.Normal.Y, 4);
            }

            calls++;
            return true;
        };
        box.OnCollision += handler;

        // 20 lengths at 100 length/s² take 0.632 s.
        Run(simulator, 62);
        Assert.Equal(0, calls);
        Run(simulator, 3);
        Assert.InRange(calls, 1, 3);
        int landed = calls;
        Run(simulator, 40);
        Assert.Equal(landed + 40, calls);
        box.OnCollision -= handler;
        Run(simulator, 5);
        Assert.Equal(landed + 40, calls);
    }

    [Fact]
    [ManualRow("F261")]
    public void OnCollisionResult_FalseCancels_TrueLetsItHappen()
    {
        foreach (bool answer in new[] { true, false })
        {
            PhysicsSimulator simulator = WithFloor(out _);
            Geom box = Box(simulator, new Vector2(0, -30));
            bool current = answer;
            int calls = 0;
            box.OnCollision += (_, _, _) =>
            {
                calls++;
                return current;
            };
            Run(simulator, 75);
            Assert.True(calls > 0);
            if (answer)
            {
                Assert.InRange(box.Body.Position.Y, -10.1f, -9.9f);
                Assert.Equal(0, box.Body.LinearVelocity.Y, 1);
            }
            else
            {
                // Free fall from rest, as if the floor were not there: y = -40 + 50 t².
                Assert.Equal(-30 + (50 * 0.75f * 0.75f), box.Body.Position.Y, 2);
                Assert.Equal(75, box.Body.LinearVelocity.Y, 2);
            }
        }
    }

    [Fact]
    [ManualRow("F261")]
    public void OnCollisionResult_IsAskedAgainOnEachStep()
    {
        PhysicsSimulator simulator = WithFloor(out _);
        Geom box = Box(simulator, new Vector2(0, -10));
        bool answer = true;
        box.OnCollision += (_, _, _) => answer;
        Run(simulator, 50);
        Assert.InRange(box.Body.Position.Y, -10.1f, -9.9f);
        answer = false;
        Run(simulator, 20);
        Assert.True(box.Body.Position.Y > -9);
        answer = true;
        Run(simulator, 100);
        Assert.InRange(box.Body.Position.Y, -10.1f, -9.9f);
    }

    [Fact]
    [ManualRow("F261")]
    public void OnCollisionResult_FalseOfTheFirstGeom_LeavesTheSecondUnasked()
    {
        PhysicsSimulator simulator = WithFloor(out Geom floor);
        Geom box = Box(simulator, new Vector2(0, -10));
        int asked = 0;
        floor.OnCollision += (_, _, _) => false;
        box.OnCollision += (_, _, _) => ++asked > 0;
        Run(simulator, 10);
        Assert.Equal(0, asked);
        Assert.True(box.Body.Position.Y > -10);
    }

    [Fact]
    [ManualRow("F262")]
    public void OnSeparation_AfterABounce_TellsBothOnce()
    {
        PhysicsSimulator simulator = WithFloor(out Geom floor);
        Geom ball = Ball(simulator, new Vector2(0, -15), 10);
        ball.RestitutionCoefficient = 1;
        floor.RestitutionCoefficient = 1;
        var log = new List<(Geom, Geom)>();
        ball.OnSeparation += (a, b) => log.Add((a, b));
        floor.OnSeparation += (a, b) => log.Add((a, b));
        int contacts = 0;
        ball.OnCollision += (_, _, _) => ++contacts > 0;

        // 5 lengths of fall take 0.316 s; at 0.45 s the ball is on its way up, well clear of the floor.
        Run(simulator, 45);
        Assert.True(contacts > 0);
        Assert.Equal(new[] { (floor, ball), (ball, floor) }, log);
    }

    [Fact]
    [ManualRow("F262")]
    public void OnSeparation_OfWhatNeverTouched_IsNotRaised()
    {
        PhysicsSimulator simulator = WithFloor(out _);
        Geom near = Ball(simulator, new Vector2(0, -14), 10);
        near.Body.IgnoreGravity = true;
        near.Body.LinearVelocity = new Vector2(30, 0);
        int calls = 0;
        near.OnSeparation += (_, _) => calls++;
        Run(simulator, 200);
        Assert.Equal(0, calls);
    }

    [Theory]
    [MemberData(nameof(Colliders))]
    [ManualRow("F263")]
    [ManualRow("F264")]
    public void OnBroadPhaseCollision_OfEachCollider_IsRaisedWhenBoxesMeet_OldGeomFirst(string name)
    {
        var simulator = new PhysicsSimulator();
        IBroadPhaseCollider collider = Make(name, simulator);
        simulator.BroadPhaseCollider = collider;
        Geom a = Ball(simulator, new Vector2(0, 0), 10);
        Geom b = Ball(simulator, new Vector2(100, 0), 10);
        Geom far = Ball(simulator, new Vector2(0, 1000), 10);
        b.Body.LinearVelocity = new Vector2(-50, 0);
        var seen = new List<(Geom, Geom)>();
        int contacts = 0;
        a.OnCollision += (_, _, _) => ++contacts > 0;
        collider.OnBroadPhaseCollision += (x, y) =>
        {
            seen.Add((x, y));
            Assert.Equal(0, contacts);
            return true;
        };
        simulator.Update(Step);
        Assert.Empty(seen);
        Run(simulator, 200);
        Assert.True(contacts > 0);
        Assert.NotEmpty(seen);
        Assert.All(seen, pair => Assert.Equal((a, b), pair));
        Assert.DoesNotContain(far, seen.SelectMany(pair => new[] { pair.Item1, pair.Item2 }));
    }

    [Theory]
    [MemberData(nameof(Colliders))]
    [ManualRow("F263")]
    public void OnBroadPhaseCollision_OfGeomsOfManyPieces_IsRaisedOnceForThePair(string name)
    {
        foreach (bool answer in new[] { true, false })
        {
            var simulator = new PhysicsSimulator();
            simulator.BroadPhaseCollider = Make(name, simulator);
            Geom lower = Comb(simulator, new Vector2(0, 0));
            Geom upper = Comb(simulator, new Vector2(0, -70));
            upper.Body.LinearVelocity = new Vector2(0, 50);
            int asked = 0;
            int touched = 0;
            lower.OnCollision += (_, _, _) => ++touched > 0;
            simulator.BroadPhaseCollider.OnBroadPhaseCollision += (x, y) =>
            {
                Assert.Same(lower, x);
                Assert.Same(upper, y);
                asked++;
                return answer;
            };
            Run(simulator, 1);
            Assert.Equal(0, asked);
            while (asked == 0)
            {
                Run(simulator, 1);
            }

            Assert.Equal(1, asked);
            if (answer)
            {
                // The other teeth come near later, while the pair stands.
                while (touched == 0)
                {
                    Run(simulator, 1);
                }

                Run(simulator, 2);
                Assert.Equal(1, asked);
            }
        }
    }

    [Theory]
    [MemberData(nameof(Colliders))]
    [ManualRow("F265")]
    public void OnBroadPhaseCollision_ReturningFalse_LeavesNoArbiterNoEventNoImpulse(string name)
    {
        PhysicsSimulator simulator = new PhysicsSimulator(new Vector2(0, 100));
        simulator.BroadPhaseCollider = Make(name, simulator);
        Geom floor = Floor(simulator);
        Geom refused = Box(simulator, new Vector2(-50, -30));
        Geom taken = Box(simulator, new Vector2(50, -30));
        int events = 0;
        refused.OnCollision += (_, _, _) => ++events > 0;
        refused.OnSeparation += (_, _) => events++;
        simulator.BroadPhaseCollider.OnBroadPhaseCollision += (a, b) => !ReferenceEquals(a, refused) && !ReferenceEquals(b, refused);
        for (int i = 0; i < 75; i++)
        {
            simulator.Update(Step);
            Assert.DoesNotContain(simulator.ArbiterList, arbiter => ReferenceEquals(arbiter.GeomB, refused));
        }

        Assert.Equal(0, events);
        Assert.Equal(-30 + (50 * 0.75f * 0.75f), refused.Body.Position.Y, 2);
        Assert.InRange(taken.Body.Position.Y, -10.1f, -9.9f);
        Assert.Same(floor, Assert.Single(simulator.ArbiterList).GeomA);
    }

    [Fact]
    [ManualRow("F266")]
    public void Events_OfTheManualsExample_AreAllRaised()
    {
        PhysicsSimulator simulator = WithFloor(out _);
        Geom geom = Ball(simulator, new Vector2(0, -15), 10);
        geom.RestitutionCoefficient = 2;
        var order = new List<string>();
        geom.OnCollision += OnCollision;
        geom.OnSeparation += OnSeparation;
        simulator.BroadPhaseCollider.OnBroadPhaseCollision += OnBroadPhaseCollision;
        Run(simulator, 60);
        Assert.Equal(new[] { "broad", "collision", "separation" }, order.Distinct());

        bool OnCollision(Geom geometry1, Geom geometry2, ContactList contactList)
        {
            order.Add("collision");
            return true;
        }

        void OnSeparation(Geom geometry1, Geom geometry2) => order.Add("separation");

        bool OnBroadPhaseCollision(Geom geometry1, Geom geometry2)
        {
            order.Add("broad");
            return true;
        }
    }

    /// <summary>A concave geom of five teeth.</summary>
    private static Geom Comb(PhysicsSimulator simulator, Vector2 place)
    {
        Vertices outline = Outline(
            0,
            0,
            90,
            0,
            90,
            30,
            80,
            30,
            80,
            10,
            70,
            10,
            70,
            30,
            60,
            30,
            60,
            10,
            50,
            10,
            50,
            30,
            40,
            30,
            40,
            10,
            30,
            10,
            30,
            30,
            20,
            30,
            20,
            10,
            0,
            10);
        Body body = BodyFactory.Instance.CreatePolygonBody(simulator, outline, 1);
        body.Position = place;
        WithoutDrag(body);
        return GeomFactory.Instance.CreatePolygonGeom(simulator, body, outline, 0);
    }

    private static IBroadPhaseCollider Make(string name, PhysicsSimulator simulator) => name switch
    {
        "sweep" => new SelectiveSweepCollider(simulator),
        "prune" => new SweepAndPruneCollider(simulator),
        "brute" => new BruteForceCollider(simulator),
        _ => new GridCollider(simulator),
    };
}
