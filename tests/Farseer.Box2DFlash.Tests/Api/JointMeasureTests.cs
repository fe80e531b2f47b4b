using System;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

/// <summary>What joints say of themselves, against the motion of rigid bodies and the balance of forces.</summary>
public sealed class JointMeasureTests
{
    // 1 kg under 10 m/s² on an axis of this direction.
    private const double Weight = 10;
    private const double Slope = 0.9;

    [Theory]
    [InlineData(0, 0, 0, 0.4, 0, 0, 0)]
    [InlineData(0, 0, 0.7, 2.1, -1.3, 2.5, -1.5)]
    [InlineData(4096.5, -2048.25, -2.6, 0.4, 0.9, -3, 4)]
    [InlineData(-8192, 8000.75, 1.1, -1.9, 3.5, 1.25, 0)]
    [InlineData(1000, 3000, 9.5, 4, -8, 0, -2)]
    public void SliderSpeedAndTranslation_OfBodiesThatMoveAndSpin_AreThoseOfTheirAnchors(
        float x, float y, float angle1, float axis, float angle2, float spin1, float spin2)
    {
        b2World world = Bench.World(0, 1e5f);
        b2Body a = OffCentre(world, x, y, angle1, 0.5f, -0.25f);
        b2Body b = OffCentre(world, x + 4.5f, y - 3.25f, angle2, -0.75f, 0.5f);
        a.SetLinearVelocity(new b2Vec2(3, -2));
        a.SetAngularVelocity(spin1);
        b.SetLinearVelocity(new b2Vec2(-1.5f, 5));
        b.SetAngularVelocity(spin2);
        b2PrismaticJointDef def = new()
        {
            body1 = a,
            body2 = b,
            localAnchor1 = new b2Vec2(1.25f, 0.5f),
            localAnchor2 = new b2Vec2(-0.5f, 2),
            localAxis1 = new b2Vec2(3 * MathF.Cos(axis), 3 * MathF.Sin(axis)),
        };
        var joint = (b2PrismaticJoint)world.CreateJoint(def);

        double Translation(double t)
        {
            (double x1, double y1) = At(x, y, angle1, 0.5, -0.25, (3, -2, spin1), def.localAnchor1, t);
            (double x2, double y2) = At(x + 4.5, y - 3.25, angle2, -0.75, 0.5, (-1.5, 5, spin2), def.localAnchor2, t);
            double direction = axis + angle1 + (spin1 * t);
            return ((x2 - x1) * Math.Cos(direction)) + ((y2 - y1) * Math.Sin(direction));
        }

        // The differences are right to 10⁻⁸; axis, speeds and rotations are floats, of 10⁻⁷ of up to 60 m/s.
        const double H = 1e-5;
        Assert.Equal(Translation(0), joint.GetJointTranslation(), 1e-5);
        Assert.Equal((Translation(H) - Translation(-H)) / (2 * H), joint.GetJointSpeed(), 5e-5);
    }

    [Theory]
    [InlineData(false, false, 0, 0)]
    [InlineData(false, true, 100, 3)]
    [InlineData(false, true, -100, 2)]
    [InlineData(false, true, 0, 500)]
    [InlineData(true, false, 0, 0)]
    [InlineData(true, true, -100, 4)]
    [InlineData(true, true, 100, 1)]
    public void SliderForce_OnAnObliqueAxisOfATurnedBody_BalancesTheWeight(bool isLimited, bool isDriven, float speed, float most)
    {
        b2World world = Bench.World(-(float)Weight);
        b2Body frame = Bench.Static(world, 20, -7, 1, 1);
        frame.SetXForm(new b2Vec2(20, -7), 0.6f);
        b2Body block = Bench.Dynamic(world, 26, -3);
        b2PrismaticJointDef def = new()
        {
            enableLimit = isLimited,
            upperTranslation = 5,
            enableMotor = isDriven,
            motorSpeed = speed,
            maxMotorForce = most,
        };
        (double x, double y) = (Math.Cos(Slope), Math.Sin(Slope));
        def.Initialize(frame, block, block.GetPosition(), new b2Vec2((float)x, (float)y));
        var joint = (b2PrismaticJoint)world.CreateJoint(def);
        Bench.Step(world, 30);

        // The axis bears what is across it. Along it the weight is borne by a limit, or by a motor that is strong enough.
        double slide = Weight * y;
        double motor = !isDriven ? 0 : speed == 0 ? slide : Math.Sign(speed) * most;
        double along = isLimited ? slide : motor;
        double across = Weight * x;
        b2Vec2 force = joint.GetReactionForce();

        // Forces are sums of floats of 10 N over a step of 1/60 s: 60·10⁻⁶ N.
        Assert.Equal((along * x) - (across * y), force.x, 1e-3);
        Assert.Equal((along * y) + (across * x), force.y, 1e-3);
        Assert.Equal(motor, joint.GetMotorForce(), 1e-3);

        // Half a second with what is left of the weight, within one step in 30; limit and motor hold to a millimetre.
        double way = isLimited ? 0 : (along - slide) / 2 * 0.25;
        Assert.Equal(way, joint.GetJointTranslation(), (Math.Abs(way) / 29) + 1e-3);

        // The old measure: both parts squared.
        world.Quirks = Box2DFlash202Quirks.PrismaticForceSquared;
        b2Vec2 squared = joint.GetReactionForce();
        Assert.Equal((along * along * x) - (across * across * y), squared.x, 2e-2);
        Assert.Equal((along * along * y) + (across * across * x), squared.y, 2e-2);
    }

    [Fact]
    public void HingeAngleAndSpeed_OfTwoTurningBodies_AreThoseOfTheSecondAgainstTheFirst()
    {
        b2World world = Bench.World(0, 1e4f);
        b2Body a = OffCentre(world, 3000, -20, 7.5f, 0.5f, 0.25f);
        b2Body b = OffCentre(world, 3002, -20, -4, 0, 0.5f);
        a.SetAngularVelocity(2);
        b.SetAngularVelocity(-3.5f);
        var joint = (b2RevoluteJoint)world.CreateJoint(new b2RevoluteJointDef { body1 = a, body2 = b, referenceAngle = 0.25f });
        Assert.Equal(-4 - 7.5f - 0.25f, joint.GetJointAngle());
        Assert.Equal(-3.5f - 2, joint.GetJointSpeed());
    }

    [Fact]
    public void HingeWithoutLimitAndMotor_UnderLoad_GivesNoTorqueAtAll()
    {
        b2World world = Bench.World();
        b2Body last = world.GetGroundBody();
        b2RevoluteJoint[] joints = new b2RevoluteJoint[8];
        for (int i = 0; i < joints.Length; i++)
        {
            b2Body bar = Bench.Dynamic(world, (2 * i) + 1, 10 + (0.3f * i), 1, 0.2f + (0.1f * i));
            b2RevoluteJointDef def = new() { enableMotor = i % 2 == 1, maxMotorTorque = 3 };
            def.Initialize(last, bar, new b2Vec2(2 * i, 10));
            joints[i] = (b2RevoluteJoint)world.CreateJoint(def);
            last = bar;
        }

        for (int step = 0; step < 60; step++)
        {
            world.Step(Bench.Dt, 10);
            for (int i = 0; i < joints.Length; i += 2)
            {
                Assert.Equal(0, joints[i].GetReactionTorque());
                Assert.NotEqual(0, joints[i].GetReactionForce().Length());
            }
        }
    }

    /// <summary>
    /// The rope is 10 + 2.5·10 = 35 m. One side falls until its own largest length, or until the other side has only 2 m left.
    /// </summary>
    [Theory]
    [InlineData(2, 1, 1000, 1000, 30, 2)]
    [InlineData(2, 1, 22, 1000, 22, 5.2)]
    [InlineData(1, 10, 1000, 1000, 2, 13.2)]
    [InlineData(1, 10, 1000, 12, 5, 12)]
    public void Pulley_LetGo_StopsAtTheLengthsOfItsSides(
        float mass1, float mass2, float most1, float most2, double length1, double length2)
    {
        b2World world = Bench.World();
        b2Body Weighs(float x, float mass)
        {
            b2Body body = Bench.Body(world, x, 10, Bench.BoxDef(0.5f, 0.5f, mass));
            body.SetLinearDamping(2);
            return body;
        }

        b2Body first = Weighs(-4, mass1);
        b2Body second = Weighs(4, mass2);
        b2PulleyJointDef def = new();
        def.Initialize(first, second, new b2Vec2(-4, 20), new b2Vec2(4, 20), first.GetPosition(), second.GetPosition(), 2.5f);
        (def.maxLength1, def.maxLength2) = (most1, most2);
        var joint = (b2PulleyJoint)world.CreateJoint(def);
        Bench.Step(world, 900);

        // Joints hold their places to a millimetre.
        Assert.Equal(length1, joint.GetLength1(), 1e-3);
        Assert.Equal(length2, joint.GetLength2(), 1e-3);
    }

    /// <summary>Nothing moves when the gear is made, wherever its bodies are; then each coordinate drives the other.</summary>
    [Theory]
    [InlineData(1.5f)]
    [InlineData(-0.4f)]
    public void Gear_OfTurnedAndDisplacedBodies_KeepsTheSumOfItsCoordinates(float ratio)
    {
        b2World world = Bench.World(0);
        b2Body ground = world.GetGroundBody();
        b2Body wheel = Bench.Ball(world, -20, 13, 1);
        wheel.SetXForm(new b2Vec2(-20, 13), 0.7f);
        b2RevoluteJointDef hinge = new() { maxMotorTorque = 1e5f };
        hinge.Initialize(ground, wheel, new b2Vec2(-20, 13));
        var turning = (b2RevoluteJoint)world.CreateJoint(hinge);
        b2PrismaticJoint Slider(float x, float y, float angle, b2Vec2 axis)
        {
            b2Body frame = Bench.Static(world, x + 5, y + 7, 0.5f, 0.5f);
            frame.SetXForm(new b2Vec2(x + 5, y + 7), -0.8f);
            b2Body block = OffCentre(world, x, y, angle, 0.25f, -0.5f);
            b2PrismaticJointDef slider = new();
            slider.Initialize(frame, block, new b2Vec2(x + 1.5f, y - 0.75f), axis);
            return (b2PrismaticJoint)world.CreateJoint(slider);
        }

        b2PrismaticJoint one = Slider(12, -9, 1.2f, new b2Vec2(3, 4));
        b2PrismaticJoint two = Slider(-15, -30, -0.6f, new b2Vec2(-5, 12));
        b2Joint Gear(b2Joint first, b2Joint second) =>
            world.CreateJoint(new b2GearJointDef { joint1 = first, joint2 = second, ratio = ratio });
        b2Joint gear = Gear(turning, one);
        Gear(one, two);
        Assert.Equal((turning.GetAnchor2().x, one.GetAnchor2().y), (gear.GetAnchor1().x, gear.GetAnchor2().y));
        Bench.Step(world, 60);

        // The places are floats of up to 30 m, of 2·10⁻⁶ each.
        Assert.Equal(0, turning.GetJointAngle(), 1e-5);
        Assert.Equal(0, one.GetJointTranslation(), 1e-5);
        Assert.Equal(0, two.GetJointTranslation(), 1e-5);
        turning.EnableMotor(true);
        turning.SetMotorSpeed(2);
        Bench.Step(world, 60);

        // One second at 2 rad/s, less the start: 10⁵ N·m turn at most 100 kg·m² in 0.002 s, shared out in a step of 1/60 s.
        Assert.Equal(2, turning.GetJointAngle(), 2 * Bench.Dt);
        Assert.Equal(-turning.GetJointAngle() / ratio, one.GetJointTranslation(), 1e-3);
        Assert.Equal(-one.GetJointTranslation() / ratio, two.GetJointTranslation(), 1e-3);
    }

    [Fact]
    public void Mouse_AtABodyWhoseCentreIsElsewhere_HoldsThePointThatWasGripped()
    {
        b2World world = Bench.World(0);
        b2Body body = OffCentre(world, 5, -3, 0.8f, 0.75f, -0.5f);
        b2Vec2 grip = new(5.5f, -2.25f);
        var joint = (b2MouseJoint)world.CreateJoint(
            new b2MouseJointDef { body1 = world.GetGroundBody(), body2 = body, target = grip, maxForce = 1000 });
        Bench.Step(world, 60);

        // Floats of 5 m hold 5·10⁻⁷ m.
        Assert.Equal((5, -3, 0.8), (body.GetPosition().x, body.GetPosition().y, body.GetAngle()), Near(1e-5));
        Assert.Equal((5.5, -2.25, 0), (joint.GetAnchor2().x, joint.GetAnchor2().y, joint.GetReactionTorque()), Near(1e-5));
        joint.SetTarget(new b2Vec2(-4, 6));
        body.SetAngularDamping(3);
        Bench.Step(world, 300);

        // A damped spring of 5 Hz is at its target long before 5 s, when what turns about the grip has lost its swing: e⁻¹⁵.
        Assert.Equal((-4, 6, 0), (joint.GetAnchor2().x, joint.GetAnchor2().y, joint.GetReactionTorque()), Near(1e-2));
    }

    /// <summary>Stiffness and damping divided by the time step are frequency and damping ratio divided by its root.</summary>
    [Theory]
    [InlineData(1f / 60)]
    [InlineData(0.25f)]
    [InlineData(0)]
    [InlineData(-1)]
    public void MouseStiffnessQuirk_IsASpringOfFrequencyAndDampingOverTheRootOfTheStep(float timeStep)
    {
        float scale = timeStep > 0 ? MathF.Sqrt(1 / timeStep) : 1;
        b2Vec2 Of(Box2DFlash202Quirks quirks, float factor, int steps)
        {
            b2World world = Bench.World(0);
            world.Quirks = quirks;
            b2Body ball = Bench.Ball(world, 1, 2);
            b2MouseJointDef def = new()
            {
                body1 = world.GetGroundBody(),
                body2 = ball,
                target = new b2Vec2(1, 2),
                maxForce = 1e6f,
                frequencyHz = 0.5f * factor,
                dampingRatio = 0.1f * factor,
                timeStep = timeStep,
            };
            ((b2MouseJoint)world.CreateJoint(def)).SetTarget(new b2Vec2(4, -2));
            Bench.Step(world, steps);
            return ball.GetPosition().Copy();
        }

        foreach (int steps in new[] { 1, 5, 20 })
        {
            b2Vec2 wanted = Of(Box2DFlash202Quirks.None, scale, steps);
            b2Vec2 got = Of(Box2DFlash202Quirks.MouseJointStiffness, 1, steps);

            // The factor is rounded to a float here: 10⁻⁷ of a way of 5 m, in 20 steps.
            Assert.Equal(0, b2Math.b2Distance(wanted, got), 1e-5);
            Assert.NotEqual(1, got.x, 1e-3);
        }
    }

    [Fact]
    public void JointsAndEdges_AskedWhetherTheyAreThere_Tell()
    {
        b2World world = Bench.World(0);
        b2Body body = Bench.Ball(world, 0, 0);
        for (int i = 0; i < 3; i++)
        {
            b2RevoluteJointDef def = new();
            def.Initialize(world.GetGroundBody(), body, new b2Vec2(i, 0));
            world.CreateJoint(def);
        }

        int joints = 0;
        for (b2Joint? joint = world.GetJointList(); joint; joint = joint!.GetNext())
        {
            joints++;
        }

        int edges = 0;
        for (b2JointEdge? edge = body.GetJointList(); edge; edge = edge!.next)
        {
            edges++;
        }

        Assert.Equal((3, 3), (joints, edges));
        b2Joint? noJoint = null;
        b2JointEdge? noEdge = null;
        Assert.True(!noJoint && !noEdge);
        Assert.False(!world.GetJointList() || !body.GetJointList());
        Assert.True(Is<b2Joint>("False", null) && Is<b2JointEdge>("False", null));
        Assert.False(Is("False", world.GetJointList()) || Is("False", body.GetJointList()));
        Assert.False(Is<b2Joint>("True", null) || Is<b2JointEdge>("True", null));
    }

    private static bool Is<T>(string name, T? value) => (bool)typeof(T).GetMethod("op_" + name)!.Invoke(null, [value])!;

    private static b2Body OffCentre(b2World world, float x, float y, float angle, float centreX, float centreY)
    {
        b2Body body = Bench.Dynamic(world, x, y);
        body.SetMass(new b2MassData { mass = 2, I = 1.5f, center = new b2Vec2(centreX, centreY) });
        body.SetXForm(new b2Vec2(x, y), angle);
        return body;
    }

    /// <summary>Where a point of a body is after a time, which its centre goes straight on and in which it turns evenly.</summary>
    private static (double X, double Y) At(
        double x, double y, double angle, double centreX, double centreY, (double X, double Y, double Spin) moves, b2Vec2 local, double t)
    {
        (double cx, double cy) = PlacedShape.Turned((centreX, centreY), angle);
        (double ax, double ay) = PlacedShape.Turned((local.x - centreX, local.y - centreY), angle + (moves.Spin * t));
        return (x + cx + (moves.X * t) + ax, y + cy + (moves.Y * t) + ay);
    }

    private static Comparison Near(double tolerance) => new(tolerance);

    private sealed class Comparison(double tolerance) : System.Collections.Generic.IEqualityComparer<(double X, double Y, double Z)>
    {
        public bool Equals((double X, double Y, double Z) a, (double X, double Y, double Z) b) =>
            Math.Abs(a.X - b.X) <= tolerance && Math.Abs(a.Y - b.Y) <= tolerance && Math.Abs(a.Z - b.Z) <= tolerance;

        public int GetHashCode((double X, double Y, double Z) value) => 0;
    }
}
