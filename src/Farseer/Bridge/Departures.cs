using System;
using System.Collections.Generic;
using Farseer.Engine.Simulation;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Finds the pairs in contact that come to an end because a geom of them leaves, so that their separation can be told.</summary>
internal sealed class Departures : IContactVisitor
{
    private readonly ObjectTable _table;
    private readonly List<Geom> _first = new List<Geom>();
    private readonly List<Geom> _second = new List<Geom>();

    public Departures(ObjectTable table) => _table = table;

    public void Collect(World world) => world.VisitContacts(this);

    public void Visit(int colliderA, int colliderB, ReadOnlySpan<ContactPoint> points)
    {
        Geom? a = _table.Geom(colliderA);
        Geom? b = _table.Geom(colliderB);
        if (a is null || b is null || !(a.IsLeaving || b.IsLeaving) || (a.OnSeparation is null && b.OnSeparation is null))
        {
            return;
        }

        bool flip = a.Id > b.Id;
        _first.Add(flip ? b : a);
        _second.Add(flip ? a : b);
    }

    /// <summary>Tells them, after the geoms are gone; a handler may remove more, which then waits for the next update.</summary>
    public void Tell(EventRelay relay)
    {
        for (int i = 0; i < _first.Count; i++)
        {
            relay.Separate(_first[i], _second[i]);
        }

        _first.Clear();
        _second.Clear();
    }
}
