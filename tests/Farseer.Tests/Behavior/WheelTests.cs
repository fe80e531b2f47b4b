using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Behavior;

/// <summary>Bodies hinged at their centre that many others touch, and heavy bodies that strike many: see decision 017.</summary>
public class WheelTests
{
    private const float Half = 10f;
    private const int Boxes = 40;

    /// <summary>
    /// A beam on a hinge at its centre holds its boxes as well as one that cannot move: 40 contacts that see nothing but its spin.
    /// </summary>
    [Fact]
    public void Beam_HeldByItsMotor_CarriesBoxesLikeAFloor()
    {
        List<Body> onFloor = BoxesOnABeam(null, out _, out _);
        List<Body> onBeam = BoxesOnABeam(1e9f, out Body beam, out FixedRevoluteJoint hinge);
        Assert.InRange(hinge.JointError, 0f, 1e-6f);
        Assert.InRange(beam.Rotation, -1e-5f, 1e-5f);
        for (int i = 0; i < onBeam.Count; i++)
        {
            // A beam that a motor holds turns by some 1e-6 before it stands, at an arm of 400.
            Assert.InRange(onBeam[i].Position.Y - onFloor[i].Position.Y, -2e-3f, 2e-3f);
            Assert.InRange(onBeam[i].LinearVelocity.Length(), 0f, 1e-2f);
        }
    }

    /// <summary>The hinge reports what rests on the beam as well as the beam: 40 of 440 parts.</summary>
    [Fact]
    public void Hinge_UnderABeamWithBoxes_ReportsTheWholeWeight()
    {
        BoxesOnABeam(1e9f, out _, out FixedRevoluteJoint hinge);
        Assert.InRange(hinge.ReactionForce.Length(), 0.999f * 44000f, 1.001f * 44000f);
    }

    /// <summary>Blows on a beam that is free to turn, bouncing or not, keep the angular momentum about its hinge.</summary>
    [Theory]
    [InlineData(0f)]
    [InlineData(0.5f)]
    public void Beam_StruckOnOneSide_KeepsTheAngularMomentumAboutItsHinge(float restitution)
    {
        PhysicsSimulator simulator = Falling(0);
        Body beam = Beam(simulator, 50);
        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, beam, Vector2.Zero);
        List<Body> bodies = AddBoxes(simulator, restitution);
        foreach (Body body in bodies)
        {
            body.LinearVelocity = new Vector2(0, body.Position.X > 0 ? 60 : 0);
        }

        bodies.Add(beam);
        double before = AngularMomentum(bodies);
        Run(simulator, 60);
        Assert.True(Math.Abs(beam.AngularVelocity) > 0.03f, "the beam was struck");

        // Floats, in some hundred impulses a box.
        Assert.InRange(AngularMomentum(bodies), before * (1 - 2e-4), before * (1 + 2e-4));
    }

    /// <summary>A heavy block makes none of the light balls wait that it strikes at once; with restitution 1 nothing is lost.</summary>
    [Fact]
    public void HeavyBlock_StrikesManyBallsAtOnce_KeepsMomentumAndEnergy()
    {
        PhysicsSimulator simulator = Falling(0);
        var bodies = new List<Body>();
        Geom block = Box(simulator, new Vector2(-20, 0), 20, 400, 4000);
        block.RestitutionCoefficient = 1;
        block.FrictionCoefficient = 0;
        block.Body.LinearVelocity = new Vector2(100, 0);
        bodies.Add(block.Body);
        for (int i = 0; i < 30; i++)
        {
            // One a little further than the other, all within the way of a substep.
            Geom ball = Ball(simulator, new Vector2(-4.9f + (0.01f * i), -185 + (12.5f * i)));
            ball.RestitutionCoefficient = 1;
            ball.FrictionCoefficient = 0;
            bodies.Add(ball.Body);
        }

        double energy = bodies.Sum(Energies.Kinetic);
        Run(simulator, 20);
        double momentum = 0;
        for (int i = 0; i < bodies.Count; i++)
        {
            momentum += bodies[i].Mass * bodies[i].LinearVelocity.X;
            float expected = 200f * 4000f / 4001f;
            if (i > 0)
            {
                // The block loses a 2000th with each ball, in whatever order, and is turned by those on one side.
                Assert.InRange(bodies[i].LinearVelocity.X, 0.98f * expected, 1.005f * expected);
            }
        }

        Assert.InRange(momentum, 4000 * 100 * (1 - 1e-6), 4000 * 100 * (1 + 1e-6));
        Assert.InRange(bodies.Sum(Energies.Kinetic), energy * (1 - 1e-5), energy * (1 + 1e-5));
    }

    private static List<Body> BoxesOnABeam(float? torque, out Body beam, out FixedRevoluteJoint hinge)
    {
        PhysicsSimulator simulator = Falling();
        beam = Beam(simulator, 400);
        hinge = JointFactory.Instance.CreateFixedRevoluteJoint(simulator, beam, Vector2.Zero);
        if (torque is float most)
        {
            hinge.MotorSpeed = 0;
            hinge.MaxMotorTorque = most;
            hinge.IsMotorEnabled = true;
        }
        else
        {
            beam.IsStatic = true;
        }

        List<Body> boxes = AddBoxes(simulator, 0);
        Run(simulator, 300);
        return boxes;
    }

    private static Body Beam(PhysicsSimulator simulator, float mass) => Box(simulator, Vector2.Zero, 900, 20, mass).Body;

    /// <summary>A row of boxes on the beam, a hundredth of a unit apart from it.</summary>
    private static List<Body> AddBoxes(PhysicsSimulator simulator, float restitution)
    {
        var bodies = new List<Body>();
        for (int i = 0; i < Boxes; i++)
        {
            Geom box = Box(simulator, new Vector2((i - (0.5f * (Boxes - 1))) * 2.1f * Half, -(2 * Half) - 0.01f));
            box.RestitutionCoefficient = restitution;
            bodies.Add(box.Body);
        }

        return bodies;
    }

    private static double AngularMomentum(List<Body> bodies)
    {
        double sum = 0;
        foreach (Body body in bodies)
        {
            double lever = ((double)body.Position.X * body.LinearVelocity.Y) - ((double)body.Position.Y * body.LinearVelocity.X);
            sum += (body.Mass * lever) + (body.MomentOfInertia * (double)body.AngularVelocity);
        }

        return sum;
    }
}
