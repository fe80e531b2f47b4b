using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Queries;
using Farseer.Engine.Shapes;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using Farseer.Engine.Tests.NarrowPhase;

namespace Farseer.Engine.Tests.Queries;

/// <summary>A world of random shapes, concave ones among them, at random places, and answers to queries by trying every collider.</summary>
internal sealed class QueryScene
{
    private readonly Random _random;
    private readonly double _centerX;

    public QueryScene(int seed, int bodies, double side, double centerX = 0, bool oneSided = false)
    {
        _random = new Random(seed);
        _centerX = centerX;
        Side = side;
        for (int i = 0; i < bodies; i++)
        {
            Handle body = World.CreateBody(new BodyDef
            {
                X = centerX + Coordinate(),
                Y = Coordinate(),
                Angle = 6.3 * _random.NextDouble(),
                Mass = 1,
                Inertia = 1,
                Flags = BodyFlags.Enabled | (i % 3 == 0 ? BodyFlags.Static : BodyFlags.None),
            });
            Handles.Add(body);
            for (int k = _random.Next(3); k >= 0; k--)
            {
                Add(body, oneSided && _random.Next(4) == 0 ? ShapeBuilder.Chain(Star(_random), true) : Shape(_random));
            }
        }
    }

    public World World { get; } = new World();

    public double Side { get; }

    public List<Handle> Handles { get; } = new List<Handle>();

    public List<Handle> Colliders { get; } = new List<Handle>();

    public static ShapeGeometry Shape(Random random) =>
        random.Next(3) == 0 ? ShapeBuilder.Polygon(Star(random)) : RandomShape.Any(random);

    /// <summary>A star: concave, with two to six points.</summary>
    public static Vector2[] Star(Random random)
    {
        int count = 2 * random.Next(2, 7);
        return Enumerable.Range(0, count).Select(i =>
        {
            double angle = 2 * Math.PI * i / count;
            double radius = i % 2 == 0 ? 1 : 0.2 + (0.5 * random.NextDouble());
            return new Vector2((float)(radius * Math.Cos(angle)), (float)(radius * Math.Sin(angle)));
        }).ToArray();
    }

    public double Coordinate() => (_random.NextDouble() - 0.5) * Side;

    public RayInput Ray()
    {
        var ray = new RayInput { X = _centerX + Coordinate(), Y = Coordinate() };
        double length = Side * _random.NextDouble();
        switch (_random.Next(4))
        {
            case 0:
                ray.DirectionX = length;
                break;
            case 1:
                ray.DirectionY = -length;
                break;
            default:
                double angle = 6.3 * _random.NextDouble();
                ray.DirectionX = length * Math.Cos(angle);
                ray.DirectionY = length * Math.Sin(angle);
                break;
        }

        return ray;
    }

    public void Add(Handle body, ShapeGeometry shape)
    {
        Colliders.Add(World.CreateCollider(body, shape, new ColliderDef
        {
            Flags = ColliderFlags.CollisionEnabled | ColliderFlags.ResponseEnabled,
            Friction = 0.5f,
            Categories = 1u << _random.Next(3),
            CollidesWith = uint.MaxValue,
            Offset = new Vector2((float)_random.NextDouble(), (float)_random.NextDouble()),
            RotationOffset = (float)(6 * _random.NextDouble()),
        }));
    }

    /// <summary>Moves, removes and adds a few bodies and colliders.</summary>
    public void Disturb()
    {
        for (int i = 0; i < Handles.Count; i++)
        {
            switch (_random.Next(8))
            {
                case 0:
                    World.SetPosition(Handles[i], _centerX + Coordinate(), Coordinate());
                    break;
                case 1:
                    World.SetAngle(Handles[i], 6.3 * _random.NextDouble());
                    break;
                case 2:
                    Add(Handles[i], Shape(_random));
                    break;
                case 3 when Colliders.Count > 1:
                    int gone = _random.Next(Colliders.Count);
                    World.DestroyCollider(Colliders[gone]);
                    Colliders.RemoveAt(gone);
                    break;
                case 4:
                    World.SetFlags(Handles[i], BodyFlags.None, BodyFlags.Enabled);
                    break;
                case 5:
                    World.SetFlags(Handles[i], BodyFlags.Enabled, BodyFlags.None);
                    break;
            }
        }
    }

    public bool IsSeen(Handle collider, in QueryFilter filter)
    {
        ref ColliderInfo info = ref World.Collider(collider);
        return (World.Bodies.Flags[info.Body] & BodyFlags.Enabled) != 0
            && (info.Categories & filter.Categories) != 0
            && (info.Body != filter.IgnoredBody || info.Body == 0);
    }

    /// <summary>Distance of a point from a collider: not by the code that casts rays.</summary>
    public double Distance(Handle collider, double x, double y) =>
        PointQuery.SignedDistance(World.Shapes, collider.Index, World.Bodies.Pose[World.Collider(collider).Body], x, y);

    /// <summary>
    /// The share of a way at which a disc first touches a collider, by going on by the distance that is left; infinite if it does not. Not
    /// by all of it: normals are rounded to floats, so it may be said too large by 6e-8 of it, and past a line nothing would say so.
    /// </summary>
    public double March(Handle collider, in RayInput ray, double radius)
    {
        double length = Math.Sqrt((ray.DirectionX * ray.DirectionX) + (ray.DirectionY * ray.DirectionY));
        double t = 0;
        for (int i = 0; i < 100_000; i++)
        {
            double gap = Distance(collider, ray.X + (t * ray.DirectionX), ray.Y + (t * ray.DirectionY)) - radius;
            if (gap <= 1e-10)
            {
                return t;
            }

            t += gap * (1 - 1e-7) / length;
            if (!(t <= 1))
            {
                break;
            }
        }

        return double.PositiveInfinity;
    }
}
