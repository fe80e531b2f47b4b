using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Behavior;

/// <summary>Without its flag each quirk gives what physics or the manual says, with it the figure of version 2.0.1.</summary>
public class QuirkTests
{
    private const float Circle = MathF.PI * 2;

    private static readonly Dictionary<Farseer201Quirks, Case> _cases = new()
    {
        // J = 8 on m = 4: Δv = J/m, and J/m² with the flag. One division more or less: some ulps.
        [Farseer201Quirks.ImpulseDividedByMassTwice] = new(ImpulseOnMass, 8f / 4f, 8f / 16f, 1e-5),

        // m (rx² + ry²) / 4, and / 12.
        [Farseer201Quirks.EllipseInertiaFromRectangle] = new(
            s => BodyFactory.Instance.CreateEllipseBody(s, 20, 10, 3).MomentOfInertia, 3 * 500 / 4.0, 3 * 500 / 12.0, 1e-3),

        // Two rectangles a = 60×20, b = 20×40 about their common centroid: Σ m_i ((w² + h²) / 12 + d_i²). The other figure is the
        // original's.
        [Farseer201Quirks.PolygonInertiaUnsigned] = new(LInertia, LInertiaOfRectangles(), 1105.7778, 0.01),
        [Farseer201Quirks.RotationSetAddsRevolutions] = new(RevolutionsAfterTwoTurns, 1, 2, 0),

        // v = v₀ − μ g t with μ = 0.5 from the change on; with the flag no friction at all. One step's share of it is the tolerance.
        [Farseer201Quirks.PairFrictionFrozen] = new(SpeedAfterFrictionRises, 100 - (0.5 * 100 * 0.5), 100, 0.5),
        [Farseer201Quirks.SeparationWithoutContact] = new(SeparationsOfANearMiss, 0, 60, 0),
        [Farseer201Quirks.NoSeparationOnRemoval] = new(SeparationsOnRemoval, 2, 0, 0),

        // 75 steps of free fall, y = −30 + g t² / 2, or at rest on the floor, AllowedPenetration deep.
        [Farseer201Quirks.OneSidedCategoryFilter] = new(HeightWhenOneSideWants, -30 + (50 * 0.75 * 0.75), -9.95, 0.05),

        // F = 10 on m = 2 for 0.01 s: Δv = 0.05 a step.
        [Farseer201Quirks.ForcesAccumulateWhilePaused] = new(SpeedAfterAPause, 0.05, 21 * 0.05, 1e-5),

        // ω·dt = 0.2 and 300 steps: √(1 + 0.04/2) a step, or none; within a swing the energy so found varies by ω·dt/2 of itself.
        [Farseer201Quirks.ForcesActAtOnce] = new(SwingOfASpringOfOnesOwn, Math.Pow(1.02, 150), 1, 0.1),
        [Farseer201Quirks.OffsetTurnedByRotationOffset] = new(OffsetPlace, 10, 0, 1e-4),

        // Half a second of free fall, or none.
        [Farseer201Quirks.SensorMakesBodyStatic] = new(FallOfASensor, 50 * 0.5 * 0.5, 0, 1e-3),

        // The error grows by 0.1 an update, from 0 in the first: it is above 0.95 in the 11th, and the flag looks at the one before.
        [Farseer201Quirks.SpringBreaksLate] = new(UpdateInWhichASpringBreaks, 11, 12, 0),

        // F = 1000 on m = 1 for 0.01 s, along a pin that breaks: Δv = 10, or held once more.
        [Farseer201Quirks.JointBreaksLate] = new(SpeedInTheUpdateInWhichAPinBreaks, 10, 0, 1e-4),

        // y from −5 to 10 of a triangle of the height 30 on a base of 20: (10 + 20) / 2 · 15, two of its three corners.
        [Farseer201Quirks.BuoyancyOfVertices] = new(LiftOfATriangle, 225, 0, 0.1),

        // Links of 10 end to end, but for the gap that the strides leave, 0.2 at most; with the flag from far end to far end less one.
        [Farseer201Quirks.PathLinkedAtFarEnds] = new(LengthOfTheSecondPinOfAChain, 0.1, 10, 0.1),

        // Straight down is a quarter of a turn; more than a turn is 7.
        [Farseer201Quirks.UprightPathsLieAcross] = new(RotationInARopeStraightDown, Math.PI / 2, 0, 1e-6),
        [Farseer201Quirks.AngleSpringTargetLimited] = new(TargetOfAnAngleSpring, 7, 5.5, 0),

        // y down: from the box to the floor below it, or from the floor, which was made first, to the box.
        [Farseer201Quirks.NormalsFromOlderGeom] = new(NormalThatABoxOnAFloorHears, 1, -1, 1e-6),
    };

    public static TheoryData<Farseer201Quirks> Flags => new(Enum.GetValues<Farseer201Quirks>()
        .Where(f => f is not Farseer201Quirks.None and not Farseer201Quirks.All));

    [Theory]
    [MemberData(nameof(Flags))]
    public void Behaviour_WithoutTheFlag_IsRight_AndWithIt_IsTheOriginals(Farseer201Quirks flag)
    {
        Case quirk = _cases[flag];

        double right = quirk.Run(Falling());
        double original = quirk.Run(With(flag));

        Assert.Equal(quirk.Right, right, quirk.Tolerance);
        Assert.Equal(quirk.Original, original, quirk.Tolerance);
    }

    /// <summary>A flag changes its own subject alone.</summary>
    [Theory]
    [MemberData(nameof(Flags))]
    public void Behaviour_WithAllOtherFlags_IsRight(Farseer201Quirks flag)
    {
        Case quirk = _cases[flag];

        Assert.Equal(quirk.Right, quirk.Run(With(Farseer201Quirks.All & ~flag)), quirk.Tolerance);
    }

    [Fact]
    public void All_HoldsEveryFlag() =>
        Assert.Equal(Farseer201Quirks.All, _cases.Keys.Aggregate(Farseer201Quirks.None, (all, flag) => all | flag));

    private static PhysicsSimulator With(Farseer201Quirks flags)
    {
        PhysicsSimulator simulator = Falling();
        simulator.Quirks = flags;
        return simulator;
    }

    private static double NormalThatABoxOnAFloorHears(PhysicsSimulator simulator)
    {
        Floor(simulator);
        Geom box = Box(simulator, new Vector2(0, -9.9f));
        double heard = 0;
        box.OnCollision += (_, _, contacts) =>
        {
            heard = contacts[0].Normal.Y;
            return true;
        };
        simulator.Update(Step);
        return heard;
    }

    private static double RotationInARopeStraightDown(PhysicsSimulator simulator) => ComplexFactory.Instance
        .CreateChain(simulator, Vector2.Zero, new Vector2(0, 100), 10, 2f, 1f, 1, LinkType.RevoluteJoint).Bodies[3].Rotation;

    private static double TargetOfAnAngleSpring(PhysicsSimulator simulator)
    {
        Body first = BodyFactory.Instance.CreateRectangleBody(simulator, 10, 10, 1);
        Body second = BodyFactory.Instance.CreateRectangleBody(simulator, 10, 10, 1);
        AngleSpring spring = SpringFactory.Instance.CreateAngleSpring(simulator, first, second, 1, 1);
        spring.TargetAngle = 7;
        simulator.Update(Step);
        return spring.TargetAngle;
    }

    private static double ImpulseOnMass(PhysicsSimulator simulator)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 10, 10, 4);
        body.IgnoreGravity = true;
        WithoutDrag(body);
        simulator.Update(Step);
        body.ApplyImpulse(new Vector2(8, 0));
        simulator.Update(Step);
        return body.LinearVelocity.X;
    }

    private static double SwingOfASpringOfOnesOwn(PhysicsSimulator simulator)
    {
        const float Stiffness = 400;
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 10, 10, 1);
        body.IgnoreGravity = true;
        WithoutDrag(body);
        body.Position = new Vector2(1, 0);
        body.Rotation = 0.5f;
        for (int i = 0; i < 300; i++)
        {
            body.ApplyForce(-Stiffness * body.Position);
            simulator.Update(Step);
        }

        // Of the energy, so that it does not matter where in its swing the last step leaves the body.
        return Math.Sqrt(body.Position.LengthSquared() + (body.LinearVelocity.LengthSquared() / Stiffness));
    }

    private static double UpdateInWhichASpringBreaks(PhysicsSimulator simulator)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 10, 10, 1);
        body.IgnoreGravity = true;
        WithoutDrag(body);
        body.LinearVelocity = new Vector2(10, 0);
        FixedLinearSpring spring = SpringFactory.Instance.CreateFixedLinearSpring(simulator, body, Vector2.Zero, Vector2.Zero, 0, 0);
        spring.Breakpoint = 0.95f;
        int updates = 0;
        while (spring.Enabled)
        {
            simulator.Update(Step);
            updates++;
        }

        return updates;
    }

    private static double SpeedInTheUpdateInWhichAPinBreaks(PhysicsSimulator simulator)
    {
        Body hook = BodyFactory.Instance.CreateRectangleBody(simulator, 10, 10, 1);
        hook.IsStatic = true;
        Body bob = BodyFactory.Instance.CreateRectangleBody(simulator, 10, 10, 1);
        bob.Position = new Vector2(0, 50);
        bob.IgnoreGravity = true;
        WithoutDrag(bob);
        PinJoint pin = JointFactory.Instance.CreatePinJoint(simulator, hook, Vector2.Zero, bob, Vector2.Zero);
        simulator.Update(Step);
        pin.Breakpoint = 0.5f;
        bob.Position = new Vector2(0, 51);
        bob.ApplyForce(new Vector2(0, 1000));
        simulator.Update(Step);
        Assert.False(pin.Enabled);
        return bob.LinearVelocity.Y;
    }

    private static double LengthOfTheSecondPinOfAChain(PhysicsSimulator simulator) => ((PinJoint)ComplexFactory.Instance
        .CreateChain(simulator, Vector2.Zero, new Vector2(100, 0), 10, 2, 1, 1, LinkType.PinJoint).Joints[1]).TargetDistance;

    private static double LiftOfATriangle(PhysicsSimulator simulator)
    {
        Body body = BodyFactory.Instance.CreatePolygonBody(simulator, Outline(-10, 10, 10, 10, 0, -20), 1);
        body.IgnoreGravity = true;
        var water = new FluidDragController();
        water.Initialize(new AABBFluidContainer(new AABB(new Vector2(-100, -5), new Vector2(100, 100))), 1, 0, 0, new Vector2(0, 100));
        water.AddGeom(GeomFactory.Instance.CreatePolygonGeom(simulator, body, Outline(-10, 10, 10, 10, 0, -20), 0));
        simulator.Add(water);
        simulator.Update(1e-3f);
        return -body.LinearVelocity.Y * 10;
    }

    private static double LInertia(PhysicsSimulator simulator) =>
        BodyFactory.Instance.CreatePolygonBody(simulator, Outline(0, 0, 60, 0, 60, 20, 20, 20, 20, 60, 0, 60), 2).MomentOfInertia;

    private static double LInertiaOfRectangles()
    {
        (double X, double Y, double W, double H)[] parts = [(30, 10, 60, 20), (10, 40, 20, 40)];
        double area = parts.Sum(p => p.W * p.H);
        double x = parts.Sum(p => p.W * p.H * p.X) / area;
        double y = parts.Sum(p => p.W * p.H * p.Y) / area;
        return parts.Sum(p => 2 * p.W * p.H / area
            * ((((p.W * p.W) + (p.H * p.H)) / 12) + ((p.X - x) * (p.X - x)) + ((p.Y - y) * (p.Y - y))));
    }

    private static double RevolutionsAfterTwoTurns(PhysicsSimulator simulator)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 10, 10, 1);
        simulator.Update(Step);
        body.Rotation = Circle + 0.5f;
        body.Rotation = Circle + 0.5f;
        return body.Revolutions;
    }

    private static double SpeedAfterFrictionRises(PhysicsSimulator simulator)
    {
        Geom floor = Floor(simulator);
        Geom box = Box(simulator, new Vector2(-150, -9.95f));
        box.Body.LinearVelocity = new Vector2(100, 0);
        Run(simulator, 20);
        box.FrictionCoefficient = 0.5f;
        floor.FrictionCoefficient = 0.5f;
        Run(simulator, 50);
        return box.Body.LinearVelocity.X;
    }

    private static double SeparationsOfANearMiss(PhysicsSimulator simulator)
    {
        // Two balls at rest beside each other on the diagonal: their boxes overlap, they do not.
        Geom first = Ball(simulator, Vector2.Zero, 10);
        Geom second = Ball(simulator, new Vector2(16, 16), 10);
        first.Body.IgnoreGravity = true;
        second.Body.IgnoreGravity = true;
        int separations = 0;
        first.OnSeparation += (_, _) => separations++;
        Run(simulator, 60);
        return separations;
    }

    private static double SeparationsOnRemoval(PhysicsSimulator simulator)
    {
        Geom floor = Floor(simulator);
        Geom box = Box(simulator, new Vector2(0, -9.95f));
        int separations = 0;
        Run(simulator, 20);
        box.OnSeparation += (_, _) => separations++;
        floor.OnSeparation += (_, _) => separations++;
        Run(simulator, 5);
        simulator.Remove(box);
        Run(simulator, 2);
        return separations;
    }

    private static double HeightWhenOneSideWants(PhysicsSimulator simulator)
    {
        Geom floor = Floor(simulator);
        floor.CollisionCategories = CollisionCategory.Cat1;
        floor.CollidesWith = CollisionCategory.All;
        Geom box = Box(simulator, new Vector2(0, -30));
        box.CollisionCategories = CollisionCategory.Cat2;
        box.CollidesWith = CollisionCategory.Cat3;
        Run(simulator, 75);
        return box.Body.Position.Y;
    }

    private static double SpeedAfterAPause(PhysicsSimulator simulator)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 10, 10, 2);
        body.IgnoreGravity = true;
        WithoutDrag(body);
        simulator.Update(Step);
        simulator.Enabled = false;
        for (int i = 0; i < 20; i++)
        {
            body.ApplyForce(new Vector2(10, 0));
            simulator.Update(Step);
        }

        simulator.Enabled = true;
        body.ApplyForce(new Vector2(10, 0));
        simulator.Update(Step);
        return body.LinearVelocity.X;
    }

    private static double OffsetPlace(PhysicsSimulator simulator)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 4, 4, 1);
        body.IsStatic = true;
        Geom geom = GeomFactory.Instance.CreateRectangleGeom(simulator, body, 4, 4, new Vector2(10, 0), MathF.PI / 2);
        simulator.Update(Step);
        return geom.GetWorldPosition(Vector2.Zero).X;
    }

    private static double FallOfASensor(PhysicsSimulator simulator)
    {
        Geom sensor = Box(simulator, Vector2.Zero);
        sensor.IsSensor = true;
        Run(simulator, 50);
        return sensor.Body.Position.Y;
    }

    /// <param name="Run">Plays a small scene in an empty simulator, y down, gravity 100, and gives the figure.</param>
    /// <param name="Right">The figure without the flag.</param>
    /// <param name="Original">The figure with it.</param>
    /// <param name="Tolerance">How far either may be off.</param>
    private sealed record Case(Func<PhysicsSimulator, double> Run, double Right, double Original, double Tolerance);
}
