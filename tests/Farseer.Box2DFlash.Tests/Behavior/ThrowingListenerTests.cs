using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Contacts;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Behavior;

/// <summary>
/// Every member of a listener throws, each time it is called. The step is completed: the world is the same, bit for bit, as one whose
/// listeners return, they are called as often, and the first exception comes out of the call that they were called by.
/// </summary>
public class ThrowingListenerTests
{
    private const int Steps = 90;

    private static readonly string[] _members =
    [
        "b2ContactListener.Add", "b2ContactListener.Persist", "b2ContactListener.Remove", "b2ContactListener.Result",
        "b2ContactFilter.ShouldCollide", "b2BoundaryListener.Violation", "b2DestructionListener.SayGoodbyeJoint",
        "b2DestructionListener.SayGoodbyeShape", "b2DebugDraw.DrawPolygon", "b2DebugDraw.DrawSolidPolygon", "b2DebugDraw.DrawCircle",
        "b2DebugDraw.DrawSolidCircle", "b2DebugDraw.DrawSegment", "b2DebugDraw.DrawXForm",
    ];

    public static TheoryData<string> Members => new(_members.Where(m => m != "b2DebugDraw.DrawPolygon" && m != "b2DebugDraw.DrawCircle"));

    [Fact]
    public void Members_AreAllThatAreCalled()
    {
        Type[] types = [typeof(b2ContactListener), typeof(b2ContactFilter), typeof(b2BoundaryListener), typeof(b2DestructionListener),
            typeof(b2DebugDraw)];
        const BindingFlags Own = BindingFlags.Public | BindingFlags.Instance | BindingFlags.DeclaredOnly;
        IEnumerable<string> all = types.SelectMany(t =>
            t.GetMethods(Own).Where(m => m.IsVirtual && !m.IsFinal).Select(m => t.Name + "." + m.Name));

        Assert.Equal(_members.Order(StringComparer.Ordinal), all.Order(StringComparer.Ordinal));
    }

    [Theory]
    [MemberData(nameof(Members))]
    public void Member_ThrowsEachTime_TheCallIsCompleted(string member)
    {
        var calm = new Stage(null);
        var wild = new Stage(member);
        for (int step = 0; step < Steps; step++)
        {
            Both(() => calm.Act(step), () => wild.Act(step));
            Both(() => calm.World.Step(Bench.Dt, 10), () => wild.World.Step(Bench.Dt, 10));
        }

        Assert.True(wild.Thrown > 0, member + " was not called");

        void Both(Action act, Action thrower)
        {
            int before = wild.Thrown;
            act();
            Exception? caught = Record.Exception(thrower);

            Assert.Equal(wild.Thrown > before, caught is FormatException && caught.Message == member);
            Assert.Equal(wild.Thrown > before, caught is not null);
            Assert.Equal(calm.Tally, wild.Tally);
            Assert.Equal(calm.World.StateHash(), wild.World.StateHash());
            Assert.Equal(calm.World.GetBodyCount(), wild.World.GetBodyCount());
            Assert.Equal(calm.World.GetJointCount(), wild.World.GetJointCount());
        }
    }

    /// <summary>A world in which each member is called: a hopping ball, a box that leaves, a joint that goes with its body.</summary>
    private sealed class Stage
    {
        private readonly SortedDictionary<string, int> _tally = new(StringComparer.Ordinal);
        private readonly string? _thrower;
        private readonly b2Body _ball;
        private readonly b2Body _hung;

        public Stage(string? thrower)
        {
            _thrower = thrower;
            World = Bench.World(half: 30);
            World.SetContactListener(new Contacts(this));
            World.SetContactFilter(new Filter(this));
            World.SetBoundaryListener(new Boundary(this));
            World.SetDestructionListener(new Destruction(this));
            var draw = new Draw(this);
            draw.SetFlags(b2DebugDraw.e_shapeBit | b2DebugDraw.e_jointBit | b2DebugDraw.e_centerOfMassBit);
            World.SetDebugDraw(draw);
            Bench.Static(World, 0, -0.5f, 20, 0.5f);
            _ball = Bench.Ball(World, 0, 2, restitution: 0.8f);
            Bench.Dynamic(World, 3, 0.5f);
            Bench.Dynamic(World, 25, 20).SetLinearVelocity(new b2Vec2(40, 0));
            _hung = Bench.Ball(World, -5, 5);
            b2Body above = Bench.Static(World, -5, 8, 0.5f, 0.5f);
            b2RevoluteJointDef def = new();
            def.Initialize(above, _hung, new b2Vec2(-5, 8));
            World.CreateJoint(def);
        }

        public b2World World { get; }

        public IReadOnlyDictionary<string, int> Tally => _tally;

        public int Thrown { get; private set; }

        public void Act(int step)
        {
            if (step == 60)
            {
                World.DestroyBody(_hung);
            }
            else if (step == 70)
            {
                World.DestroyBody(_ball);
            }
        }

        public void Called(string member)
        {
            // How much is drawn is nobody's business: what throws while it draws leaves the rest of the picture out.
            if (!member.StartsWith("b2DebugDraw", StringComparison.Ordinal))
            {
                _tally[member] = _tally.GetValueOrDefault(member) + 1;
            }

            if (member == _thrower)
            {
                Thrown++;
                throw new FormatException(member);
            }
        }
    }

    private sealed class Contacts(Stage stage) : b2ContactListener
    {
        public override void Add(b2ContactPoint point) => stage.Called("b2ContactListener.Add");

        public override void Persist(b2ContactPoint point) => stage.Called("b2ContactListener.Persist");

        public override void Remove(b2ContactPoint point) => stage.Called("b2ContactListener.Remove");

        public override void Result(b2ContactResult point) => stage.Called("b2ContactListener.Result");
    }

    private sealed class Filter(Stage stage) : b2ContactFilter
    {
        public override bool ShouldCollide(b2Shape shape1, b2Shape shape2)
        {
            stage.Called("b2ContactFilter.ShouldCollide");
            return true;
        }
    }

    private sealed class Boundary(Stage stage) : b2BoundaryListener
    {
        public override void Violation(b2Body body) => stage.Called("b2BoundaryListener.Violation");
    }

    private sealed class Destruction(Stage stage) : b2DestructionListener
    {
        public override void SayGoodbyeJoint(b2Joint joint) => stage.Called("b2DestructionListener.SayGoodbyeJoint");

        public override void SayGoodbyeShape(b2Shape shape) => stage.Called("b2DestructionListener.SayGoodbyeShape");
    }

    private sealed class Draw(Stage stage) : b2DebugDraw
    {
        public override void DrawPolygon(b2Vec2[] vertices, int vertexCount, b2Color color) => stage.Called("b2DebugDraw.DrawPolygon");

        public override void DrawSolidPolygon(b2Vec2[] vertices, int vertexCount, b2Color color) =>
            stage.Called("b2DebugDraw.DrawSolidPolygon");

        public override void DrawCircle(b2Vec2 center, float radius, b2Color color) => stage.Called("b2DebugDraw.DrawCircle");

        public override void DrawSolidCircle(b2Vec2 center, float radius, b2Vec2 axis, b2Color color) =>
            stage.Called("b2DebugDraw.DrawSolidCircle");

        public override void DrawSegment(b2Vec2 p1, b2Vec2 p2, b2Color color) => stage.Called("b2DebugDraw.DrawSegment");

        public override void DrawXForm(b2XForm xf) => stage.Called("b2DebugDraw.DrawXForm");
    }
}
