using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Behavior;

/// <summary>Nets: joints that close so many loops that they are iterated, side by side where their kind allows.</summary>
public class NetTests
{
    private const int Size = 6;
    private const float Gap = 20;
    private const float Gravity = 100;

    public static TheoryData<string> Ties => new() { "revolute", "weld", "pin", "distance", "driven", "breakable" };

    [Theory]
    [MemberData(nameof(Ties))]
    public void Net_ThatHangsStill_PullsAtItsNailsWithItsWeight(string tie)
    {
        PhysicsSimulator simulator = Falling(Gravity);
        var net = new Net(simulator, tie, drag: 2);
        Run(simulator, 1500);
        foreach (Body body in net.Bodies)
        {
            // Drag takes a share of what gravity gives in a substep before the joints do.
            WithoutDrag(body);
        }

        Run(simulator, 200);
        Vector2 force = Vector2.Zero;
        float moment = 0;
        foreach (Joint nail in net.Nails)
        {
            force += nail.ReactionForce;
            moment = Math.Max(moment, Math.Abs(nail.ReactionTorque));
        }

        // The reaction is that on the second body, which hangs.
        float weight = Gravity * net.Masses;
        Assert.InRange(-force.Y, weight * 0.999f, weight * 1.001f);
        Assert.InRange(Math.Abs(force.X), 0, weight * 1e-3f);
        Assert.True(tie is "weld" or "driven" || moment < weight * Gap * 1e-6f, "A pivot turned its body by " + moment);
        Assert.InRange(net.LargestError(), 0, Gap * 1e-3f);
    }

    [Theory]
    [MemberData(nameof(Ties))]
    public void Net_WhoseJointsComeAndGo_HoldsByThoseThatItHas(string tie)
    {
        PhysicsSimulator simulator = Falling(Gravity);
        var net = new Net(simulator, tie, drag: 2);
        var random = new Random(5);
        Joint? off = null;
        for (int i = 0; i < 600; i++)
        {
            if (off is { IsDisposed: false })
            {
                off.Enabled = true;
            }

            Joint joint = net.Joints[random.Next(net.Joints.Count)];
            switch (random.Next(6))
            {
                case 0:
                    off = joint;
                    joint.Enabled = false;
                    break;
                case 1 when joint is RevoluteJoint pivot:
                    pivot.IsMotorEnabled = !pivot.IsMotorEnabled;
                    break;
                case 2:
                    joint.Breakpoint = random.Next(2) == 0 ? float.MaxValue : 1e6f;
                    break;
                case 3 when i % 20 == 0:
                    simulator.Remove(joint);
                    net.Joints.Remove(joint);
                    break;
                case 4 when i % 20 == 0:
                    joint.Dispose();
                    net.Joints.Remove(joint);
                    break;
                case 5:
                    net.Bodies[random.Next(net.Bodies.Count)].ApplyImpulse(new Vector2(random.Next(-20, 20), random.Next(-20, 20)));
                    break;
            }

            simulator.Update(Step);
        }

        if (off is { IsDisposed: false })
        {
            off.Enabled = true;
        }

        // Pieces that came off fall with the speed that drag leaves them, g over its rate.
        Run(simulator, 1500);
        foreach (Body body in net.Bodies)
        {
            Assert.InRange(body.LinearVelocity.Length(), 0, 51);
        }

        Assert.InRange(net.LargestError(), 0, Gap * 2e-3f);
    }

    [Theory]
    [MemberData(nameof(Ties))]
    public void WarmNet_AllocatesNothing(string tie)
    {
        long bytes = 0;
        for (int run = 0; run < 2; run++)
        {
            PhysicsSimulator simulator = Falling(Gravity);
            _ = new Net(simulator, tie, drag: 0);
            Run(simulator, 300);
            long before = GC.GetAllocatedBytesForCurrentThread();
            Run(simulator, 300);
            bytes = GC.GetAllocatedBytesForCurrentThread() - before;
        }

        Assert.Equal(0, bytes);
    }

    [Theory]
    [MemberData(nameof(Ties))]
    public void Net_ThatSleepsAndWakes_GoesOnWithItsImpulses(string tie)
    {
        PhysicsSimulator simulator = Falling(Gravity);
        simulator.AllowSleep = true;
        var net = new Net(simulator, tie, drag: 5);
        for (int i = 0; i < 20000 && simulator.SleepingBodyCount == 0; i++)
        {
            simulator.Update(Step);
        }

        Assert.Equal(net.Bodies.Count, simulator.SleepingBodyCount);
        net.Bodies[0].ApplyImpulse(new Vector2(1e-3f, 0));
        Run(simulator, 10);

        // Without its impulses the net would fall for a substep: 100 · 0.002 = 0.2.
        Assert.Equal(0, simulator.SleepingBodyCount);
        foreach (Body body in net.Bodies)
        {
            Assert.InRange(body.LinearVelocity.Length(), 0, 0.02f);
        }
    }

    [Fact]
    public void Net_Swinging_GainsNoEnergy()
    {
        PhysicsSimulator simulator = Falling(Gravity);
        var net = new Net(simulator, "revolute", drag: 0, nails: 1);
        double start = net.Energy();
        double scale = net.Masses * Gravity * Size * Gap;
        for (int i = 0; i < 1500; i++)
        {
            simulator.Update(Step);
            Assert.InRange(net.Energy() - start, -scale * 2, scale * 2e-3);
        }
    }

    /// <summary>Discs in rows and columns, tied to their neighbours; the first row is nailed fast.</summary>
    private sealed class Net
    {
        private readonly PhysicsSimulator _simulator;

        public Net(PhysicsSimulator simulator, string tie, float drag, int nails = Size)
        {
            _simulator = simulator;
            var grid = new Body[Size, Size];
            for (int y = 0; y < Size; y++)
            {
                for (int x = 0; x < Size; x++)
                {
                    Body body = BodyFactory.Instance.CreateCircleBody(simulator, 8, 1 + ((x + y) % 3));
                    body.Position = new Vector2(x * Gap, y * Gap);
                    body.LinearDragCoefficient = drag * body.Mass;
                    body.RotationalDragCoefficient = drag * body.MomentOfInertia;
                    body.IsStatic = y == 0 && x < nails;
                    grid[x, y] = body;
                    if (!body.IsStatic)
                    {
                        Bodies.Add(body);
                        Masses += body.Mass;
                    }

                    if (y > 0)
                    {
                        Tie(tie, grid[x, y - 1], body);
                    }

                    if (x > 0)
                    {
                        Tie(tie, grid[x - 1, y], body);
                    }
                }
            }
        }

        public List<Body> Bodies { get; } = new List<Body>();

        public List<Joint> Joints { get; } = new List<Joint>();

        public List<Joint> Nails { get; } = new List<Joint>();

        public float Masses { get; private set; }

        public float LargestError()
        {
            float largest = 0;
            foreach (Joint joint in Joints)
            {
                largest = Math.Max(largest, Math.Abs(joint.JointError));
            }

            return largest;
        }

        public double Energy()
        {
            double sum = 0;
            foreach (Body body in Bodies)
            {
                sum += Energies.Kinetic(body) - (body.Mass * Gravity * body.Position.Y);
            }

            return sum;
        }

        private void Tie(string tie, Body first, Body second)
        {
            if (first.IsStatic && second.IsStatic)
            {
                return;
            }

            Vector2 middle = (first.Position + second.Position) / 2;
            Vector2 inward = (second.Position - first.Position) / 4;
            Joint joint = tie switch
            {
                "weld" => new WeldJoint(first, second, middle),
                "pin" => new PinJoint(first, inward, second, -inward),
                "distance" => new DistanceJoint(first, Vector2.Zero, second, Vector2.Zero),
                _ => new RevoluteJoint(first, second, middle),
            };
            if (tie == "driven" && joint is RevoluteJoint pivot)
            {
                pivot.IsMotorEnabled = true;
                pivot.MaxMotorTorque = 10;
            }

            joint.Breakpoint = tie == "breakable" ? 1e6f : float.MaxValue;
            _simulator.Add(joint);
            Joints.Add(joint);
            if (first.IsStatic)
            {
                Nails.Add(joint);
            }
        }
    }
}
