using System;
using System.Collections.Generic;
using Farseer.Accuracy;
using Farseer.Tests.Behavior;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using Xunit;

namespace Farseer.Tests.Accuracy;

/// <summary>What an update says of itself is what an observer with the true outlines and double precision finds.</summary>
public class StepReportTests
{
    /// <summary>Share by which the reported figure may differ from the measured one.</summary>
    private const double Agreement = 0.1;

    /// <summary>Below this (m, on bodies of 0.1 to 1 m) the float coordinates of the corners decide: 1 m × 6e-8, over two bodies.</summary>
    private const double Rounding = 5e-7;

    [Theory]
    [InlineData("stack")]
    [InlineData("mass ratio")]
    [InlineData("pyramid")]
    [InlineData("arch")]
    [InlineData("falling boxes")]
    public void Report_OfPenetration_IsWhatAnObserverMeasures(string scene)
    {
        using Rig rig = Build(scene);
        rig.Simulator.EnableReport = true;
        double largest = 0;
        int compared = 0;
        for (int i = 0; i < 120; i++)
        {
            rig.Step();
            double measured = Metrics.Penetration(rig.Actors);
            double reported = rig.Simulator.Report.LargestPenetration;
            Assert.InRange(reported, ((1 - Agreement) * measured) - Rounding, ((1 + Agreement) * measured) + Rounding);
            largest = Math.Max(largest, measured);
            compared += measured > 10 * Rounding ? 1 : 0;
        }

        Assert.True(compared > 20, $"{compared} steps had a depth to compare; the largest was {largest} m.");
    }

    [Theory]
    [InlineData("swinging rope")]
    [InlineData("bridge")]
    [InlineData("loop")]
    public void Report_OfSeparation_IsWhatAnObserverMeasures(string scene)
    {
        using Rig rig = Build(scene);
        rig.Simulator.EnableReport = true;
        double largest = 0;
        for (int i = 0; i < 120; i++)
        {
            rig.Step();
            double measured = rig.LargestHingeError();
            double squares = 0;
            foreach (Hinge hinge in rig.Hinges)
            {
                squares += hinge.Error * hinge.Error;
            }

            // The anchors that the rig keeps and those of the joint differ by the last bits of a float or double.
            const double AnchorRounding = 1e-9;
            StepReport report = rig.Simulator.Report;
            Assert.InRange(
                report.LargestSeparation, ((1 - Agreement) * measured) - AnchorRounding, ((1 + Agreement) * measured) + AnchorRounding);
            Assert.Equal(Math.Sqrt(squares / rig.Hinges.Count), report.RmsSeparation, AnchorRounding + (Agreement * measured));
            Assert.Equal(rig.Hinges.Count, report.Joints);
            largest = Math.Max(largest, measured);
        }

        Assert.True(largest > 1e-8, $"The joints were off by {largest} m at most: nothing to compare.");
    }

    [Fact]
    public void Report_Enabled_ChangesNoBitOfTheMotion()
    {
        for (int seed = 1; seed <= 2; seed++)
        {
            var plain = new RandomPile(seed, 30, 1);
            var reported = new RandomPile(seed, 30, 1);
            reported.Simulator.EnableReport = true;
            for (int i = 0; i < 120; i++)
            {
                Sandbox.Run(plain.Simulator, 1);
                Sandbox.Run(reported.Simulator, 1);
                Assert.Equal(plain.Simulator.MotionHash(), reported.Simulator.MotionHash());
            }
        }
    }

    [Fact]
    public void Report_Off_IsEmpty()
    {
        using Rig rig = Build("stack");
        rig.Step();
        Assert.Equal(0, rig.Simulator.Report.Iterations);
        Assert.Null(rig.Simulator.Report.WorstBody);
        Assert.True(rig.Simulator.Report.IsWithinBudget);
    }

    [Fact]
    public void Report_OfAStack_NamesItsLowestPairAndItsIsland()
    {
        using Rig rig = Build("stack");
        rig.Simulator.EnableReport = true;
        rig.Run(2);
        StepReport report = rig.Simulator.Report;
        Assert.Equal(10, report.WorstIslandBodies);
        Assert.Equal(10, report.Contacts);
        Assert.Equal(5, report.Iterations);
        Assert.NotNull(report.WorstBody);
        Assert.Equal(report.LargestPenetration, report.ConstraintError);
        Assert.Equal(ErrorCause.Motion, report.Cause);

        // The top is off by what all ten contacts sink in, which is counted twice: what a contact is off by also turns a body.
        Assert.InRange(report.MotionError, 3 * report.LargestPenetration, 20 * report.LargestPenetration);
        Assert.InRange(report.RmsPenetration, 1e-9, report.LargestPenetration);
    }

    [Fact]
    public void Report_OfARestingBox_FindsItsWeightInTheSupport()
    {
        using Rig rig = New();
        rig.AddGround();
        Actor box = rig.AddBox(0, 0.5, 1, 1);
        rig.Simulator.EnableReport = true;
        rig.Run(2);
        StepReport report = rig.Simulator.Report;

        // m·g·dt; the box still sinks by a hundredth of a micrometre an update.
        Assert.Equal(box.Mass * 10 * rig.Dt, report.SupportImpulseY, 1e-6);
        Assert.Equal(0, report.GravityWork, 1e-6);
        Assert.Equal(0, report.KineticEnergyChange, 1e-6);
        Assert.Equal(0, report.EnergyError, 1e-6);
    }

    [Fact]
    public void Report_OfASwingingRod_FindsNoWorkOfItsHinge()
    {
        using Rig rig = New();
        Actor rod = rig.AddLooseBox(new Vec(1, 0), 0.1, 2, Math.PI / 2, 0.2);
        rig.AddHinge(rig.AddAnchor(0, 0), rod, new Vec(0, 0));
        rig.Simulator.EnableReport = true;
        double gravity = 0;
        double joint = 0;
        double error = 0;
        double change = 0;
        for (int i = 0; i < 120; i++)
        {
            rig.Step();
            StepReport report = rig.Simulator.Report;
            gravity += report.GravityWork;
            joint += Math.Abs(report.JointWork);
            error += Math.Abs(report.EnergyError);
            change += report.KineticEnergyChange;
            Assert.Equal(rod.KineticEnergy, report.KineticEnergy, 1e-6);
        }

        // Of the 2 J that gravity moves to and fro; the hinge turns with the rod within a substep, an error of third order in h.
        Assert.Equal(rod.KineticEnergy, change, 1e-6);
        Assert.InRange(joint, 0, 0.01);
        Assert.InRange(error, 0, 0.01);
        Assert.Equal(rod.KineticEnergy, gravity, 0.01);
    }

    [Fact]
    public void Report_OfAMotor_IsTorqueTimesAngle()
    {
        using Rig rig = New(gravity: 0);
        Actor disc = rig.AddLoose(new Vec(0, 0), 2, 0.25);
        RevoluteJoint joint = rig.AddHinge(rig.AddAnchor(0, 0), disc, new Vec(0, 0));
        joint.IsMotorEnabled = true;
        joint.MotorSpeed = 1000;
        joint.MaxMotorTorque = 3;
        rig.Simulator.EnableReport = true;
        double work = 0;
        for (int i = 0; i < 60; i++)
        {
            rig.Step();
            work += rig.Simulator.Report.MotorWork;
        }

        Assert.Equal(disc.KineticEnergy, work, 1e-6 * disc.KineticEnergy);

        // A joint's bodies move by the speed at the end of each substep: 1/300 of this way more.
        Assert.Equal(3 * disc.Angle, work, 0.004 * work);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Report_OfDrag_TakesWhatTheBodyLoses(bool touching)
    {
        using Rig rig = New(gravity: 0);
        rig.Friction = 0;
        Actor ball = rig.AddCircle(0, 0.5, 0.5);
        if (touching)
        {
            rig.AddGround();
        }

        ball.Velocity = new Vec(10, 0);
        ball.SetLinearDrag(0.8);
        double before = ball.KineticEnergy;
        rig.Simulator.EnableReport = true;
        double drag = 0;
        for (int i = 0; i < 60; i++)
        {
            rig.Step();
            drag += rig.Simulator.Report.DragWork;
        }

        // Each step rounds its velocity to a float.
        Assert.Equal(ball.KineticEnergy - before, drag, 1e-4);
        Assert.True(drag < -10);
    }

    [Fact]
    public void Report_OfAnImpact_AccountsForTheEnergyLost()
    {
        using Rig rig = New(gravity: 0);
        rig.Friction = 0;
        rig.Restitution = 0.5;
        Actor a = rig.AddCircle(-2, 0, 0.5);
        Actor b = rig.AddCircle(0, 0, 0.5);
        a.Velocity = new Vec(5, 0);
        rig.Simulator.EnableReport = true;
        double before = a.KineticEnergy;
        double lost = 0;
        double unbalanced = 0;
        for (int i = 0; i < 60; i++)
        {
            rig.Step();
            lost += rig.Simulator.Report.ContactWork + rig.Simulator.Report.BounceWork;
            unbalanced = Math.Max(unbalanced, rig.Simulator.Report.MomentumError);
        }

        // Equal masses keep (1 + e²)/2 of the energy.
        Assert.Equal(-0.375 * before, lost, 1e-5);
        Assert.Equal(before + lost, a.KineticEnergy + b.KineticEnergy, 1e-5);
        Assert.InRange(unbalanced, 0, 1e-5);
        Assert.Equal(5 * a.Mass, rig.Simulator.Report.MomentumX, 1e-5);
    }

    [Fact]
    public void Report_OfAnyScene_AddsUp()
    {
        foreach (string scene in new[] { "stack", "pyramid", "falling boxes", "loop", "ragdoll", "swinging rope" })
        {
            using Rig rig = Build(scene);
            rig.Simulator.EnableReport = true;
            double traffic = 0;
            double missing = 0;
            for (int i = 0; i < 180; i++)
            {
                rig.Step();
                StepReport r = rig.Simulator.Report;
                traffic += Math.Abs(r.GravityWork) + Math.Abs(r.ContactWork) + Math.Abs(r.JointWork) + Math.Abs(r.KineticEnergyChange);
                missing += Math.Abs(r.EnergyError);
            }

            double weight = 0;
            foreach (Actor actor in rig.Actors)
            {
                weight += actor.IsStatic ? 0 : 10 * actor.Mass;
            }

            // A hundredth of the energy that went through the scene, for positions move by a rule of second order; and what it takes
            // to lift everything by 0.2 mm, for contacts that are found overlapping are pushed apart without speed.
            Assert.True(missing <= (0.01 * traffic) + (2e-4 * weight), $"{scene}: {missing} J of {traffic} J unexplained.");
        }
    }

    internal static Rig New(double gravity = 10) =>
        new(new Dial(Options.DefaultIterations, Options.DefaultDt), gravity);

    internal static Rig Build(string scene)
    {
        Rig rig = New();
        switch (scene)
        {
            case "stack":
                rig.AddGround();
                Boxes(rig, 10, _ => 1);
                break;
            case "mass ratio":
                rig.AddGround();
                Boxes(rig, 2, i => i == 0 ? 1 : 100);
                break;
            case "pyramid":
                rig.AddGround();
                for (int row = 0; row < 6; row++)
                {
                    for (int i = 0; i < 6 - row; i++)
                    {
                        rig.AddBox((i - (0.5 * (5 - row))) * 1.1, 0.5 + row, 1, 1);
                    }
                }

                break;
            case "arch":
                Arch(rig);
                break;
            case "falling boxes":
                rig.AddGround();
                for (int i = 0; i < 12; i++)
                {
                    rig.AddBox(0.6 * (i % 3), 0.6 + (1.3 * i), 1, 0.6 + (0.05 * i), 0.1 * i);
                }

                break;
            case "bridge":
                Bridge(rig);
                break;
            case "swinging rope":
                Rope(rig);
                break;
            case "loop":
                Loop(rig);
                break;
            default:
                Ragdoll(rig);
                break;
        }

        return rig;
    }

    private static void Boxes(Rig rig, int n, Func<int, double> density)
    {
        for (int i = 0; i < n; i++)
        {
            rig.AddBox(0, 0.5 + i, 1, 1, density: density(i));
        }
    }

    private static void Arch(Rig rig)
    {
        rig.AddGround();
        const int Stones = 9;
        for (int i = 0; i < Stones; i++)
        {
            double from = Math.PI * i / Stones;
            double to = Math.PI * (i + 1) / Stones;
            Vec[] corners =
            [
                new(5 * Math.Cos(from), 5 * Math.Sin(from)), new(6 * Math.Cos(from), 6 * Math.Sin(from)),
                new(6 * Math.Cos(to), 6 * Math.Sin(to)), new(5 * Math.Cos(to), 5 * Math.Sin(to)),
            ];
            Vec centre = Outlines.Centroid(corners);
            Vec[] local = Array.ConvertAll(corners, c => c - centre);
            rig.AddPolygon(centre, 0, local, [local]);
        }
    }

    private static void Bridge(Rig rig)
    {
        Actor before = rig.AddAnchor(-5, 0);
        for (int i = 0; i < 10; i++)
        {
            Actor plank = rig.AddBox(-4.5 + i, 0, 1, 0.25, 0, 20);
            rig.SetGroup(plank, 1);
            rig.AddHinge(before, plank, new Vec(-5 + i, 0));
            before = plank;
        }

        rig.AddHinge(before, rig.AddAnchor(5, 0), new Vec(5, 0));
        rig.AddBox(0, 0.9, 1.5, 1.5, 0, 50);
    }

    private static void Rope(Rig rig)
    {
        Actor before = rig.AddAnchor(0, 0);
        for (int i = 0; i < 20; i++)
        {
            Actor link = rig.AddLooseBox(new Vec(0.25 + (0.5 * i), 0), 0.125, 0.5, Math.PI / 2, 1);
            rig.AddHinge(before, link, new Vec(0.5 * i, 0));
            before = link;
        }
    }

    /// <summary>A ring of rods, one of them hung up: its last joint closes a loop and is iterated.</summary>
    private static void Loop(Rig rig)
    {
        var rods = new List<Actor>();
        const int Count = 8;
        for (int i = 0; i < Count; i++)
        {
            double angle = 2 * Math.PI * i / Count;
            Vec middle = new(2 * Math.Cos(angle), 2 * Math.Sin(angle));
            rods.Add(rig.AddLooseBox(middle, 0.2, 2 * 2 * Math.Tan(Math.PI / Count), angle, 1));
        }

        rig.AddHinge(rig.AddAnchor(2, 0), rods[0], new Vec(2, 0));
        for (int i = 0; i < Count; i++)
        {
            double angle = 2 * Math.PI * (i + 0.5) / Count;
            double radius = 2 / Math.Cos(Math.PI / Count);
            rig.AddHinge(rods[i], rods[(i + 1) % Count], new Vec(radius * Math.Cos(angle), radius * Math.Sin(angle)));
        }
    }

    private static void Ragdoll(Rig rig)
    {
        rig.AddGround();
        Actor torso = rig.AddBox(0, 3, 0.4, 0.6, 0.3);
        Actor legLeft = rig.AddBox(-0.12, 2.45, 0.14, 0.4);
        Actor legRight = rig.AddBox(0.12, 2.45, 0.14, 0.4);
        foreach (Actor part in rig.Actors)
        {
            if (!part.IsStatic)
            {
                rig.SetGroup(part, 1);
            }
        }

        rig.AddHinge(torso, legLeft, new Vec(-0.12, 2.65));
        rig.AddHinge(torso, legRight, new Vec(0.12, 2.65));
    }
}
