using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Joints in motion against closed forms, and what happens to them from within handlers.</summary>
public class JointMotionTests
{
    [Fact]
    public void Pendulum_OfSmallSwing_HasThePeriodOfTheFormula()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Body rod = BodyFactory.Instance.CreateRectangleBody(simulator, 2, 80, 1);
        Sandbox.WithoutDrag(rod);
        const float Start = 0.05f;
        rod.Position = new Vector2(-40 * MathF.Sin(Start), 40 * MathF.Cos(Start));
        rod.Rotation = Start;
        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, rod, Vector2.Zero);
        var crossings = new List<double>();
        float before = Start;
        for (int i = 0; crossings.Count < 6; i++)
        {
            simulator.Update(Sandbox.Step);
            float now = rod.TotalRotation > MathF.PI ? rod.TotalRotation - (2 * MathF.PI) : rod.TotalRotation;
            if (before > 0 && now <= 0)
            {
                crossings.Add((i + (before / (before - now))) * Sandbox.Step);
            }

            before = now;
        }

        // T = 2π·√(I/(m·g·d))·(1 + θ²/16), I about the pivot.
        double inertia = rod.MomentOfInertia + 1600;
        double exact = 2 * Math.PI * Math.Sqrt(inertia / 4000) * (1 + (Start * Start / 16));
        Assert.Equal(exact, (crossings[5] - crossings[0]) / 5, exact * 1e-4);
    }

    [Fact]
    public void RopeOf50_WithAHeavyWeight_HangsStill()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Body before = new Body { IsStatic = true };
        for (int i = 0; i < 50; i++)
        {
            Body link = BodyFactory.Instance.CreateRectangleBody(simulator, 4, 10, 1);
            link.Position = new Vector2(0, (10 * i) + 5);
            JointFactory.Instance.CreateRevoluteJoint(simulator, before, link, new Vector2(0, 10 * i));
            before = link;
        }

        Body weight = BodyFactory.Instance.CreateCircleBody(simulator, 10, 1000);
        weight.Position = new Vector2(0, 510);
        JointFactory.Instance.CreateRevoluteJoint(simulator, before, weight, new Vector2(0, 500));
        Sandbox.Run(simulator, 300);

        // A thousandth of a pixel on 500: what rounding leaves.
        Assert.Equal(510, weight.Position.Y, 1e-3f);
    }

    /// <summary>A load beside its slide pulls across and turns; both are held, and what rounding leaves of them is no way.</summary>
    [Theory]
    [InlineData(10)]
    [InlineData(30)]
    [InlineData(100)]
    [InlineData(1000)]
    public void Slide_UnderALoadBesideIt_StaysOnItsLineToTheLastBit(float far)
    {
        PhysicsSimulator simulator = Sandbox.Falling(10);
        double mass = 1 + far;
        double centre = 3 * far / mass;
        double inertia = (mass / 6) + (centre * centre) + (far * (3 - centre) * (3 - centre));
        Body load = BodyFactory.Instance.CreateBody(simulator, (float)mass, (float)inertia);
        Sandbox.WithoutDrag(load);
        load.SetPosition(centre, 0);
        simulator.Add(new FixedPrismaticJoint(load, Vector2.Zero, Vector2.UnitX));
        for (int i = 0; i < 300; i++)
        {
            simulator.Update(Sandbox.Step);
            load.GetPosition(out double x, out double y);
            Assert.Equal(centre, x);
            Assert.Equal(0, y);
        }
    }

    [Theory]
    [InlineData(0.5f)]
    [InlineData(1)]
    [InlineData(2)]
    public void Gear_WhileItTurns_KeepsItsRatioToTheLastBit(float ratio)
    {
        using var simulator = new PhysicsSimulator(Vector2.Zero);
        var discs = new Body[2];
        for (int i = 0; i < 2; i++)
        {
            discs[i] = BodyFactory.Instance.CreateCircleBody(simulator, 2 - i, 3 - (2 * i));
            Sandbox.WithoutDrag(discs[i]);
            discs[i].Position = new Vector2(4 * i, 0);
            JointFactory.Instance.CreateFixedRevoluteJoint(simulator, discs[i], discs[i].Position);
        }

        JointFactory.Instance.CreateGearJoint(simulator, discs[0], discs[1], ratio);
        discs[0].AngularVelocity = 10;
        for (int i = 0; i < 600; i++)
        {
            simulator.Update(Sandbox.Step);
            discs[0].GetTotalRotation(out double first);
            discs[1].GetTotalRotation(out double second);
            Assert.Equal(0, second + (ratio * first));
        }

        Assert.True(discs[0].TotalRotation > 1);
    }

    [Fact]
    public void Motor_LiftsWithEnoughTorqueOnly()
    {
        Assert.True(Lifted(1.01f) > 0);
        Assert.True(Lifted(0.99f) < 0);
    }

    [Fact]
    public void BreakForce_IsReachedByAHeavyWeight_NotByALightOne()
    {
        Assert.True(Holds(1));
        Assert.False(Holds(3));
    }

    [Fact]
    public void ReactionForce_OfAHangingBody_IsItsWeight()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 10, 10, 2);
        FixedRevoluteJoint joint = JointFactory.Instance.CreateFixedRevoluteJoint(simulator, body, body.Position);
        Sandbox.Run(simulator, 20);
        Assert.Equal(-200, joint.ReactionForce.Y, 0.5f);
    }

    [Fact]
    public void CollideConnected_False_LetsTheBodiesOverlap()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Body a = Sandbox.Box(simulator, Vector2.Zero).Body;
        Body b = Sandbox.Box(simulator, new Vector2(0, 10)).Body;
        RevoluteJoint joint = JointFactory.Instance.CreateRevoluteJoint(simulator, a, b, new Vector2(0, 5));
        joint.CollideConnected = false;
        Sandbox.Run(simulator, 20);
        Assert.Equal(0, simulator.ContactCount);
        joint.CollideConnected = true;
        Sandbox.Run(simulator, 2);
        Assert.True(simulator.ContactCount > 0);
    }

    [Fact]
    public void JointsOfEveryKind_AllocateNothingOnceWarm()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Fill(simulator);
        Sandbox.Run(simulator, 60);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Sandbox.Run(simulator, 60);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    [Fact]
    public void BrokeHandler_MayRemoveDisposeAndBreakOthers()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        List<Joint> joints = Fill(simulator);
        Sandbox.Run(simulator, 5);
        int broke = 0;
        foreach (Joint joint in joints)
        {
            joint.Broke += (sender, _) =>
            {
                broke++;
                simulator.Remove((Joint)sender!);
                Joint next = joints[(joints.IndexOf((Joint)sender!) + 1) % joints.Count];
                next.Enabled = false;
                next.Dispose();
            };
        }

        joints[0].Breakpoint = 0;
        joints[1].Breakpoint = 0;
        Sandbox.Run(simulator, 30);
        Assert.True(broke > 0);
        Assert.True(simulator.JointList.Count < joints.Count);
        foreach (Body body in simulator.BodyList)
        {
            Assert.True(float.IsFinite(body.Position.X) && float.IsFinite(body.Position.Y));
        }
    }

    [Fact]
    public void Joints_ScaledByAPowerOfTwo_GiveScaledBits()
    {
        float[] one = Track(1);
        float[] four = Track(4);
        for (int i = 0; i < one.Length; i++)
        {
            Assert.Equal(one[i] * 4, four[i]);
        }
    }

    private static float[] Track(float scale)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 100 * scale)) { AllowedPenetration = 0.05f * scale };
        var bodies = new List<Body>();
        Body before = new Body { IsStatic = true };
        for (int i = 0; i < 6; i++)
        {
            Body link = BodyFactory.Instance.CreateBody(simulator, 1, 20 * scale * scale);
            Sandbox.WithoutDrag(link);
            link.Position = new Vector2(((10 * i) + 5) * scale, 0);
            JointFactory.Instance.CreateRevoluteJoint(simulator, before, link, new Vector2(10 * i * scale, 0));
            bodies.Add(link);
            before = link;
        }

        Sandbox.Run(simulator, 50);
        return bodies.ConvertAll(b => b.Position.X).ToArray();
    }

    private static bool Holds(float mass)
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 10, 10, mass);
        FixedRevoluteJoint joint = JointFactory.Instance.CreateFixedRevoluteJoint(simulator, body, body.Position);
        joint.BreakForce = 200;
        Sandbox.Run(simulator, 20);
        return joint.Enabled;
    }

    private static float Lifted(float share)
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Body arm = BodyFactory.Instance.CreateRectangleBody(simulator, 40, 2, 1);
        Sandbox.WithoutDrag(arm);
        arm.Position = new Vector2(20, 0);
        FixedRevoluteJoint joint = JointFactory.Instance.CreateFixedRevoluteJoint(simulator, arm, Vector2.Zero);
        joint.IsMotorEnabled = true;
        joint.MotorSpeed = -1;
        joint.MaxMotorTorque = share * 2000;
        Sandbox.Run(simulator, 10);
        return -arm.Position.Y;
    }

    private static List<Joint> Fill(PhysicsSimulator simulator)
    {
        JointFactory factory = JointFactory.Instance;
        var joints = new List<Joint>();
        float x = 0;
        Body New()
        {
            Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 10, 10, 1);
            body.Position = new Vector2(x += 12, 0);
            return body;
        }

        joints.Add(factory.CreateFixedRevoluteJoint(New(), new Vector2(0, 0)));
        joints.Add(factory.CreateRevoluteJoint(New(), New(), new Vector2(x, 5)));
        joints.Add(factory.CreateAngleJoint(New(), New()));
        joints.Add(factory.CreateFixedAngleJoint(New()));
        joints.Add(factory.CreateAngleLimitJoint(New(), New(), -1, 1));
        joints.Add(factory.CreateFixedAngleLimitJoint(New(), -1, 1));
        joints.Add(factory.CreatePinJoint(New(), Vector2.Zero, New(), Vector2.One));
        joints.Add(factory.CreateSliderJoint(New(), Vector2.Zero, New(), Vector2.One, 0, 20));
        joints.Add(factory.CreateGearJoint(New(), New(), 2));
        joints.Add(new PrismaticJoint(
            New(), New(), new Vector2(x, 0), Vector2.UnitX) { IsMotorEnabled = true, MaxMotorForce = 5, MotorSpeed = 1 });
        joints.Add(new FixedPrismaticJoint(New(), new Vector2(x, 0), Vector2.UnitX) { AreLimitsEnabled = true, UpperLimit = 3 });
        joints.Add(new PulleyJoint(New(), new Vector2(x, -9), Vector2.Zero, New(), new Vector2(x, -9), Vector2.Zero));
        joints.Add(new DistanceJoint(New(), Vector2.Zero, New(), Vector2.One) { Frequency = 3, DampingRatio = 0.3f });
        joints.Add(new WeldJoint(New(), New(), new Vector2(x, 0)) { Frequency = 2 });
        joints.Add(new WheelJoint(New(), New(), new Vector2(x, 0), Vector2.UnitY));
        joints.Add(new TargetJoint(New(), new Vector2(x, 0)) { MaxForce = 500 });
        joints.Add(new RopeJoint(New(), Vector2.Zero, New(), Vector2.One, 15));
        joints.Add(new MotorJoint(New(), New()) { MaxForce = 50, MaxTorque = 50 });
        foreach (Joint joint in joints)
        {
            simulator.Add(joint);
        }

        return joints;
    }
}
