using System;
using System.Linq;
using Box2D.Common;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

public sealed class JointTests
{
    [Fact]
    [ManualRow("B004", "B005", "B177", "B180", "B181", "B182", "B242", "B243")]
    public void Joints_OfEveryKind_HaveTwoDifferentBodies()
    {
        b2World world = Bench.World(0);
        b2Body a = Bench.Ball(world, 0, 0);
        b2Body b = Bench.Ball(world, 3, 0);
        b2Body ground = world.GetGroundBody();
        b2RevoluteJointDef hinge = new();
        hinge.Initialize(ground, a, a.GetPosition());
        b2PrismaticJointDef slider = new();
        slider.Initialize(ground, b, b.GetPosition(), new b2Vec2(1, 0));
        b2Joint first = world.CreateJoint(hinge);
        b2Joint second = world.CreateJoint(slider);
        b2DistanceJointDef rod = new();
        rod.Initialize(a, b, a.GetPosition(), b.GetPosition());
        b2PulleyJointDef pulley = new();
        pulley.Initialize(a, b, new b2Vec2(0, 5), new b2Vec2(3, 5), a.GetPosition(), b.GetPosition(), 1);
        b2MouseJointDef mouse = new() { body1 = ground, body2 = a, maxForce = 1 };
        b2GearJointDef gear = new() { body1 = a, body2 = b, joint1 = first, joint2 = second };
        (b2Joint Joint, int Type)[] all =
        [
            (first, b2Joint.e_revoluteJoint), (second, b2Joint.e_prismaticJoint), (world.CreateJoint(rod), b2Joint.e_distanceJoint),
            (world.CreateJoint(pulley), b2Joint.e_pulleyJoint), (world.CreateJoint(mouse), b2Joint.e_mouseJoint),
            (world.CreateJoint(gear), b2Joint.e_gearJoint),
        ];

        Assert.All(all, j => Assert.Equal(j.Type, j.Joint.GetType()));
        Assert.Same(ground, first.GetBody1());
        Assert.Same(a, first.GetBody2());
        rod.body2 = a;
        Assert.Throws<ArgumentException>(() => world.CreateJoint(rod));
        rod.body2 = null;
        Assert.Throws<ArgumentNullException>(() => world.CreateJoint(rod));
        Assert.Throws<ArgumentException>(() => Bench.World().CreateJoint(hinge));
    }

    [Fact]
    [ManualRow("B183")]
    public void LocalAnchors_OfAViolatedJoint_ArePulledTogether()
    {
        for (int i = 0; i < 12; i++)
        {
            // Anchors far off the centres, of turned bodies, and a distance that is not that of the anchors.
            b2World world = Bench.World(0);
            b2Body a = Bench.Dynamic(world, 0, 0, 1, 0.5f);
            b2Body b = Bench.Dynamic(world, 6, 1, 1, 0.5f);
            a.SetXForm(new b2Vec2(0, 0), 0.5f * i);
            b.SetXForm(new b2Vec2(6, 1), -0.3f * i);
            b2DistanceJointDef def = new()
            {
                body1 = a,
                body2 = b,
                length = 2 + (0.3f * i),
                localAnchor1 = new b2Vec2(0.9f, -0.4f),
                localAnchor2 = new b2Vec2(-0.7f, 0.3f),
            };
            b2Joint joint = world.CreateJoint(def);
            Assert.Equal(0, b2Math.b2Distance(a.GetWorldPoint(def.localAnchor1), joint.GetAnchor1()), 1e-6);
            Assert.Equal(0, b2Math.b2Distance(b.GetWorldPoint(def.localAnchor2), joint.GetAnchor2()), 1e-6);
            Bench.Step(world, 120);

            Assert.Equal(def.length, b2Math.b2Distance(a.GetWorldPoint(def.localAnchor1), b.GetWorldPoint(def.localAnchor2)), 1e-3);

            // The same for a hinge, whose anchors must meet.
            b2World other = Bench.World(0);
            b2Body c = Bench.Dynamic(other, 0, 0, 1, 0.5f);
            b2Body d = Bench.Dynamic(other, 3, 1, 1, 0.5f);
            d.SetXForm(new b2Vec2(3, 1), 0.2f * i);
            b2RevoluteJointDef hinge = new() { body1 = c, body2 = d, localAnchor1 = def.localAnchor1, localAnchor2 = def.localAnchor2 };
            other.CreateJoint(hinge);
            Bench.Step(other, 120);
            Assert.Equal(0, b2Math.b2Distance(c.GetWorldPoint(def.localAnchor1), d.GetWorldPoint(def.localAnchor2)), 1e-3);
        }
    }

    [Fact]
    [ManualRow("B250")]
    public void DistanceJoint_HasNoLimitsAndNoMotor()
    {
        string[] names = [.. typeof(b2DistanceJoint).GetMembers().Select(m => m.Name)];

        Assert.DoesNotContain(names, n => n.Contains("Limit", StringComparison.OrdinalIgnoreCase));
        Assert.DoesNotContain(names, n => n.Contains("Motor", StringComparison.OrdinalIgnoreCase));
        Assert.Equal(typeof(b2Joint), typeof(b2DistanceJoint).BaseType);

        // A rod holds its length whichever way it is loaded: no range, no drive.
        foreach (float load in new[] { -50f, -1, 1, 50 })
        {
            b2World world = Bench.World(0);
            b2Body ball = Bench.Ball(world, 2, 0);
            b2DistanceJointDef def = new();
            def.Initialize(world.GetGroundBody(), ball, new b2Vec2(0, 0), ball.GetPosition());
            world.CreateJoint(def);
            for (int step = 0; step < 60; step++)
            {
                ball.ApplyForce(new b2Vec2(load, 0), ball.GetPosition());
                world.Step(Bench.Dt, 10);
            }

            Assert.Equal(2, ball.GetPosition().x, 1e-3);
            Assert.Equal(0, ball.GetLinearVelocity().Length(), 1e-3);
        }
    }

    [Fact]
    [ManualRow("B184", "B186-B189", "B244", "B245")]
    public void DistanceJoint_KeepsItsLength_AndPullsAViolatedOneTogether()
    {
        b2World world = Bench.World();
        b2Body ball = Bench.Ball(world, 3, 10);
        b2DistanceJointDef def = new();
        def.Initialize(world.GetGroundBody(), ball, new b2Vec2(0, 10), ball.GetPosition());
        Assert.Equal(3, def.length, 1e-6f);
        b2Joint joint = world.CreateJoint(def);
        Bench.Step(world, 200);
        Assert.Equal(3, b2Math.b2Distance(joint.GetAnchor1(), joint.GetAnchor2()), 1e-3);

        b2World other = Bench.World(0);
        b2Body a = Bench.Ball(other, 0, 0);
        b2Body b = Bench.Ball(other, 2, 0);
        b2DistanceJointDef violated = new() { body1 = a, body2 = b, length = 2.5f };
        other.CreateJoint(violated);
        Bench.Step(other, 120);
        Assert.Equal(2.5, b2Math.b2Distance(a.GetPosition(), b.GetPosition()), 1e-2);
    }

    [Fact]
    [ManualRow("B190-B194", "B251", "B252")]
    public void RevoluteJoint_CountsItsAngleFromWhereItWasMade()
    {
        b2World world = Bench.World(0);
        b2Body bar = Bench.Dynamic(world, 1, 0, 1, 0.1f);
        bar.SetXForm(new b2Vec2(1, 0), 0.5f);
        b2RevoluteJointDef def = new();
        def.Initialize(world.GetGroundBody(), bar, new b2Vec2(0, 0));
        b2RevoluteJoint joint = (b2RevoluteJoint)world.CreateJoint(def);
        Assert.Equal(0, joint.GetJointAngle(), 1e-6);
        bar.SetAngularVelocity(1);
        bar.SetLinearVelocity(new b2Vec2(0, 1));
        Bench.Step(world, 30);

        Assert.Equal(1, joint.GetJointSpeed(), 0.01);
        Assert.Equal(0.5, joint.GetJointAngle(), 0.01);
        Assert.Equal(0, joint.GetAnchor2().Length(), 1e-3);
    }

    [Fact]
    [ManualRow("B006")]
    public void LimitsAndMotors_BoundAndDriveTheFreeMotion_OfHingesAndSliders()
    {
        foreach (bool back in new[] { false, true })
        {
            int way = back ? -1 : 1;
            b2World world = Bench.World(0);
            b2Body bar = Bench.Dynamic(world, 1, 0, 1, 0.1f);
            b2RevoluteJointDef hinge = new() { enableLimit = true, lowerAngle = -0.5f, upperAngle = 0.3f };
            hinge.enableMotor = true;
            hinge.motorSpeed = 2 * way;
            hinge.maxMotorTorque = 100;
            hinge.Initialize(world.GetGroundBody(), bar, new b2Vec2(0, 0));
            var turning = (b2RevoluteJoint)world.CreateJoint(hinge);
            b2Body block = Bench.Dynamic(world, 0, 5);
            b2PrismaticJointDef slider = new() { enableLimit = true, lowerTranslation = -1, upperTranslation = 2 };
            slider.enableMotor = true;
            slider.motorSpeed = 3 * way;
            slider.maxMotorForce = 100;
            slider.Initialize(world.GetGroundBody(), block, new b2Vec2(0, 5), new b2Vec2(1, 0));
            var sliding = (b2PrismaticJoint)world.CreateJoint(slider);
            Bench.Step(world, 6);

            // On the way the motors keep their speeds; at the ends the limits hold against them.
            Assert.Equal(2 * way, turning.GetJointSpeed(), 1e-2);
            Assert.Equal(3 * way, sliding.GetJointSpeed(), 1e-2);
            Bench.Step(world, 120);
            Assert.Equal(back ? -0.5 : 0.3, turning.GetJointAngle(), 1e-3);
            Assert.Equal(back ? -1 : 2, sliding.GetJointTranslation(), 1e-3);

            // Without limits they go on.
            turning.EnableLimit(false);
            sliding.EnableLimit(false);
            Bench.Step(world, 60);
            Assert.Equal((back ? -0.5 : 0.3) + (2 * way), turning.GetJointAngle(), 0.05);
            Assert.Equal((back ? -1 : 2) + (3 * way), sliding.GetJointTranslation(), 0.05);

            // Without motors nothing drives them.
            turning.EnableMotor(false);
            sliding.EnableMotor(false);
            bar.SetAngularVelocity(0);
            bar.SetLinearVelocity(new b2Vec2(0, 0));
            block.SetLinearVelocity(new b2Vec2(0, 0));
            double angle = turning.GetJointAngle();
            Bench.Step(world, 30);
            Assert.Equal(angle, turning.GetJointAngle(), 1e-3);
        }
    }

    [Fact]
    [ManualRow("B195-B197", "B201", "B202")]
    public void RevoluteLimit_HoldsTheRange()
    {
        b2World world = Bench.World();
        b2Body bar = Bench.Dynamic(world, 1, 0, 1, 0.1f);
        b2RevoluteJointDef def = new();
        def.Initialize(world.GetGroundBody(), bar, new b2Vec2(0, 0));
        Assert.Equal(0, def.referenceAngle);
        def.lowerAngle = -0.5f;
        def.upperAngle = 0.3f;
        def.enableLimit = true;
        b2RevoluteJoint joint = (b2RevoluteJoint)world.CreateJoint(def);
        Bench.Step(world, 120);

        Assert.Equal(-0.5, joint.GetJointAngle(), 0.01);
        Assert.True(joint.IsLimitEnabled());
        def.lowerAngle = 1;
        Assert.Throws<ArgumentOutOfRangeException>(() => world.CreateJoint(def));
        Assert.Throws<ArgumentOutOfRangeException>(() => joint.SetLimits(1, 0));
        Assert.Equal(-0.5f, joint.GetLowerLimit());
    }

    [Fact]
    [ManualRow("B185", "B198-B200", "B203", "B253-B255")]
    public void RevoluteMotor_HoldsItsSpeed_UpToItsTorque()
    {
        b2World world = Bench.World(0);
        b2Body wheel = Bench.Ball(world, 0, 0, 1);
        b2RevoluteJointDef def = new();
        def.Initialize(world.GetGroundBody(), wheel, new b2Vec2(0, 0));
        def.enableMotor = true;
        def.motorSpeed = 5;
        def.maxMotorTorque = 1;
        b2RevoluteJoint joint = (b2RevoluteJoint)world.CreateJoint(def);
        Bench.Step(world, 60);

        Assert.Equal(1 / wheel.GetInertia(), wheel.GetAngularVelocity(), 1e-3);
        Assert.Equal(1, joint.GetMotorTorque(), 1e-3);
        joint.SetMaxMotorTorque(100);
        Bench.Step(world, 10);
        Assert.Equal(5, joint.GetJointSpeed(), 1e-3);
        joint.SetMotorSpeed(0);
        joint.SetMaxMotorTorque(0.1f);
        Bench.Step(world, 60);
        Assert.Equal(5 - (0.1 / wheel.GetInertia()), joint.GetJointSpeed(), 1e-3);
        Assert.Throws<ArgumentOutOfRangeException>(() => joint.SetMaxMotorTorque(-1));
        Assert.Throws<ArgumentOutOfRangeException>(() => joint.SetMotorSpeed(float.NaN));
    }

    [Fact]
    [ManualRow("B256")]
    public void RevoluteMotor_TracksACosineAndAnAngle()
    {
        b2World world = Bench.World(0);
        b2Body wheel = Bench.Ball(world, 0, 0, 1);
        b2RevoluteJointDef def = new() { enableMotor = true, maxMotorTorque = 1000 };
        def.Initialize(world.GetGroundBody(), wheel, new b2Vec2(0, 0));
        b2RevoluteJoint joint = (b2RevoluteJoint)world.CreateJoint(def);
        for (int i = 0; i < 60; i++)
        {
            joint.SetMotorSpeed((float)Math.Cos(0.5 * i * Bench.Dt));
            world.Step(Bench.Dt, 10);
        }

        Assert.Equal(Math.Cos(0.5 * 59 * Bench.Dt), joint.GetJointSpeed(), 1e-3);
        for (int i = 0; i < 600; i++)
        {
            joint.SetMotorSpeed(-0.1f * (joint.GetJointAngle() - 2) * 60);
            world.Step(Bench.Dt, 10);
        }

        Assert.Equal(2, joint.GetJointAngle(), 1e-3);
    }

    [Fact]
    [ManualRow("B206-B216", "B257-B261")]
    public void PrismaticJoint_SlidesBetweenLimits_DrivenByItsMotor()
    {
        b2World world = Bench.World(0);
        b2Body slider = Bench.Dynamic(world, 0, 0);
        b2PrismaticJointDef def = new();
        def.Initialize(world.GetGroundBody(), slider, new b2Vec2(0, 0), new b2Vec2(2, 0));
        def.lowerTranslation = -1;
        def.upperTranslation = 1.5f;
        def.enableLimit = true;
        def.enableMotor = true;
        def.motorSpeed = 2;
        def.maxMotorForce = 50;
        b2PrismaticJoint joint = (b2PrismaticJoint)world.CreateJoint(def);
        Assert.Equal(0, joint.GetJointTranslation(), 1e-6);
        Bench.Step(world, 30);

        Assert.Equal(2, joint.GetJointSpeed(), 1e-2);

        // 50 N bring 1 kg to 2 m/s in 0.04 s, on the first 0.04 m.
        Assert.Equal(0.96, joint.GetJointTranslation(), 0.005);
        joint.SetMotorSpeed(-1);
        joint.SetMaxMotorForce(10);
        Bench.Step(world, 30);
        Assert.Equal(-1, joint.GetJointSpeed(), 1e-2);
        Assert.True(Math.Abs(joint.GetMotorForce()) <= 10.01);
        joint.SetMotorSpeed(2);
        slider.ApplyImpulse(new b2Vec2(0, 1), new b2Vec2(0.5f, 0));
        Bench.Step(world, 120);
        Assert.Equal(1.5, joint.GetJointTranslation(), 0.01);
        Assert.Equal(0, slider.GetAngle(), 1e-3);
        Assert.Equal(0, slider.GetPosition().y, 1e-3);
        Bench.AssertOldName(typeof(b2PrismaticJoint).GetMethod("SetMotorForce"), "SetMaxMotorForce");
        def.localAxis1.Set(0, 0);
        Assert.Throws<ArgumentException>(() => world.CreateJoint(def));
    }

    [Fact]
    [ManualRow("B217-B225", "B262", "B263")]
    public void PulleyJoint_KeepsTheRope_AndItsRatio()
    {
        b2World world = Bench.World();
        b2Body light = Bench.Dynamic(world, -2, 10);
        b2Body heavy = Bench.Body(world, 2, 10, Bench.BoxDef(0.5f, 0.5f, 3));
        b2PulleyJointDef def = new();
        def.Initialize(light, heavy, new b2Vec2(-2, 20), new b2Vec2(2, 20), light.GetPosition(), heavy.GetPosition(), 2);
        Assert.Equal((10f + 20f - 4, (10f + 20f - 2) / 2), (def.maxLength1, def.maxLength2));
        def.maxLength1 = 18;
        def.maxLength2 = 20;
        b2PulleyJoint joint = (b2PulleyJoint)world.CreateJoint(def);
        Bench.Step(world, 30);

        Assert.Equal(30, joint.GetLength1() + (2 * joint.GetLength2()), 0.01);
        Assert.Equal(-2 * heavy.GetLinearVelocity().y, light.GetLinearVelocity().y, 0.01);
        Assert.NotEqual(0, light.GetLinearVelocity().y, 0.1);
        Assert.Equal(2, joint.GetRatio());
        Bench.Step(world, 300);
        Assert.True(joint.GetLength1() <= 18.05 && joint.GetLength2() <= 20.05);
    }

    [Fact]
    [ManualRow("B226-B235", "B264")]
    public void GearJoint_TiesHingeAndSlider_AndGoesBeforeThem()
    {
        b2World world = Bench.World(0);
        b2Body wheel = Bench.Ball(world, 0, 0, 1);
        b2Body rack = Bench.Dynamic(world, 5, 0);
        b2RevoluteJointDef hinge = new() { enableMotor = true, motorSpeed = 2, maxMotorTorque = 1000 };
        hinge.Initialize(world.GetGroundBody(), wheel, wheel.GetPosition());
        b2PrismaticJointDef slider = new();
        slider.Initialize(world.GetGroundBody(), rack, rack.GetPosition(), new b2Vec2(0, 1));
        b2Joint joint1 = world.CreateJoint(hinge);
        b2Joint joint2 = world.CreateJoint(slider);
        b2GearJointDef def = new() { body1 = wheel, body2 = rack, joint1 = joint1, joint2 = joint2, ratio = -0.5f };
        b2GearJoint gear = (b2GearJoint)world.CreateJoint(def);
        Bench.Step(world, 60);

        double angle = ((b2RevoluteJoint)joint1).GetJointAngle();
        double travel = ((b2PrismaticJoint)joint2).GetJointTranslation();
        Assert.Equal(2, angle, 0.02);
        Assert.Equal(0, angle - (0.5 * travel), 1e-3);
        Assert.Equal(-0.5f, gear.GetRatio());
        world.DestroyJoint(joint1);
        Assert.Equal(1, world.GetJointCount());
        Assert.Throws<ArgumentException>(() => world.CreateJoint(def));
    }

    [Fact]
    [ManualRow("B236-B239")]
    public void MouseJoint_DrawsTheBodyToItsTarget()
    {
        b2World world = Bench.World(0);
        b2Body box = Bench.Dynamic(world, 0, 0);
        b2MouseJointDef def = new() { body1 = world.GetGroundBody(), body2 = box, maxForce = 1000 };
        b2MouseJoint joint = (b2MouseJoint)world.CreateJoint(def);
        joint.SetTarget(new b2Vec2(3, 2));
        Bench.Step(world, 120);

        Assert.Equal(3, box.GetPosition().x, 0.01);
        Assert.Equal(2, box.GetPosition().y, 0.01);
        Assert.Equal(3, joint.GetAnchor1().x);
        Assert.Equal(
            (5f, 0.7f, 0f), (new b2MouseJointDef().frequencyHz, new b2MouseJointDef().dampingRatio, new b2MouseJointDef().maxForce));
    }

    [Fact]
    [ManualRow("B241")]
    public void Joints_GoWithTheirBodies()
    {
        b2World world = Bench.World();
        b2Body a = Bench.Ball(world, 0, 0);
        b2Body b = Bench.Ball(world, 3, 0);
        b2DistanceJointDef def = new();
        def.Initialize(a, b, a.GetPosition(), b.GetPosition());
        world.CreateJoint(def);
        world.DestroyBody(a);
        Bench.Step(world, 10);

        Assert.Equal(0, world.GetJointCount());
        Assert.Null(b.GetJointList());
    }

    [Fact]
    [ManualRow("B247-B249")]
    public void Reaction_CarriesTheLoad()
    {
        b2World world = Bench.World();
        b2Body box = Bench.Dynamic(world, 0, 9);
        b2RevoluteJointDef def = new();
        def.Initialize(world.GetGroundBody(), box, new b2Vec2(0, 10));
        b2Joint joint = world.CreateJoint(def);
        b2Body arm = Bench.Dynamic(world, 11, 10, 1, 0.25f);
        b2RevoluteJointDef weld = new() { enableLimit = true };
        weld.Initialize(world.GetGroundBody(), arm, new b2Vec2(10, 10));
        b2Joint welded = world.CreateJoint(weld);
        Bench.Step(world, 20);

        Assert.Equal(10, joint.GetReactionForce().y, 1e-3);
        Assert.Equal(0, joint.GetReactionTorque());
        Assert.Equal(10, welded.GetReactionForce().y, 0.05);
        Assert.Equal(10, welded.GetReactionTorque(), 0.05);
    }
}
