using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Behavior;

/// <summary>Large piles whose contacts bounce weakly and strike all at once: see decision 013.</summary>
public class WeakBounceTests
{
    private const float Restitution = 0.4f;

    /// <summary>
    /// A carpet of boxes that touch each other lands flat: so many strike in one step that they are not taken one by one.
    /// </summary>
    [Fact]
    public void Carpet_ThatLandsFlat_ComesBackAsFastAsOneBox()
    {
        List<Body> one = Landed(1, out _);
        List<Body> carpet = Landed(1200, out int contacts);
        Assert.True(contacts > 2048, $"{contacts} contacts: the carpet is one island with many");
        Assert.All(carpet, body =>
            // A box alone is turned where it meets the ground, one of the carpet up to a substep's way above: the fall of 1/500 s.
            Assert.InRange(body.LinearVelocity.Y, one[0].LinearVelocity.Y - 0.2f, one[0].LinearVelocity.Y + 0.2f));
    }

    /// <summary>Velocities upwards shortly after landing at some 100 with restitution 0.4.</summary>
    private static List<Body> Landed(int count, out int contacts)
    {
        PhysicsSimulator simulator = Falling();
        simulator.BroadPhaseCollider = new GridCollider(simulator);
        var bodies = new List<Body>();
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, count * 30f, 20, 1);
        floor.IsStatic = true;
        floor.Position = new Vector2(0, 10);
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, count * 30f, 20).RestitutionCoefficient = Restitution;
        for (int i = 0; i < count; i++)
        {
            Geom box = Box(simulator, new Vector2((i - (count / 2)) * 20f, -20.5f));
            box.RestitutionCoefficient = Restitution;
            box.Body.LinearVelocity = new Vector2(0, 100);
            bodies.Add(box.Body);
        }

        contacts = 0;
        for (int step = 0; step < 16; step++)
        {
            Run(simulator, 1);
            contacts = Math.Max(contacts, simulator.ContactCount);
        }

        return bodies;
    }
}
