using System;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Games;

public sealed class BuilderTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(-1)]
    public void Ragdoll_FallsAndStaysWholeWithinItsLimits(float up)
    {
        PhysicsSimulator simulator = Ground(up);
        Ragdoll ragdoll = Ragdoll.Create(simulator, new Vector2(0, 1.5f * up), 1.8f, 70, new Vector2(0, up));
        Assert.Equal(11, ragdoll.Bodies.Count);
        Assert.Equal(10, ragdoll.Joints.Count);
        Assert.Equal(70, ragdoll.Bodies.Sum(b => b.Mass), 1e-3f);
        ragdoll.Head.ApplyImpulse(new Vector2(8, 0));
        for (int i = 0; i < 400; i++)
        {
            simulator.Update(1f / 60);
            foreach (FarseerGames.FarseerPhysics.Dynamics.Joints.RevoluteJoint joint in ragdoll.Joints)
            {
                float angle = joint.Body2.TotalRotation - joint.Body1.TotalRotation;
                Assert.InRange(angle, joint.LowerLimit - 0.02f, joint.UpperLimit + 0.02f);
            }
        }

        // It lies.
        Assert.All(ragdoll.Bodies, b => Assert.InRange(up * b.Position.Y, 0, 0.8f));
        Assert.All(ragdoll.Bodies, b => Assert.InRange(b.LinearVelocity.Length(), 0, 0.5f));
        Assert.Throws<ArgumentOutOfRangeException>("height", () => Ragdoll.Create(simulator, Vector2.Zero, 0, 1));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(-1)]
    public void Vehicle_DrivesForwardsAndBrakes(float up)
    {
        PhysicsSimulator simulator = Ground(up);
        Vehicle car = Vehicle.Create(simulator, new Vector2(0, 1.3f * up), 4, 1000, new Vector2(0, up));
        Run(simulator, 120);
        Assert.Equal(0, car.Chassis.LinearVelocity.X, 0.05f);
        Assert.InRange(up * car.Chassis.Position.Y, 1, 1.3f);
        car.Drive(8, 900);
        Run(simulator, 300);
        Assert.Equal(8, car.Chassis.LinearVelocity.X, 0.1f);
        Assert.InRange(car.Chassis.Rotation, -0.2f, 6.3f);
        car.Drive(0, 900);
        Run(simulator, 300);
        Assert.Equal(0, car.Chassis.LinearVelocity.X, 0.1f);
        car.Drive(-3, 900);
        Run(simulator, 300);
        Assert.Equal(-3, car.Chassis.LinearVelocity.X, 0.1f);
        Assert.Throws<ArgumentOutOfRangeException>("torque", () => car.Drive(1, -1));
    }

    private static void Run(PhysicsSimulator simulator, int steps) => Sandbox.Run(simulator, steps, 1f / 60);

    private static PhysicsSimulator Ground(float up)
    {
        // Wheels roll on the middle of their overlap with the ground.
        var simulator = new PhysicsSimulator(new Vector2(0, -10 * up)) { AllowedPenetration = 0.005f };
        Body ground = BodyFactory.Instance.CreateRectangleBody(simulator, 400, 2, 1);
        ground.IsStatic = true;
        ground.Position = new Vector2(0, -up);
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(simulator, ground, 400, 2);
        geom.FrictionCoefficient = 0.8f;
        return simulator;
    }
}
