using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Behavior;

/// <summary>
/// A world that follows from a seed, in which something happens all the time and nothing is ever added: boxes, discs, polygons and
/// compounds between walls, some within each other, some elastic, with joints, springs, controllers and handlers; bodies are kicked, put
/// elsewhere, switched off and on, joints and gravity as well. What happens in a step follows from the seed and the step, and what makes it
/// happen allocates nothing.
/// </summary>
internal sealed class WarmWorld
{
    private const int Period = 7;
    private readonly int _seed;
    private readonly List<Geom> _geoms = new List<Geom>();
    private readonly List<object> _items = new List<object>();
    private readonly List<Body> _moving = new List<Body>();
    private readonly float _width;
    private int _told;
    private readonly bool _switches;
    private int _step;

    /// <param name="seed">Which world.</param>
    /// <param name="switches">Joints, springs, controllers and bodies are switched off and on: what hangs together is another thing each
    /// time.</param>
    public WarmWorld(int seed, bool switches)
    {
        _seed = seed;
        _switches = switches;
        var random = new Random(seed);
        Simulator = Falling();
        Simulator.AllowSleep = random.Next(3) > 0;
        Simulator.EnableDiagnostics = random.Next(4) == 0;
        int bodies =
            random.Next(4) switch { 0 => random.Next(1, 6), 1 => random.Next(6, 20), 2 => random.Next(20, 60), _ => random.Next(60, 160) };
        _width = 60 + (MathF.Sqrt(bodies) * (20 + random.Next(40)));
        AddWalls(random);
        bool elastic = random.Next(3) == 0;
        bool deep = random.Next(4) == 0;
        for (int i = 0; i < bodies; i++)
        {
            AddBody(random, elastic, deep);
        }

        int kinds = random.Next(3) == 0 ? 0 : random.Next(1, 6);
        // What a user writes cannot be captured.
        string[] all = Kinds.All.Where(kind => !kind.StartsWith("Own", StringComparison.Ordinal)).ToArray();
        for (int i = 0; i < kinds; i++)
        {
            var pair = new Kinds.Pair(Simulator, Place(random) - new Vector2(15, 0));
            object item = Kinds.Make(all[random.Next(all.Length)], pair);
            Kinds.Add(Simulator, item);
            _items.Add(item);
            _geoms.Add(pair.GeomA);
            _geoms.Add(pair.GeomB);
            _moving.Add(pair.A);
            _moving.Add(pair.B);
        }

        AddNet(random);

        // A body has room for what is done to it from outside from the first time on.
        foreach (Body body in _moving)
        {
            body.ApplyImpulse(Vector2.UnitX);
        }

        if (random.Next(2) == 0)
        {
            foreach (Geom geom in _geoms)
            {
                Listen(geom, random);
            }
        }
    }

    public PhysicsSimulator Simulator { get; }

    public int Told => _told;

    /// <summary>One step, with what happens before it.</summary>
    public void Step(int step)
    {
        _step = step;
        uint chance = Mix((uint)((_seed * 7919) + step));
        if (chance % Period == 0)
        {
            Disturb(chance / Period);
        }

        Simulator.Update(Sandbox.Step);
    }

    private static uint Mix(uint value)
    {
        value = (value ^ (value >> 16)) * 0x45D9F3B;
        value = (value ^ (value >> 16)) * 0x45D9F3B;
        return value ^ (value >> 16);
    }

    private void Disturb(uint chance)
    {
        Body body = _moving[(int)(chance / 8 % (uint)_moving.Count)];
        var way = new Vector2((int)(chance / 64 % 41) - 20, (int)(chance / 4096 % 41) - 30);
        switch (chance % 8)
        {
            case 0 when _switches && _items.Count > 0:
                object item = _items[(int)(chance / 8 % (uint)_items.Count)];
                Kinds.Enable(item, !IsEnabled(item));
                break;
            case 1:
                body.Position = new Vector2(way.X / 20 * (_width / 3), -60 + way.Y);
                break;
            case 2:
                Simulator.Gravity = new Vector2(way.X, 100);
                break;
            case 3:
                body.LinearVelocity = 20 * way;
                break;
            case 4 when _switches:
                body.Enabled = !body.Enabled;
                break;
            default:
                body.ApplyImpulse(body.Mass * 4 * way);
                break;
        }
    }

    private static bool IsEnabled(object item) => item switch
    {
        Joint joint => joint.Enabled,
        FarseerGames.FarseerPhysics.Dynamics.Springs.Spring spring => spring.Enabled,
        _ => ((Controller)item).Enabled,
    };

    private Vector2 Place(Random random) => new Vector2((random.NextSingle() - 0.5f) * (_width - 60), -20 - (random.NextSingle() * _width));

    private void AddWalls(Random random)
    {
        float height = 4 * _width;
        Wall(new Vector2(0, 10), _width + 40, 20);
        Wall(new Vector2((_width / 2) + 10, -height / 2), 20, height);
        Wall(new Vector2((-_width / 2) - 10, -height / 2), 20, height);
        if (random.Next(3) == 0)
        {
            Body ground = BodyFactory.Instance.CreateBody(Simulator, 1, 1);
            ground.IsStatic = true;
            float half = _width / 2;
            _geoms.Add(GeomFactory.Instance.CreateChainGeom(
                Simulator, ground, Outline(-half, -20, -half / 2, -3, 0, -12, half / 2, -2, half, -25), false));
        }
    }

    private void Wall(Vector2 place, float width, float height)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(Simulator, width, height, 1);
        body.IsStatic = true;
        body.Position = place;
        _geoms.Add(GeomFactory.Instance.CreateRectangleGeom(Simulator, body, width, height));
    }

    private void AddBody(Random random, bool elastic, bool deep)
    {
        float size = 6 + random.Next(16);
        Vector2 place = Place(random);
        place.Y = deep ? place.Y / 4 : place.Y;
        float mass = random.Next(6) == 0 ? 20 : 1;
        Geom geom;
        switch (random.Next(4))
        {
            case 0:
                geom = Ball(Simulator, place, size / 2, mass);
                break;
            case 1:
                Vertices outline = Outline(0, 0, size, 0, size, size / 3, size / 3, size / 3, size / 3, size, 0, size);
                Body corner = BodyFactory.Instance.CreatePolygonBody(Simulator, outline, mass);
                corner.Position = place;
                geom = GeomFactory.Instance.CreatePolygonGeom(Simulator, corner, outline, 0);
                break;
            case 2:
                geom = Ball(Simulator, place, size / 3, mass);
                _geoms.Add(GeomFactory.Instance.CreateCircleGeom(Simulator, geom.Body, size / 3, 16, new Vector2(size / 2, 0), 0));
                break;
            default:
                geom = Box(Simulator, place, size, size / (1 + random.Next(2)), mass);
                break;
        }

        geom.RestitutionCoefficient = elastic && random.Next(2) == 0 ? random.NextSingle() : 0;
        geom.FrictionCoefficient = random.NextSingle();
        geom.Body.Rotation = random.NextSingle();
        geom.Body.IsAutoIdle = random.Next(2) == 0;
        _geoms.Add(geom);
        _moving.Add(geom.Body);
    }

    /// <summary>Sometimes a mesh of bodies on hinges, or a chain.</summary>
    private void AddNet(Random random)
    {
        int columns = random.Next(4) switch { 0 => random.Next(2, 5), 1 => 1, _ => 0 };
        int rows = random.Next(2, 6);
        Vector2 corner = Place(random) - new Vector2(20, 40);
        var net = new Geom[columns, rows];
        for (int i = 0; i < columns; i++)
        {
            for (int k = 0; k < rows; k++)
            {
                net[i, k] = Ball(Simulator, corner + new Vector2(10 * i, 10 * k), 3);
                _geoms.Add(net[i, k]);
                _moving.Add(net[i, k].Body);
                Hinge(net[i, k], i > 0 ? net[i - 1, k] : null);
                Hinge(net[i, k], k > 0 ? net[i, k - 1] : null);
            }
        }
    }

    private void Hinge(Geom geom, Geom? other)
    {
        if (other is null)
        {
            return;
        }

        var joint = new RevoluteJoint(geom.Body, other.Body, (geom.Body.Position + other.Body.Position) / 2);
        Simulator.Add(joint);
        _items.Add(joint);
    }

    private void Listen(Geom geom, Random random)
    {
        if (random.Next(2) == 0)
        {
            geom.OnCollision += (_, _, contacts) =>
            {
                _told += contacts.Count;
                return true;
            };
        }

        if (random.Next(2) == 0)
        {
            geom.OnSeparation += (_, _) => _told++;
        }

        if (random.Next(8) == 0)
        {
            geom.OnCollision += (_, _, _) => _step % 3 > 0;
        }
    }
}
