using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>A simulator has an item once, however often it is added.</summary>
public class RepeatedAddTests
{
    [Fact]
    public void Add_OfWhatIsThereOrWaits_IsIgnored_ForEveryKind()
    {
        for (int seed = 0; seed < 200; seed++)
        {
            string once = Run(seed, 0);
            Assert.Equal(once, Run(seed, 1));
            Assert.Equal(once, Run(seed, 3));
        }
    }

    [Fact]
    public void Add_OfWhatIsElsewhere_IsStillRefused()
    {
        var simulator = new PhysicsSimulator();
        Body body = BodyFactory.Instance.CreateBody(simulator, 1, 1);
        var other = new PhysicsSimulator();
        Assert.Throws<ArgumentException>("body", () => other.Add(body));
        simulator.Update(0.01f);
        Assert.Throws<ArgumentException>("body", () => other.Add(body));
        Assert.Throws<ArgumentException>("controller", () => other.Add(simulator.InactivityController));
    }

    /// <summary>A pendulum, a spring, a controller and a floor; each addition repeated at once, and before each update.</summary>
    private static string Run(int seed, int repeats)
    {
        var random = new Random(seed);
        var simulator = new PhysicsSimulator(new Vector2(0, 100));
        int told = 0;
        simulator.BodyList.Added += _ => told++;
        simulator.JointList.Added += _ => told++;
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 500, 20, 1);
        floor.IsStatic = true;
        floor.Position = new Vector2(0, 100);
        Geom ground = GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 500, 20);
        Body bob = BodyFactory.Instance.CreateRectangleBody(simulator, 10 + (10 * (float)random.NextDouble()), 10, 1);
        bob.Position = new Vector2(50 * (float)random.NextDouble(), 0);
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(simulator, bob, 10, 10);
        Joint joint = JointFactory.Instance.CreateFixedRevoluteJoint(simulator, bob, new Vector2(-5, -20));
        Spring spring = SpringFactory.Instance.CreateFixedLinearSpring(simulator, bob, Vector2.Zero, new Vector2(9, 9), 20, 1);
        var wind = new WindController(new Vector2(10, 0), (float)random.NextDouble());
        simulator.Add(wind);
        for (int step = 0; step < 30; step++)
        {
            for (int i = 0; i < repeats && step % 3 != 1; i++)
            {
                simulator.Add(floor);
                simulator.Add(bob);
                simulator.Add(ground);
                simulator.Add(geom);
                simulator.Add(joint);
                simulator.Add(spring);
                simulator.Add(wind);
                simulator.Add(simulator.InactivityController);
                simulator.BodyList.Add(bob);
            }

            simulator.Update(1 / 60f);
        }

        simulator.Remove(joint);
        simulator.Update(1 / 60f);
        return $"{told} {simulator.BodyList.Count} {simulator.GeomList.Count} {simulator.JointList.Count} {simulator.SpringList.Count} "
            + $"{simulator.ControllerList.Count} {bob.PositionX:R} {bob.PositionY:R} {bob.Rotation:R} {bob.LinearVelocity}";
    }
}
