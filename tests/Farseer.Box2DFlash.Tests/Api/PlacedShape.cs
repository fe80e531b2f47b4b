using System;
using System.Collections.Generic;
using System.Linq;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;

namespace Farseer.Box2DFlash.Tests.Api;

/// <summary>A random convex polygon, or circle, of a turned and displaced body, and where its corners are by plain trigonometry.</summary>
internal sealed class PlacedShape
{
    private PlacedShape(b2Body body, b2ShapeDef def)
    {
        Body = body;
        Shape = body.CreateShape(def);
    }

    public b2Body Body { get; }

    public b2Shape Shape { get; }

    public b2PolygonShape Polygon => (b2PolygonShape)Shape;

    /// <summary>In the body.</summary>
    public (double X, double Y)[] Corners { get; private init; } = [];

    public (double X, double Y) Center { get; private init; }

    public double Radius { get; private init; }

    /// <summary>Polygons of 3 to 8 corners, in places within 8 m.</summary>
    public static IEnumerable<PlacedShape> Polygons(int seed, int count)
    {
        Random random = new(seed);
        b2World world = Bench.World(0);
        for (int i = 0; i < count; i++)
        {
            int corners = 3 + (i % 6);
            double first = 6 * random.NextDouble();
            double tilt = 6 * random.NextDouble();
            (double a, double b) = (Number(random, 0.7, 2), Number(random, 0.7, 2));
            (double cx, double cy) = (Number(random, -3, 3), Number(random, -3, 3));
            (double X, double Y)[] outline = [.. Enumerable.Range(0, corners)
                .Select(k => first + ((k + (0.4 * random.NextDouble())) * 2 * Math.PI / corners))
                .Select(t => Turned((a * Math.Cos(t), b * Math.Sin(t)), tilt))
                .Select(p => ((double)(float)(cx + p.X), (double)(float)(cy + p.Y)))];
            b2PolygonDef def = new()
            {
                density = (float)Number(random, 0.5, 3),
                vertexCount = corners,
                vertices = [.. outline.Select(p => V(p))],
            };
            yield return new PlacedShape(Turned(world, random), def) { Corners = outline };
        }
    }

    /// <summary>Circles beside the origin of their bodies, in places within 8 m.</summary>
    public static IEnumerable<PlacedShape> Circles(int seed, int count)
    {
        Random random = new(seed);
        b2World world = Bench.World(0);
        for (int i = 0; i < count; i++)
        {
            b2CircleDef def = new() { radius = (float)Number(random, 0.3, 2), density = (float)Number(random, 0.5, 3) };
            def.localPosition.Set((float)Number(random, -3, 3), (float)Number(random, -3, 3));
            yield return new PlacedShape(Turned(world, random), def)
            {
                Center = (def.localPosition.x, def.localPosition.y),
                Radius = def.radius,
            };
        }
    }

    public static b2Vec2 V((double X, double Y) p) => new((float)p.X, (float)p.Y);

    public static double Number(Random random, double least, double most) => least + ((most - least) * random.NextDouble());

    public static double Cross((double X, double Y) o, (double X, double Y) a, (double X, double Y) b) =>
        ((a.X - o.X) * (b.Y - o.Y)) - ((a.Y - o.Y) * (b.X - o.X));

    public static double Distance((double X, double Y) a, (double X, double Y) b) =>
        Math.Sqrt(((a.X - b.X) * (a.X - b.X)) + ((a.Y - b.Y) * (a.Y - b.Y)));

    public static (double X, double Y) Turned((double X, double Y) p, double angle) =>
        ((Math.Cos(angle) * p.X) - (Math.Sin(angle) * p.Y), (Math.Sin(angle) * p.X) + (Math.Cos(angle) * p.Y));

    /// <summary>Where a point of the body is in the world.</summary>
    public (double X, double Y) World((double X, double Y) p)
    {
        (double x, double y) = Turned(p, Body.GetAngle());
        return (Body.GetPosition().x + x, Body.GetPosition().y + y);
    }

    public (double X, double Y)[] WorldCorners() => [.. Corners.Select(World)];

    private static b2Body Turned(b2World world, Random random)
    {
        b2BodyDef def = new() { angle = (float)Number(random, -4, 4) };
        def.position.Set((float)Number(random, -4, 4), (float)Number(random, -4, 4));
        return world.CreateBody(def);
    }
}
