using System.Collections.Generic;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;

namespace Farseer.Testbed.Scenes;

/// <summary>A crank that drives a piston, a wheel geared to a rack, and a pulley with a ratio.</summary>
public sealed class CrankGearsPulley : TestScene
{
    private readonly b2RevoluteJoint _crank;
    private readonly b2PrismaticJoint _piston;
    private readonly b2RevoluteJoint _wheel;
    private readonly b2PrismaticJoint _rack;
    private readonly b2PulleyJoint _pulley;
    private readonly float _rope;
    private float _highest = float.MinValue;
    private float _lowest = float.MaxValue;

    public CrankGearsPulley()
    {
        b2Body ground = World.GetGroundBody();
        b2Body arm = Add(-10, 7, Box(0.3f, 2, 1));
        b2RevoluteJointDef hinge = new();
        hinge.Initialize(ground, arm, new b2Vec2(-10, 5));
        hinge.motorSpeed = b2_pi;
        hinge.maxMotorTorque = 10000;
        hinge.enableMotor = true;
        _crank = (b2RevoluteJoint)World.CreateJoint(hinge);
        b2Body rod = Add(-10, 13, Box(0.3f, 4, 1));
        b2RevoluteJointDef pin = new();
        pin.Initialize(arm, rod, new b2Vec2(-10, 9));
        World.CreateJoint(pin);
        b2Body piston = Add(-10, 17, Box(1, 1, 1));
        pin.Initialize(rod, piston, new b2Vec2(-10, 17));
        World.CreateJoint(pin);
        b2PrismaticJointDef slide = new();
        slide.Initialize(ground, piston, new b2Vec2(-10, 17), new b2Vec2(0, 1));
        _piston = (b2PrismaticJoint)World.CreateJoint(slide);

        b2Body wheel = Add(0, 5, Circle(1));
        b2RevoluteJointDef axle = new() { enableMotor = true, motorSpeed = 1, maxMotorTorque = 1000 };
        axle.Initialize(ground, wheel, wheel.GetPosition());
        _wheel = (b2RevoluteJoint)World.CreateJoint(axle);
        b2Body rack = Add(1.5f, 5, Box(0.5f, 4));
        slide.Initialize(ground, rack, rack.GetPosition(), new b2Vec2(0, 1));
        _rack = (b2PrismaticJoint)World.CreateJoint(slide);
        World.CreateJoint(new b2GearJointDef { body1 = wheel, body2 = rack, joint1 = _wheel, joint2 = _rack, ratio = -1 });

        b2Body light = Add(8, 8, Box(1, 0.5f, 5));
        b2Body heavy = Add(14, 8, Box(1, 0.5f, 5));
        b2PulleyJointDef rope = new();
        rope.Initialize(light, heavy, new b2Vec2(8, 16), new b2Vec2(14, 16), new b2Vec2(8, 8.5f), new b2Vec2(14, 8.5f), 2);
        _pulley = (b2PulleyJoint)World.CreateJoint(rope);
        _rope = rope.length1 + (2 * rope.length2);
    }

    public override string Name => "crank-gears-pulley";

    public override string Description => "A motor turns a crank, a wheel moves a rack by a gear, and a pulley has a ratio of 2.";

    public override (float HalfWidth, float X, float Y) View => (20, 2, 10);

    public override int Steps => 180;

    private static float b2_pi => Box2D.Common.b2Settings.b2_pi;

    public override IEnumerable<Outcome> Check()
    {
        yield return Near("angle of the crank", _crank.GetJointAngle(), 3 * b2_pi, 0.05);
        yield return Near("stroke of the piston", _highest - _lowest, 8, 0.2);
        yield return Near("rack less wheel", _rack.GetJointTranslation() - _wheel.GetJointAngle(), 0, 0.01);
        yield return That("the rope did not grow", _pulley.GetLength1() + (2 * _pulley.GetLength2()) < _rope + 0.02f);
    }

    protected override void After(int step)
    {
        _highest = System.Math.Max(_highest, _piston.GetJointTranslation());
        _lowest = System.Math.Min(_lowest, _piston.GetJointTranslation());
    }
}
