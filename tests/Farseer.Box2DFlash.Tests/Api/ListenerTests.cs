using System;
using System.Collections.Generic;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Contacts;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

public sealed class ListenerTests
{
    [Fact]
    [ManualRow("B007", "B265-B270", "B273-B280", "B283-B286", "B288", "B289", "B297")]
    public void Contacts_AreToldFromFirstTouchToLast()
    {
        b2World world = Bench.World();
        Recorder recorder = new();
        world.SetContactListener(recorder);
        b2Body ground = Bench.Static(world, 0, -0.5f, 5, 0.5f);
        b2Body box = Bench.Dynamic(world, 0, 1.5f);
        Bench.Step(world, 60);

        Assert.Equal(2, recorder.Count("Add"));
        Assert.True(recorder.Count("Persist") > 20);
        Assert.Equal(0, recorder.Count("Remove"));
        Assert.Equal(1, recorder.LastNormal.y, 1e-3);
        Assert.True(Math.Abs(recorder.LastSeparation) < 0.01);
        Assert.Equal(10 * Bench.Dt, recorder.ImpulseOfLastStep, 0.01);
        Assert.Same(ground, recorder.First);
        Assert.Same(box, recorder.Second);
        Assert.True(recorder.Ids.Count == 2);
        b2Contact contact = world.GetContactList()!;
        Assert.True(contact.IsSolid());
        Assert.Same(ground.GetShapeList(), contact.GetShape1());
        box.SetXForm(new b2Vec2(0, 20), 0);
        Assert.Equal(2, recorder.Count("Remove"));
    }

    [Fact]
    public void Result_OfABounce_IsTheWholeBlow()
    {
        b2World world = Bench.World(0);
        Recorder recorder = new();
        world.SetContactListener(recorder);
        Bench.Static(world, 5, 0, 0.5f, 5);
        b2Body ball = Bench.Ball(world, 0, 0, 0.5f, 0.5f);
        ball.SetLinearVelocity(new b2Vec2(4, 0));
        for (int i = 0; i < 120 && ball.GetLinearVelocity().x > 0; i++)
        {
            world.Step(Bench.Dt, 10);
        }

        Assert.Equal(-2, ball.GetLinearVelocity().x, 0.01);
        Assert.Equal(6 * ball.GetMass(), recorder.ImpulseOfLastStep, 0.05);
    }

    [Fact]
    [ManualRow("B281", "B282")]
    public void Points_AreOneObjectUsedAgain()
    {
        b2World world = Bench.World();
        Recorder recorder = new();
        world.SetContactListener(recorder);
        Bench.Static(world, 0, -0.5f, 5, 0.5f);
        Bench.Dynamic(world, 0, 0.51f);
        Bench.Step(world, 30);

        Assert.Single(recorder.Objects);
    }

    [Fact]
    [ManualRow("B287")]
    public void ChangesWithinACallback_AreRefused_AndVelocitiesAllowed()
    {
        b2World world = Bench.World();
        List<Exception> errors = [];
        b2Body other = Bench.Ball(world, 9, 9);
        b2RevoluteJointDef def = new();
        def.Initialize(world.GetGroundBody(), other, other.GetPosition());
        world.SetContactListener(new Doer(() =>
        {
            Action[] calls =
            [
                () => world.CreateBody(new b2BodyDef()), () => world.DestroyBody(other), () => other.CreateShape(new b2CircleDef()),
                () => other.DestroyShape(other.GetShapeList()!), () => other.SetMassFromShapes(), () => other.SetMass(new b2MassData()),
                () => other.SetXForm(new b2Vec2(), 0), () => world.CreateJoint(def), () => world.Refilter(other.GetShapeList()!),
                () => world.Step(Bench.Dt, 1),
            ];
            foreach (Action call in calls)
            {
                errors.Add(Assert.Throws<InvalidOperationException>(call));
            }

            other.SetLinearVelocity(new b2Vec2(1, 0));
        }));
        Bench.Static(world, 0, -0.5f, 5, 0.5f);
        Bench.Dynamic(world, 0, 0.51f);
        Bench.Step(world, 30);

        Assert.Equal(10, errors.Count);
        Assert.All(errors, e => Assert.Contains("locked", e.Message, StringComparison.Ordinal));
        Assert.Equal(1, other.GetLinearVelocity().x, 1e-5);
        Assert.Equal(4, world.GetBodyCount());
    }

    [Fact]
    public void LockedCalls_WithTheQuirk_DoNothing()
    {
        b2World world = Bench.World();
        world.Quirks = Box2DFlash202Quirks.LockedCallsDoNothing;
        b2Body other = Bench.Ball(world, 9, 9);
        b2Body? made = other;
        bool moved = false;
        world.SetContactListener(new Doer(() =>
        {
            made = world.CreateBody(new b2BodyDef());
            world.DestroyBody(other);
            moved = other.SetXForm(new b2Vec2(), 0);
        }));
        Bench.Static(world, 0, -0.5f, 5, 0.5f);
        Bench.Dynamic(world, 0, 0.51f);
        Bench.Step(world, 30);

        Assert.Null(made);
        Assert.True(moved);
        Assert.Equal(9, other.GetPosition().x);
        Assert.Equal(4, world.GetBodyCount());
    }

    [Fact]
    public void ExceptionOfAListener_ComesOutOfStep_WhenTheStepIsComplete()
    {
        b2World world = Bench.World();
        world.SetContactListener(new Doer(() => throw new NotSupportedException("mine")));
        Bench.Static(world, 0, -0.5f, 5, 0.5f);
        b2Body box = Bench.Dynamic(world, 0, 0.4975f);

        Assert.Equal("mine", Assert.Throws<NotSupportedException>(() => world.Step(Bench.Dt, 10)).Message);
        Bench.Step(world, 30);
        Assert.Equal(0.4975, box.GetPosition().y, 1e-3);
    }

    [Fact]
    [ManualRow("B290")]
    public void CollisionProcessing_OfTheManual_DestroysLighterBodiesAfterTheStep()
    {
        b2World world = Bench.World();
        Recorder recorder = new();
        world.SetContactListener(recorder);
        Bench.Static(world, 0, -0.5f, 5, 0.5f);
        b2Body heavy = Bench.Dynamic(world, 0, 0.499f);
        b2Body light = Bench.Dynamic(world, 0, 1.2f, 0.2f, 0.2f);
        for (int i = 0; i < 60; i++)
        {
            world.Step(Bench.Dt, 10);
            HashSet<b2Body> nuke = [];
            foreach ((b2Body body1, b2Body body2) in recorder.TakePairs())
            {
                if (body1.GetMass() > 0 && body2.GetMass() > 0 && nuke.Count < 6)
                {
                    nuke.Add(body1.GetMass() < body2.GetMass() ? body1 : body2);
                }
            }

            foreach (b2Body body in nuke)
            {
                world.DestroyBody(body);
            }
        }

        Assert.Equal(3, world.GetBodyCount());
        Assert.Null(light.GetShapeList());
        Assert.NotNull(heavy.GetShapeList());
    }

    [Fact]
    [ManualRow("B271", "B272", "B291", "B292", "B295", "B296")]
    public void Filter_IsAskedOnce_AndItsAnswerKept()
    {
        b2World world = Bench.World();
        Never never = new();
        world.SetContactFilter(never);
        Bench.Static(world, 0, -0.5f, 5, 0.5f);
        b2Body box = Bench.Dynamic(world, 0, 0.4975f);
        Bench.Step(world, 2);

        Assert.Equal(1, never.Asked);
        Assert.IsType<b2NullContact>(world.GetContactList());
        Assert.False(world.GetContactList()!.IsSolid());
        Bench.Step(world, 20);
        Assert.True(box.GetPosition().y < 0.3);
        Assert.Equal(1, never.Asked);
    }

    [Fact]
    [ManualRow("B096", "B303-B308")]
    public void DestroyedBody_SaysGoodbyeForItsJointsThenItsShapes()
    {
        b2World world = Bench.World();
        Goodbyes goodbyes = new();
        world.SetDestructionListener(goodbyes);
        b2Body a = Bench.Ball(world, 0, 0);
        b2Shape first = a.GetShapeList()!;
        b2Shape second = a.CreateShape(new b2CircleDef());
        b2Body b = Bench.Ball(world, 3, 0);
        b2DistanceJointDef def = new();
        def.Initialize(a, b, a.GetPosition(), b.GetPosition());
        b2Joint one = world.CreateJoint(def);
        b2Joint two = world.CreateJoint(def);
        b2Joint alone = world.CreateJoint(def);
        world.DestroyJoint(alone);
        Assert.Empty(goodbyes.Heard);
        world.DestroyBody(a);

        Assert.Equal([two, one, second, first], goodbyes.Heard);
    }

    private sealed class Recorder : b2ContactListener
    {
        private readonly List<string> _calls = [];
        private readonly List<(b2Body First, b2Body Second)> _pairs = [];
        private double _impulse;

        public b2Vec2 LastNormal { get; private set; } = new();

        public float LastSeparation { get; private set; }

        public b2Body? First { get; private set; }

        public b2Body? Second { get; private set; }

        public HashSet<uint> Ids { get; } = [];

        public HashSet<b2ContactPoint> Objects { get; } = new(ReferenceEqualityComparer.Instance);

        public double ImpulseOfLastStep => _impulse;

        public int Count(string call) => _calls.FindAll(c => c == call).Count;

        public List<(b2Body First, b2Body Second)> TakePairs()
        {
            List<(b2Body, b2Body)> pairs = [.. _pairs];
            _pairs.Clear();
            return pairs;
        }

        public override void Add(b2ContactPoint point) => Note("Add", point);

        public override void Persist(b2ContactPoint point) => Note("Persist", point);

        public override void Remove(b2ContactPoint point) => Note("Remove", point);

        public override void Result(b2ContactResult point)
        {
            Assert.True(point.normalImpulse >= 0);
            _impulse += point.normalImpulse;
            Assert.True(point.shape1.GetBody()!.IsStatic() || point.shape2.GetBody()!.IsDynamic());
            _ = point.tangentImpulse;
        }

        private void Note(string call, b2ContactPoint point)
        {
            _impulse = 0;
            _calls.Add(call);
            Objects.Add(point);
            Ids.Add(point.id.key);
            LastNormal = point.normal.Copy();
            LastSeparation = point.separation;
            First = point.shape1.GetBody();
            Second = point.shape2.GetBody();
            _ = point.velocity.Length();
            if (call != "Remove")
            {
                _pairs.Add((First!, Second!));
            }
        }
    }

    private sealed class Doer(Action act) : b2ContactListener
    {
        private bool _done;

        public override void Add(b2ContactPoint point)
        {
            if (!_done)
            {
                _done = true;
                act();
            }
        }
    }

    private sealed class Never : b2ContactFilter
    {
        public int Asked { get; private set; }

        public override bool ShouldCollide(b2Shape shape1, b2Shape shape2)
        {
            Asked++;
            return false;
        }
    }

    private sealed class Goodbyes : b2DestructionListener
    {
        public List<object> Heard { get; } = [];

        public override void SayGoodbyeJoint(b2Joint joint) => Heard.Add(joint);

        public override void SayGoodbyeShape(b2Shape shape) => Heard.Add(shape);
    }
}
