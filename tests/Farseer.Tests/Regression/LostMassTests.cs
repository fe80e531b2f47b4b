using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// A body that carries others loses mass. Its contacts started from what had carried the mass before, and those that lay on it were thrown
/// off by that before the ground took it back: a box at 0.45 m/s, sixty of them at 90.
/// </summary>
public class LostMassTests
{
    private const float BoxMass = 0.01f;

    [Theory]
    [InlineData(1, 1f, 0.01f)]
    [InlineData(1, 100f, 0.01f)]
    [InlineData(1, 1f, 0.1f)]
    [InlineData(60, 100f, 10f)]
    [InlineData(60, 100f, 1f)]
    public void BoxesOnAPlate_ThatLosesMass_StayAtRest(int boxes, float before, float after)
    {
        PhysicsSimulator simulator = Build(boxes, before, out Body plate, out List<Body> lying);
        Sandbox.Run(simulator, 240, 1 / 60f);

        float share = after / before;
        plate.Mass *= share;
        plate.MomentOfInertia *= share;
        double fastest = 0;
        for (int step = 0; step < 60; step++)
        {
            simulator.Update(1 / 60f);
            foreach (Body box in lying)
            {
                fastest = Math.Max(fastest, box.LinearVelocity.Length());
            }
        }

        // Contacts find what they carry anew from less than it was: boxes sink by less than their millimetre meanwhile, at less than what
        // falls in a tenth of a step.
        Assert.InRange(fastest, 0, 0.017);
    }

    private static PhysicsSimulator Build(int boxes, float mass, out Body plate, out List<Body> lying)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowedPenetration = 0.001f };
        Body ground = Box(simulator, new Vector2(0, -0.5f), 200, 1);
        ground.IsStatic = true;
        float width = (1.2f * boxes) + 1;
        plate = Box(simulator, new Vector2(0, 0.5f), width, mass);
        lying = new List<Body>();
        for (int i = 0; i < boxes; i++)
        {
            lying.Add(Box(simulator, new Vector2(1.2f * (i - (0.5f * (boxes - 1))), 1.5f), 1, BoxMass));
        }

        return simulator;
    }

    private static Body Box(PhysicsSimulator simulator, Vector2 place, float width, float mass)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, width, 1, mass);
        body.Position = place;
        GeomFactory.Instance.CreateRectangleGeom(simulator, body, width, 1);
        return body;
    }
}
