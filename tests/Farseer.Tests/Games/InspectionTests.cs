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

namespace Farseer.Tests.Games;

/// <summary>What is not meant so is told.</summary>
public sealed class InspectionTests
{
    private static readonly Dictionary<int, Func<PhysicsSimulator, object>> _scenes = new()
    {
        [1] = s =>
        {
            Geom geom = GeomFactory.Instance.CreateCircleGeom(s, new Body { Position = new Vector2(0, -300) }, 5, 8);
            return geom;
        },
        [2] = s => BodyFactory.Instance.CreateBody(s, 1, 1),
        [3] = s =>
        {
            Body body = Ball(s, new Vector2(0, -300)).Body;
            body.LinearVelocity = new Vector2(float.NaN, 0);
            s.Update(Step);
            return body;
        },
        [4] = s => Box(s, new Vector2(0, -3)),
        [5] = s =>
        {
            Box(s, new Vector2(0, -30));
            return Box(s, new Vector2(0, -49.98f));
        },
        [6] = s =>
        {
            s.AdaptIterations = false;
            Body one = Ball(s, new Vector2(0, -300)).Body;
            Body two = Ball(s, new Vector2(50, -300), mass: 1000).Body;
            return JointFactory.Instance.CreatePinJoint(s, one, Vector2.Zero, two, Vector2.Zero);
        },
        [7] = s =>
        {
            Geom zone = Box(s, new Vector2(0, -300));
            zone.IsSensor = true;
            zone.Body.IsStatic = true;
            zone.CollidesWith = CollisionCategory.None;
            return zone;
        },
        [8] = s =>
        {
            Geom geom = Box(s, new Vector2(0, -300));
            geom.CollisionCategories = CollisionCategory.Cat7;
            s.ListPresent().ForEach(g => g.CollidesWith = ReferenceEquals(g, geom) ? CollisionCategory.All : CollisionCategory.Cat1);
            return geom;
        },
        [9] = s =>
        {
            s.IsContinuousCollisionEnabled = false;
            Body body = Ball(s, new Vector2(0, -300)).Body;
            body.LinearVelocity = new Vector2(0, 5000);
            return body;
        },
        [10] = s =>
        {
            RopeJoint rope = JointFactory.Instance.CreateRopeJoint(
                s, Ball(s, new Vector2(0, -300)).Body, Vector2.Zero, Ball(s, new Vector2(50, -300)).Body, Vector2.Zero, 0);
            return rope;
        },
        [11] = s =>
        {
            Body one = Ball(s, new Vector2(0, -300)).Body;
            Body two = Ball(s, new Vector2(50, -300)).Body;
            one.IsStatic = true;
            two.IsKinematic = true;
            return JointFactory.Instance.CreateWeldJoint(s, one, two, Vector2.Zero);
        },
        [12] = s =>
        {
            FixedAngleLimitJoint joint = JointFactory.Instance.CreateFixedAngleLimitJoint(s, Ball(s, new Vector2(0, -300)).Body, 0, 1);
            joint.LowerLimit = 2;
            return joint;
        },
        [13] = s =>
        {
            Geom ball = Ball(s, new Vector2(0, -300));
            ball.RestitutionCoefficient = 1.5f;
            return ball;
        },
    };

    public static TheoryData<int> Numbers => new(_scenes.Keys);

    [Theory]
    [MemberData(nameof(Numbers))]
    public void Inspect_FindsTheKind_AndNamesTheObjectAndTheDial(int number)
    {
        PhysicsSimulator simulator = WithFloor(out Geom floor);
        floor.FrictionCoefficient = 0.5f;
        object subject = _scenes[number](simulator);
        ulong before = simulator.MotionHash();
        List<InspectionFinding> findings = simulator.Inspect();
        InspectionFinding found = Assert.Single(findings, f => f.Number == number);
        Assert.True(ReferenceEquals(subject, found.Subject) || number is 4 or 5, found.ToString());
        Assert.NotEqual("", found.Dial);
        Assert.StartsWith($"FI{number:00} ", found.ToString(), StringComparison.Ordinal);
        Assert.Equal(before, simulator.MotionHash());
    }

    [Fact]
    public void Inspect_OfASoundScene_FindsNothing()
    {
        PhysicsSimulator simulator = WithFloor(out Geom floor);
        floor.FrictionCoefficient = 0.5f;
        for (int i = 0; i < 5; i++)
        {
            Box(simulator, new Vector2(0, -10 - (20 * i))).FrictionCoefficient = 0.5f;
        }

        Assert.Empty(simulator.Inspect());
        Run(simulator, 100);
        Assert.Empty(simulator.Inspect());
    }

    [Fact]
    public void Limits_InTheWrongOrder_AreRefusedByNameAndValue()
    {
        var body = new Body();
        Assert.Contains(
            "2",
            Assert.Throws<ArgumentOutOfRangeException>("upperLimit", () => new FixedAngleLimitJoint(body, 3, 2)).Message,
            StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>("upperLimit", () => new AngleLimitJoint(body, new Body(), 3, 2));
        Assert.Throws<ArgumentOutOfRangeException>("max", () => JointFactory.Instance.CreateAngleLimitJoint(body, new Body(), 3, 2));
        Assert.Throws<ArgumentOutOfRangeException>("max", () => JointFactory.Instance.CreateFixedAngleLimitJoint(body, 3, 2));
        Assert.Throws<ArgumentOutOfRangeException>("max", () => new SliderJoint(body, Vector2.Zero, new Body(), Vector2.Zero, 3, 2));
    }

    [Fact]
    public void Text_OfThings_SaysWhatTheyAre()
    {
        PhysicsSimulator simulator = WithFloor(out Geom floor);
        Geom box = Box(simulator, new Vector2(3, -30));
        box.Name = "crate";
        Assert.Equal("Geom crate box at (3, -30)", box.ToString());
        Assert.StartsWith(
            "Body at (3, -30) turned 0, dynamic, mass 1, velocity (0, 0), spin 0", box.Body.ToString(), StringComparison.Ordinal);
        Assert.Contains("static", floor.Body.ToString(), StringComparison.Ordinal);
        simulator.Update(Step);
        Assert.Equal("PhysicsSimulator after 1 updates: 2 bodies (0 asleep), 2 geoms, 0 joints, 0 springs", simulator.ToString());
        Assert.StartsWith("FixedAngleJoint of [Body at", new FixedAngleJoint(box.Body).ToString(), StringComparison.Ordinal);
        Assert.Contains("1, 2", new Pose(1, 2, 3).ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Kinds_OfFindings_AreThoseOfTheScenes() => Assert.Equal(Enumerable.Range(1, 13), _scenes.Keys.Order());
}
