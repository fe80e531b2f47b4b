using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Regression;

/// <summary>
/// A bridge exactly as long as its gap: an error along it can be closed only by a far larger bend. Taken as a speed, or left over by a
/// push against overlap, that bend threw off the crates in three of ten lengths of the step.
/// </summary>
public class TautBridgeTests
{
    private const int Planks = 20;

    [Theory]
    [InlineData(0.0165f)]
    [InlineData(0.01666f)]
    [InlineData(1 / 60f)]
    [InlineData(0.0168f)]
    [InlineData(0.017f)]
    [InlineData(0.02f)]
    public void Crates_FallenOntoIt_LieStill(float dt)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 100));
        var planks = new Body[Planks];
        for (int i = 0; i < Planks; i++)
        {
            planks[i] = BodyFactory.Instance.CreateRectangleBody(simulator, 20, 6, 1);
            planks[i].Position = new Vector2(i * 20, 0);
            var geom = GeomFactory.Instance.CreateRectangleGeom(simulator, planks[i], 20, 6);
            geom.CollisionGroup = 1;
            geom.FrictionCoefficient = 0.5f;
            if (i > 0)
            {
                JointFactory.Instance.CreateRevoluteJoint(simulator, planks[i - 1], planks[i], new Vector2((i * 20) - 10, 0));
            }
        }

        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, planks[0], new Vector2(-10, 0));
        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, planks[Planks - 1], new Vector2((20 * Planks) - 10, 0));
        var crates = new Body[3];
        for (int i = 0; i < crates.Length; i++)
        {
            crates[i] = BodyFactory.Instance.CreateRectangleBody(simulator, 16, 16, 5);
            crates[i].Position = new Vector2(150 + (40 * i), -30);
            GeomFactory.Instance.CreateRectangleGeom(simulator, crates[i], 16, 16).FrictionCoefficient = 0.8f;
        }

        for (float time = 0; time < 10; time += dt)
        {
            simulator.Update(dt);
        }

        foreach (Body crate in crates)
        {
            // 8 of the crate, 3 of the plank, and the allowed penetration.
            Assert.Equal(-11, crate.Position.Y, 0.3f);
            Assert.InRange(crate.LinearVelocity.Length(), 0, 3);
        }
    }

    /// <summary>A thousand planks' mass and more, dropped from four and a half planks' length: it was thrown up by kilometres.</summary>
    [Theory]
    [InlineData(1000, 1)]
    [InlineData(1000, 4.5f)]
    [InlineData(3000, 4.5f)]
    [InlineData(5000, 1)]
    [InlineData(5000, 4.5f)]
    public void HeavyBox_Dropped_LiesStill(float mass, float height)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -10)) { Iterations = 20, AllowedPenetration = 0 };
        Body? before = null;
        for (int i = 0; i < Planks; i++)
        {
            Body plank = Sandbox.Box(simulator, new Vector2(i + 0.5f, 0), 1, 0.2f).Body;
            if (before is null)
            {
                JointFactory.Instance.CreateFixedRevoluteJoint(simulator, plank, Vector2.Zero);
            }
            else
            {
                JointFactory.Instance.CreateRevoluteJoint(simulator, before, plank, new Vector2(i, 0));
            }

            before = plank;
        }

        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, before!, new Vector2(Planks, 0));
        var geom = Sandbox.Box(simulator, new Vector2(Planks / 2f, height + 0.6f), 1, 1, mass);
        foreach (var each in simulator.GeomList)
        {
            each.FrictionCoefficient = 0.6f;
        }

        Sandbox.Run(simulator, 600, 1 / 60f);

        // Half a box and half a plank above the line of the nails, and no more than a tremble.
        Assert.Equal(0.6f, geom.Body.Position.Y, 0.02f);
        Assert.InRange(geom.Body.LinearVelocity.Length(), 0, 0.2f);
    }
}
