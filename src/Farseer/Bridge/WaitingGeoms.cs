using System.Collections.Generic;
using Farseer.Engine.Bodies;
using Farseer.Engine.Shapes;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Geoms that wait for the next update, or for a new outline or body in it, in a world of their own that only queries see. If a query took
/// them into that of the simulator, bodies would get other places there than without it, and the run other bits.
/// </summary>
internal sealed class WaitingGeoms
{
    private readonly List<Entry> _entries = new List<Entry>();
    private readonly List<Geom> _now = new List<Geom>();
    private readonly List<Handle> _bodies = new List<Handle>();
    private Geom?[] _byCollider = [];
    private World? _world;

    /// <summary>Where they are, once there was one.</summary>
    public World World => _world ??= new World();

    public Geom? Find(int collider) => collider < _byCollider.Length ? _byCollider[collider] : null;

    /// <summary>The first piece of a geom that waits; -1: it does not.</summary>
    public int FirstPiece(Geom geom)
    {
        for (int i = 0; i < _entries.Count; i++)
        {
            if (ReferenceEquals(_entries[i].Geom, geom))
            {
                return World.Collider(_entries[i].Collider).FirstPiece;
            }
        }

        return -1;
    }

    /// <summary>Brings the world up to date.</summary>
    /// <returns>False if nothing waits.</returns>
    public bool Refresh(PhysicsSimulator simulator)
    {
        if (_entries.Count == 0 && !simulator.MayWait)
        {
            return false;
        }

        // Listing marks geoms for a while.
        lock (simulator.WaitingGate)
        {
            return RefreshAlone(simulator);
        }
    }

    private bool RefreshAlone(PhysicsSimulator simulator)
    {
        _now.Clear();
        simulator.ListWaiting(_now);
        if (_now.Count == 0 && _entries.Count == 0)
        {
            return false;
        }

        bool same = _now.Count == _entries.Count;
        for (int i = 0; same && i < _now.Count; i++)
        {
            same = _entries[i].IsOf(_now[i]);
        }

        if (!same)
        {
            Rebuild();
        }

        return _now.Count > 0;
    }

    private void Rebuild()
    {
        foreach (Handle body in _bodies)
        {
            World.DestroyBody(body);
        }

        _bodies.Clear();
        _entries.Clear();
        _byCollider = [];
        foreach (Geom geom in _now)
        {
            var entry = new Entry(geom);
            Handle body = World.CreateBody(entry.Body);
            entry.Collider = World.CreateCollider(body, entry.Shape, entry.Definition);
            World.Shapes.Order[entry.Collider.Index] = geom.Id;
            int place = entry.Collider.Index;
            if (place >= _byCollider.Length)
            {
                System.Array.Resize(ref _byCollider, System.Math.Max(place + 1, 2 * _byCollider.Length));
            }

            _byCollider[place] = geom;
            _bodies.Add(body);
            _entries.Add(entry);
        }
    }

    /// <summary>A geom as it was when it was put here.</summary>
    private struct Entry
    {
        public Handle Collider;

        public Entry(Geom geom)
        {
            Collider = default;
            Geom = geom;
            Shape = geom.Form!.Shape;
            Form = geom.Form;
            Definition = GeomLink.Describe(geom);
            Body = Place(geom);
        }

        public readonly Geom Geom { get; }

        public readonly ShapeGeometry Shape { get; }

        public readonly ColliderDef Definition { get; }

        public readonly BodyDef Body { get; }

        private readonly GeomForm Form { get; }

        public readonly bool IsOf(Geom geom)
        {
            if (!ReferenceEquals(geom, Geom) || !ReferenceEquals(geom.Form, Form))
            {
                return false;
            }

            BodyDef body = Place(geom);
            ColliderDef definition = GeomLink.Describe(geom);
            return body.X == Body.X && body.Y == Body.Y && body.Angle == Body.Angle && body.Flags == Body.Flags
                && definition.Flags == Definition.Flags && definition.Categories == Definition.Categories
                && definition.Offset == Definition.Offset && definition.RotationOffset == Definition.RotationOffset;
        }

        private static BodyDef Place(Geom geom)
        {
            ref BodyPose pose = ref geom.Body.Link.PoseRef;
            return new BodyDef
            {
                X = pose.X,
                Y = pose.Y,
                Angle = pose.Angle,
                Mass = 1,
                Inertia = 1,
                Flags = BodyFlags.Static | (geom.Body.Enabled ? BodyFlags.Enabled : BodyFlags.None),
            };
        }
    }
}
