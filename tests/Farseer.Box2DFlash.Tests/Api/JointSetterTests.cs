using System;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

/// <summary>What is set on a joint acts from the next step on, and wakes its bodies.</summary>
public sealed class JointSetterTests
{
    private static readonly (string Name, Func<b2World, b2Body, b2Body, b2Joint> Make, Action<b2Joint> Set)[] _setters =
    [
        ("hinge, speed", Hinge, j => ((b2DrivenJoint)j).SetMotorSpeed(2)),
        ("hinge, motor", Hinge, j => ((b2DrivenJoint)j).EnableMotor(true)),
        ("hinge, limit", Hinge, j => ((b2DrivenJoint)j).EnableLimit(true)),
        ("hinge, limits", Hinge, j => ((b2DrivenJoint)j).SetLimits(-1, 1)),
        ("hinge, torque", Hinge, j => ((b2RevoluteJoint)j).SetMaxMotorTorque(5)),
        ("slider, speed", Slider, j => ((b2DrivenJoint)j).SetMotorSpeed(2)),
        ("slider, limits", Slider, j => ((b2DrivenJoint)j).SetLimits(-1, 1)),
        ("slider, force", Slider, j => ((b2PrismaticJoint)j).SetMaxMotorForce(5)),
        ("rod, length", Rod, j => ((b2DistanceJoint)j).SetLength(1)),
        ("rod, frequency", Rod, j => ((b2DistanceJoint)j).SetFrequency(3)),
        ("rod, damping", Rod, j => ((b2DistanceJoint)j).SetDampingRatio(1)),
    ];

    public static TheoryData<string, bool, bool> Setters()
    {
        TheoryData<string, bool, bool> data = [];
        foreach ((string name, _, _) in _setters)
        {
            data.Add(name, false, false);
            data.Add(name, false, true);
            data.Add(name, true, false);
            data.Add(name, true, true);
        }

        return data;
    }

    /// <summary>The sleeper is the first body or the second, and has seen a step or not.</summary>
    [Theory]
    [MemberData(nameof(Setters))]
    public void Setter_WakesTheBody_UnlessItIsToWakeNobody(string name, bool isFirst, bool isStepped)
    {
        foreach (Box2DFlash202Quirks quirk in new[] { Box2DFlash202Quirks.None, Box2DFlash202Quirks.SettersWakeNobody })
        {
            b2World world = Bench.World(0);
            world.Quirks = quirk;
            b2Body still = Bench.Static(world, 0, 0, 0.5f, 0.5f);
            b2Body body = Bench.Dynamic(world, 3, 0);
            b2Body other = Bench.Dynamic(world, 10, 0);
            (_, Func<b2World, b2Body, b2Body, b2Joint> make, Action<b2Joint> set) = Array.Find(_setters, s => s.Name == name);
            b2Joint joint = isFirst ? make(world, body, still) : make(world, still, body);
            Bench.Step(world, isStepped ? 1 : 0);
            body.PutToSleep();
            other.PutToSleep();
            Bench.Step(world, isStepped ? 1 : 0);
            Assert.True(body.IsSleeping());
            set(joint);
            Assert.Equal(quirk == Box2DFlash202Quirks.SettersWakeNobody, body.IsSleeping());
            Assert.True(other.IsSleeping());
        }
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void MotorOfASleeper_SetWithoutWakingIt_DrivesItWhenItWakes(bool isStepped)
    {
        b2World world = Bench.World(0);
        b2Body a = Bench.Dynamic(world, 0, 0);
        b2Body b = Bench.Dynamic(world, 3, 0);
        var hinge = (b2RevoluteJoint)Hinge(world, a, b);
        Bench.Step(world, isStepped ? 1 : 0);
        a.PutToSleep();
        b.PutToSleep();
        Bench.Step(world, isStepped ? 1 : 0);
        world.Quirks = Box2DFlash202Quirks.SettersWakeNobody;
        hinge.SetMaxMotorTorque(100);
        hinge.EnableMotor(true);
        hinge.SetMotorSpeed(2);
        hinge.SetLimits(-0.5f, 0.75f);
        hinge.EnableLimit(true);
        Bench.Step(world, 60);
        Assert.True(a.IsSleeping() && b.IsSleeping());
        Assert.Equal((0f, 3f, 0f), (a.GetPosition().x, b.GetPosition().x, hinge.GetJointAngle()));
        b.WakeUp();
        Bench.Step(world, 6);
        Assert.Equal(2, hinge.GetJointSpeed(), 1e-3);
        Bench.Step(world, 60);

        // Limits hold to a milliradian.
        Assert.Equal(0.75, hinge.GetJointAngle(), 1e-3);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void MouseTarget_WakesItsBody_WithEitherRule(bool isStepped)
    {
        foreach (Box2DFlash202Quirks quirk in new[] { Box2DFlash202Quirks.None, Box2DFlash202Quirks.SettersWakeNobody })
        {
            b2World world = Bench.World(0);
            world.Quirks = quirk;
            b2Body body = Bench.Dynamic(world, 3, 0);
            b2MouseJointDef def = new() { body1 = world.GetGroundBody(), body2 = body, target = new b2Vec2(3, 0), maxForce = 10 };
            var joint = (b2MouseJoint)world.CreateJoint(def);
            Bench.Step(world, isStepped ? 1 : 0);
            body.PutToSleep();
            Bench.Step(world, isStepped ? 1 : 0);
            Assert.True(body.IsSleeping());
            joint.SetTarget(new b2Vec2(4, 0));
            Assert.False(body.IsSleeping());
            Bench.Step(world, 1);
            Assert.True(body.GetLinearVelocity().x > 0);
        }
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void LimitsAndForce_OfALiveJoint_ActAtOnce(bool isHinge)
    {
        b2World world = Bench.World(0);
        b2Body body = Bench.Dynamic(world, 3, 0);
        body.SetMass(new Box2D.Collision.Shapes.b2MassData { mass = 2, I = 2 });
        b2DrivenJoint joint;
        if (isHinge)
        {
            b2RevoluteJointDef hinge = new() { enableMotor = true, motorSpeed = 100, maxMotorTorque = 4 };
            hinge.Initialize(world.GetGroundBody(), body, body.GetPosition());
            joint = (b2DrivenJoint)world.CreateJoint(hinge);
        }
        else
        {
            b2PrismaticJointDef slider = new() { enableMotor = true, motorSpeed = 100, maxMotorForce = 4 };
            slider.Initialize(world.GetGroundBody(), body, body.GetPosition(), new b2Vec2(1, 0));
            joint = (b2DrivenJoint)world.CreateJoint(slider);
        }

        double Speed() => isHinge ? ((b2RevoluteJoint)joint).GetJointSpeed() : ((b2PrismaticJoint)joint).GetJointSpeed();
        double Way() => isHinge ? ((b2RevoluteJoint)joint).GetJointAngle() : ((b2PrismaticJoint)joint).GetJointTranslation();
        double Given() => isHinge ? ((b2RevoluteJoint)joint).GetMotorTorque() : ((b2PrismaticJoint)joint).GetMotorForce();
        void SetMost(float most)
        {
            if (isHinge)
            {
                ((b2RevoluteJoint)joint).SetMaxMotorTorque(most);
            }
            else
            {
                ((b2PrismaticJoint)joint).SetMaxMotorForce(most);
            }
        }

        // Half a second of 4 N on 2 kg, then of 10 N.
        Bench.Step(world, 30);
        Assert.Equal(1, Speed(), 1e-4);
        SetMost(10);
        Bench.Step(world, 30);
        Assert.Equal(3.5, Speed(), 1e-4);
        Assert.Equal(10, Given(), 1e-4);
        foreach (float bad in new[] { -1, float.NaN, float.PositiveInfinity })
        {
            Assert.Throws<ArgumentOutOfRangeException>(isHinge ? "torque" : "force", () => SetMost(bad));
            Assert.Throws<ArgumentOutOfRangeException>("lower", () => joint.SetLimits(-Math.Abs(bad), bad > 0 ? 1 : -2));
        }

        Assert.Throws<ArgumentOutOfRangeException>("upper", () => joint.SetLimits(0, float.NaN));
        Assert.Throws<ArgumentOutOfRangeException>("speed", () => joint.SetMotorSpeed(float.NegativeInfinity));
        Bench.Step(world, 1);
        Assert.Equal(10, Given(), 1e-4);
        Assert.Equal((100f, 0f, 0f), (joint.GetMotorSpeed(), joint.GetLowerLimit(), joint.GetUpperLimit()));

        // The motor goes on against each new limit, which holds to a millimetre or milliradian.
        joint.EnableLimit(true);
        foreach (float most in new[] { 0.5f, 0.25f, 0.75f })
        {
            joint.SetLimits(-1, most);
            Bench.Step(world, 120);
            Assert.Equal(most, Way(), 1e-3);
        }

        joint.SetMotorSpeed(-5);
        Bench.Step(world, 240);
        Assert.Equal(-1, Way(), 1e-3);
    }

    [Fact]
    public void LimitsOutOfOrder_AreKeptWhileTheyAreOff_AndNotSwitchedOn()
    {
        b2World world = Bench.World(0);
        b2Body body = Bench.Dynamic(world, 3, 0);
        b2RevoluteJointDef def = new() { lowerAngle = 1, upperAngle = -1 };
        def.Initialize(world.GetGroundBody(), body, body.GetPosition());
        var joint = (b2RevoluteJoint)world.CreateJoint(def);
        Assert.Throws<ArgumentOutOfRangeException>("lower", () => joint.EnableLimit(true));
        Assert.False(joint.IsLimitEnabled());
        joint.EnableLimit(false);
        Assert.Equal((1f, -1f), (joint.GetLowerLimit(), joint.GetUpperLimit()));
        joint.SetLimits(-1, 1);
        joint.EnableLimit(true);
        Assert.True(joint.IsLimitEnabled());
    }

    [Fact]
    public void Rod_MadeASpringAndBack_HangsByTheSpringAndByTheRod()
    {
        b2World world = Bench.World();
        b2Body ball = Bench.Ball(world, 0, -3);
        var rod = (b2DistanceJoint)Rod(world, world.GetGroundBody(), ball);
        rod.SetDampingRatio(1);
        foreach (float hz in new[] { 1, 0, 2, 0f })
        {
            rod.SetFrequency(hz);
            Bench.Step(world, 300);

            // A spring hangs lower by g/ω²; critically damped, it is there after 5 s. A rod keeps its length to a millimetre.
            double lower = hz > 0 ? 10 / Math.Pow(2 * Math.PI * hz, 2) : 0;
            Assert.Equal(3 + lower, -ball.GetPosition().y, 1e-3);
        }

        foreach (float bad in new[] { -1, float.NaN, float.PositiveInfinity })
        {
            Assert.Throws<ArgumentOutOfRangeException>("hz", () => rod.SetFrequency(bad));
            Assert.Throws<ArgumentOutOfRangeException>("length", () => rod.SetLength(bad));
            Assert.Throws<ArgumentOutOfRangeException>("ratio", () => rod.SetDampingRatio(bad));
        }

        Assert.Equal((0f, 3f, 1f), (rod.GetFrequency(), rod.GetLength(), rod.GetDampingRatio()));
    }

    private static b2Joint Hinge(b2World world, b2Body first, b2Body second)
    {
        b2RevoluteJointDef def = new();
        def.Initialize(first, second, new b2Vec2(1.5f, 0));
        return world.CreateJoint(def);
    }

    private static b2Joint Slider(b2World world, b2Body first, b2Body second)
    {
        b2PrismaticJointDef def = new();
        def.Initialize(first, second, new b2Vec2(1.5f, 0), new b2Vec2(1, 0));
        return world.CreateJoint(def);
    }

    private static b2Joint Rod(b2World world, b2Body first, b2Body second)
    {
        b2DistanceJointDef def = new();
        def.Initialize(first, second, first.GetPosition(), second.GetPosition());
        return world.CreateJoint(def);
    }
}
