using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Regression;

/// <summary>A spring of a joint that pulls where its body cannot go.</summary>
public class OutOfReachTests
{
    // The hinge leaves the spring's row next to no mass to move; a stiffness made from that threw the body about with 10000 a second.
    [Theory]
    [InlineData(2, 1f / 60)]
    [InlineData(5, 1f / 60)]
    [InlineData(5, 0.01f)]
    [InlineData(40, 0.01f)]
    public void TargetBeyondTheReachOfAHinge_TurnsTheRodTowardsIt(int iterations, float dt)
    {
        PhysicsSimulator simulator = Falling(0);
        simulator.Iterations = iterations;
        Body rod = BodyFactory.Instance.CreateRectangleBody(simulator, 60, 8, 1);
        rod.Position = new Vector2(30, 0);
        WithoutDrag(rod);
        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, rod, Vector2.Zero);
        var pull = new TargetJoint(rod, new Vector2(60, 0));
        simulator.Add(pull);
        simulator.Update(dt);
        pull.Target = new Vector2(20, 150);
        double fastest = 0;
        for (float time = 0; time < 8; time += dt)
        {
            simulator.Update(dt);
            fastest = Math.Max(fastest, Math.Abs(rod.AngularVelocity));
        }

        // A spring of 5 Hz on the rod's own mass, stretched by up to 160, held 60 from the hinge. Its stiffness w^2/L with w = 2 pi 5 and
        // the least response L = 1/8 of 1/m + 30^2/I has an energy of k 160^2 / 2; all of it in the rod would turn it at w sqrt(k/I0) 160.
        double own = 1 + (30 * 30 / (double)rod.MomentOfInertia);
        double stiffness = Math.Pow(2 * Math.PI * 5, 2) / (own / 8);
        double aboutHinge = rod.MomentOfInertia + (30 * 30);
        Assert.True(fastest < Math.Sqrt(stiffness / aboutHinge) * 160, "turned at " + fastest);
        Assert.Equal(Math.Atan2(150, 20), rod.Rotation, 0.02);
    }
}
