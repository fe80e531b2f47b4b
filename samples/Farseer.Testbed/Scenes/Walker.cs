using System.Collections.Generic;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;

namespace Farseer.Testbed.Scenes;

/// <summary>A walking machine on six legs of triangles and rods, driven by one wheel.</summary>
public sealed class Walker : TestScene
{
    private readonly b2Body _chassis;
    private readonly b2Body _wheel;
    private readonly float _start;

    public Walker()
    {
        Ground();
        b2PolygonDef body = Box(2.5f, 1, 1);
        body.filter.groupIndex = -1;
        _chassis = Add(0, 8.8f, body);
        b2CircleDef round = Circle(1.6f);
        round.filter.groupIndex = -1;
        _wheel = Add(0, 8.8f, round);
        b2RevoluteJointDef motor = new() { motorSpeed = 2, maxMotorTorque = 400, enableMotor = true };
        motor.Initialize(_wheel, _chassis, new b2Vec2(0, 8.8f));
        World.CreateJoint(motor);
        b2Vec2 crank = new(0, 8);
        for (int i = 0; i < 3; i++)
        {
            // The wheel is turned by a third before the next pair of legs is made.
            _wheel.SetXForm(_wheel.GetPosition().Copy(), i * 2 * Box2D.Common.b2Settings.b2_pi / 3);
            MakeLeg(-1, crank);
            MakeLeg(1, crank);
        }

        _start = _chassis.GetPosition().x;
    }

    public override string Name => "walker";

    public override string Description => "A walking machine on six legs, driven by one wheel.";

    public override int Steps => 600;

    public override IEnumerable<Outcome> Check()
    {
        yield return That(
            $"it has walked {_chassis.GetPosition().x - _start:0.0} m", System.Math.Abs(_chassis.GetPosition().x - _start) > 3);
        yield return That("it stands", _chassis.GetPosition().y > 4);
    }

    private void MakeLeg(float s, b2Vec2 crank)
    {
        b2Vec2 p1 = new(5.4f * s, -6.1f);
        b2Vec2 p2 = new(7.2f * s, -1.2f);
        b2Vec2 p3 = new(4.3f * s, -1.9f);
        b2Vec2 p4 = new(3.1f * s, 0.8f);
        b2Vec2 p5 = new(6.0f * s, 1.5f);
        b2Vec2 p6 = new(2.5f * s, 3.7f);
        b2Body foot = Add(0, 8, Triangle(s, p1, p2, p3));
        b2Body knee = Add(0, 8, Triangle(s, new b2Vec2(), b2Math.SubtractVV(p5, p4), b2Math.SubtractVV(p6, p4)));
        knee.SetXForm(b2Math.AddVV(new b2Vec2(0, 8), p4), 0);
        b2Vec2 At(b2Vec2 p) => b2Math.AddVV(new b2Vec2(0, 8), p);
        Rod(foot, knee, At(p2), At(p5));
        Rod(foot, knee, At(p3), At(p4));
        Rod(foot, _wheel, At(p3), crank);
        Rod(knee, _wheel, At(p6), crank);
        b2RevoluteJointDef hinge = new();
        hinge.Initialize(knee, _chassis, At(p4));
        World.CreateJoint(hinge);
    }

    private void Rod(b2Body a, b2Body b, b2Vec2 anchor1, b2Vec2 anchor2)
    {
        b2DistanceJointDef def = new();
        def.Initialize(a, b, anchor1, anchor2);
        def.frequencyHz = 10;
        def.dampingRatio = 0.5f;
        World.CreateJoint(def);
    }

    private static b2PolygonDef Triangle(float s, b2Vec2 a, b2Vec2 b, b2Vec2 c)
    {
        b2PolygonDef def = new() { density = 1, friction = 0.9f, vertexCount = 3, vertices = s > 0 ? [a, b, c] : [a, c, b] };
        def.filter.groupIndex = -1;
        return def;
    }
}
