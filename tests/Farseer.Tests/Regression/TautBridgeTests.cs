using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
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

    /// <summary>
    /// A car drives over a bridge between abutments that its ends touch. Bodies that touch a tree whose correction went astray are
    /// projected with it: one to which that would have given energy was left with the speed of the last correction, which is none, and the
    /// car stood.
    /// </summary>
    [Theory]
    [InlineData(1 / 240f, 1)]
    [InlineData(1 / 60f, 1)]
    [InlineData(1 / 30f, 0.2f)]
    [InlineData(0, 1)]
    [InlineData(0, 0.2f)]
    public void Car_DrivenOntoIt_Crosses(float dt, float mass)
    {
        const int Length = Planks / 2;
        var simulator = new PhysicsSimulator(new Vector2(0, -10));
        Body before = Sandbox.Box(simulator, new Vector2(-10, -1), 20, 2).Body;
        before.IsStatic = true;
        for (int i = 0; i < Length; i++)
        {
            Geom plank = Sandbox.Box(simulator, new Vector2(i + 0.5f, -0.1f), 1, 0.2f, mass);
            plank.CollisionGroup = 1;
            JointFactory.Instance.CreateRevoluteJoint(simulator, before, plank.Body, new Vector2(i, -0.1f));
            before = plank.Body;
        }

        Body after = Sandbox.Box(simulator, new Vector2(Length + 10, -1), 20, 2).Body;
        after.IsStatic = true;
        JointFactory.Instance.CreateRevoluteJoint(simulator, after, before, new Vector2(Length, -0.1f));
        Geom car = Sandbox.Box(simulator, new Vector2(-6, 0.9f), 3, 0.5f, 4);
        car.CollisionGroup = 2;
        foreach (float x in new[] { -7f, -5f })
        {
            Geom wheel = Sandbox.Ball(simulator, new Vector2(x, 0.4f), 0.4f, 0.5f, 32);
            wheel.CollisionGroup = 2;
            wheel.FrictionCoefficient = 1;
            simulator.Add(new WheelJoint(car.Body, wheel.Body, wheel.Body.Position, Vector2.UnitY)
            {
                Frequency = 4, DampingRatio = 0.7f, IsMotorEnabled = true, MotorSpeed = -10, MaxMotorTorque = 20,
            });
        }

        var random = new Random(5);
        for (float time = 0; time < 14 && car.Body.Position.X < Length + 4;)
        {
            float step = dt == 0 ? 1 / (30 + (210 * (float)random.NextDouble())) : dt;
            simulator.Update(step);
            time += step;
        }

        // Twenty lengths at the 4 m/s of its wheels and a second and a half to get going are 5.4 s; it still loses some speed at joints,
        // and needs up to 9.5.
        Assert.InRange(car.Body.Position.X, Length + 4, Length + 10);
        Assert.InRange(car.Body.Position.Y, 0.7f, 0.9f);
    }
}
