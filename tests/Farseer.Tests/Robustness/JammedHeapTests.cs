using System;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Robustness;

/// <summary>
/// A dense heap between the wall of a bin and a rod that nothing stops: the performance scene spinner, a third as large. What is jammed
/// spins at a hundred radians a second and more, and within a step speeds and impulses may have nothing to do with each other any more.
/// </summary>
public class JammedHeapTests
{
    private const float Spin = 15;
    private const float HalfLength = 6.9f;
    private const float Dt = 1 / 60f;
    private const float RodHeight = 4;
    private const float BinHeight = 32 / 3f;
    private const float BinRadius = 40 / 3f;
    private const int Bodies = 675;
    private const int Columns = 31;

    [Theory]
    [InlineData(float.MaxValue)]
    [InlineData(1e9f)]
    public void Heap_BetweenAWallAndARodThatAMotorTurns_IsNotThrownOff(float torque)
    {
        using PhysicsSimulator simulator = CreateBin(out Body bin, out Body rod);
        RevoluteJoint motor = JointFactory.Instance.CreateRevoluteJoint(simulator, bin, rod, new Vector2(0, RodHeight));
        motor.CollideConnected = false;
        motor.MotorSpeed = Spin;
        motor.MaxMotorTorque = torque;
        motor.IsMotorEnabled = true;

        AssertNobodyIsThrownOff(simulator);

        Assert.InRange(rod.AngularVelocity, 0.99f * Spin, 1.01f * Spin);
    }

    [Fact]
    public void Heap_BetweenAWallAndARodThatTurnsByItself_IsNotThrownOff()
    {
        using PhysicsSimulator simulator = CreateBin(out _, out Body rod);
        rod.IsKinematic = true;
        rod.AngularVelocity = Spin;

        AssertNobodyIsThrownOff(simulator);
    }

    /// <summary>The tips move at 103 m/s, what they strike leaves at up to twice that, and may strike another that is lighter.</summary>
    private static void AssertNobodyIsThrownOff(PhysicsSimulator simulator)
    {
        for (int step = 0; step < 120; step++)
        {
            simulator.Update(Dt);
            Assert.InRange(simulator.BodyList.Max(body => body.LinearVelocity.Length()), 0, 3 * Spin * HalfLength);
        }
    }

    private static PhysicsSimulator CreateBin(out Body bin, out Body rod)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, -10));
        bin = AddBody(simulator, 0, 0, 1, 1);
        bin.IsStatic = true;
        var wall = new Vertices(Enumerable.Range(0, 120).Select(PointOfBin).ToArray());
        Finish(GeomFactory.Instance.CreateChainGeom(simulator, bin, wall, true), 0.1f, 0);
        rod = AddBody(simulator, 0, RodHeight, 5.5f, 5.5f * (4 * HalfLength * HalfLength) / 12);
        var tip = new Vector2(0, HalfLength - 0.2f);
        Finish(GeomFactory.Instance.CreateCapsuleGeom(simulator, rod, -tip, tip, 0.2f), 0, 0);
        for (int i = 0; i < Bodies; i++)
        {
            AddBrick(simulator, i % 3, -7.5f + (0.5f * (i % Columns)), (2 / 3f) + (0.5f * (i / Columns)));
        }

        return simulator;
    }

    private static Vector2 PointOfBin(int index)
    {
        float angle = -2 * MathF.PI * index / 120;
        return new Vector2(BinRadius * MathF.Cos(angle), BinHeight + (BinRadius * MathF.Sin(angle)));
    }

    /// <summary>Capsules, discs and boxes, half a metre apart and 0.7 m large.</summary>
    private static void AddBrick(PhysicsSimulator simulator, int shape, float x, float y)
    {
        float mass = shape == 0 ? 0.11f : shape == 1 ? 0.096f : 0.1225f;
        Body body = AddBody(simulator, x, y, mass, mass * 0.07f);
        Geom geom = shape switch
        {
            0 => GeomFactory.Instance.CreateCapsuleGeom(simulator, body, new Vector2(-0.25f, 0), new Vector2(0.25f, 0), 0.25f),
            1 => GeomFactory.Instance.CreateCircleGeom(simulator, body, 0.35f, 16),
            _ => GeomFactory.Instance.CreateRectangleGeom(simulator, body, 0.7f, 0.7f),
        };
        Finish(geom, 0.1f, 0.1f);
    }

    private static Body AddBody(PhysicsSimulator simulator, float x, float y, float mass, float inertia)
    {
        Body body = BodyFactory.Instance.CreateBody(simulator, mass, inertia);
        body.LinearDragCoefficient = 0;
        body.RotationalDragCoefficient = 0;
        body.Position = new Vector2(x, y);
        return body;
    }

    private static void Finish(Geom geom, float friction, float restitution)
    {
        geom.FrictionCoefficient = friction;
        geom.RestitutionCoefficient = restitution;
    }
}
