using System;
using System.Collections.Generic;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Contacts;
using Box2D.Dynamics.Joints;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Behavior;

/// <summary>A warm world in which every kind of joint, listener, filter and query is at work allocates nothing.</summary>
public sealed class KindAllocationTests
{
    /// <summary>Until nearly as many pairs have been near each other at once as ever will: the pool of contacts grows with them.</summary>
    private const int WarmSteps = 4000;
    private const int CountedSteps = 400;

    [Fact]
    public void WarmSteps_WithEveryKindAtWork_AllocateNothing()
    {
        // A first run compiles every method that the second one will use.
        Count();

        (long bytes, Busy busy) = Count();

        Assert.Equal(0, bytes);
        busy.AssertActive();
    }

    private static (long Bytes, Busy Busy) Count()
    {
        Busy busy = new();
        busy.Run(WarmSteps, false);
        long before = GC.GetAllocatedBytesForCurrentThread();
        busy.Run(CountedSteps, true);
        return (GC.GetAllocatedBytesForCurrentThread() - before, busy);
    }

    /// <summary>A box of bouncing bodies and a row of machines.</summary>
    private sealed class Busy
    {
        private readonly b2World _world = Bench.World();
        private readonly Ears _ears = new();
        private readonly Choice _choice = new();
        private readonly Edge _edge = new();
        private readonly Goodbye _goodbye = new();
        private readonly List<b2Joint> _joints = [];
        private readonly List<b2Body> _kicked = [];
        private readonly b2Body _leaver;
        private readonly b2Shape[] _places = new b2Shape[64];
        private readonly List<b2Shape> _list = new(64);
        private readonly b2AABB _box = new();
        private readonly b2Segment _segment = new();
        private readonly b2Vec2 _point = new(0, 2);
        private readonly b2Vec2 _normal = new();
        private readonly b2Vec2 _kick = new();
        private readonly b2Vec2 _aside = new(0, 90);
        private readonly float[] _lambda = new float[1];
        private readonly b2Body _bullet;
        private long _found;
        private int _step;

        public Busy()
        {
            _world.SetContactListener(_ears);
            _world.SetContactFilter(_choice);
            _world.SetBoundaryListener(_edge);
            _world.SetDestructionListener(_goodbye);
            Bench.Static(_world, 0, -0.5f, 60, 0.5f);
            Bench.Static(_world, -10.5f, 5, 0.5f, 6);
            Bench.Static(_world, 10.5f, 5, 0.5f, 6);
            Bench.Static(_world, 0, 11, 11, 0.5f);
            for (int i = 0; i < 8; i++)
            {
                b2Body ball = Bench.Ball(_world, -7 + (2 * i), 3 + (i % 3), 0.4f, 1);
                ball.SetLinearVelocity(new b2Vec2(6 - (3 * (i % 5)), 4 - (i % 4)));
                _kicked.Add(ball);
            }

            _bullet = Bench.Ball(_world, 0, 8, 0.2f, 1);
            _bullet.SetBullet(true);
            _kicked.Add(_bullet);
            b2PolygonDef sensor = Bench.BoxDef(3, 1, 0);
            sensor.isSensor = true;
            Bench.Body(_world, 0, 6, sensor);
            for (int i = 0; i < 3; i++)
            {
                Bench.Dynamic(_world, -4, 0.5f + (1.01f * i));
            }

            AddMachines();

            // It leaves the world while bytes are counted.
            _leaver = Bench.Ball(_world, 0, 50);
            _leaver.AllowSleeping(false);
        }

        public void Run(int steps, bool counted)
        {
            for (int i = 0; i < steps; i++, _step++)
            {
                if (_step % 40 == 0)
                {
                    Kick();
                }

                if (counted && i == steps / 2)
                {
                    _leaver.SetXForm(_aside, 0);
                    _leaver.SetLinearVelocity(_aside);
                }
                else if (!_leaver.IsFrozen() && _leaver.GetPosition().y < 40)
                {
                    _kick.Set(0, 60);
                    _leaver.SetXForm(_kick, 0);
                }

                _world.Step(Bench.Dt, 10);
                Ask();
            }
        }

        public void AssertActive()
        {
            Assert.True(_ears.Added > 0 && _ears.Persisted > 0 && _ears.Removed > 0 && _ears.Results > 0);
            Assert.True(_choice.Asked > 0);
            Assert.Equal(1, _edge.Violations);
            Assert.True(_leaver.IsFrozen());
            Assert.True(_found > 0);
            Assert.Equal(8, _joints.Count);
            Assert.True(_bullet.IsBullet());
            _world.DestroyBody(_joints[0].GetBody2());
            Assert.True(_goodbye.Joints > 0 && _goodbye.Shapes > 0);
        }

        private void AddMachines()
        {
            b2Body ground = _world.GetGroundBody();
            b2DistanceJointDef rod = new();
            rod.Initialize(ground, Made(20, 8), new b2Vec2(18, 12), new b2Vec2(20, 8));
            Join(rod);
            b2DistanceJointDef spring = new() { frequencyHz = 2, dampingRatio = 0.1f };
            spring.Initialize(ground, Made(24, 8), new b2Vec2(24, 12), new b2Vec2(24, 8));
            Join(spring);
            b2RevoluteJointDef hinge =
                new() { enableLimit = true, lowerAngle = -0.5f, upperAngle = 0.5f, enableMotor = true, motorSpeed = 3, maxMotorTorque = 5 };
            hinge.Initialize(ground, Made(28, 8), new b2Vec2(28, 9));
            Join(hinge);
            b2PrismaticJointDef slider = new()
            {
                enableLimit = true,
                lowerTranslation = -2,
                upperTranslation = 2,
                enableMotor = true,
                motorSpeed = 2,
                maxMotorForce = 5,
            };
            slider.Initialize(ground, Made(33, 8), new b2Vec2(33, 8), new b2Vec2(0, 1));
            Join(slider);
            b2PulleyJointDef pulley = new();
            pulley.Initialize(Made(37, 8), Made(40, 8), new b2Vec2(37, 14), new b2Vec2(40, 14), new b2Vec2(37, 8), new b2Vec2(40, 8), 1.5f);
            Join(pulley);
            b2Body wheel = Made(44, 8);
            b2RevoluteJointDef axle = new();
            axle.Initialize(ground, wheel, new b2Vec2(44, 8));
            b2Body rack = Made(47, 8);
            b2PrismaticJointDef rail = new() { enableLimit = true, lowerTranslation = -3, upperTranslation = 3 };
            rail.Initialize(ground, rack, new b2Vec2(47, 8), new b2Vec2(0, 1));
            Join(new b2GearJointDef { body1 = wheel, body2 = rack, joint1 = Join(axle), joint2 = Join(rail), ratio = 0.5f });
            _joints.RemoveAt(_joints.Count - 2);
            b2Body dragged = Made(52, 8);
            Join(new b2MouseJointDef { body1 = ground, body2 = dragged, maxForce = 200, target = new b2Vec2(52, 9) });
        }

        private b2Body Made(float x, float y)
        {
            b2Body body = Bench.Dynamic(_world, x, y);
            _kicked.Add(body);
            return body;
        }

        private b2Joint Join(b2JointDef def)
        {
            b2Joint joint = _world.CreateJoint(def)!;
            _joints.Add(joint);
            return joint;
        }

        private void Kick()
        {
            for (int i = 0; i < _kicked.Count; i++)
            {
                b2Body body = _kicked[i];
                _kick.Set((_step / 40 % 2) == 0 ? 2 : -2, 3);
                body.ApplyImpulse(_kick, body.GetWorldCenter());
                body.WakeUp();
            }
        }

        private void Ask()
        {
            _box.lowerBound.Set(-10, -1);
            _box.upperBound.Set(10, 10);
            _found += _world.Query(_box, _places, _places.Length);
            _list.Clear();
            _found += _world.Query(_box, _list, 60);
            _segment.p1.Set(-9, 5);
            _segment.p2.Set(9, 5);
            for (int i = 0; i < _list.Count; i++)
            {
                b2Shape shape = _list[i];
                b2XForm pose = shape.GetBody()!.GetXForm();
                _found += shape.TestPoint(pose, _point) ? 1 : 0;
                _found += shape.TestSegment(pose, _lambda, _normal, _segment, 1) ? 1 : 0;
            }
        }
    }

    private sealed class Ears : b2ContactListener
    {
        public int Added { get; private set; }

        public int Persisted { get; private set; }

        public int Removed { get; private set; }

        public int Results { get; private set; }

        public override void Add(b2ContactPoint point) => Added++;

        public override void Persist(b2ContactPoint point) => Persisted++;

        public override void Remove(b2ContactPoint point) => Removed++;

        public override void Result(b2ContactResult point) => Results++;
    }

    private sealed class Choice : b2ContactFilter
    {
        public int Asked { get; private set; }

        public override bool ShouldCollide(b2Shape shape1, b2Shape shape2)
        {
            Asked++;
            return base.ShouldCollide(shape1, shape2);
        }
    }

    private sealed class Edge : b2BoundaryListener
    {
        public int Violations { get; private set; }

        public override void Violation(b2Body body) => Violations++;
    }

    private sealed class Goodbye : b2DestructionListener
    {
        public int Joints { get; private set; }

        public int Shapes { get; private set; }

        public override void SayGoodbyeJoint(b2Joint joint) => Joints++;

        public override void SayGoodbyeShape(b2Shape shape) => Shapes++;
    }
}
