using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Joints;

namespace Farseer.Serialization.Tests;

/// <summary>A small world of the other facade with every shape and joint.</summary>
internal static class FlashEverything
{
    public static b2World Build()
    {
        var box = new b2AABB { lowerBound = new b2Vec2(-100, -100), upperBound = new b2Vec2(200, 100) };
        var world = new b2World(box, new b2Vec2(0.5f, -10), true) { Quirks = Box2DFlash202Quirks.PulleyForceSign };
        b2Body ground = world.GetGroundBody();
        b2Body first = Square(world, 0);
        ground.CreateShape(Box(100, 1));
        b2Body second = Square(world, 4);
        var hinge = new b2RevoluteJointDef { enableMotor = true, motorSpeed = 1, maxMotorTorque = 3, userData = "hinge" };
        hinge.Initialize(ground, first, new b2Vec2(0, 6));
        var slider = new b2PrismaticJointDef { enableLimit = true, lowerTranslation = -1, upperTranslation = 2 };
        slider.Initialize(ground, second, new b2Vec2(4, 5), new b2Vec2(3, 1));
        world.CreateJoint(new b2GearJointDef
        {
            joint1 = world.CreateJoint(hinge),
            joint2 = world.CreateJoint(slider),
            body1 = first,
            body2 = second,
            ratio = 2,
        });
        var rod = new b2DistanceJointDef();
        rod.Initialize(Square(world, 8), Square(world, 11), new b2Vec2(8, 5), new b2Vec2(11, 5.5f));
        rod.frequencyHz = 3;
        rod.dampingRatio = 0.2f;
        world.CreateJoint(rod);
        var rope = new b2PulleyJointDef();
        rope.Initialize(
            Square(world, 20), Square(world, 24), new b2Vec2(20, 12), new b2Vec2(24, 12), new b2Vec2(20, 5), new b2Vec2(24, 5), 1.5f);
        world.CreateJoint(rope);
        b2Body pulled = Square(world, 30);
        world.CreateJoint(new b2MouseJointDef { body1 = ground, body2 = pulled, target = new b2Vec2(30.2f, 5), maxForce = 100 });
        b2Body ball = world.CreateBody(new b2BodyDef
        {
            position = new b2Vec2(40, 3), angle = 0.5f, isBullet = true, fixedRotation = true, linearDamping = 0.1f, angularDamping = 0.2f,
            userData = "ball",
        });
        ball.CreateShape(new b2CircleDef
        {
            radius = 0.5f,
            density = 2,
            localPosition = new b2Vec2(0.25f, 0.125f),
            friction = 0.4f,
            restitution = 0.3f,
            userData = "skin",
        });
        ball.SetMassFromShapes();
        ball.SetLinearVelocity(new b2Vec2(1, 2));
        ball.ApplyForce(new b2Vec2(3, 0), new b2Vec2(40, 3));
        b2Body sleeper = Square(world, 50);
        sleeper.SetXForm(new b2Vec2(50, 1.5f), 0);
        sleeper.PutToSleep();
        b2Body outside = Square(world, 60);
        outside.SetXForm(new b2Vec2(500, 0), 0);
        return world;
    }

    private static b2PolygonDef Box(float x, float y)
    {
        var def = new b2PolygonDef { density = 1, filter = { groupIndex = -2, categoryBits = 3 } };
        def.SetAsBox(x, y);
        return def;
    }

    private static b2Body Square(b2World world, float x)
    {
        b2Body body = world.CreateBody(new b2BodyDef { position = new b2Vec2(x, 5) });
        var def = new b2PolygonDef { density = 1 };
        def.SetAsBox(0.5f, 0.5f);
        body.CreateShape(def);
        body.SetMassFromShapes();
        return body;
    }
}
