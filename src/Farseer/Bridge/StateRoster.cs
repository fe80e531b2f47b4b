using System;
using System.Collections.Generic;
using System.Threading;
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
    private static long s_lastRound;

    // Of so many items it is told at once whether one has changed: few enough that one who has costs little.
    private const int Together = 64;

    private long _round;
    private int _count;

    /// <summary>The last round that began in this process.</summary>
    public static long LastRound => Volatile.Read(ref s_lastRound);

    /// <summary>The round that it was last filled in.</summary>
    public long Round => _round;

    /// <summary>A state of the simulator is written or read, and items of the user's own are called.</summary>
    public bool IsInUse { get; set; }

    public List<Body> Bodies { get; } = new List<Body>();

    public List<Geom> Geoms { get; } = new List<Geom>();

    public List<Joint> Joints { get; } = new List<Joint>();

    public List<Spring> Springs { get; } = new List<Spring>();

    public List<Controller> Controllers { get; } = new List<Controller>();

    public void Clear()
    {
        Begin();
        Bodies.Clear();
        Geoms.Clear();
        Joints.Clear();
        Springs.Clear();
        Controllers.Clear();
    }

    /// <summary>Enters somebody who may be there already.</summary>
    public void Enter<T>(List<T> list, T? item)
        where T : class, IStatePart
    {
        if (item is not null && item.Mark.Round != _round)
        {
            EnterOnce(list, item);
        }
    }

    /// <summary>Enters somebody of whom it is known that he is not there yet.</summary>
    public void EnterOnce<T>(List<T> list, T item)
        where T : class, IStatePart
    {
        SetMark(item);
        list.Add(item);
    }

    /// <summary>Numbers all of them anew, for <see cref="Has"/> and for those who refer to them.</summary>
    public void Index()
    {
        Begin();
        Index(Bodies);
        Index(Geoms);
        Index(Joints);
        Index(Springs);
        Index(Controllers);
    }

    /// <summary>Whether somebody is there; <see cref="Index()"/> comes before.</summary>
    public bool Has(IStatePart item) => item.Mark.Round == _round;

    /// <summary>
    /// What a reference of a state is told by: a number that is the same in every simulation that was made in the same way.
    /// </summary>
    public ulong Number(object? item)
    {
        const ulong Others = 3;
        return item switch
        {
            null => 0,
            IStatePart part => Has(part) ? Others + (ulong)part.Mark.Place : 1,
            string text => Hash(text),
            _ => 2,
        };
    }

    /// <summary>Writes, or reads, who is in it.</summary>
    public void Visit(StateStream s)
    {
        s.Of("Roster").Section();
        s.References(Bodies);
        s.Section();
        s.References(Geoms);
        s.Section();
        s.References(Joints);
        s.Section();
        s.References(Springs);
        s.Section();
        s.References(Controllers);
        s.EndRoster();
    }

    /// <summary>Whether what is read next has the same ones in the same order, as is usual. If not it is to be read anew.</summary>
    public bool IsNext(StateStream s)
    {
        s.Section();
        return Are(Bodies) && Are(Geoms) && Are(Joints) && Are(Springs) && s.AreNext(Controllers);

        bool Are<T>(List<T> items)
            where T : class
        {
            bool same = s.AreNext(items);
            if (same)
            {
                s.Section();
            }

            return same;
        }
    }

    /// <summary>Writes, or reads, what states have of the bodies, geoms and joints; what has not changed stays as it is.</summary>
    public void VisitItems(StateStream s)
    {
        Visit(s, nameof(Body), Bodies, static body => body.ChangedIn, static (body, stream) => body.Visit(stream));
        Visit(s, nameof(Geom), Geoms, static geom => geom.ChangedIn, static (geom, stream) => geom.Visit(stream));
        Visit(s, nameof(Joint), Joints, static joint => joint.ChangedIn, static (joint, stream) => joint.Visit(stream));
        s.Section();
    }

    private static void Visit<T>(StateStream s, string kind, List<T> items, Func<T, long> changedIn, Action<T, StateStream> visit)
        where T : class, IStatePart
    {
        for (int first = 0; first < items.Count; first += Together)
        {
            int end = Math.Min(first + Together, items.Count);
            long changed = 0;
            for (int i = first; i < end; i++)
            {
                changed = Math.Max(changed, changedIn(items[i]));
            }

            s.Section(kind, first);
            for (int i = s.Holds(changed) ? end : first; i < end; i++)
            {
                visit(items[i], s.Of(kind, i, items[i]));
            }
        }
    }

    // What an item has of another roster is not mistaken: no two have the same number, not even those of other simulators.
    private void Begin()
    {
        _round = Interlocked.Increment(ref s_lastRound);
        _count = 0;
    }

    private static ulong Hash(string text)
    {
        ulong hash = StateHasher.Start;
        foreach (char letter in text)
        {
            hash = StateHasher.Add(hash, letter);
        }

        return hash;
    }

    private void SetMark(IStatePart item)
    {
        ref StateMark mark = ref item.Mark;
        mark.Round = _round;
        mark.Place = ++_count;
    }

    private void Index<T>(List<T> items)
        where T : class, IStatePart
    {
        foreach (T item in items)
        {
            SetMark(item);
        }
    }
}
