using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>The manual's chapters "Collision detection" and "Narrow phase".</summary>
public class CollisionDetectionTests
{
    [Fact]
    [ManualRow("F222")]
    public void Parts_BoxesPairUpFirst_ThenTheExactShapesDecide()
    {
        // Two balls beside each other on the diagonal: the boxes overlap by 1, the circles are 2.7 apart.
        var simulator = new PhysicsSimulator();
        Geom first = Sandbox.Ball(simulator, Vector2.Zero, 10);
        Geom second = Sandbox.Ball(simulator, new Vector2(19, 19) * 0.9f, 10);
        var log = new List<string>();
        simulator.BroadPhaseCollider.OnBroadPhaseCollision += (_, _) =>
        {
            log.Add("broad");
            return true;
        };
        first.OnCollision += (_, _, _) =>
        {
            log.Add("narrow");
            return true;
        };
        Assert.True(AABB.Intersect(first.AABB, second.AABB));
        Assert.False(first.Collide(second));
        simulator.Update(0.01f);
        Assert.Equal(new[] { "broad" }, log);
        Assert.Empty(simulator.ArbiterList);
        second.Body.Position = new Vector2(13, 13);
        simulator.Update(0.01f);
        Assert.Equal(new[] { "broad", "narrow" }, log);
        var inside = new Vector2(5, 0);
        Assert.True(first.Intersect(ref inside, out Feature feature));
        Assert.True(feature.Distance < -4);
    }

    [Fact]
    [ManualRow("F230")]
    public void Arbiter_HoldsThePairAndItsContacts_AsLongAsTheyTouch()
    {
        var simulator = new PhysicsSimulator();
        Geom older = Sandbox.Box(simulator, Vector2.Zero);
        Geom newer = Sandbox.Box(simulator, new Vector2(0, -19.9f));
        simulator.Update(0.01f);
        Arbiter arbiter = Assert.Single(simulator.ArbiterList);
        Assert.Same(older, arbiter.GeomA);
        Assert.Same(newer, arbiter.GeomB);
        Assert.Same(older, arbiter.GeometryA);
        Assert.Equal(2, arbiter.ContactList.Count);
        Assert.True(arbiter == new Arbiter { GeomA = older, GeomB = newer });
        Assert.False(arbiter.Equals(new Arbiter { GeomA = newer, GeomB = older }));
        newer.Body.Position = new Vector2(0, -40);
        simulator.Update(0.01f);
        Assert.Empty(simulator.ArbiterList);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    [ManualRow("F231")]
    [ManualRow("F232")]
    public void Vertex_OfEitherGeomInsideTheOther_BecomesAContact(bool olderHasTheVertex)
    {
        // A square stood on its corner reaches 1 into the side of the other one, which has no vertex inside it.
        var simulator = new PhysicsSimulator();
        float reach = 10 * MathF.Sqrt(2);
        var corner = new Vector2(0, -10 - reach + 1);
        Geom older = Sandbox.Box(simulator, olderHasTheVertex ? corner : Vector2.Zero);
        Geom newer = Sandbox.Box(simulator, olderHasTheVertex ? Vector2.Zero : corner);
        (olderHasTheVertex ? older : newer).Body.Rotation = MathF.PI / 4;
        ContactList? heard = null;
        older.OnCollision += (_, _, contacts) =>
        {
            heard = new ContactList(contacts);
            return true;
        };
        simulator.Update(0.001f);
        Contact contact = Assert.Single(heard!);

        // The vertex is at (0, -9) and the side at y = -10; the contact is somewhere between the two.
        Assert.Equal(0, contact.Position.X, 0.01f);
        Assert.InRange(contact.Position.Y, -10.01f, -8.99f);
        Assert.Equal(-1, contact.Separation, 0.01f);
        Assert.Equal(olderHasTheVertex ? 1 : -1, contact.Normal.Y, 1e-4f);
    }

    [Fact]
    [ManualRow("F233")]
    public void ContactList_IsHandedOverWithBothGeoms_DeepestFirstAndCut()
    {
        foreach (int most in new[] { 4, 1 })
        {
            var simulator = new PhysicsSimulator { MaxContactsToResolve = most };
            Geom floor = Sandbox.Floor(simulator);
            Geom box = Sandbox.Box(simulator, new Vector2(0, -9));
            box.Body.Rotation = 0.05f;
            var heard = new List<(Geom, Geom, int)>();
            floor.OnCollision += (a, b, contacts) =>
            {
                heard.Add((a, b, contacts.Count));
                float[] depths = contacts.Select(contact => contact.Separation).ToArray();
                Assert.Equal(depths.OrderBy(depth => depth), depths);

                // Turned clockwise on the screen, the lower right corner is the deepest: 1 + 10 sin 0.05 or so.
                Assert.True(contacts[0].Position.X > 5);
                Assert.InRange(contacts[0].Separation, -1.6f, -1.4f);
                return true;
            };
            box.OnCollision += (a, b, contacts) =>
            {
                heard.Add((a, b, contacts.Count));
                return true;
            };
            simulator.Update(0.001f);
            int count = Math.Min(most, 2);
            Assert.Equal(new[] { (floor, box, count), (box, floor, count) }, heard);
            Assert.Equal(count, Assert.Single(simulator.ArbiterList).ContactList.Count);
        }
    }

    [Fact]
    [ManualRow("F234")]
    public void Impulses_OfAContact_StopTheApproachAndCarryWeight()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Sandbox.Floor(simulator);
        Geom lower = Sandbox.Box(simulator, new Vector2(0, -10));
        Geom upper = Sandbox.Box(simulator, new Vector2(0, -30), mass: 4);
        Sandbox.Run(simulator, 200);

        // A contact that pushed too little would sink, one that pulled or pushed too much would move it.
        Assert.InRange(lower.Body.Position.Y, -10.001f, -9.9f);
        Assert.InRange(upper.Body.Position.Y, -30.001f, -29.8f);
        Assert.InRange(upper.Body.LinearVelocity.Length(), 0, 0.01f);

        // Pulled up, it comes free: the impulses never pull.
        upper.Body.LinearVelocity = new Vector2(0, -20);
        simulator.Update(0.01f);
        Assert.InRange(upper.Body.LinearVelocity.Y, -20, -18.9f);
    }
}
