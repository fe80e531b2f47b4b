using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>The manual's chapters on springs, member by member.</summary>
public class SpringTests
{
    private static readonly SpringFactory Factory = SpringFactory.Instance;

    [Fact]
    [ManualRow("F168")]
    [ManualRow("F187")]
    [ManualRow("F188")]
    [ManualRow("F189")]
    public void LinearSpring_Stretched_PullsItsTwoBodiesTogether()
    {
        var simulator = new PhysicsSimulator();
        Body a = Free(simulator, 0, 0);
        Body b = Free(simulator, 100, 0);
        LinearSpring spring = Factory.CreateLinearSpring(simulator, a, Vector2.Zero, b, Vector2.Zero, 5, 0);
        spring.RestLength = 50;
        Assert.Same(a, spring.Body1);
        Assert.Same(b, spring.Body2);
        simulator.Update(0.01f);
        Assert.True(a.LinearVelocity.X > 0);
        Assert.Equal(-a.LinearVelocity.X, b.LinearVelocity.X, 6);
        Body c = Free(simulator, 0, 100);
        spring.Body2 = c;
        simulator.Update(0.01f);
        Assert.True(c.LinearVelocity.Y < 0);
        spring.Body1 = b;
        Assert.Same(b, spring.Body1);
    }

    [Fact]
    [ManualRow("F187")]
    [ManualRow("F197")]
    public void RestLength_LargerOrSmallerThanTheDistance_PushesOrPulls()
    {
        Assert.True(SpeedOfLengthening(200) > 0);
        Assert.True(SpeedOfLengthening(50) < 0);
        Assert.Equal(0, SpeedOfLengthening(100));
    }

    [Fact]
    [ManualRow("F169")]
    [ManualRow("F190")]
    public void FixedLinearSpring_PullsItsBodyTowardsAPointOfTheWorld()
    {
        var simulator = new PhysicsSimulator();
        Body body = Free(simulator, 0, 0);
        FixedLinearSpring spring = Factory.CreateFixedLinearSpring(simulator, body, Vector2.Zero, new Vector2(0, 80), 5, 0);
        Assert.Same(body, spring.Body);
        spring.RestLength = 0;
        simulator.Update(0.01f);
        Assert.True(body.LinearVelocity.Y > 0);
        Body other = Free(simulator, 30, 80);
        spring.Body = other;
        simulator.Update(0.01f);
        Assert.True(other.LinearVelocity.X < 0);
    }

    [Fact]
    [ManualRow("F170")]
    [ManualRow("F198")]
    [ManualRow("F199")]
    [ManualRow("F200")]
    public void AngleSpring_Twisted_TurnsItsBodiesBack()
    {
        var simulator = new PhysicsSimulator();
        Body a = Free(simulator, 0, 0);
        Body b = Free(simulator, 100, 0);
        AngleSpring spring = Factory.CreateAngleSpring(simulator, a, b, 10, 0);
        Assert.Same(a, spring.Body1);
        Assert.Same(b, spring.Body2);
        b.Rotation = 0.5f;
        simulator.Update(0.01f);
        Assert.True(b.AngularVelocity < 0);
        Assert.Equal(-a.AngularVelocity, b.AngularVelocity, 6);
        Assert.Equal(0, b.LinearVelocity.Length());
        Body c = Free(simulator, 0, 100);
        c.Rotation = 1;
        spring.Body2 = c;
        simulator.Update(0.01f);
        Assert.True(c.AngularVelocity < 0);
        spring.Body1 = b;
        Assert.Same(b, spring.Body1);
    }

    [Fact]
    [ManualRow("F171")]
    [ManualRow("F201")]
    public void FixedAngleSpring_TurnsItsBodyBackToTheTarget()
    {
        var simulator = new PhysicsSimulator();
        Body body = Free(simulator, 0, 0);
        FixedAngleSpring spring = Factory.CreateFixedAngleSpring(simulator, body, 10, 5);
        Assert.Same(body, spring.Body);
        body.Rotation = 1;
        Run(simulator, 2000);
        Assert.Equal(0, body.TotalRotation, 3);
        Body other = Free(simulator, 0, 50);
        spring.Body = other;
        spring.TargetAngle = -1;
        simulator.Update(0.01f);
        Assert.True(other.AngularVelocity < 0);
    }

    [Fact]
    [ManualRow("F172")]
    [ManualRow("F191")]
    [ManualRow("F192")]
    [ManualRow("F193")]
    public void AttachPoints_OutsideTheBody_AreLocalAndTurnIt()
    {
        var simulator = new PhysicsSimulator();
        Body a = Free(simulator, 0, 0);
        Body b = Free(simulator, 0, 100);
        b.IsStatic = true;
        a.Rotation = MathF.PI / 2;
        LinearSpring spring = Factory.CreateLinearSpring(simulator, a, new Vector2(0, -40), b, new Vector2(40, 0), 5, 0);
        Assert.Equal(new Vector2(0, -40), spring.AttachPoint1);
        Assert.Equal(new Vector2(0, -40), spring.Anchor1);
        Assert.Equal(new Vector2(40, 0), spring.Anchor2);

        // The first point is at (40, 0) in the world, the second at (40, 100): the pull turns the body.
        Assert.Equal(100, spring.RestLength, 4);
        spring.RestLength = 50;
        simulator.Update(0.01f);
        Assert.True(a.LinearVelocity.Y > 0);
        Assert.True(a.AngularVelocity > 0);
        spring.Anchor1 = new Vector2(1, 2);
        spring.Anchor2 = new Vector2(3, 4);
        Assert.Equal(new Vector2(1, 2), spring.AttachPoint1);
        Assert.Equal(new Vector2(3, 4), spring.AttachPoint2);
        FixedLinearSpring fixedSpring = Factory.CreateFixedLinearSpring(b, new Vector2(5, 6), new Vector2(7, 8), 1, 1);
        Assert.Equal(new Vector2(5, 6), fixedSpring.BodyAttachPoint);
        Assert.Equal(new Vector2(7, 8), fixedSpring.WorldAttachPoint);
        fixedSpring.Position = new Vector2(9, 9);
        Assert.Equal(new Vector2(9, 9), fixedSpring.WorldAttachPoint);
        fixedSpring.BodyAttachPoint = Vector2.One;
        Assert.Equal(Vector2.One, fixedSpring.BodyAttachPoint);
    }

    [Fact]
    [ManualRow("F173")]
    [ManualRow("F174")]
    [ManualRow("F185")]
    public void SpringOfTheUsersOwn_IsUpdatedInOrderAtTheMomentOfForces()
    {
        var simulator = new PhysicsSimulator();
        Body body = Free(simulator, 0, 0);
        var calls = new List<string>();
        simulator.Add(new Rocket(body, "first", calls));
        simulator.Add(new Rocket(body, "second", calls));
        simulator.Update(0.5f);
        Assert.Equal(["first 0.5", "second 0.5"], calls);

        // Force 2 + 2 on mass 1 for half a second.
        Assert.Equal(2, body.LinearVelocity.X, 5);
    }

    [Fact]
    [ManualRow("F175")]
    public void Enabled_False_LetsTheSpringRest()
    {
        var simulator = new PhysicsSimulator();
        Body body = Free(simulator, 0, 0);
        FixedLinearSpring spring = Factory.CreateFixedLinearSpring(simulator, body, Vector2.Zero, new Vector2(10, 0), 5, 0);
        spring.RestLength = 0;
        Assert.True(spring.Enabled);
        spring.Enabled = false;
        Run(simulator, 10);
        Assert.Equal(Vector2.Zero, body.LinearVelocity);
        spring.Enabled = true;
        Run(simulator, 1);
        Assert.True(body.LinearVelocity.X > 0);
    }

    [Fact]
    [ManualRow("F176")]
    [ManualRow("F184")]
    [ManualRow("F186")]
    public void Dispose_OfTheSpringOrItsBody_TakesItOutAtTheNextUpdate()
    {
        var simulator = new PhysicsSimulator();
        Body a = Free(simulator, 0, 0);
        Body b = Free(simulator, 50, 0);
        LinearSpring one = Factory.CreateLinearSpring(simulator, a, Vector2.Zero, b, Vector2.Zero, 5, 0);
        FixedLinearSpring two = Factory.CreateFixedLinearSpring(simulator, a, Vector2.Zero, Vector2.One, 5, 0);
        AngleSpring three = Factory.CreateAngleSpring(simulator, a, b, 5, 0);
        FixedAngleSpring four = Factory.CreateFixedAngleSpring(simulator, b, 5, 0);
        FixedAngleSpring five = Factory.CreateFixedAngleSpring(simulator, a, 5, 0);
        Run(simulator, 2);
        Assert.Equal(5, simulator.SpringList.Count);
        two.Dispose();
        two.Dispose();
        Assert.True(two.IsDisposed);
        Run(simulator, 1);
        Assert.Equal(4, simulator.SpringList.Count);
        b.Dispose();
        one.Validate();
        Assert.True(one.IsDisposed);
        Run(simulator, 1);
        Assert.True(three.IsDisposed);
        Assert.True(four.IsDisposed);
        Assert.False(five.IsDisposed);
        Assert.Equal([five], simulator.SpringList);
    }

    [Fact]
    [ManualRow("F177")]
    [ManualRow("F178")]
    public void Constants_BothSpellings_AreThoseOfTheFormula()
    {
        var simulator = new PhysicsSimulator();
        Body body = Free(simulator, 10, 0);
        var spring = new FixedLinearSpring(body, Vector2.Zero, Vector2.Zero, 3, 0.5f);
        Assert.Equal(3, spring.SpringConstant);
        Assert.Equal(0.5f, spring.DampingConstant);
        spring.DampningConstant = 0.25f;
        Assert.Equal(0.25f, spring.DampingConstant);
        spring.DampingConstant = 0.75f;
        Assert.Equal(0.75f, spring.DampningConstant);
        spring.RestLength = 0;
        body.LinearVelocity = new Vector2(4, 0);
        simulator.Add(spring);
        simulator.Update(1e-4f);

        // a = -(3·10 + 0.75·4); over 1e-4 s the float velocity has five digits of it.
        Assert.Equal(-33, (body.LinearVelocity.X - 4) / 1e-4f, 1);
    }

    [Fact]
    [ManualRow("F179")]
    public void SpringError_IsTheDeviationFromTheRest()
    {
        var simulator = new PhysicsSimulator();
        Body a = Free(simulator, 0, 0);
        Body b = Free(simulator, 100, 0);
        b.Rotation = 0.25f;
        a.IsStatic = b.IsStatic = true;
        LinearSpring linear = Factory.CreateLinearSpring(simulator, a, Vector2.Zero, b, Vector2.Zero, 5, 0);
        AngleSpring angle = Factory.CreateAngleSpring(simulator, a, b, 5, 0);
        FixedAngleSpring fixedAngle = Factory.CreateFixedAngleSpring(simulator, b, 5, 0);
        linear.RestLength = 70;
        angle.TargetAngle = 0.5f;
        fixedAngle.TargetAngle = 1;
        Run(simulator, 1);
        Assert.Equal(30, linear.SpringError, 4);
        Assert.Equal(-0.25f, angle.SpringError, 5);
        Assert.Equal(0.75f, fixedAngle.SpringError, 5);
    }

    [Fact]
    [ManualRow("F180")]
    [ManualRow("F181")]
    [ManualRow("F182")]
    public void Breakpoint_Exceeded_BreaksTheSpringOnce()
    {
        var simulator = new PhysicsSimulator();
        Body body = Free(simulator, 0, 0);
        FixedLinearSpring spring = Factory.CreateFixedLinearSpring(simulator, body, Vector2.Zero, Vector2.Zero, 1, 0);
        Assert.Equal(float.MaxValue, spring.Breakpoint);
        spring.Breakpoint = 5;
        int broke = 0;
        spring.Broke += (sender, _) =>
        {
            Assert.Same(spring, sender);
            broke++;
        };
        body.LinearVelocity = new Vector2(10, 0);
        Run(simulator, 40);
        Assert.Equal(0, broke);
        Run(simulator, 40);
        Assert.Equal(1, broke);
        Assert.False(spring.Enabled);

        // Broken it pulls no more, and is still there to be mended.
        float speed = body.LinearVelocity.X;
        Run(simulator, 10);
        Assert.Equal(speed, body.LinearVelocity.X);
        Assert.Single(simulator.SpringList);
        spring.Breakpoint = float.MaxValue;
        spring.Enabled = true;
        Run(simulator, 1);
        Assert.True(body.LinearVelocity.X < speed);
    }

    [Fact]
    [ManualRow("F183")]
    public void Tag_KeepsTheUsersObject()
    {
        var tag = new object();
        Assert.Same(tag, new LinearSpring { Tag = tag }.Tag);
    }

    [Fact]
    [ManualRow("F195")]
    [ManualRow("F196")]
    public void RestLength_FromAFactory_IsTheDistanceOfTheAnchors()
    {
        var a = new Body { Position = new Vector2(0, 0) };
        var b = new Body { Position = new Vector2(30, 0) };
        Assert.Equal(50, Factory.CreateLinearSpring(a, Vector2.Zero, b, new Vector2(0, 40), 1, 1).RestLength, 4);
        FixedLinearSpring spring = Factory.CreateFixedLinearSpring(a, new Vector2(0, 5), new Vector2(12, 0), 1, 1);
        Assert.Equal(13, spring.RestLength, 4);
        spring.RestLength = 7;
        Assert.Equal(7, spring.RestLength);
    }

    [Fact]
    [ManualRow("F194")]
    public void RestLength_IsTheLengthAtWhichTheSpringRests()
    {
        for (int i = 1; i <= 20; i++)
        {
            float rest = 7f * i;
            foreach (float stretched in new[] { -3f, 0, 3 })
            {
                var simulator = new PhysicsSimulator();
                Body a = Free(simulator, 0, 0);
                Body b = Free(simulator, rest + stretched, 0);
                LinearSpring spring = Factory.CreateLinearSpring(simulator, a, Vector2.Zero, b, Vector2.Zero, 5, 0);
                spring.RestLength = rest;
                Assert.Equal(rest, spring.RestLength);
                simulator.Update(0.001f);

                // F = −k·x at both ends, on masses of 1, for a millisecond; none at the length of rest.
                Assert.Equal(-5 * stretched * 0.001f, b.LinearVelocity.X, 1e-5f);
                Assert.Equal(5 * stretched * 0.001f, a.LinearVelocity.X, 1e-5f);
                Assert.Equal(stretched, spring.SpringError, 1e-3f);
            }
        }
    }

    [Fact]
    [ManualRow("F215")]
    public void CreateLinearSpring_WithoutASimulator_TakesEachArgument()
    {
        var a = new Body { Position = new Vector2(10, 20) };
        var b = new Body { Position = new Vector2(50, 20) };
        LinearSpring spring = Factory.CreateLinearSpring(a, new Vector2(1, 2), b, new Vector2(3, 5), 6, 7);
        var simulator = new PhysicsSimulator();
        simulator.Add(a);
        simulator.Add(b);
        Run(simulator, 1);

        Assert.Same(a, spring.Body1);
        Assert.Same(b, spring.Body2);
        Assert.Equal((new Vector2(1, 2), new Vector2(3, 5)), (spring.Anchor1, spring.Anchor2));
        Assert.Equal((6f, 7f), (spring.SpringConstant, spring.DampingConstant));

        // From (11, 22) to (53, 25).
        Assert.Equal(Math.Sqrt((42 * 42) + (3 * 3)), spring.RestLength, 1e-4);
        Assert.Empty(simulator.SpringList);
    }

    [Fact]
    [ManualRow("F216")]
    public void CreateFixedLinearSpring_WithASimulator_TakesEachArgument_AndAddsIt()
    {
        var simulator = new PhysicsSimulator();
        Body body = Free(simulator, 10, 20);
        FixedLinearSpring spring = Factory.CreateFixedLinearSpring(simulator, body, new Vector2(1, 2), new Vector2(41, 62), 6, 7);
        Run(simulator, 1);

        Assert.Same(body, spring.Body);
        Assert.Equal((new Vector2(1, 2), new Vector2(41, 62)), (spring.BodyAttachPoint, spring.WorldAttachPoint));
        Assert.Equal((6f, 7f), (spring.SpringConstant, spring.DampingConstant));

        // From (11, 22) to (41, 62).
        Assert.Equal(50, spring.RestLength, 1e-4);
        Assert.Same(spring, Assert.Single(simulator.SpringList));
        spring.RestLength = 0;
        Run(simulator, 1);
        Assert.True(body.LinearVelocity.X > 0 && body.LinearVelocity.Y > 0);
    }

    [Fact]
    [ManualRow("F218")]
    public void CreateAngleSpring_WithASimulator_TakesEachArgument_AndAddsIt()
    {
        var simulator = new PhysicsSimulator();
        Body a = Free(simulator, 0, 0);
        Body b = Free(simulator, 50, 0);
        a.Rotation = 0.5f;
        b.Rotation = 2;
        AngleSpring spring = Factory.CreateAngleSpring(simulator, a, b, 6, 7);
        Run(simulator, 1);

        Assert.Same(a, spring.Body1);
        Assert.Same(b, spring.Body2);
        Assert.Equal((6f, 7f), (spring.SpringConstant, spring.DampingConstant));
        Assert.Equal(1.5f, spring.TargetAngle, 1e-5f);
        Assert.Same(spring, Assert.Single(simulator.SpringList));
        Assert.Equal(0, b.AngularVelocity, 1e-4f);
        b.Rotation = 3;
        Run(simulator, 1);
        Assert.True(b.AngularVelocity < 0);
        Assert.Equal(-b.AngularVelocity, a.AngularVelocity, 1e-6f);
    }

    [Fact]
    [ManualRow("F202")]
    [ManualRow("F203")]
    public void AngleSpring_HasAnchors_ThatDoNotChangeItsTorque()
    {
        var simulator = new PhysicsSimulator();
        Body a = Free(simulator, 0, 0);
        Body b = Free(simulator, 50, 0);
        AngleSpring spring = Factory.CreateAngleSpring(simulator, a, b, 5, 0);
        Assert.Equal(Vector2.Zero, spring.Anchor1);
        spring.Anchor1 = new Vector2(3, 0);
        spring.Anchor2 = new Vector2(0, 4);
        Assert.Equal(new Vector2(3, 0), spring.Anchor1);
        Assert.Equal(new Vector2(0, 4), spring.Anchor2);
        spring.TargetAngle = 1;
        Run(simulator, 1);
        Assert.Equal(-a.AngularVelocity, b.AngularVelocity, 6);
        Assert.Equal(Vector2.Zero, a.LinearVelocity);
    }

    [Fact]
    [ManualRow("F204")]
    [ManualRow("F205")]
    public void TargetAngle_IsTheAngleWithoutTorque_AlsoBeyondATurn()
    {
        var simulator = new PhysicsSimulator();
        Body a = Free(simulator, 0, 0);
        Body b = Free(simulator, 50, 0);
        a.IsStatic = true;
        AngleSpring spring = Factory.CreateAngleSpring(simulator, a, b, 20, 8);
        Assert.Equal(0, spring.TargetAngle);
        spring.TargetAngle = 7;
        Body c = Free(simulator, 100, 0);
        FixedAngleSpring fixedSpring = Factory.CreateFixedAngleSpring(simulator, c, 20, 8);
        fixedSpring.TargetAngle = -8;
        Run(simulator, 2000);
        Assert.Equal(7, b.TotalRotation, 3);
        Assert.Equal(-8, c.TotalRotation, 3);
    }

    [Fact]
    [ManualRow("F206")]
    [ManualRow("F207")]
    public void MaxTorque_LimitsTheTorqueOnEachBody()
    {
        var simulator = new PhysicsSimulator();
        Body a = Free(simulator, 0, 0);
        Body b = Free(simulator, 50, 0);
        Body c = Free(simulator, 100, 0);
        AngleSpring spring = Factory.CreateAngleSpring(simulator, a, b, 1000, 0);
        FixedAngleSpring fixedSpring = Factory.CreateFixedAngleSpring(simulator, c, 1000, 0);
        Assert.Equal(float.MaxValue, spring.MaxTorque);
        Assert.Equal(float.MaxValue, fixedSpring.MaxTorque);
        spring.MaxTorque = fixedSpring.MaxTorque = 5;
        spring.TargetAngle = fixedSpring.TargetAngle = 3;
        Run(simulator, 10);

        // 5 on the inertia 1 of each body for 0.1 s.
        Assert.Equal(-0.5f, a.AngularVelocity, 4);
        Assert.Equal(0.5f, b.AngularVelocity, 4);
        Assert.Equal(0.5f, c.AngularVelocity, 4);
    }

    [Fact]
    [ManualRow("F208")]
    [ManualRow("F209")]
    [ManualRow("F210")]
    public void TorqueMultiplier_MultipliesTheTorque_AndIsOneByDefault()
    {
        var simulator = new PhysicsSimulator();
        Body a = Free(simulator, 0, 0);
        Body b = Free(simulator, 50, 0);
        FixedAngleSpring plain = Factory.CreateFixedAngleSpring(simulator, a, 1, 0);
        FixedAngleSpring tripled = Factory.CreateFixedAngleSpring(simulator, b, 1, 0);
        Assert.Equal(1, plain.TorqueMultiplier);
        Assert.Equal(1, new AngleSpring().TorqueMultiplier);
        tripled.TorqueMultiplier = 3;
        plain.TargetAngle = tripled.TargetAngle = 1;
        Run(simulator, 1);
        Assert.Equal(3, b.AngularVelocity / a.AngularVelocity, 3);
        var c = new Body();
        var d = new Body();
        simulator.Add(c);
        simulator.Add(d);
        AngleSpring pair = Factory.CreateAngleSpring(simulator, c, d, 1, 0);
        pair.TorqueMultiplier = 2;
        pair.TargetAngle = 1;
        Run(simulator, 1);
        Assert.Equal(2 * a.AngularVelocity / 2, d.AngularVelocity, 2);
    }

    [Fact]
    [ManualRow("F211")]
    [ManualRow("F212")]
    [ManualRow("F213")]
    public void SpringFactory_IsOneSharedInstance_AndLeavesTheOtherParametersAtTheirDefaults()
    {
        Assert.Same(SpringFactory.Instance, SpringFactory.Instance);
        FixedAngleSpring spring = Factory.CreateFixedAngleSpring(new Body { Rotation = 0.5f }, 1, 2);
        Assert.True(spring.Enabled);
        Assert.Null(spring.Tag);
        Assert.Equal(float.MaxValue, spring.Breakpoint);
        Assert.Equal(float.MaxValue, spring.MaxTorque);
        Assert.Equal(0.5f, spring.TargetAngle);
        Assert.Equal(0, spring.SpringError);
    }

    [Fact]
    [ManualRow("F214")]
    [ManualRow("F217")]
    [ManualRow("F219")]
    [ManualRow("F220")]
    [ManualRow("F221")]
    public void FactoryOverloads_WithASimulatorAdd_WithoutDoNot()
    {
        var simulator = new PhysicsSimulator();
        Body a = Free(simulator, 0, 0);
        Body b = Free(simulator, 50, 0);
        Vector2 p = new(1, 2);
        Vector2 q = new(3, 4);
        Spring[] added =
        [
            Factory.CreateLinearSpring(simulator, a, p, b, q, 5, 6),
            Factory.CreateFixedLinearSpring(simulator, a, p, q, 5, 6),
            Factory.CreateAngleSpring(simulator, a, b, 5, 6),
            Factory.CreateFixedAngleSpring(simulator, a, 5, 6),
            ControllerFactory.Instance.CreateLinearSpring(simulator, a, p, b, q, 5, 6),
            ControllerFactory.Instance.CreateFixedLinearSpring(simulator, a, p, q, 5, 6),
            ControllerFactory.Instance.CreateAngleSpring(simulator, a, b, 5, 6),
            ControllerFactory.Instance.CreateFixedAngleSpring(simulator, a, 5, 6),
        ];
        Spring[] loose =
        [
            Factory.CreateLinearSpring(a, p, b, q, 5, 6),
            Factory.CreateFixedLinearSpring(a, p, q, 5, 6),
            Factory.CreateAngleSpring(a, b, 5, 6),
            Factory.CreateFixedAngleSpring(a, 5, 6),
            ControllerFactory.Instance.CreateLinearSpring(a, p, b, q, 5, 6),
            ControllerFactory.Instance.CreateFixedLinearSpring(a, p, q, 5, 6),
            ControllerFactory.Instance.CreateAngleSpring(a, b, 5, 6),
            ControllerFactory.Instance.CreateFixedAngleSpring(a, 5, 6),
        ];
        Run(simulator, 1);
        Assert.Equal(added, simulator.SpringList);
        Assert.All(added, s => Assert.Equal((5f, 6f), (s.SpringConstant, s.DampingConstant)));
        Assert.All(loose, s => Assert.Equal((5f, 6f), (s.SpringConstant, s.DampingConstant)));
        simulator.Add(loose[0]);
        simulator.Remove(added[0]);
        Run(simulator, 1);
        Assert.Contains(loose[0], simulator.SpringList);
        Assert.DoesNotContain(added[0], simulator.SpringList);
    }

    [Fact]
    public void SpringList_TellsOfAdditionsAndRemovals_AndStandsForTheSimulator()
    {
        var simulator = new PhysicsSimulator();
        var log = new List<string>();
        simulator.SpringList.Added += _ => log.Add("in");
        simulator.SpringList.Removed += _ => log.Add("out");
        var spring = new FixedAngleSpring(Free(simulator, 0, 0), 1, 1);
        simulator.SpringList.Add(spring);
        Assert.Empty(simulator.SpringList);
        Run(simulator, 1);
        simulator.SpringList.Remove(spring);
        Assert.Single(simulator.SpringList);
        Run(simulator, 1);
        Assert.Equal(["in", "out"], log);
        var list = new SpringList { spring };
        spring.Dispose();
        list.RemoveDisposed();
        Assert.Empty(list);
    }

    [Fact]
    public void Clear_TakesSpringsOut_ForUseInAnotherSimulator()
    {
        var simulator = new PhysicsSimulator();
        Body body = Free(simulator, 0, 0);
        FixedLinearSpring spring = Factory.CreateFixedLinearSpring(simulator, body, Vector2.Zero, new Vector2(10, 0), 1, 0);
        Run(simulator, 1);
        simulator.Clear();
        Assert.Empty(simulator.SpringList);
        var other = new PhysicsSimulator();
        other.Add(body);
        other.Add(spring);
        spring.RestLength = 0;
        Run(other, 1);
        Assert.True(body.LinearVelocity.X > 0);
    }

    [Fact]
    public void Update_CalledByTheUser_GivesThePlainForce()
    {
        var body = new Body { Position = new Vector2(10, 0) };
        var spring = new FixedLinearSpring(body, Vector2.Zero, Vector2.Zero, 3, 0) { RestLength = 4 };
        spring.Update(0.01f);
        Assert.Equal(-18, body.Force.X, 4);
        var twist = new FixedAngleSpring(body, 2, 0) { TargetAngle = 1 };
        twist.Update(0.01f);
        Assert.Equal(2, body.Torque, 4);
        new LinearSpring().Update(0.01f);
        new AngleSpring().Update(0.01f);
    }

    [Fact]
    public void BadInput_IsRefusedByName()
    {
        var a = new Body();
        var b = new Body();
        Vector2 bad = new(float.NaN, 0);
        Assert.Throws<ArgumentNullException>(() => new LinearSpring(null!, Vector2.Zero, b, Vector2.Zero, 1, 1));
        Assert.Throws<ArgumentNullException>(() => new LinearSpring(a, Vector2.Zero, null!, Vector2.Zero, 1, 1));
        Assert.Throws<ArgumentException>("body2", () => new LinearSpring(a, Vector2.Zero, a, Vector2.Zero, 1, 1));
        Assert.Throws<ArgumentOutOfRangeException>("attachPoint1", () => new LinearSpring(a, bad, b, Vector2.Zero, 1, 1));
        Assert.Throws<ArgumentOutOfRangeException>("attachPoint2", () => new LinearSpring(a, Vector2.Zero, b, bad, 1, 1));
        Assert.Throws<ArgumentOutOfRangeException>("springConstant", () => new LinearSpring(a, Vector2.Zero, b, Vector2.Zero, -1, 1));
        Assert.Throws<ArgumentOutOfRangeException>(
            "dampingConstant", () => new LinearSpring(a, Vector2.Zero, b, Vector2.Zero, 1, float.NaN));
        Assert.Throws<ArgumentNullException>(() => new FixedLinearSpring(null!, Vector2.Zero, Vector2.Zero, 1, 1));
        Assert.Throws<ArgumentOutOfRangeException>("worldAttachPoint", () => new FixedLinearSpring(a, Vector2.Zero, bad, 1, 1));
        Assert.Throws<ArgumentNullException>(() => new AngleSpring(a, null!, 1, 1));
        Assert.Throws<ArgumentException>("body2", () => new AngleSpring(a, a, 1, 1));
        Assert.Throws<ArgumentOutOfRangeException>("springConstant", () => new AngleSpring(a, b, float.PositiveInfinity, 1));
        Assert.Throws<ArgumentNullException>(() => new FixedAngleSpring(null!, 1, 1));
        var linear = new LinearSpring(a, Vector2.Zero, b, Vector2.Zero, 1, 1);
        Assert.Throws<ArgumentOutOfRangeException>("RestLength", () => linear.RestLength = -1);
        Assert.Throws<ArgumentOutOfRangeException>("SpringConstant", () => linear.SpringConstant = -1);
        Assert.Throws<ArgumentOutOfRangeException>(() => linear.DampningConstant = float.NaN);
        Assert.Throws<ArgumentOutOfRangeException>(() => linear.Breakpoint = float.NaN);
        Assert.Throws<ArgumentOutOfRangeException>(() => linear.AttachPoint1 = bad);
        Assert.Throws<ArgumentNullException>(() => linear.Body1 = null);
        Assert.Throws<ArgumentException>(() => linear.Body1 = b);
        var angle = new FixedAngleSpring(a, 1, 1);
        Assert.Throws<ArgumentOutOfRangeException>(() => angle.TargetAngle = float.NaN);
        Assert.Throws<ArgumentOutOfRangeException>(() => angle.MaxTorque = -1);
        Assert.Throws<ArgumentOutOfRangeException>(() => angle.TorqueMultiplier = float.PositiveInfinity);
        var simulator = new PhysicsSimulator();
        Assert.Throws<ArgumentNullException>(() => simulator.Add((Spring)null!));
        Assert.Throws<ArgumentNullException>(() => Factory.CreateFixedAngleSpring(null!, a, 1, 1));
        simulator.Add(angle);
        Assert.Throws<ArgumentException>(() => new PhysicsSimulator().Add(angle));
        Assert.Throws<ArgumentException>(() => new PhysicsSimulator().Remove(angle));
        angle.Dispose();
        Assert.Throws<ObjectDisposedException>(() => simulator.Add(angle));
    }

    internal static Body Free(PhysicsSimulator simulator, float x, float y)
    {
        var body = new Body { Position = new Vector2(x, y), LinearDragCoefficient = 0, RotationalDragCoefficient = 0 };
        simulator.Add(body);
        return body;
    }

    internal static void Run(PhysicsSimulator simulator, int steps, float dt = 0.01f)
    {
        for (int i = 0; i < steps; i++)
        {
            simulator.Update(dt);
        }
    }

    private static float SpeedOfLengthening(float restLength)
    {
        var simulator = new PhysicsSimulator();
        Body a = Free(simulator, 0, 0);
        Body b = Free(simulator, 100, 0);
        Factory.CreateLinearSpring(simulator, a, Vector2.Zero, b, Vector2.Zero, 5, 1).RestLength = restLength;
        Run(simulator, 3);
        return b.LinearVelocity.X - a.LinearVelocity.X;
    }

    private sealed class Rocket(Body body, string name, List<string> calls) : Spring
    {
        public override void Validate()
        {
            if (body.IsDisposed)
            {
                Dispose();
            }
        }

        public override void Update(float dt)
        {
            base.Update(dt);
            calls.Add(FormattableString.Invariant($"{name} {dt}"));
            body.ApplyForce(new Vector2(2, 0));
        }
    }
}
