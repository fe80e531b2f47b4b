using System;
using System.Collections.Generic;
using System.Linq;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Contacts;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Behavior;

/// <summary>
/// Listeners and a filter that make, destroy and change at random whatever they can reach, also while something is being destroyed or
/// moved: each call does what it says or throws that the world is locked, and the world stays whole.
/// </summary>
public sealed class RandomCallbackTests
{
    [Theory]
    [InlineData(1, 0)]
    [InlineData(2, 0)]
    [InlineData(3, 1)]
    [InlineData(4, 2)]
    public void Callbacks_DoingAnythingAtRandom_LeaveAValidWorld(int seed, int mode)
    {
        // Four times 25,000 steps of a small, lively world.
        const int Steps = 25_000;
        Playground playground = new(seed, mode);
        for (int step = 0; step < Steps; step++)
        {
            playground.Step();
            if (step % 500 == 0)
            {
                playground.Check();
            }
        }

        playground.Check();
        Assert.True(playground.Told > Steps / 4, $"only {playground.Told} calls of listeners");
        Assert.True(mode == 1 || playground.Refused > Steps / 100, $"only {playground.Refused} calls were refused");
        Assert.True(playground.Done > Steps / 10, $"only {playground.Done} deeds were done");

        // What is left goes on like any other world.
        playground.GoOn();
    }

    private sealed class Playground
    {
        private const int FewestBodies = 8;
        private const int MostBodies = 14;
        private const float Half = 12;

        private readonly Random _random;
        private readonly b2World _world;
        private readonly bool _throws;
        private b2Body? _floor;

        /// <param name="seed">Of all choices.</param>
        /// <param name="mode">0: calls are refused with an exception; 1: they do nothing (the quirk); 2: the listeners throw it on.</param>
        public Playground(int seed, int mode)
        {
            _random = new Random(seed);
            _throws = mode == 2;
            _world = Bench.World(-10, Half);
            _world.Quirks = mode == 1 ? Box2DFlash202Quirks.LockedCallsDoNothing : Box2DFlash202Quirks.None;
            Listener listener = new(this);
            _world.SetContactListener(listener);
            _world.SetContactFilter(new Filter(this));
            _world.SetDestructionListener(new Goodbye(this));
            _world.SetBoundaryListener(new Boundary(this));
        }

        public int Told { get; private set; }

        public int Refused { get; private set; }

        public int Done { get; private set; }

        public void Step()
        {
            Tidy();
            if (_random.Next(4) == 0)
            {
                Try(Deed(), false);
            }

            try
            {
                _world.Step(Bench.Dt, 1 + _random.Next(3));
            }
            catch (InvalidOperationException e) when (_throws && e.Message.Contains("locked", StringComparison.Ordinal))
            {
                Refused++;
            }
        }

        /// <summary>Keeps the place lively: what is frozen or fixed goes, and there is a floor and a few bodies.</summary>
        private void Tidy()
        {
            foreach (b2Body body in Bodies().Where(b => b != _world.GetGroundBody() && b != _floor && (b.IsFrozen() || b.IsStatic())))
            {
                Try(() => _world.DestroyBody(body), false);
            }

            if (!Bodies().Contains(_floor!))
            {
                _floor = Bench.Static(_world, 0, -8, 10, 0.5f);
            }

            while (_world.GetBodyCount() < FewestBodies)
            {
                Try(Create, false);
            }
        }

        /// <summary>Lists, counts, places and the engine's answers agree.</summary>
        public void Check()
        {
            List<b2Body> bodies = Bodies();
            List<b2Joint> joints = Joints();
            Assert.Equal(_world.GetBodyCount(), bodies.Count);
            Assert.Equal(_world.GetJointCount(), joints.Count);
            Assert.Equal(bodies.Count, bodies.Distinct().Count());
            int edges = 0;
            HashSet<b2Shape> shapes = [];
            foreach (b2Body body in bodies)
            {
                Assert.True(
                    float.IsFinite(body.GetPosition().x) && float.IsFinite(body.GetPosition().y) && float.IsFinite(body.GetAngle()));
                Assert.True(float.IsFinite(body.GetLinearVelocity().x) && float.IsFinite(body.GetAngularVelocity()));
                for (b2Shape? shape = body.GetShapeList(); shape is not null; shape = shape.GetNext())
                {
                    Assert.Same(body, shape.GetBody());
                    Assert.True(shapes.Add(shape));
                }

                for (b2JointEdge? edge = body.GetJointList(); edge is not null; edge = edge.next)
                {
                    edges++;
                    Assert.Contains(edge.joint, joints);
                    Assert.Contains(edge.other, bodies);
                }
            }

            Assert.Equal(2 * joints.Count, edges);
            for (b2Contact? contact = _world.GetContactList(); contact is not null; contact = contact.GetNext())
            {
                Assert.Contains(contact.GetShape1(), shapes);
                Assert.Contains(contact.GetShape2(), shapes);
            }

            // The engine knows the same shapes: a query finds each that is not frozen, and none that is gone.
            List<b2Shape> found = [];
            _world.Query(Bench.Box(1e6f), found, int.MaxValue);
            Assert.Equal(found.Count, found.Distinct().Count());
            Assert.All(found, s => Assert.Contains(s, shapes));
            foreach (b2Shape shape in shapes.Where(s => !s.GetBody()!.IsFrozen()))
            {
                b2Body owner = shape.GetBody()!;
                Assert.True(found.Contains(shape), $"a shape at {owner.GetPosition()}, v {owner.GetLinearVelocity()}, static "
                    + $"{owner.IsStatic()}, asleep {owner.IsSleeping()}, is not found");
            }
        }

        public void GoOn()
        {
            _world.SetContactListener(null);
            _world.SetContactFilter(null);
            _world.SetDestructionListener(null);
            _world.SetBoundaryListener(null);
            foreach (b2Joint joint in Joints())
            {
                if (Joints().Contains(joint))
                {
                    _world.DestroyJoint(joint);
                }
            }

            // A static body that was given a velocity is a belt, as in the original: it would carry on what lies on it.
            Tidy();

            // What cannot come to rest goes: circles roll on over a level floor (a body of four of them at 0.25 m/s for a minute), and what
            // has no solid shape falls for ever, since nothing of it can leave the world.
            foreach (b2Body body in Bodies().Where(b => b.IsDynamic() && !CanRest(b)))
            {
                _world.DestroyBody(body);
            }

            foreach (b2Body body in Bodies().Where(b => b != _world.GetGroundBody()))
            {
                body.SetLinearVelocity(new b2Vec2());
                body.SetAngularVelocity(0);
                body.AllowSleeping(true);
            }

            for (int i = 0; i < FewestBodies; i++)
            {
                Bench.Dynamic(_world, i - 4, i % 3);
            }

            Bench.Step(_world, 900);
            Check();
            Assert.All(
                Bodies().Where(b => b.IsDynamic() && !b.IsFrozen()),
                b => Assert.True(b.IsSleeping(), $"at {b.GetPosition()}, v {b.GetLinearVelocity()}, w {b.GetAngularVelocity()}"));
        }

        /// <summary>From a callback: mostly nothing, sometimes anything.</summary>
        public void Act()
        {
            Told++;
            if (_random.Next(8) == 0)
            {
                Try(Deed(), true);
            }
        }

        private static bool CanRest(b2Body body)
        {
            bool solid = false;
            for (b2Shape? shape = body.GetShapeList(); shape is not null; shape = shape.GetNext())
            {
                solid |= !shape.IsSensor();
                if (shape.GetType() == b2Shape.e_circleShape)
                {
                    return false;
                }
            }

            return solid;
        }

        private void Try(Action deed, bool inCallback)
        {
            try
            {
                deed();
                Done++;
            }
            catch (InvalidOperationException e) when (e.Message.Contains("locked", StringComparison.Ordinal))
            {
                Refused++;
                if (inCallback && _throws)
                {
                    throw;
                }
            }
        }

        private Action Deed()
        {
            List<b2Body> bodies = [.. Bodies().Where(b => b != _world.GetGroundBody())];
            b2Body body = bodies[_random.Next(bodies.Count)];
            b2Shape? shape = body.GetShapeList();
            List<b2Joint> joints = Joints();
            return _random.Next(17) switch
            {
                0 or 1 => Create,
                2 => () => Destroy(body, bodies.Count),
                3 => () => body.CreateShape(Shape()),
                4 => shape is null ? Create : () => body.DestroyShape(shape),
                5 => () => body.SetMassFromShapes(),
                6 => () => body.SetMass(new b2MassData { mass = _random.Next(3), I = _random.Next(2) }),
                7 => () => body.SetXForm(Place(_random.Next(30) == 0 ? 2 * Half : Half - 2), Angle()),
                8 => () => Join(body, bodies[_random.Next(bodies.Count)]),
                9 => joints.Count == 0 ? Create : () => _world.DestroyJoint(joints[_random.Next(joints.Count)]),
                10 => shape is null ? Create : () => Filter(shape),
                11 => () => body.SetLinearVelocity(Place(20)),
                12 => () => body.SetAngularVelocity(Angle() * 5),
                13 => () => body.PutToSleep(),
                14 => () => body.WakeUp(),
                15 => () => body.SetBullet(_random.Next(2) == 0),
                _ => () => body.ApplyImpulse(Place(5), body.GetWorldCenter()),
            };
        }

        private void Create()
        {
            if (_world.GetBodyCount() >= MostBodies)
            {
                return;
            }

            b2BodyDef def = new();
            def.position.SetV(Place(Half - 2));
            def.angle = Angle();
            def.isBullet = _random.Next(5) == 0;
            b2Body? body = _world.CreateBody(def);
            body?.CreateShape(Shape());
            body?.SetMassFromShapes();
        }

        private void Destroy(b2Body body, int count)
        {
            if (count > FewestBodies)
            {
                _world.DestroyBody(body);
            }
        }

        private b2ShapeDef Shape()
        {
            b2ShapeDef def = _random.Next(2) == 0
                ? new b2CircleDef { radius = 0.2f + (0.5f * _random.NextSingle()) }
                : Bench.BoxDef(0.2f + (0.5f * _random.NextSingle()), 0.2f + (0.5f * _random.NextSingle()), 1);
            def.density = 1;
            def.restitution = 0.5f * _random.Next(2);
            def.isSensor = _random.Next(8) == 0;
            return def;
        }

        private void Join(b2Body a, b2Body b)
        {
            if (a == b || _world.GetJointCount() > 6)
            {
                return;
            }

            b2JointDef def;
            switch (_random.Next(4))
            {
                case 0:
                    b2RevoluteJointDef revolute = new();
                    revolute.Initialize(a, b, a.GetWorldCenter());
                    def = revolute;
                    break;
                case 1:
                    b2PrismaticJointDef prismatic = new();
                    prismatic.Initialize(a, b, a.GetWorldCenter(), new b2Vec2(1, 0));
                    def = prismatic;
                    break;
                case 2:
                    b2DistanceJointDef distance = new();
                    distance.Initialize(a, b, a.GetWorldCenter(), b.GetWorldCenter());
                    def = distance;
                    break;
                default:
                    def = new b2MouseJointDef
                    {
                        body1 = _world.GetGroundBody(),
                        body2 = b,
                        target = b.GetWorldCenter().Copy(),
                        maxForce = 100,
                    };
                    break;
            }

            def.collideConnected = _random.Next(2) == 0;
            _world.CreateJoint(def);
        }

        private void Filter(b2Shape shape)
        {
            shape.SetFilterData(new b2FilterData { groupIndex = _random.Next(3) - 1 });
            _world.Refilter(shape);
        }

        private b2Vec2 Place(float reach) => new(reach * ((2 * _random.NextSingle()) - 1), reach * ((2 * _random.NextSingle()) - 1));

        private float Angle() => 6 * (_random.NextSingle() - 0.5f);

        private List<b2Body> Bodies()
        {
            List<b2Body> bodies = [];
            for (b2Body? body = _world.GetBodyList(); body is not null; body = body.GetNext())
            {
                bodies.Add(body);
            }

            return bodies;
        }

        private List<b2Joint> Joints()
        {
            List<b2Joint> joints = [];
            for (b2Joint? joint = _world.GetJointList(); joint is not null; joint = joint.GetNext())
            {
                joints.Add(joint);
            }

            return joints;
        }
    }

    private sealed class Listener(Playground playground) : b2ContactListener
    {
        public override void Add(b2ContactPoint point) => playground.Act();

        public override void Persist(b2ContactPoint point) => playground.Act();

        public override void Remove(b2ContactPoint point) => playground.Act();

        public override void Result(b2ContactResult point) => playground.Act();
    }

    private sealed class Filter(Playground playground) : b2ContactFilter
    {
        public override bool ShouldCollide(b2Shape shape1, b2Shape shape2)
        {
            playground.Act();
            return base.ShouldCollide(shape1, shape2);
        }
    }

    private sealed class Goodbye(Playground playground) : b2DestructionListener
    {
        public override void SayGoodbyeJoint(b2Joint joint) => playground.Act();

        public override void SayGoodbyeShape(b2Shape shape) => playground.Act();
    }

    private sealed class Boundary(Playground playground) : b2BoundaryListener
    {
        public override void Violation(b2Body body) => playground.Act();
    }
}
