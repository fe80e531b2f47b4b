using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Api;

/// <summary>The chapters of the manual on joints: members and defaults.</summary>
public class JointTests
{
    private static readonly JointFactory _joints = JointFactory.Instance;

    [Fact]
    [ManualRow("F056")]
    [ManualRow("F057")]
    [ManualRow("F058")]
    [ManualRow("F060")]
    [ManualRow("F061")]
    [ManualRow("F062")]
    [ManualRow("F063")]
    [ManualRow("F071")]
    [ManualRow("F073")]
    [ManualRow("F075")]
    [ManualRow("F076")]
    [ManualRow("F077")]
    [ManualRow("F078")]
    [ManualRow("F079")]
    [ManualRow("F080")]
    [ManualRow("F083")]
    [ManualRow("F087")]
    public void EveryJoint_WhenMade_HasTheDocumentedDefaults()
    {
        foreach (Joint joint in All(Sandbox.Falling()))
        {
            Assert.True(joint.Enabled);
            Assert.False(joint.IsDisposed);
            Assert.Equal(0, joint.JointError);
            Assert.Equal(float.MaxValue, joint.Breakpoint);
            Assert.Equal(0, joint.Softness);
            Assert.Equal(0.2f, joint.BiasFactor);
            Assert.Null(joint.Tag);
            joint.Tag = this;
            Assert.Same(this, joint.Tag);
            joint.Breakpoint = 3;
            joint.Softness = 0.5f;
            joint.BiasFactor = 0.4f;
            Assert.Equal((3f, 0.5f, 0.4f), (joint.Breakpoint, joint.Softness, joint.BiasFactor));
            joint.Dispose();
            joint.Dispose();
            Assert.True(joint.IsDisposed);
        }
    }

    [Fact]
    public void Reaction_BeyondAFloat_IsTheLargestOne()
    {
        var simulator = new PhysicsSimulator();
        Body body = BodyFactory.Instance.CreateBody(simulator, 1e9f, 1e9f);
        FixedRevoluteJoint joint = _joints.CreateFixedRevoluteJoint(simulator, body, Vector2.Zero);
        body.LinearVelocity = new Vector2(1000, -1000);
        simulator.Update(1e-30f);

        // 10¹² N·s in 10⁻³⁰ s.
        Assert.Equal(new Vector2(-float.MaxValue, float.MaxValue), joint.ReactionForce);
    }

    [Fact]
    [ManualRow("F072")]
    public void Enabled_False_LetsGo()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Body body = Bar(simulator, 0);
        FixedRevoluteJoint joint = _joints.CreateFixedRevoluteJoint(simulator, body, body.Position);
        Sandbox.Run(simulator, 10);
        Assert.Equal(0, body.Position.Y, 1e-4f);
        joint.Enabled = false;
        Sandbox.Run(simulator, 10);

        // ½·g·t² of a free fall, with the default drag.
        Assert.InRange(body.Position.Y, 0.4f, 0.51f);
        joint.Enabled = true;
        float held = body.Position.Y;
        Sandbox.Run(simulator, 200);
        Assert.InRange(body.Position.Y, -0.01f, held);
    }

    [Fact]
    [ManualRow("F065")]
    [ManualRow("F066")]
    [ManualRow("F067")]
    [ManualRow("F068")]
    [ManualRow("F097")]
    public void FixedJoint_WithAnAnchorOutsideTheBody_SwingsItAboutThatPointOfTheWorld()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Body body = Bar(simulator, 100);
        FixedRevoluteJoint joint = _joints.CreateFixedRevoluteJoint(simulator, body, new Vector2(0, 0));
        float farthest = 0;
        for (int i = 0; i < 300; i++)
        {
            simulator.Update(Sandbox.Step);
            Assert.Equal(100, body.Position.Length(), 1e-3f);
            Assert.True(joint.CurrentAnchor.Length() < 1e-3f);
            farthest = Math.Max(farthest, body.Position.Y);
        }

        Assert.InRange(farthest, 99, 100.01f);
    }

    [Fact]
    [ManualRow("F069")]
    [ManualRow("F086")]
    public void JointOfOnesOwn_IsPreparedAndSolvedInOrder_AndHolds()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Body a = Bar(simulator, 0);
        Body b = Bar(simulator, 50);
        var log = new System.Collections.Generic.List<string>();
        simulator.Add(new Hook("a", a, log));
        simulator.Add(new Hook("b", b, log));
        Sandbox.Run(simulator, 200);
        Assert.Equal(["a prepared", "b prepared", "a solved", "b solved"], log.GetRange(0, 4));
        Assert.Equal(0, a.Position.Y, 0.05f);
        Assert.Equal(0, b.Position.Y, 0.05f);
    }

    [Fact]
    [ManualRow("F074")]
    [ManualRow("F089")]
    public void JointError_OfAHinge_IsTheDistanceOfItsAnchors()
    {
        PhysicsSimulator simulator = new PhysicsSimulator();
        Body a = Bar(simulator, 0);
        Body b = Bar(simulator, 40);
        RevoluteJoint joint = _joints.CreateRevoluteJoint(simulator, a, b, new Vector2(20, 0));
        simulator.Update(Sandbox.Step);
        b.Position = new Vector2(43, 4);
        simulator.Update(Sandbox.Step);
        Assert.Equal(5, joint.JointError, 1e-4f);
        Sandbox.Run(simulator, 300);
        Assert.Equal(0, joint.JointError, 1e-3f);
    }

    [Fact]
    [ManualRow("F081")]
    [ManualRow("F082")]
    public void JointPastItsBreakpoint_BreaksOnce_AndLetsGo()
    {
        PhysicsSimulator simulator = new PhysicsSimulator();
        Body a = Bar(simulator, 0);
        Body b = Bar(simulator, 40);
        RevoluteJoint joint = _joints.CreateRevoluteJoint(simulator, a, b, new Vector2(20, 0));
        joint.Breakpoint = 1;
        int broke = 0;
        joint.Broke += (sender, _) =>
        {
            Assert.Same(joint, sender);
            Assert.False(joint.Enabled);
            broke++;
        };
        Sandbox.Run(simulator, 10);
        Assert.Equal(0, broke);
        b.Position = new Vector2(45, 0);
        Sandbox.Run(simulator, 10);
        Assert.Equal(1, broke);
        Assert.Equal(45, b.Position.X, 1e-3f);
    }

    [Fact]
    [ManualRow("F084")]
    public void Validate_WithADisposedBody_DisposesTheJoint()
    {
        PhysicsSimulator simulator = new PhysicsSimulator();
        foreach (Joint joint in All(simulator))
        {
            simulator.Add(joint);
            joint.Validate();
            Assert.False(joint.IsDisposed);
            simulator.Update(Sandbox.Step);
            Assert.Contains(joint, simulator.JointList);
            Second(joint).Dispose();
            simulator.Update(Sandbox.Step);
            Assert.True(joint.IsDisposed);
            Assert.DoesNotContain(joint, simulator.JointList);
        }
    }

    [Fact]
    [ManualRow("F088")]
    [ManualRow("F090")]
    [ManualRow("F091")]
    [ManualRow("F092")]
    [ManualRow("F094")]
    [ManualRow("F096")]
    [ManualRow("F098")]
    public void Hinge_KeepsItsAnchorInBothBodies_AndLetsThemMove()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Body a = Bar(simulator, 0);
        Body b = Bar(simulator, 40);
        var joint = new RevoluteJoint { Anchor = new Vector2(7, 7) };
        joint.Body1 = a;
        joint.Body2 = b;
        Assert.Same(a, joint.Body1);
        Assert.Same(b, joint.Body2);
        joint.SetInitialAnchor(new Vector2(20, 0));
        Assert.Equal(new Vector2(20, 0), joint.Anchor);
        simulator.Add(joint);
        a.AngularVelocity = 3;
        Sandbox.Run(simulator, 100);

        // One second of fall of both together.
        Assert.InRange((a.Position.Y + b.Position.Y) / 2, 49, 50.5f);
        Assert.Equal(a.GetWorldPosition(new Vector2(20, 0)), joint.CurrentAnchor, Near(1e-3f));
        Assert.Equal(b.GetWorldPosition(new Vector2(-20, 0)), joint.CurrentAnchor, Near(1e-3f));
    }

    [Fact]
    [ManualRow("F093")]
    [ManualRow("F095")]
    [ManualRow("F099")]
    public void FixedHinge_TakesItsBodyAndAnchorLater()
    {
        Body body = Bar(new PhysicsSimulator(), 10);
        var joint = new FixedRevoluteJoint { Body = body };
        Assert.Same(body, joint.Body);
        joint.SetInitialAnchor(new Vector2(1, 2));
        Assert.Equal(new Vector2(1, 2), joint.Anchor);
        joint.SetAnchor(new Vector2(3, 4));
        Assert.Equal(new Vector2(3, 4), joint.Anchor);
        joint.Anchor = new Vector2(5, 6);
        Assert.Equal(new Vector2(5, 6), joint.CurrentAnchor, Near(1e-5f));
    }

    [Fact]
    [ManualRow("F100")]
    [ManualRow("F102")]
    [ManualRow("F104")]
    [ManualRow("F106")]
    [ManualRow("F107")]
    public void AngleJoint_TurnsBothToTheTargetBySharesOfTheError()
    {
        PhysicsSimulator simulator = new PhysicsSimulator();
        Body a = Bar(simulator, 0);
        Body b = Bar(simulator, 40);
        AngleJoint joint = _joints.CreateAngleJoint(simulator, a, b);
        Assert.Equal(float.MaxValue, joint.MaxImpulse);
        Assert.Same(a, joint.Body1);
        Assert.Same(b, joint.Body2);
        joint.TargetAngle = 0.5f;
        simulator.Update(Sandbox.Step);
        simulator.Update(Sandbox.Step);
        Assert.Equal(0.8f * 0.5f, Math.Abs(joint.JointError), 1e-4f);
        Sandbox.Run(simulator, 100);
        Assert.Equal(0.5f, b.TotalRotation - a.TotalRotation, 1e-4f);

        joint.MaxImpulse = 0;
        joint.TargetAngle = 2;
        Sandbox.Run(simulator, 20);
        Assert.Equal(0.5f, b.TotalRotation - a.TotalRotation, 1e-3f);
    }

    [Fact]
    [ManualRow("F101")]
    [ManualRow("F103")]
    [ManualRow("F105")]
    [ManualRow("F109")]
    public void FixedAngleJoint_TurnsTheBodyToTheTarget()
    {
        PhysicsSimulator simulator = new PhysicsSimulator();
        Body body = Bar(simulator, 0);
        FixedAngleJoint joint = _joints.CreateFixedAngleJoint(simulator, body);
        Assert.Same(body, joint.Body);
        Assert.Equal(float.MaxValue, joint.MaxImpulse);
        joint.TargetAngle = 1;
        joint.MaxImpulse = 1e6f;
        Sandbox.Run(simulator, 100);
        Assert.Equal(1, body.Rotation, 1e-4f);
    }

    [Fact]
    [ManualRow("F110")]
    [ManualRow("F111")]
    [ManualRow("F112")]
    [ManualRow("F113")]
    public void AngleLimitJoint_StopsAtItsLimits_AndTurnsNothingByItself()
    {
        PhysicsSimulator simulator = new PhysicsSimulator();
        Body a = Bar(simulator, 0);
        Body b = Bar(simulator, 40);
        AngleLimitJoint joint = _joints.CreateAngleLimitJoint(simulator, a, b, -0.2f, 0.3f);
        Assert.Equal((-0.2f, 0.3f, 0.01f), (joint.LowerLimit, joint.UpperLimit, joint.Slop));
        Assert.Same(a, joint.Body1);
        Assert.Same(b, joint.Body2);
        Sandbox.Run(simulator, 20);
        Assert.Equal(0, b.Rotation);
        b.AngularVelocity = 2;
        Sandbox.Run(simulator, 100);
        Assert.InRange(b.TotalRotation - a.TotalRotation, 0.29f, 0.3f + joint.Slop);
        joint.LowerLimit = -0.1f;
        joint.UpperLimit = 0.4f;
        joint.Slop = 0.001f;
        b.AngularVelocity = -2;
        Sandbox.Run(simulator, 100);
        Assert.InRange(b.TotalRotation - a.TotalRotation, -0.1f - joint.Slop - 1e-3f, -0.09f);
    }

    [Fact]
    [ManualRow("F117")]
    [ManualRow("F118")]
    [ManualRow("F119")]
    public void FixedAngleLimitJoint_StopsTheBodyAtItsLimits()
    {
        PhysicsSimulator simulator = new PhysicsSimulator();
        Body body = Bar(simulator, 0);
        FixedAngleLimitJoint joint = _joints.CreateFixedAngleLimitJoint(simulator, body, -0.2f, 0.3f);
        Assert.Same(body, joint.Body);
        joint.LowerLimit = -0.5f;
        joint.UpperLimit = 0.5f;
        joint.Slop = 0.002f;
        body.AngularVelocity = 5;
        Sandbox.Run(simulator, 50);
        Assert.InRange(body.TotalRotation, 0.49f, 0.503f);
    }

    [Fact]
    [ManualRow("F120")]
    [ManualRow("F121")]
    [ManualRow("F122")]
    [ManualRow("F123")]
    [ManualRow("F124")]
    [ManualRow("F125")]
    [ManualRow("F126")]
    [ManualRow("F127")]
    [ManualRow("F128")]
    public void PinJoint_KeepsTheDistanceOfItsAnchors()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Body a = Bar(simulator, 0);
        a.IsStatic = true;
        Body b = Bar(simulator, 100);
        PinJoint joint = _joints.CreatePinJoint(simulator, a, new Vector2(10, 0), b, new Vector2(-10, 0));
        Assert.Equal(80, joint.TargetDistance);
        Assert.Equal(new Vector2(10, 0), joint.WorldAnchor1);
        Assert.Equal(new Vector2(90, 0), joint.WorldAnchor2);
        Assert.Same(a, joint.Body1);
        Assert.Same(b, joint.Body2);
        Sandbox.Run(simulator, 150);
        Assert.Equal(80, Vector2.Distance(joint.WorldAnchor1, joint.WorldAnchor2), 1e-3f);
        joint.Anchor1 = Vector2.Zero;
        joint.Anchor2 = Vector2.Zero;
        joint.TargetDistance = 60;
        Sandbox.Run(simulator, 300);
        Assert.Equal(60, Vector2.Distance(a.Position, b.Position), 1e-2f);
        joint.Body1 = Bar(simulator, 0);
        joint.Body1.IsStatic = true;
        Sandbox.Run(simulator, 10);
        Assert.Equal(60, Vector2.Distance(joint.Body1.Position, b.Position), 1e-2f);
    }

    [Fact]
    [ManualRow("F129")]
    [ManualRow("F130")]
    [ManualRow("F131")]
    [ManualRow("F132")]
    [ManualRow("F134")]
    [ManualRow("F135")]
    [ManualRow("F136")]
    [ManualRow("F137")]
    [ManualRow("F139")]
    public void SliderJoint_KeepsTheDistanceBetweenItsLimits()
    {
        PhysicsSimulator simulator = Sandbox.Falling();
        Body a = Bar(simulator, 0);
        a.IsStatic = true;
        Body b = Bar(simulator, 30);
        SliderJoint joint = _joints.CreateSliderJoint(simulator, a, Vector2.Zero, b, Vector2.Zero, 20, 60);
        Assert.Equal((20f, 60f, 0.01f, 40f), (joint.Min, joint.Max, joint.Slop, joint.TargetDistance));
        float least = 100;
        float most = 0;
        for (int i = 0; i < 400; i++)
        {
            simulator.Update(Sandbox.Step);
            float distance = Vector2.Distance(joint.WorldAnchor1, joint.WorldAnchor2);
            least = Math.Min(least, distance);
            most = Math.Max(most, distance);
        }

        Assert.InRange(least, 20 - joint.Slop, 60);
        Assert.InRange(most, 59, 60.1f);
        joint.TargetDistance = 50;
        Assert.Equal((30f, 70f), (joint.Min, joint.Max));
        joint.Min = 10;
        joint.Max = 40;
        joint.Slop = 0.1f;
        joint.Anchor1 = joint.Anchor2 = new Vector2(1, 1);
        joint.Body1 = a;
        joint.Body2 = b;
        Sandbox.Run(simulator, 300);
        Assert.InRange(Vector2.Distance(joint.WorldAnchor1, joint.WorldAnchor2), 9, 41);
    }

    [Fact]
    [ManualRow("F140")]
    [ManualRow("F141")]
    [ManualRow("F142")]
    [ManualRow("F143")]
    [ManualRow("F144")]
    [ManualRow("F145")]
    public void GearJoint_TurnsTheSecondByTheRatioTheOtherWay()
    {
        PhysicsSimulator simulator = new PhysicsSimulator();
        Body a = Bar(simulator, 0);
        Body b = Bar(simulator, 40);
        GearJoint joint = _joints.CreateGearJoint(simulator, a, b, 2);
        Assert.Equal((2f, float.MaxValue), (joint.Ratio, joint.MaxImpulse));
        Assert.Same(a, joint.Body1);
        Assert.Same(b, joint.Body2);
        a.AngularVelocity = 3;
        Sandbox.Run(simulator, 100);
        Assert.True(a.TotalRotation > 0.3f);
        Assert.Equal(-2 * a.TotalRotation, b.TotalRotation, 1e-4f);

        // With hardly an impulse allowed it slips.
        joint.MaxImpulse = 1e-3f;
        float before = b.AngularVelocity;
        a.AngularVelocity = 30;
        Sandbox.Run(simulator, 10);
        Assert.Equal(before, b.AngularVelocity, 0.1f);
    }

    [Fact]
    [ManualRow("F059")]
    public void FixedAngleJoint_HoldsTheBodyAtItsTarget_AgainstATorque()
    {
        for (int i = -8; i <= 8; i++)
        {
            PhysicsSimulator simulator = new PhysicsSimulator();
            Body body = Bar(simulator, 0);
            FixedAngleJoint joint = _joints.CreateFixedAngleJoint(simulator, body);
            joint.TargetAngle = 0.4f * i;
            for (int step = 0; step < 150; step++)
            {
                body.ApplyTorque(500);
                simulator.Update(Sandbox.Step);
            }

            // With a bias of a fifth an update the torque turns it by 5·α·dt², at most.
            Assert.Equal(0.4f * i, body.TotalRotation, 5.1f * 500 * body.InverseMomentOfInertia * Sandbox.Step * Sandbox.Step);
            joint.Enabled = false;
            body.ApplyTorque(500);
            Sandbox.Run(simulator, 100);
            Assert.True(Math.Abs(body.TotalRotation - (0.4f * i)) > 0.03f);
        }
    }

    [Fact]
    [ManualRow("F064")]
    public void GearJoint_KeepsTheRatioOfTheAngles_WhicheverBodyIsTurned()
    {
        for (int i = -10; i <= 10; i++)
        {
            float ratio = 0.3f * i;
            PhysicsSimulator simulator = new PhysicsSimulator();
            Body a = Bar(simulator, 0);
            Body b = Bar(simulator, 100);
            GearJoint joint = _joints.CreateGearJoint(simulator, a, b, 7);
            joint.Ratio = ratio;
            Body turned = i % 2 == 0 ? a : b;
            for (int step = 0; step < 100; step++)
            {
                turned.ApplyTorque(5000);
                simulator.Update(Sandbox.Step);
            }

            Assert.True(turned.TotalRotation > 0.1f);
            Assert.Equal(-ratio * a.TotalRotation, b.TotalRotation, 1e-3f);
        }
    }

    [Fact]
    [ManualRow("F085")]
    public void PreStep_IsToldTheInverseOfTheTimeThatItPrepares()
    {
        foreach (int iterations in new[] { 1, 3, 5, 10 })
        {
            foreach (float dt in new[] { 0.005f, 0.01f, 1 / 60f })
            {
                PhysicsSimulator simulator = new PhysicsSimulator { Iterations = iterations };
                var listener = new Listener(Bar(simulator, 0));
                simulator.Add(listener);
                simulator.Update(dt);
                simulator.Update(dt);

                // Once for each of the iterations, into which an update is cut, and each time before it is solved.
                Assert.Equal(2 * iterations, listener.Prepared.Count);
                Assert.All(listener.Prepared, inverse => Assert.Equal(iterations / dt, inverse, 1e-4f * iterations / dt));
                Assert.True(listener.WasPreparedFirst);
            }
        }
    }

    [Fact]
    [ManualRow("F108")]
    [ManualRow("F114")]
    [ManualRow("F115")]
    public void Bodies_OfAngleJoints_AreExchanged()
    {
        // The joint turns, or stops, the bodies that it has now, and no other.
        PhysicsSimulator simulator = new PhysicsSimulator();
        Body[] bodies = new Body[6];
        for (int i = 0; i < bodies.Length; i++)
        {
            bodies[i] = Bar(simulator, 60 * i);
        }

        AngleJoint turn = _joints.CreateAngleJoint(simulator, bodies[0], bodies[1]);
        simulator.Update(Sandbox.Step);
        turn.Body2 = bodies[2];
        Assert.Same(bodies[2], turn.Body2);
        turn.TargetAngle = 0.5f;
        Sandbox.Run(simulator, 150);
        Assert.Equal(0.5f, bodies[2].TotalRotation - bodies[0].TotalRotation, 1e-4f);
        Assert.Equal(0, bodies[1].TotalRotation);

        AngleLimitJoint limit = _joints.CreateAngleLimitJoint(simulator, bodies[3], bodies[1], -0.2f, 0.3f);
        simulator.Update(Sandbox.Step);
        limit.Body1 = bodies[4];
        simulator.Update(Sandbox.Step);
        limit.Body2 = bodies[5];
        Assert.Same(bodies[4], limit.Body1);
        Assert.Same(bodies[5], limit.Body2);
        bodies[4].IsStatic = true;
        bodies[5].AngularVelocity = 2;
        bodies[1].AngularVelocity = 2;
        bodies[3].AngularVelocity = -2;
        Sandbox.Run(simulator, 100);
        Assert.InRange(bodies[5].TotalRotation, 0.29f, 0.31f);
        Assert.True(bodies[1].TotalRotation > 1.5f && bodies[3].TotalRotation < -1.5f);
        bodies[5].AngularVelocity = -2;
        Sandbox.Run(simulator, 100);
        Assert.InRange(bodies[5].TotalRotation, -0.21f, -0.19f);
    }

    [Fact]
    [ManualRow("F116")]
    public void LowerLimit_OfAFixedAngleLimitJoint_StopsTheBody()
    {
        for (int i = 0; i < 12; i++)
        {
            PhysicsSimulator simulator = new PhysicsSimulator();
            Body body = Bar(simulator, 0);
            FixedAngleLimitJoint joint = _joints.CreateFixedAngleLimitJoint(simulator, body, -3, 3);
            joint.Slop = 0.002f;
            simulator.Update(Sandbox.Step);
            joint.LowerLimit = -0.1f - (0.2f * i);
            Assert.Equal(-0.1f - (0.2f * i), joint.LowerLimit);
            body.AngularVelocity = -5;
            Sandbox.Run(simulator, 100);
            Assert.InRange(body.TotalRotation, joint.LowerLimit - 0.003f, joint.LowerLimit + 0.01f);
        }
    }

    [Fact]
    [ManualRow("F133")]
    [ManualRow("F138")]
    public void AnchorAndMax_OfASliderJoint_AreTakenAsTheyAreSet()
    {
        for (int i = 0; i < 12; i++)
        {
            PhysicsSimulator simulator = Sandbox.Falling();
            Body a = Bar(simulator, 0);
            a.IsStatic = true;
            Body b = Bar(simulator, 30);
            b.LinearDragCoefficient = 4;
            SliderJoint joint = _joints.CreateSliderJoint(simulator, a, Vector2.Zero, b, Vector2.Zero, 0, 200);
            simulator.Update(Sandbox.Step);
            joint.Slop = 0.01f;

            // Each of the two in an update of its own: what is set last is not carried by the other.
            if (i % 2 == 0)
            {
                joint.Anchor1 = new Vector2(3 * i, -2 * i);
                simulator.Update(Sandbox.Step);
                joint.Max = 20 + (5 * i);
            }
            else
            {
                joint.Max = 20 + (5 * i);
                simulator.Update(Sandbox.Step);
                joint.Anchor1 = new Vector2(3 * i, -2 * i);
            }

            Assert.Equal((new Vector2(3 * i, -2 * i), 20 + (5 * i)), (joint.Anchor1, joint.Max));
            Sandbox.Run(simulator, 1500);

            // It hangs straight below the anchor, as far down as the rod goes.
            Assert.Equal(3 * i, b.Position.X, 0.05f);
            Assert.Equal((-2 * i) + 20 + (5 * i), b.Position.Y, 0.05f);
        }
    }

    private static Func<Vector2, Vector2, bool> Near(float tolerance) => (a, b) => Vector2.Distance(a, b) <= tolerance;

    private static Body Bar(PhysicsSimulator simulator, float x)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 40, 10, 1);
        body.Position = new Vector2(x, 0);
        return body;
    }

    private static Body Second(Joint joint) => joint is PairJoint pair ? pair.Body2 : ((WorldJoint)joint).Body;

    private static Joint[] All(PhysicsSimulator simulator)
    {
        Body New() => Bar(simulator, 0);
        return
        [
            _joints.CreateRevoluteJoint(New(), New(), Vector2.Zero),
            _joints.CreateFixedRevoluteJoint(New(), Vector2.Zero),
            _joints.CreateAngleJoint(New(), New()),
            _joints.CreateFixedAngleJoint(New()),
            _joints.CreateAngleLimitJoint(New(), New(), -1, 1),
            _joints.CreateFixedAngleLimitJoint(New(), -1, 1),
            _joints.CreatePinJoint(New(), Vector2.Zero, New(), Vector2.One),
            _joints.CreateSliderJoint(New(), Vector2.Zero, New(), Vector2.One, 0, 2),
            _joints.CreateGearJoint(New(), New(), 2),
            new PrismaticJoint(New(), New(), Vector2.Zero, Vector2.UnitX),
            new FixedPrismaticJoint(New(), Vector2.Zero, Vector2.UnitX),
            new PulleyJoint(New(), new Vector2(0, -9), Vector2.Zero, New(), new Vector2(9, -9), Vector2.Zero),
            new DistanceJoint(New(), Vector2.Zero, New(), Vector2.One),
            new WeldJoint(New(), New(), Vector2.Zero),
            new WheelJoint(New(), New(), Vector2.Zero, Vector2.UnitY),
            new TargetJoint(New(), Vector2.Zero),
            new RopeJoint(New(), Vector2.Zero, New(), Vector2.One, 5),
            new MotorJoint(New(), New()),
        ];
    }

    /// <summary>Hears when it is prepared.</summary>
    private sealed class Listener(Body body) : Joint
    {
        public System.Collections.Generic.List<float> Prepared { get; } = new System.Collections.Generic.List<float>();

        public bool WasPreparedFirst { get; private set; } = true;

        public override void Validate()
        {
            if (body.IsDisposed)
            {
                Dispose();
            }
        }

        public override void PreStep(float inverseDt) => Prepared.Add(inverseDt);

        public override void Update()
        {
            base.Update();
            WasPreparedFirst &= Prepared.Count > 0;
        }
    }

    /// <summary>Holds a body at the height 0.</summary>
    private sealed class Hook : Joint
    {
        private readonly string _name;
        private readonly Body _body;
        private readonly System.Collections.Generic.List<string> _log;
        private float _bias;
        private float _impulse;

        public Hook(string name, Body body, System.Collections.Generic.List<string> log)
        {
            _name = name;
            _body = body;
            _log = log;
        }

        public override void Validate()
        {
            if (_body.IsDisposed)
            {
                Dispose();
            }
        }

        public override void PreStep(float inverseDt)
        {
            _log.Add(_name + " prepared");
            JointError = _body.Position.Y;
            _bias = BiasFactor * inverseDt * JointError;
            _body.LinearVelocity.Y += _impulse * _body.InverseMass;
        }

        public override void Update()
        {
            base.Update();
            _log.Add(_name + " solved");
            float impulse = -(_body.LinearVelocity.Y + _bias) * _body.Mass;
            _impulse += impulse;
            _body.LinearVelocity.Y += impulse * _body.InverseMass;
        }
    }
}
