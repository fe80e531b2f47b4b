using System;
using System.Reflection;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Xunit;

namespace Farseer.Box2DFlash.Tests;

/// <summary>Worlds and bodies that many tests need.</summary>
internal static class Bench
{
    public const float Dt = 1f / 60;

    /// <summary>A name that the manual uses and the sources lack: it is there, and says the other one.</summary>
    public static void AssertOldName(MemberInfo? member, string name) =>
        Assert.Contains(name, member!.GetCustomAttribute<ObsoleteAttribute>()!.Message!, StringComparison.Ordinal);

    public static b2AABB Box(float half) => new() { lowerBound = new b2Vec2(-half, -half), upperBound = new b2Vec2(half, half) };

    public static b2World World(float gravityY = -10, float half = 100, bool doSleep = true) =>
        new(Box(half), new b2Vec2(0, gravityY), doSleep);

    public static b2Body Static(b2World world, float x, float y, float hx, float hy) => Body(world, x, y, BoxDef(hx, hy, 0));

    public static b2Body Dynamic(b2World world, float x, float y, float hx = 0.5f, float hy = 0.5f) => Body(world, x, y, BoxDef(hx, hy, 1));

    public static b2Body Ball(b2World world, float x, float y, float radius = 0.5f, float restitution = 0)
        => Body(world, x, y, new b2CircleDef { radius = radius, density = 1, restitution = restitution });

    public static b2Body Body(b2World world, float x, float y, b2ShapeDef shape)
    {
        b2BodyDef def = new();
        def.position.Set(x, y);
        b2Body body = world.CreateBody(def);
        body.CreateShape(shape);
        if (shape.density > 0)
        {
            body.SetMassFromShapes();
        }

        return body;
    }

    public static b2PolygonDef BoxDef(float hx, float hy, float density)
    {
        b2PolygonDef def = new() { density = density };
        def.SetAsBox(hx, hy);
        return def;
    }

    public static void Step(b2World world, int steps, int iterations = 10)
    {
        for (int i = 0; i < steps; i++)
        {
            world.Step(Dt, iterations);
        }
    }
}
