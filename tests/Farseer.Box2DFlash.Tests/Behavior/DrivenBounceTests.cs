using System;
using System.Collections.Generic;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Behavior;

/// <summary>Restitutions above 1 drive bodies on up to the documented greatest speeds.</summary>
public class DrivenBounceTests
{
    [Fact]
    public void BodiesThatBounceHigherEachTime_StayInTheirRoom_AndWithinTheDocumentedSpeeds()
    {
        for (int seed = 0; seed < 200; seed++)
        {
            b2World world = Room(seed, out List<b2Body> bodies);
            for (int step = 0; step < 900; step++)
            {
                world.Step(1 / 60f, 10);
                foreach (b2Body body in bodies)
                {
                    string what =
                        $"seed {seed}, step {step}: at {body.GetPosition()}, {body.GetLinearVelocity()}, {body.GetAngularVelocity()}";
                    Assert.False(body.IsFrozen(), what);
                    Assert.True(Math.Abs(body.GetPosition().x) < 10.1f && Math.Abs(body.GetPosition().y) < 10.1f, what);

                    // What falls by the height of the room gains g·h.
                    Assert.True(body.GetLinearVelocity().Length() < b2Settings.b2_maxLinearVelocity + 2, what);
                    Assert.True(Math.Abs(body.GetAngularVelocity()) <= b2Settings.b2_maxAngularVelocity, what);
                }
            }
        }
    }

    private static b2World Room(int seed, out List<b2Body> bodies)
    {
        var random = new Random(seed);
        b2AABB bounds = new();
        bounds.lowerBound.Set(-100, -100);
        bounds.upperBound.Set(100, 100);
        b2World world = new(bounds, new b2Vec2(0, -10), true);
        b2Body ground = world.CreateBody(new b2BodyDef());
        foreach ((float x, float y) in new[] { (11f, 0f), (-11f, 0f), (0f, 11f), (0f, -11f) })
        {
            b2PolygonDef wall = new();
            wall.SetAsOrientedBox(x != 0 ? 1 : 12, y != 0 ? 1 : 12, new b2Vec2(x, y), 0);
            ground.CreateShape(wall);
        }

        bodies = [];
        for (int i = 0; i <= seed % 10; i++)
        {
            b2BodyDef def = new();
            def.position.Set((16 * (float)random.NextDouble()) - 8, (16 * (float)random.NextDouble()) - 8);
            b2Body body = world.CreateBody(def);
            float width = 0.1f + (0.7f * (float)random.NextDouble());
            float height = 0.1f + (0.7f * (float)random.NextDouble());
            b2PolygonDef box = new();
            box.SetAsBox(width, height);
            b2ShapeDef shape = random.Next(2) == 0 ? new b2CircleDef { radius = width } : box;
            shape.density = 1;
            shape.friction = 0.3f;
            shape.restitution = 1.2f + (float)random.NextDouble();
            body.CreateShape(shape);
            body.SetMassFromShapes();
            bodies.Add(body);
        }

        return world;
    }
}
