using System;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;

namespace Farseer.Accuracy.Surveys;

/// <summary>A world of the other facade, and what its surveys put into it.</summary>
internal sealed class FlashRoom
{
    private const float Dt = 1 / 60f;

    public FlashRoom(float gravity, float bounds = 1000)
    {
        var box = new b2AABB();
        box.lowerBound.Set(-bounds, -bounds);
        box.upperBound.Set(bounds, bounds);
        World = new b2World(box, new b2Vec2(0, gravity), false);
    }

    public b2World World { get; }

    public void Steps(int count, int iterations, Action? after = null)
    {
        for (int i = 0; i < count; i++)
        {
            World.Step(Dt, iterations);
            after?.Invoke();
        }
    }

    /// <summary>A box, static if it has no density.</summary>
    public b2Body Box(float x, float y, float width, float height, float density, float bounce = 0, bool bullet = false)
    {
        var shape = new b2PolygonDef { density = density, restitution = bounce };
        shape.SetAsBox(width / 2, height / 2);
        return Made(x, y, shape, bullet);
    }

    public b2Body Ball(float x, float y, float radius, float density, float bounce = 0, bool bullet = false) =>
        Made(x, y, new b2CircleDef { radius = radius, density = density, restitution = bounce }, bullet);

    private b2Body Made(float x, float y, b2ShapeDef shape, bool bullet)
    {
        var def = new b2BodyDef { isBullet = bullet };
        def.position.Set(x, y);
        b2Body body = World.CreateBody(def);
        body.CreateShape(shape);
        body.SetMassFromShapes();
        return body;
    }
}
