using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>A motor that has driven its joint against a limit: the block that holds the limit leaves it nothing to move.</summary>
public class StalledMotorTests
{
    [Theory]
    [InlineData(50f, 10f)]
    [InlineData(float.MaxValue, float.MaxValue)]
    public void Slide_DrivenBackFromItsLimit_Leaves(float force, float forceBack)
    {
        PhysicsSimulator simulator = new(Vector2.Zero);
        Body slider = Box(simulator);
        FixedPrismaticJoint slide = new(slider, Vector2.Zero, new Vector2(1, 0))
        {
            AreLimitsEnabled = true, LowerLimit = -1, UpperLimit = 1.5f, IsMotorEnabled = true, MotorSpeed = 2, MaxMotorForce = force,
        };
        simulator.Add(slide);
        Run(simulator, 300);
        Assert.Equal(1.5f, slide.Travel, 1e-3f);
        Assert.Equal(0, slider.LinearVelocity.X, 1e-3f);
        slide.MotorSpeed = -1;
        slide.MaxMotorForce = forceBack;
        Run(simulator, 30);

        // 10 N take a tenth of a second to bring 1 kg to 1 m/s: 0.45 m by now; without a bound it is half a second.
        Assert.Equal(-1, slider.LinearVelocity.X, 1e-2f);
        Assert.Equal(1.5f - (forceBack < 100 ? 0.45f : 0.5f), slide.Travel, 2e-2f);
    }

    [Fact]
    public void Hinge_DrivenBackFromItsLimit_Leaves()
    {
        PhysicsSimulator simulator = new(Vector2.Zero);
        Body post = Box(simulator);
        post.IsStatic = true;
        Body arm = Box(simulator);
        arm.Position = new Vector2(2, 0);
        RevoluteJoint hinge = new(post, arm, Vector2.Zero)
        {
            AreLimitsEnabled = true, LowerLimit = -1, UpperLimit = 1, IsMotorEnabled = true, MotorSpeed = 3, MaxMotorTorque = 1000,
        };
        simulator.Add(hinge);
        Run(simulator, 120);
        Assert.Equal(1, arm.Rotation, 1e-3f);
        hinge.MotorSpeed = -3;
        Run(simulator, 120);
        Assert.InRange(arm.Rotation, 5f, 5.3f);
    }

    private static Body Box(PhysicsSimulator simulator)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
        body.LinearDragCoefficient = 0;
        body.RotationalDragCoefficient = 0;
        return body;
    }

    private static void Run(PhysicsSimulator simulator, int updates)
    {
        for (int i = 0; i < updates; i++)
        {
            simulator.Update(1 / 60f);
        }
    }
}
