using System.Collections.Generic;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Everybody whose state is part of a simulator's: what is in it, what waits for it, and the bodies and geoms that these have.
/// </summary>
internal sealed class StateRoster
{
    private readonly HashSet<object> _seen = new HashSet<object>();

    public List<Body> Bodies { get; } = new List<Body>();

    public List<Geom> Geoms { get; } = new List<Geom>();

    public List<Joint> Joints { get; } = new List<Joint>();

    public List<Spring> Springs { get; } = new List<Spring>();

    public List<Controller> Controllers { get; } = new List<Controller>();

    public void Clear()
    {
        _seen.Clear();
        Bodies.Clear();
        Geoms.Clear();
        Joints.Clear();
        Springs.Clear();
        Controllers.Clear();
    }

    /// <summary>Enters somebody who may be there already.</summary>
    public void Enter<T>(List<T> list, T? item)
        where T : class
    {
        if (item is not null && _seen.Add(item))
        {
            list.Add(item);
        }
    }

    /// <summary>Enters somebody of a list, of whom it is known that he is not there yet.</summary>
    public void EnterOnce<T>(List<T> list, T item)
        where T : class => list.Add(item);

    /// <summary>True if both have the same ones in the same order, as is usual.</summary>
    public bool IsSameAs(StateRoster other) =>
        AreSame(Bodies, other.Bodies) && AreSame(Geoms, other.Geoms) && AreSame(Joints, other.Joints)
        && AreSame(Springs, other.Springs) && AreSame(Controllers, other.Controllers);

    /// <summary>Enters all of them for <see cref="Has"/>.</summary>
    public void Index()
    {
        _seen.Clear();
        Index(Bodies);
        Index(Geoms);
        Index(Joints);
        Index(Springs);
        Index(Controllers);
    }

    /// <summary>Whether somebody is there; <see cref="Index()"/> comes before.</summary>
    public bool Has(object item) => _seen.Contains(item);

    /// <summary>Writes, or reads, who is in it.</summary>
    public void Visit(StateStream s)
    {
        s.Section();
        s.References(Bodies);
        s.Section();
        s.References(Geoms);
        s.Section();
        s.References(Joints);
        s.Section();
        s.References(Springs);
        s.Section();
        s.References(Controllers);
    }

    private static bool AreSame<T>(List<T> one, List<T> other)
        where T : class
    {
        if (one.Count != other.Count)
        {
            return false;
        }

        for (int i = 0; i < one.Count; i++)
        {
            if (!ReferenceEquals(one[i], other[i]))
            {
                return false;
            }
        }

        return true;
    }

    private void Index<T>(List<T> items)
        where T : class
    {
        foreach (T item in items)
        {
            _seen.Add(item);
        }
    }
}
