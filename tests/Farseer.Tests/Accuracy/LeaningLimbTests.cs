using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Accuracy;

/// <summary>
/// A light limb that lies flat on the floor while a heavy body leans on its end through a hinge: its two points bear unlike loads. Fed
/// forward was only what both bore, so the loaded end sagged ten times as deep as a limb that is loaded evenly.
/// </summary>
public class LeaningLimbTests
{
    private const float Length = 0.4f;
    private const float Thickness = 0.12f;

    [Fact]
    public void Limb_LeantOnAtItsEnd_LiesOnTheFloor()
    {
        for (int seed = 0; seed < 100; seed++)
        {
            var random = new Random(seed);
            float ratio = MathF.Exp(random.NextSingle() * MathF.Log(30));
            float lever = 0.1f + (0.09f * random.NextSingle());
            double depth = DepthAtRest(ratio, lever);

            // A limb loaded evenly sags by a tenth of g·h²·ratio/(π/2)², 0.14 mm at 1:30.
            Assert.True(depth <= 1e-4, $"Seed {seed}: {1000 * depth} mm deep under 1:{ratio}, {lever} m from the middle.");
        }
    }

    private static double DepthAtRest(float ratio, float lever)
    {
        const float LimbMass = 0.048f;
        using var simulator = new PhysicsSimulator(new Vector2(0, -10));
        Geom floor = Sandbox.Box(simulator, new Vector2(0, -0.5f), 60, 1);
        floor.Body.IsStatic = true;
        floor.FrictionCoefficient = 0.6f;
        Geom limb = Sandbox.Box(simulator, new Vector2(0, 0.5f * Thickness), Length, Thickness, LimbMass);
        Geom trunk = Sandbox.Box(simulator, new Vector2(lever + 0.5f, 0.35f), 1.2f, 0.2f, ratio * LimbMass);
        Geom post = Sandbox.Box(simulator, new Vector2(lever + 1, 0.125f), 0.1f, 0.25f);
        post.Body.IsStatic = true;
        RevoluteJoint hinge = JointFactory.Instance.CreateRevoluteJoint(
            simulator, trunk.Body, limb.Body, new Vector2(lever, 0.5f * Thickness));
        hinge.CollideConnected = false;
        Sandbox.Run(simulator, 600, 1 / 60f);
        double angle = limb.Body.Rotation;
        double low = limb.Body.Position.Y - (0.5 * Thickness * Math.Cos(angle)) - (0.5 * Length * Math.Abs(Math.Sin(angle)));
        return -low;
    }
}
