using System;
using System.Linq;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Behavior;

/// <summary>Each flag brings its own wrong of the original back, and without it the answer is right.</summary>
public sealed class QuirkTests
{
    [Fact]
    public void EveryFlag_HasATestOfItsName()
    {
        string[] tests = [.. typeof(QuirkTests).GetMethods().Select(m => m.Name)];

        Assert.All(
            Enum.GetValues<Box2DFlash202Quirks>().Where(q => q != Box2DFlash202Quirks.None),
            q => Assert.Contains(tests, t => t.StartsWith(q + "_", StringComparison.Ordinal)));
    }

    [Fact]
    public void LocalPointVelocity_MixesTheComponentsUp()
    {
        b2Vec2 Of(Box2DFlash202Quirks quirks)
        {
            b2World world = World(quirks, 0);
            b2Body body = Bench.Dynamic(world, 0, 0);
            body.SetLinearVelocity(new b2Vec2(3, 1));
            body.SetAngularVelocity(2);
            return body.GetLinearVelocityFromLocalPoint(new b2Vec2(0.5f, 0.25f));
        }

        // v + ω × r, and (v.x + ω·ry, v.x − ω·rx).
        AssertVector(2.5f, 2, Of(Box2DFlash202Quirks.None));
        AssertVector(3.5f, 2, Of(Box2DFlash202Quirks.LocalPointVelocity));
    }

    [Fact]
    public void PrismaticForceSquared_SquaresTheForce()
    {
        b2Vec2 Of(Box2DFlash202Quirks quirks)
        {
            b2World world = World(quirks);
            b2Body slider = Bench.Dynamic(world, 0, 5);
            b2PrismaticJointDef def = new();
            def.Initialize(world.GetGroundBody(), slider, new b2Vec2(0, 5), new b2Vec2(1, 0));
            b2Joint joint = world.CreateJoint(def)!;
            Bench.Step(world, 30);
            return joint.GetReactionForce();
        }

        Assert.Equal(10, Of(Box2DFlash202Quirks.None).y, 0.01f);
        Assert.Equal(100, Of(Box2DFlash202Quirks.PrismaticForceSquared).y, 0.2f);
    }

    [Theory]
    [InlineData(Box2DFlash202Quirks.None)]
    [InlineData(Box2DFlash202Quirks.PrismaticForceSquared)]
    public void PrismaticForce_BeyondAFloat_IsTheLargestOne(Box2DFlash202Quirks quirks)
    {
        b2World world = World(quirks);
        b2Body slider = Bench.Dynamic(world, 0, 5);
        b2PrismaticJointDef def = new();
        def.Initialize(world.GetGroundBody(), slider, new b2Vec2(0, 5), new b2Vec2(1, 0));
        b2Joint joint = world.CreateJoint(def)!;
        slider.SetMass(new b2MassData { mass = 1e9f, I = 1e9f });
        slider.SetLinearVelocity(new b2Vec2(0, -1000));
        world.Step(1e-30f, 10);

        // 10¹² N·s in 10⁻³⁰ s.
        Assert.Equal(float.MaxValue, joint.GetReactionForce().y);
    }

    [Fact]
    public void PulleyForceSign_TurnsTheForceRound()
    {
        b2Vec2 Of(Box2DFlash202Quirks quirks)
        {
            b2World world = World(quirks);
            b2Body a = Bench.Dynamic(world, -2, 0);
            b2Body b = Bench.Dynamic(world, 2, 0);
            b2PulleyJointDef def = new();
            def.Initialize(a, b, new b2Vec2(-2, 10), new b2Vec2(2, 10), new b2Vec2(-2, 0), new b2Vec2(2, 0), 1);
            b2Joint joint = world.CreateJoint(def)!;
            Bench.Step(world, 30);
            return joint.GetReactionForce();
        }

        Assert.Equal(10, Of(Box2DFlash202Quirks.None).y, 0.01f);
        Assert.Equal(-10, Of(Box2DFlash202Quirks.PulleyForceSign).y, 0.01f);
    }

    [Fact]
    public void RevoluteTorqueOfLimitOnly_LeavesTheMotorOut()
    {
        float Of(Box2DFlash202Quirks quirks)
        {
            b2World world = World(quirks, 0);
            b2Body wheel = Bench.Ball(world, 0, 0);
            b2RevoluteJointDef def = new() { enableMotor = true, motorSpeed = 1000, maxMotorTorque = 2 };
            def.Initialize(world.GetGroundBody(), wheel, new b2Vec2());
            b2Joint joint = world.CreateJoint(def)!;
            Bench.Step(world, 5);
            return joint.GetReactionTorque();
        }

        Assert.Equal(2, Of(Box2DFlash202Quirks.None), 1e-3f);
        Assert.Equal(0, Of(Box2DFlash202Quirks.RevoluteTorqueOfLimitOnly), 1e-6f);
    }

    [Fact]
    public void LockedCallsDoNothing_InPlaceOfAnException()
    {
        Maker Of(Box2DFlash202Quirks quirks)
        {
            b2World world = World(quirks);
            Maker maker = new(world);
            world.SetContactListener(maker);
            Bench.Static(world, 0, -0.5f, 5, 0.5f);
            Bench.Dynamic(world, 0, 0.5f);
            try
            {
                Bench.Step(world, 5);
            }
            catch (InvalidOperationException e)
            {
                maker.Thrown = e;
            }

            Assert.Equal(3, world.GetBodyCount());
            return maker;
        }

        Assert.NotNull(Of(Box2DFlash202Quirks.None).Thrown);
        Maker quiet = Of(Box2DFlash202Quirks.LockedCallsDoNothing);
        Assert.Null(quiet.Thrown);
        Assert.True(quiet.Told > 0);
        Assert.Null(quiet.Made);
    }

    [Fact]
    public void SettersWakeNobody_LeavesASleeperAsleep()
    {
        bool Of(Box2DFlash202Quirks quirks)
        {
            b2World world = World(quirks);
            b2Body body = Bench.Dynamic(world, 0, 0);
            body.PutToSleep();
            body.SetLinearVelocity(new b2Vec2(1, 0));
            return body.IsSleeping();
        }

        Assert.False(Of(Box2DFlash202Quirks.None));
        Assert.True(Of(Box2DFlash202Quirks.SettersWakeNobody));
    }

    [Fact]
    public void StaticKeepsVelocity_UntilItHasMassAgain()
    {
        float Of(Box2DFlash202Quirks quirks)
        {
            b2World world = World(quirks, 0);
            b2Body body = Bench.Dynamic(world, 0, 0);
            body.SetLinearVelocity(new b2Vec2(4, 0));
            body.SetMass(new b2MassData());
            Bench.Step(world, 5);
            Assert.Equal(0, body.GetPosition().x);
            body.SetMassFromShapes();
            return body.GetLinearVelocity().x;
        }

        Assert.Equal(0, Of(Box2DFlash202Quirks.None));
        Assert.Equal(4, Of(Box2DFlash202Quirks.StaticKeepsVelocity));
    }

    [Fact]
    public void SpeedLimits_CutSpeedAndSpin()
    {
        (float Speed, float Spin) Of(Box2DFlash202Quirks quirks)
        {
            b2World world = World(quirks, 0);
            b2Body body = Bench.Ball(world, 0, 0);
            body.SetLinearVelocity(new b2Vec2(1000, 0));
            body.SetAngularVelocity(1000);
            Bench.Step(world, 1);
            return (body.GetLinearVelocity().x, body.GetAngularVelocity());
        }

        Assert.Equal((1000f, 1000f), Of(Box2DFlash202Quirks.None));
        Assert.Equal((200f, 250f), Of(Box2DFlash202Quirks.SpeedLimits));
    }

    [Fact]
    public void BoxOfTurnedBox_IsLargerThanTheTriangle()
    {
        float Of(Box2DFlash202Quirks quirks)
        {
            b2World world = World(quirks);
            b2PolygonDef def = new() { density = 1, vertexCount = 3 };
            def.vertices[0].Set(0, 0);
            def.vertices[1].Set(2, 1);
            def.vertices[2].Set(1, 1.25f);
            b2Body body = Bench.Body(world, 0, 0, def);
            b2AABB box = new();
            body.GetShapeList()!.ComputeAABB(box, body.GetXForm());
            return (box.upperBound.x - box.lowerBound.x) * (box.upperBound.y - box.lowerBound.y);
        }

        // The smallest box around the triangle lies along its long side, not along the axes.
        Assert.Equal(2.5f, Of(Box2DFlash202Quirks.None), 1e-3f);
        Assert.True(Of(Box2DFlash202Quirks.BoxOfTurnedBox) > 2.6f);
    }

    [Fact]
    public void MouseJointSlowsTurn_TakesTwoPercentAStep()
    {
        float Of(Box2DFlash202Quirks quirks)
        {
            b2Body body = Dragged(quirks, new b2Vec2(), out b2World world);
            body.SetAngularVelocity(1);
            Bench.Step(world, 10);
            return body.GetAngularVelocity();
        }

        Assert.Equal(1, Of(Box2DFlash202Quirks.None), 1e-4f);
        Assert.Equal(MathF.Pow(0.98f, 10), Of(Box2DFlash202Quirks.MouseJointSlowsTurn), 1e-3f);
    }

    [Fact]
    public void MouseJointStiffness_PullsFaster()
    {
        float Of(Box2DFlash202Quirks quirks)
        {
            b2Body body = Dragged(quirks, new b2Vec2(1, 0), out b2World world);
            Bench.Step(world, 3);
            return body.GetPosition().x;
        }

        float right = Of(Box2DFlash202Quirks.None);
        float stiff = Of(Box2DFlash202Quirks.MouseJointStiffness);
        Assert.True(stiff > 2 * right, $"{stiff} and {right}");
    }

    private static b2Body Dragged(Box2DFlash202Quirks quirks, b2Vec2 target, out b2World world)
    {
        world = World(quirks, 0);
        b2Body body = Bench.Ball(world, 0, 0);
        b2MouseJointDef def = new() { body1 = world.GetGroundBody(), body2 = body, maxForce = 1e6f, frequencyHz = 1, dampingRatio = 1 };
        def.target.Set(0, 0);
        ((b2MouseJoint)world.CreateJoint(def)!).SetTarget(target);
        return body;
    }

    private static b2World World(Box2DFlash202Quirks quirks, float gravity = -10)
    {
        b2World world = Bench.World(gravity, 1e5f);
        world.Quirks = quirks;
        return world;
    }

    private static void AssertVector(float x, float y, b2Vec2 got)
    {
        Assert.Equal(x, got.x, 1e-5f);
        Assert.Equal(y, got.y, 1e-5f);
    }

    private sealed class Maker(b2World world) : b2ContactListener
    {
        public int Told { get; private set; }

        public b2Body? Made { get; private set; }

        public Exception? Thrown { get; set; }

        public override void Add(b2ContactPoint point)
        {
            Told++;
            Made = world.CreateBody(new b2BodyDef());
        }
    }
}
