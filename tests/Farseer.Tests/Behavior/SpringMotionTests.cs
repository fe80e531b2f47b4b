using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using static Farseer.Tests.Api.SpringTests;

namespace Farseer.Tests.Behavior;

/// <summary>How springs move bodies: exactly when alone, boundedly always.</summary>
public class SpringMotionTests
{
    private static readonly SpringFactory Factory = SpringFactory.Instance;

    /// <summary>The damped oscillator in closed form, at frequencies up to nearly half the rate of the updates.</summary>
    [Theory]
    [InlineData(1, 0.05f)]
    [InlineData(2, 0.05f)]
    [InlineData(8, 0.1f)]
    [InlineData(20, 0.05f)]
    [InlineData(29, 0.02f)]
    [InlineData(5, 1f)]
    [InlineData(3, 4f)]
    public void FixedLinearSpring_Alone_FollowsTheClosedForm(float frequency, float ratio)
    {
        const float Dt = 1 / 60f;
        var simulator = new PhysicsSimulator();
        Body body = Free(simulator, 6, 0);
        double omega = 2 * Math.PI * frequency;
        FixedLinearSpring spring = Factory.CreateFixedLinearSpring(
            simulator, body, Vector2.Zero, Vector2.Zero, (float)(omega * omega), (float)(2 * ratio * omega));
        spring.RestLength = 5;
        double worst = 0;
        for (int i = 1; i <= 120; i++)
        {
            simulator.Update(Dt);
            worst = Math.Max(worst, Math.Abs(body.PositionX - 5 - Decay(omega, ratio, i * (double)Dt)));
        }

        // The constants and velocities are floats: at 29 Hz that leaves a phase of 1e-5 of the 2π·58 turned.
        Assert.InRange(worst, 0, 1e-4);
    }

    [Theory]
    [InlineData(2)]
    [InlineData(25)]
    public void LinearSpring_BetweenTwoFreeBodies_SwingsWithTheReducedMass(float frequency)
    {
        const float Dt = 1 / 60f;
        var simulator = new PhysicsSimulator();
        Body a = Free(simulator, 0, 0);
        Body b = Free(simulator, 6, 0);
        b.Mass = 3;
        double omega = 2 * Math.PI * frequency;
        double reduced = 3.0 / 4;
        Factory.CreateLinearSpring(
            simulator, a, Vector2.Zero, b, Vector2.Zero, (float)(reduced * omega * omega), (float)(reduced * 0.1 * omega))
            .RestLength = 5;
        double worst = 0;
        for (int i = 1; i <= 120; i++)
        {
            simulator.Update(Dt);
            worst = Math.Max(worst, Math.Abs(b.PositionX - a.PositionX - 5 - Decay(omega, 0.05, i * (double)Dt)));
        }

        Assert.InRange(worst, 0, 1e-4);
        Assert.Equal(4.5, (a.PositionX + (3 * b.PositionX)) / 4, 4);
    }

    [Fact]
    public void AngleSprings_Alone_FollowTheClosedForm()
    {
        const float Dt = 1 / 60f;
        var simulator = new PhysicsSimulator();
        Body a = Free(simulator, 0, 0);
        Body b = Free(simulator, 50, 0);
        Body c = Free(simulator, 100, 0);
        double omega = 2 * Math.PI * 10;

        // Equal inertias 1: the difference of the angles swings with k(1 + 1), and each body's own damping is also that of the difference.
        AngleSpring pair = Factory.CreateAngleSpring(simulator, a, b, (float)(omega * omega / 2), (float)(0.2 * omega));
        FixedAngleSpring single = Factory.CreateFixedAngleSpring(simulator, c, (float)(omega * omega), (float)(0.2 * omega));
        b.Rotation = 1;
        c.Rotation = 1;
        double worst = 0;
        for (int i = 1; i <= 60; i++)
        {
            simulator.Update(Dt);
            double exact = Decay(omega, 0.1, i * (double)Dt);
            worst = Math.Max(worst, Math.Abs(b.TotalRotation - a.TotalRotation - exact));
            worst = Math.Max(worst, Math.Abs(c.TotalRotation - exact));
        }

        Assert.InRange(worst, 0, 1e-4);
        Assert.True(pair.Enabled && single.Enabled);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(1e3)]
    [InlineData(1e6)]
    public void ConstantAndDampingTimesAMillion_AtLargeSteps_StayBoundedAndRestWhereTheForcesBalance(double factor)
    {
        foreach ((double k, double c) in new[] { (factor, 1.0), (1.0, factor), (factor, factor), (factor, 0.0) })
        {
            var simulator = new PhysicsSimulator(new Vector2(0, 100));
            Body hung = Free(simulator, 0, 40);
            hung.Mass = 2;
            Factory.CreateFixedLinearSpring(simulator, hung, Vector2.Zero, Vector2.Zero, (float)(30 * k), (float)(2 * c)).RestLength = 20;
            Body turned = Free(simulator, 100, 0);
            turned.IgnoreGravity = true;
            turned.AngularVelocity = 30;
            Factory.CreateFixedAngleSpring(simulator, turned, (float)(30 * k), (float)(2 * c)).TargetAngle = 1;
            double before = Energy(hung, 30 * k, 20) + (450 + (15 * k));
            double most = 0;
            for (int i = 0; i < 3000; i++)
            {
                simulator.Update(1 / 15f);
                double angle = turned.TotalRotation - 1;
                double now = Energy(hung, 30 * k, 20) + (turned.AngularVelocity * turned.AngularVelocity / 2) + (15 * k * angle * angle);
                most = Math.Max(most, now);
            }

            // Undamped swings keep their energy but for the second-order ripple of a sampled swing; nothing grows.
            Assert.InRange(most, 0, 1.3 * Math.Abs(before));
            if (c > 0 && c * c * 1000 > k)
            {
                double sag = 200 / (30 * k);
                double due = c >= 1e3 * k ? 0.5 : 1e-3 * Math.Max(sag, 1);
                Assert.InRange(hung.PositionY, c >= 1e3 * k ? 20 : 20 + sag - due, c >= 1e3 * k ? 41 : 20 + sag + due);
            }
        }
    }

    /// <summary>The springs between two bodies that are free: the same, about their common centre, whose motion they leave alone.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(1e3)]
    [InlineData(1e6)]
    public void ConstantAndDampingTimesAMillion_BetweenFreeBodiesAtLargeSteps_StayBoundedAndRest(double factor)
    {
        foreach ((double k, double c) in new[] { (factor, 1.0), (1.0, factor), (factor, factor), (factor, 0.0) })
        {
            var simulator = new PhysicsSimulator();
            Body a = Free(simulator, 0, 0);
            Body b = Free(simulator, 30, 0);
            b.Mass = 2;
            LinearSpring linear = Factory.CreateLinearSpring(simulator, a, Vector2.Zero, b, Vector2.Zero, (float)(30 * k), (float)(2 * c));
            linear.RestLength = 20;
            Body first = Free(simulator, 0, 200);
            Body second = Free(simulator, 100, 200);
            second.MomentOfInertia = 2;
            first.AngularVelocity = 30;
            AngleSpring angle = Factory.CreateAngleSpring(simulator, first, second, (float)(30 * k), (float)(2 * c));
            angle.TargetAngle = 1;
            double before = (15 * k * 100) + 450 + (15 * k);
            double most = 0;
            double turning = 0;
            for (int i = 0; i < 3000; i++)
            {
                simulator.Update(1 / 15f);
                double stretch = b.PositionX - a.PositionX - 20;
                double twist = second.TotalRotation - first.TotalRotation - 1;
                turning = first.AngularVelocity + (2 * second.AngularVelocity);
                double moving = a.LinearVelocity.LengthSquared() + (2 * b.LinearVelocity.LengthSquared())
                    + (first.AngularVelocity * first.AngularVelocity) + (2 * second.AngularVelocity * second.AngularVelocity);
                most = Math.Max(most, (moving / 2) + (15 * k * ((stretch * stretch) + (twist * twist))));
            }

            // As above. The centre stays at (0 + 2 30) / 3; an angle spring damps each body's own turning, so that goes, but never grows.
            Assert.InRange(most, 0, 1.3 * before);
            Assert.Equal(20, (a.PositionX + (2 * b.PositionX)) / 3, 1e-2);
            Assert.InRange(turning, -0.1, 30.1);
            if (c > 0 && c * c * 1000 > k && c < 1e3 * k)
            {
                Assert.Equal(20, b.PositionX - a.PositionX, 0.02);
                Assert.Equal(1, second.TotalRotation - first.TotalRotation, 0.01);
            }
        }
    }

    [Fact]
    public void HungBody_OnSpringsOfAnyStrength_RestsAtTheExtensionOfItsWeight()
    {
        foreach (double k in new[] { 3, 30, 300, 3e3, 3e4, 3e5, 3e7 })
        {
            var simulator = new PhysicsSimulator(new Vector2(0, 100));
            Body body = Free(simulator, 0, 0);
            double critical = 2 * Math.Sqrt(k);
            FixedLinearSpring spring =
                Factory.CreateFixedLinearSpring(simulator, body, Vector2.Zero, new Vector2(0, -10), (float)k, (float)critical);
            spring.RestLength = 10;
            Run(simulator, 1200, 1 / 60f);
            Assert.Equal(0, body.LinearVelocity.Length(), 3);
            Assert.InRange(body.PositionY, (100 / k) - (1e-4 * Math.Max(1, 100 / k)), (100 / k) + (1e-4 * Math.Max(1, 100 / k)));
        }
    }

    [Theory]
    [InlineData(1e3f)]
    [InlineData(1e6f)]
    [InlineData(1e9f)]
    public void ChainOfSprings_OfAnyStrength_HangsByTheWeightBelowEachSpring(float k)
    {
        const int Links = 20;
        const float Gravity = 10;
        var simulator = new PhysicsSimulator(new Vector2(0, Gravity));
        var bodies = new Body[Links];
        for (int i = 0; i < Links; i++)
        {
            bodies[i] = Free(simulator, 0, 10 * (i + 1));
            if (i == 0)
            {
                Factory.CreateFixedLinearSpring(simulator, bodies[0], Vector2.Zero, Vector2.Zero, k, 50);
            }
            else
            {
                Factory.CreateLinearSpring(simulator, bodies[i - 1], Vector2.Zero, bodies[i], Vector2.Zero, k, 50);
            }
        }

        Run(simulator, 6000, 1 / 60f);
        double y = 0;
        for (int i = 0; i < Links; i++)
        {
            y += 10 + ((Links - i) * Gravity / k);
            Assert.InRange(bodies[i].PositionY, y - 0.01, y + 0.01);
        }
    }

    [Fact]
    public void MattressOfStiffSprings_Dropped_StaysWholeAndLandsOnItsFeet()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 100));
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 400, 20, 1);
        floor.IsStatic = true;
        floor.Position = new Vector2(0, 110);
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 400, 20);
        var grid = new Body[6, 3];
        for (int i = 0; i < 6; i++)
        {
            for (int j = 0; j < 3; j++)
            {
                grid[i, j] = BodyFactory.Instance.CreateCircleBody(simulator, 4, 1);
                grid[i, j].Position = new Vector2(20 * i, 20 * j);
                GeomFactory.Instance.CreateCircleGeom(simulator, grid[i, j], 4, 16).FrictionCoefficient = 0.5f;
                Tie(simulator, grid, i, j, -1, 0);
                Tie(simulator, grid, i, j, 0, -1);
                Tie(simulator, grid, i, j, -1, -1);
                Tie(simulator, grid, i, j, -1, 1);
            }
        }

        Run(simulator, 600, 1 / 60f);
        for (int i = 0; i < 6; i++)
        {
            for (int j = 0; j < 3; j++)
            {
                Assert.InRange(grid[i, j].PositionY, 55 + (20 * (j - 2)), 97 + (20 * (j - 2)));
                Assert.InRange(grid[i, j].LinearVelocity.Length(), 0, 1);
            }
        }
    }

    [Fact]
    public void SpringPressingABoxOnTheFloor_LeavesItAtTheAllowedDepth()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 100));
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 400, 20, 1);
        floor.IsStatic = true;
        floor.Position = new Vector2(0, 20);
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 400, 20);
        Body box = BodyFactory.Instance.CreateRectangleBody(simulator, 20, 20, 1);
        GeomFactory.Instance.CreateRectangleGeom(simulator, box, 20, 20);
        Factory.CreateFixedLinearSpring(simulator, box, Vector2.Zero, new Vector2(0, 60), 100, 5).RestLength = 20;
        Run(simulator, 300, 1 / 60f);
        Assert.InRange(box.PositionY, -0.1, 0.2);
        Assert.InRange(box.LinearVelocity.Length(), 0, 0.05f);
    }

    [Fact]
    public void SpringOnAHinge_SwingsWithTheInertiaAboutTheHinge()
    {
        const float Dt = 1 / 60f;
        var simulator = new PhysicsSimulator();
        Body rod = Free(simulator, 0, 0);
        JointFactory.Instance.CreateFixedRevoluteJoint(simulator, rod, new Vector2(-2, 0));
        FixedAngleSpring spring = Factory.CreateFixedAngleSpring(simulator, rod, 500, 0);
        spring.TargetAngle = 0.1f;

        // The inertia about the hinge is 1 + 1·2²: a frequency of 10 rad/s.
        int crossings = 0;
        double last = -0.1;
        for (int i = 0; i < 600; i++)
        {
            simulator.Update(Dt);
            double angle = rod.TotalRotation - 0.1;
            crossings += last < 0 && angle >= 0 ? 1 : 0;
            last = angle;
        }

        // 10 s at 10 rad/s: 15.9 turns.
        Assert.InRange(crossings, 15, 16);
    }

    [Fact]
    public void SpringOnABodyThatIsOffOrNotAdded_TreatsItAsAPlace()
    {
        var simulator = new PhysicsSimulator();
        Body body = Free(simulator, 0, 0);
        Body off = Free(simulator, 20, 0);
        off.Enabled = false;
        off.LinearVelocity = new Vector2(9, 9);
        var absent = new Body { Position = new Vector2(0, 30) };

        // The springs end up in one line, across which they damp nothing.
        body.LinearDragCoefficient = 2;
        Factory.CreateLinearSpring(simulator, body, Vector2.Zero, off, Vector2.Zero, 10, 1).RestLength = 0;
        Factory.CreateLinearSpring(simulator, body, Vector2.Zero, absent, Vector2.Zero, 10, 1).RestLength = 0;
        Run(simulator, 3000);
        Assert.Equal(10, body.PositionX, 2);
        Assert.Equal(15, body.PositionY, 2);
        Assert.Equal(new Vector2(20, 0), off.Position);
        Assert.Equal(new Vector2(0, 30), absent.Position);
    }

    [Fact]
    public void SpringsRemovedDisposedAndBrokenInHandlers_LeaveTheRestRunning()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 50));
        var springs = new FixedLinearSpring[8];
        for (int i = 0; i < springs.Length; i++)
        {
            Body body = Free(simulator, 20 * i, 0);
            springs[i] = Factory.CreateFixedLinearSpring(simulator, body, Vector2.Zero, new Vector2(20 * i, -10), 10, 0.1f);
        }

        springs[0].Breakpoint = springs[1].Breakpoint = springs[2].Breakpoint = springs[3].Breakpoint = 1;
        springs[0].Broke += (_, _) => springs[0].Dispose();
        springs[1].Broke += (_, _) => simulator.Remove(springs[4]);
        springs[2].Broke += (_, _) => springs[5].Body!.Dispose();
        springs[3].Broke += (_, _) =>
        {
            simulator.Add(new FixedAngleSpring(springs[6].Body!, 1, 1));
            springs[6].Enabled = false;
        };
        Run(simulator, 200);
        Assert.True(springs[0].IsDisposed);
        Assert.True(springs[5].IsDisposed);
        Assert.DoesNotContain(springs[4], simulator.SpringList);
        Assert.Equal(6, simulator.SpringList.Count);
        Assert.InRange(springs[7].Body!.PositionY, 0, 12);
        Assert.True(springs[6].Body!.PositionY > 50);
    }

    [Fact]
    public void SpringThatThrows_DoesNotStopTheStep_AndIsHeardOfAfterIt()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 10));
        Body body = Free(simulator, 0, 0);
        FixedLinearSpring spring = Factory.CreateFixedLinearSpring(simulator, body, Vector2.Zero, Vector2.Zero, 1, 0);
        spring.Breakpoint = 0;
        spring.Broke += (_, _) => throw new InvalidOperationException("broke");
        Run(simulator, 1);
        Assert.Throws<InvalidOperationException>(() => simulator.Update(0.01f));
        Assert.Equal(0.2f, body.LinearVelocity.Y, 3);
    }

    [Fact]
    public void ScenesOfSprings_ScaledByAPowerOfTwo_GiveScaledBits()
    {
        Body[] small = Net(1);
        Body[] large = Net(1024);
        for (int i = 0; i < small.Length; i++)
        {
            Assert.Equal(small[i].PositionX * 1024, large[i].PositionX);
            Assert.Equal(small[i].PositionY * 1024, large[i].PositionY);
            Assert.Equal(small[i].TotalRotation, large[i].TotalRotation);
        }
    }

    [Fact]
    public void Update_WithEveryKindOfSpring_AllocatesNothing()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 50));
        var bodies = new Body[6];
        for (int i = 0; i < bodies.Length; i++)
        {
            bodies[i] = Free(simulator, 20 * i, 0);
            Factory.CreateFixedLinearSpring(
                simulator, bodies[i], new Vector2(1, 1), new Vector2(20 * i, -10), i % 2 == 0 ? 10 : 1e7f, 0.1f);
            Factory.CreateFixedAngleSpring(simulator, bodies[i], 10, 0.1f).MaxTorque = 5;
        }

        Factory.CreateLinearSpring(simulator, bodies[0], Vector2.Zero, bodies[1], Vector2.Zero, 1e6f, 1);
        Factory.CreateAngleSpring(simulator, bodies[2], bodies[3], 1e6f, 1).MaxTorque = 20;
        Run(simulator, 50);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Run(simulator, 100);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    private static void Tie(PhysicsSimulator simulator, Body[,] grid, int i, int j, int di, int dj)
    {
        if (i + di >= 0 && j + dj >= 0 && j + dj < grid.GetLength(1) && grid[i + di, j + dj] is { } other)
        {
            Factory.CreateLinearSpring(simulator, other, Vector2.Zero, grid[i, j], Vector2.Zero, 2e5f, 100);
        }
    }

    private static Body[] Net(float scale)
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 20 * scale));
        var bodies = new Body[4];
        for (int i = 0; i < bodies.Length; i++)
        {
            bodies[i] = Free(simulator, 7 * i * scale, i * i * scale);
            bodies[i].MomentOfInertia = 3 * scale * scale;
            Factory.CreateFixedLinearSpring(
                simulator, bodies[i], new Vector2(1, 2) * scale, new Vector2(6 * i, -9) * scale, i % 2 == 0 ? 40 : 1e6f, 3);
        }

        Factory.CreateLinearSpring(simulator, bodies[0], Vector2.Zero, bodies[1], Vector2.Zero, 50, 2).RestLength = 3 * scale;
        Factory.CreateAngleSpring(simulator, bodies[2], bodies[3], 9 * scale * scale, scale * scale).TargetAngle = 2;
        Run(simulator, 200);
        return bodies;
    }

    /// <summary>x(t) of the oscillator released at 1.</summary>
    private static double Decay(double omega, double ratio, double t)
    {
        if (ratio < 1)
        {
            double turn = omega * Math.Sqrt(1 - (ratio * ratio));
            return Math.Exp(-ratio * omega * t) * (Math.Cos(turn * t) + (ratio * omega / turn * Math.Sin(turn * t)));
        }

        if (ratio == 1)
        {
            return (1 + (omega * t)) * Math.Exp(-omega * t);
        }

        double root = Math.Sqrt((ratio * ratio) - 1);
        double slow = omega * (ratio - root);
        double fast = omega * (ratio + root);
        return ((fast * Math.Exp(-slow * t)) - (slow * Math.Exp(-fast * t))) / (fast - slow);
    }

    // Of the hung body of mass 2 in gravity 100, above its rest.
    private static double Energy(Body body, double k, double rest)
    {
        double stretch = body.PositionY - rest - (200 / k);
        return body.LinearVelocity.LengthSquared() + (k * stretch * stretch / 2);
    }
}
