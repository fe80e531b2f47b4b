using System;
using System.Collections.Generic;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

/// <summary>What definitions of joints take from their bodies, what they begin with, and which values they refuse.</summary>
public sealed class JointDefinitionTests
{
    // Places are below 20 m, where a float holds 10⁻⁶ m, and a few operations are between.
    private const float Close = 1e-5f;

    /// <summary>Values that are no finite number of the engine.</summary>
    public static TheoryData<string, Func<b2JointDef>, string> Refused()
    {
        TheoryData<string, Func<b2JointDef>, string> data = [];
        foreach (float bad in new[] { float.NaN, float.PositiveInfinity, float.NegativeInfinity })
        {
            b2Vec2 point = new(1, 1) { y = bad };
            void Add<T>(string name, Action<T> spoil)
                where T : b2JointDef, new() => data.Add(
                    $"{typeof(T).Name}, {bad}",
                    () =>
                    {
                        T def = new();
                        spoil(def);
                        return def;
                    },
                    name);

            Add<b2DistanceJointDef>("localAnchor1", d => d.localAnchor1 = point);
            Add<b2DistanceJointDef>("localAnchor2", d => d.localAnchor2 = point);
            Add<b2DistanceJointDef>("length", d => d.length = bad);
            Add<b2DistanceJointDef>("frequencyHz", d => d.frequencyHz = bad);
            Add<b2DistanceJointDef>("dampingRatio", d => d.dampingRatio = bad);
            Add<b2RevoluteJointDef>("localAnchor1", d => d.localAnchor1 = point);
            Add<b2RevoluteJointDef>("localAnchor2", d => d.localAnchor2 = point);
            Add<b2RevoluteJointDef>("referenceAngle", d => d.referenceAngle = bad);
            Add<b2RevoluteJointDef>("lowerAngle", d => d.lowerAngle = bad);
            Add<b2RevoluteJointDef>("upperAngle", d => d.upperAngle = bad);
            Add<b2RevoluteJointDef>("motorSpeed", d => d.motorSpeed = bad);
            Add<b2RevoluteJointDef>("maxMotorTorque", d => d.maxMotorTorque = bad);
            Add<b2PrismaticJointDef>("localAnchor1", d => d.localAnchor1 = point);
            Add<b2PrismaticJointDef>("localAnchor2", d => d.localAnchor2 = point);
            Add<b2PrismaticJointDef>("localAxis1", d => d.localAxis1 = point);
            Add<b2PrismaticJointDef>("referenceAngle", d => d.referenceAngle = bad);
            Add<b2PrismaticJointDef>("lowerTranslation", d => d.lowerTranslation = bad);
            Add<b2PrismaticJointDef>("upperTranslation", d => d.upperTranslation = bad);
            Add<b2PrismaticJointDef>("motorSpeed", d => d.motorSpeed = bad);
            Add<b2PrismaticJointDef>("maxMotorForce", d => d.maxMotorForce = bad);
            Add<b2PulleyJointDef>("groundAnchor1", d => d.groundAnchor1 = point);
            Add<b2PulleyJointDef>("groundAnchor2", d => d.groundAnchor2 = point);
            Add<b2PulleyJointDef>("localAnchor1", d => d.localAnchor1 = point);
            Add<b2PulleyJointDef>("localAnchor2", d => d.localAnchor2 = point);
            Add<b2PulleyJointDef>("length1", d => d.length1 = bad);
            Add<b2PulleyJointDef>("length2", d => d.length2 = bad);
            Add<b2PulleyJointDef>("maxLength1", d => d.maxLength1 = bad);
            Add<b2PulleyJointDef>("maxLength2", d => d.maxLength2 = bad);
            Add<b2PulleyJointDef>("ratio", d => d.ratio = bad);
            Add<b2MouseJointDef>("target", d => d.target = point);
            Add<b2MouseJointDef>("maxForce", d => d.maxForce = bad);
            Add<b2MouseJointDef>("frequencyHz", d => d.frequencyHz = bad);
            Add<b2MouseJointDef>("dampingRatio", d => d.dampingRatio = bad);
            Add<b2MouseJointDef>("timeStep", d => d.timeStep = bad);
        }

        foreach (bool isPulley in new[] { true, false })
        {
            foreach (float bad in new[] { 0, -1f })
            {
                data.Add(
                    "above 0, " + bad,
                    () => isPulley ? new b2PulleyJointDef { ratio = bad } : new b2MouseJointDef { frequencyHz = bad },
                    isPulley ? "ratio" : "frequencyHz");
            }
        }

        data.Add("negative", () => new b2DistanceJointDef { length = -1 }, "length");
        data.Add("negative", () => new b2DistanceJointDef { frequencyHz = -1 }, "frequencyHz");
        data.Add("negative", () => new b2DistanceJointDef { dampingRatio = -1 }, "dampingRatio");
        data.Add("negative", () => new b2RevoluteJointDef { maxMotorTorque = -1 }, "maxMotorTorque");
        data.Add("negative", () => new b2PrismaticJointDef { maxMotorForce = -1 }, "maxMotorForce");
        data.Add("negative", () => new b2PulleyJointDef { length1 = -1 }, "length1");
        data.Add("negative", () => new b2PulleyJointDef { length2 = -1 }, "length2");
        data.Add("negative", () => new b2MouseJointDef { maxForce = -1 }, "maxForce");
        data.Add("negative", () => new b2MouseJointDef { dampingRatio = -1 }, "dampingRatio");
        data.Add("order", () => new b2RevoluteJointDef { enableLimit = true, lowerAngle = 1 }, "lowerAngle");
        data.Add("order", () => new b2PrismaticJointDef { enableLimit = true, lowerTranslation = 1 }, "lowerTranslation");
        return data;
    }

    public static TheoryData<string> Kinds() => ["distance", "revolute", "prismatic", "pulley", "mouse"];

    [Theory]
    [MemberData(nameof(Refused), DisableDiscoveryEnumeration = true)]
    public void CreateJoint_OfABadValue_RefusesItByName_AndMakesNothing(string why, Func<b2JointDef> make, string name)
    {
        b2World world = Bench.World(0);
        b2JointDef def = make();
        def.body1 = Bench.Dynamic(world, 0, 0);
        def.body2 = Bench.Dynamic(world, 3, 0);
        Assert.True(
            Record.Exception(() => world.CreateJoint(def)) is ArgumentOutOfRangeException e && e.ParamName == name, $"{name}: {why}");
        AssertNothingMade(world, def);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void CreateJoint_WithoutTwoBodiesOfTheWorld_RefusesThemByName(string kind)
    {
        b2World world = Bench.World(0);
        b2Body a = Bench.Dynamic(world, 0, 0);
        b2Body b = Bench.Dynamic(world, 3, 0);
        b2Body stranger = Bench.Dynamic(Bench.World(0), 0, 0);
        b2Body dead = Bench.Dynamic(world, 6, 0);
        world.DestroyBody(dead);
        b2JointDef def = New(kind);
        foreach (b2Body bad in new[] { stranger, dead })
        {
            (def.body1, def.body2) = (bad, b);
            Assert.Throws<ArgumentException>("body1", () => world.CreateJoint(def));
            (def.body1, def.body2) = (a, bad);
            Assert.Throws<ArgumentException>("body2", () => world.CreateJoint(def));
        }

        (def.body1, def.body2) = (null, b);
        Assert.Throws<ArgumentNullException>("body1", () => world.CreateJoint(def));
        (def.body1, def.body2) = (a, null);
        Assert.Throws<ArgumentNullException>("body2", () => world.CreateJoint(def));
        (def.body1, def.body2) = (a, a);
        Assert.Throws<ArgumentException>("body2", () => world.CreateJoint(def));
        (def.body1, def.body2) = (a, b);
        AssertNothingMade(world, def);
        Assert.Same(world.CreateJoint(def), a.GetJointList()!.joint);
    }

    [Fact]
    public void Initialize_OfABadArgument_RefusesItByName_AndTakesNothing()
    {
        b2World world = Bench.World(0);
        b2Body a = Bench.Dynamic(world, 0, 0);
        b2Body b = Bench.Dynamic(world, 3, 0);
        b2Vec2 good = new(2, 1);
        b2DistanceJointDef rod = new();
        b2RevoluteJointDef hinge = new();
        b2PrismaticJointDef slider = new();
        b2PulleyJointDef pulley = new();
        Dictionary<b2JointDef, Action<b2Body, b2Body>> all = new()
        {
            [rod] = (first, second) => rod.Initialize(first, second, good, good),
            [hinge] = (first, second) => hinge.Initialize(first, second, good),
            [slider] = (first, second) => slider.Initialize(first, second, good, good),
            [pulley] = (first, second) => pulley.Initialize(first, second, good, good, good, good, 1),
        };
        foreach (Action<b2Body, b2Body> initialize in all.Values)
        {
            Assert.Throws<ArgumentNullException>("b1", () => initialize(null!, b));
            Assert.Throws<ArgumentNullException>("b2", () => initialize(a, null!));
        }

        foreach (b2Vec2? bad in new[] { null, new b2Vec2(float.NaN, 0), new b2Vec2(0, float.NegativeInfinity) })
        {
            void Refuses(string name, Action call) => Assert.Equal(name, Assert.ThrowsAny<ArgumentException>(call).ParamName);
            Refuses("anchor1", () => rod.Initialize(a, b, bad!, good));
            Refuses("anchor2", () => rod.Initialize(a, b, good, bad!));
            Refuses("anchor", () => hinge.Initialize(a, b, bad!));
            Refuses("anchor", () => slider.Initialize(a, b, bad!, good));
            Refuses("axis", () => slider.Initialize(a, b, good, bad!));
            Refuses("ga1", () => pulley.Initialize(a, b, bad!, good, good, good, 1));
            Refuses("ga2", () => pulley.Initialize(a, b, good, bad!, good, good, 1));
            Refuses("anchor1", () => pulley.Initialize(a, b, good, good, bad!, good, 1));
            Refuses("anchor2", () => pulley.Initialize(a, b, good, good, good, bad!, 1));
        }

        foreach (float bad in new[] { 0, -1, float.NaN, float.PositiveInfinity })
        {
            Assert.Throws<ArgumentOutOfRangeException>("r", () => pulley.Initialize(a, b, good, good, good, good, bad));
        }

        Assert.All(all.Keys, def => Assert.Equal((null, null), (def.body1, def.body2)));
        Assert.Equal((0f, 0f, 0f), (rod.localAnchor1.x, hinge.localAnchor2.y, slider.localAnchor1.x));
        Assert.Equal((1f, 0f, -1f), (rod.length, slider.localAxis1.y, pulley.localAnchor1.x));
    }

    [Fact]
    public void Gear_OfJointsThatItCannotTie_IsRefusedByName()
    {
        b2World world = Bench.World(0);
        b2Body ground = world.GetGroundBody();
        b2Body a = Bench.Dynamic(world, 0, 0);
        b2Body b = Bench.Dynamic(world, 3, 0);
        b2Joint Hinge(b2Body first, b2Body second)
        {
            b2RevoluteJointDef hinge = new();
            hinge.Initialize(first, second, second.GetPosition());
            return world.CreateJoint(hinge);
        }

        b2Joint one = Hinge(ground, a);
        b2Joint two = Hinge(ground, b);
        b2Joint same = Hinge(ground, a);
        b2Joint moving = Hinge(a, b);
        b2DistanceJointDef rod = new();
        rod.Initialize(ground, b, new b2Vec2(), b.GetPosition());
        b2Joint wrong = world.CreateJoint(rod);
        b2Joint dead = Hinge(ground, b);
        world.DestroyJoint(dead);
        int count = world.GetJointCount();
        b2GearJointDef def = new() { joint2 = two };
        Assert.Throws<ArgumentNullException>("joint1", () => world.CreateJoint(def));
        (def.joint1, def.joint2) = (one, null);
        Assert.Throws<ArgumentNullException>("joint2", () => world.CreateJoint(def));
        foreach ((b2Joint bad, string why) in new[] { (wrong, "hinges and sliders"), (moving, "static"), (dead, "destroyed") })
        {
            (def.joint1, def.joint2) = (bad, one);
            string first = Assert.Throws<ArgumentException>("joint1", () => world.CreateJoint(def)).Message;
            (def.joint1, def.joint2) = (one, bad);
            string second = Assert.Throws<ArgumentException>("joint2", () => world.CreateJoint(def)).Message;
            Assert.All([first, second], message => Assert.Contains(why, message, StringComparison.Ordinal));
        }

        (def.joint1, def.joint2) = (one, same);
        Assert.Throws<ArgumentException>("joint2", () => world.CreateJoint(def));
        def.joint2 = two;
        foreach (float bad in new[] { 0, float.NaN, float.PositiveInfinity })
        {
            def.ratio = bad;
            Assert.Throws<ArgumentOutOfRangeException>("ratio", () => world.CreateJoint(def));
        }

        Assert.Equal(count, world.GetJointCount());
        def.ratio = -2;
        Assert.Equal(-2, ((b2GearJoint)world.CreateJoint(def)).GetRatio());
    }

    [Fact]
    public void Initialize_OfTurnedBodies_TakesAnchorsAxisAndAngleInTheirFrames()
    {
        b2World world = Bench.World(0);
        b2Body a = Bench.Dynamic(world, 0, 0, 1, 0.5f);
        b2Body b = Bench.Dynamic(world, 0, 0, 1, 0.5f);
        a.SetXForm(new b2Vec2(-3, 2), 0.7f);
        b.SetXForm(new b2Vec2(5, -4), -1.9f);
        b2Vec2 first = new(1.5f, 2.5f);
        b2Vec2 second = new(6, -1);
        (double X, double Y) Local(b2Vec2 place, double x, double y, double angle) =>
            PlacedShape.Turned((place.x - x, place.y - y), -angle);
        void AssertLocal(b2Vec2 world1, b2Vec2 world2, b2Vec2 local1, b2Vec2 local2)
        {
            AssertAt(Local(world1, -3, 2, 0.7f), local1);
            AssertAt(Local(world2, 5, -4, -1.9f), local2);
        }

        b2DistanceJointDef rod = new() { frequencyHz = 3, dampingRatio = 0.5f, length = 99 };
        rod.Initialize(a, b, first, second);
        AssertLocal(first, second, rod.localAnchor1, rod.localAnchor2);
        Assert.Equal(Math.Sqrt((4.5 * 4.5) + (3.5 * 3.5)), rod.length, Close);
        Assert.Equal((0f, 0f), (rod.frequencyHz, rod.dampingRatio));

        b2RevoluteJointDef hinge = new();
        hinge.Initialize(a, b, first);
        AssertLocal(first, first, hinge.localAnchor1, hinge.localAnchor2);
        Assert.Equal(-2.6f, hinge.referenceAngle, Close);

        b2PrismaticJointDef slider = new();
        slider.Initialize(a, b, second, first);
        AssertLocal(second, second, slider.localAnchor1, slider.localAnchor2);
        AssertAt(Local(first, 0, 0, 0.7f), slider.localAxis1);
        Assert.Equal(-2.6f, slider.referenceAngle, Close);

        b2PulleyJointDef pulley = new();
        b2Vec2 over1 = new(1.5f, 9);
        b2Vec2 over2 = new(9, 3);
        pulley.Initialize(a, b, over1, over2, first, second, 2.5f);
        AssertLocal(first, second, pulley.localAnchor1, pulley.localAnchor2);
        Assert.Equal((6.5f, 5f, 2.5f), (pulley.length1, pulley.length2, pulley.ratio));

        // The rope is 6.5 + 2.5·5 = 19; what a side can have at most leaves 2 m of the other.
        Assert.Equal((19f - (2.5f * 2), (19f - 2) / 2.5f), (pulley.maxLength1, pulley.maxLength2));
        over1.x = 50;
        Assert.Equal((1.5f, 9f, 9f, 3f),
            (pulley.groundAnchor1.x, pulley.groundAnchor1.y, pulley.groundAnchor2.x, pulley.groundAnchor2.y));
        Assert.All(new b2JointDef[] { rod, hinge, slider, pulley }, d => Assert.Equal((a, b), (d.body1, d.body2)));
    }

    [Fact]
    public void Definitions_BeginWithTheValuesThatTheyPromise()
    {
        b2PulleyJointDef pulley = new();
        Assert.Equal((-1f, 1f, 1f, 1f), (pulley.groundAnchor1.x, pulley.groundAnchor1.y, pulley.groundAnchor2.x, pulley.groundAnchor2.y));
        Assert.Equal((-1f, 0f, 1f, 0f), (pulley.localAnchor1.x, pulley.localAnchor1.y, pulley.localAnchor2.x, pulley.localAnchor2.y));
        Assert.Equal((0f, 0f, 0f, 0f, 1f), (pulley.length1, pulley.length2, pulley.maxLength1, pulley.maxLength2, pulley.ratio));
        Assert.True(pulley.collideConnected);

        b2DistanceJointDef rod = new();
        Assert.Equal((1f, 0f, 0f), (rod.length, rod.frequencyHz, rod.dampingRatio));
        Assert.Equal((0f, 0f, 0f, 0f), (rod.localAnchor1.x, rod.localAnchor1.y, rod.localAnchor2.x, rod.localAnchor2.y));

        b2PrismaticJointDef slider = new();
        Assert.Equal((1f, 0f, 0f), (slider.localAxis1.x, slider.localAxis1.y, slider.referenceAngle));
        Assert.Equal((0f, 0f, 0f, 0f), (slider.lowerTranslation, slider.upperTranslation, slider.motorSpeed, slider.maxMotorForce));

        b2RevoluteJointDef hinge = new();
        Assert.Equal((0f, 0f, 0f), (hinge.referenceAngle, hinge.lowerAngle, hinge.upperAngle));
        Assert.Equal((0f, 0f), (hinge.motorSpeed, hinge.maxMotorTorque));
        Assert.False(slider.enableLimit || slider.enableMotor || hinge.enableLimit || hinge.enableMotor);

        b2MouseJointDef mouse = new();
        Assert.Equal((0f, 0f, 1f / 60), (mouse.target.x, mouse.target.y, mouse.timeStep));
        b2GearJointDef gear = new();
        Assert.Equal((null, null, 1f), (gear.joint1, gear.joint2, gear.ratio));
        Assert.All(new b2JointDef[] { rod, slider, hinge, mouse, gear }, d => Assert.False(d.collideConnected));
        Assert.All(new b2JointDef[] { rod, slider, hinge, mouse, gear, pulley }, d => Assert.Null(d.userData ?? d.body1 ?? d.body2));
    }

    [Fact]
    public void AnchorPoint_IsTheHingeInTheWorld_AndInTheFirstBodyWhileThereIsNone()
    {
        b2World world = Bench.World(0);
        b2Body a = Bench.Dynamic(world, 0, 0);
        b2Body b = Bench.Dynamic(world, 3, 0);
        a.SetXForm(new b2Vec2(4, -2), 0.5f);
        b.SetXForm(new b2Vec2(7, 1), -0.25f);
        b2RevoluteJointDef def = new() { localAnchor1 = new b2Vec2(2, 3) };
#pragma warning disable CS0618 // It is the old name that is tested.
        AssertAt((2, 3), def.anchorPoint);
        def.anchorPoint.x = 9;
        Assert.Equal(2, def.localAnchor1.x);
        Assert.Throws<ArgumentNullException>("b1", () => def.anchorPoint = new b2Vec2());
        def.body1 = a;
        double sin = Math.Sin(0.5);
        double cos = Math.Cos(0.5);
        AssertAt((4 + (2 * cos) - (3 * sin), -2 + (2 * sin) + (3 * cos)), def.anchorPoint);
        def.body2 = b;
        def.anchorPoint = new b2Vec2(5, 1);
        AssertAt((5, 1), def.anchorPoint);
#pragma warning restore CS0618
        b2RevoluteJointDef other = new();
        other.Initialize(a, b, new b2Vec2(5, 1));
        Assert.Equal(other.referenceAngle, def.referenceAngle);
        Assert.Equal((other.localAnchor2.x, other.localAnchor2.y), (def.localAnchor2.x, def.localAnchor2.y));
    }

    private static b2JointDef New(string kind) => kind switch
    {
        "distance" => new b2DistanceJointDef(),
        "revolute" => new b2RevoluteJointDef(),
        "prismatic" => new b2PrismaticJointDef(),
        "pulley" => new b2PulleyJointDef { length1 = 5, length2 = 5, maxLength1 = 8, maxLength2 = 8 },
        _ => new b2MouseJointDef(),
    };

    private static void AssertNothingMade(b2World world, b2JointDef def)
    {
        Assert.Equal(0, world.GetJointCount());
        Assert.Null(world.GetJointList());
        Assert.Null(def.body1!.GetJointList());
        Assert.Null(def.body2!.GetJointList());
    }

    private static void AssertAt((double X, double Y) wanted, b2Vec2 got)
    {
        Assert.Equal(wanted.X, got.x, Close);
        Assert.Equal(wanted.Y, got.y, Close);
    }
}
