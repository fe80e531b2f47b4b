using System;
using System.Runtime.ExceptionServices;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Passes the engine's events on to the handlers of the user. An exception from a handler does not tear the step apart: the first
/// one is kept and thrown again when the step is complete.
/// </summary>
internal sealed class EventRelay : IStepHooks
{
    private readonly PhysicsSimulator _simulator;
    [NotState(Why.Elsewhere)]
    private readonly ObjectTable _table;
    [NotState(Why.OfOneStep)]
    private ContactList? _contacts;
    [NotState(Why.Calm)]
    private ExceptionDispatchInfo? _failure;

    public EventRelay(PhysicsSimulator simulator, ObjectTable table)
    {
        _simulator = simulator;
        _table = table;
    }

    /// <summary>The collider in use, whose handlers may refuse a pair; null for a user's own, which asks by itself.</summary>
    public EngineCollider? Collider { get; set; }

    /// <summary>The points of a pair as its handlers see them: nobody else needs a list.</summary>
    private ContactList Contacts => _contacts ??= new ContactList(16);

    /// <summary>Keeps events for those who read them after the update.</summary>
    public StepRecorder Recorder { get; } = new StepRecorder();

    /// <summary>Pairs that pass through one-way surfaces.</summary>
    public OneWayPairs OneWay { get; } = new OneWayPairs();

    /// <summary>True while a collider is being taken out: the engine then ends its contacts.</summary>
    [NotState(Why.Calm)]
    public bool IsRemoving { get; set; }

    /// <summary>True while everything is being taken out, which tells nobody.</summary>
    [NotState(Why.Calm)]
    public bool IsClearing { get; set; }

    /// <summary>
    /// Also while disposed geoms wait to leave. To ask for each pair whether its geoms live was a tenth of a tumbling scene.
    /// </summary>
    public bool JudgesPairs => _simulator.HasDisposedGeoms || (Collider is not null && Collider.HasHandlers);

    public bool AcceptPair(int colliderA, int colliderB)
    {
        if (!Find(colliderA, colliderB, out Geom a, out Geom b, out _))
        {
            return false;
        }

        try
        {
            return Collider is null || Collider.Accept(a, b);
        }
        catch (Exception exception)
        {
            Keep(exception);
            return true;
        }
    }

    public ContactAnswer OnContact(int colliderA, int colliderB, ReadOnlySpan<ContactPoint> points, bool began)
    {
        if (!Find(colliderA, colliderB, out Geom a, out Geom b, out bool flip))
        {
            return ContactAnswer.Untold;
        }

        if (began)
        {
            Recorder.Begin(a, b);
        }

        if (a.OneWayDirection != System.Numerics.Vector2.Zero || b.OneWayDirection != System.Numerics.Vector2.Zero)
        {
            if (!OneWay.Accepts(a, b, points, flip, began))
            {
                return ContactAnswer.Refuse;
            }
        }
        else
        {
            OneWay.End(a, b);
        }

        if (a.OnCollision is null && b.OnCollision is null)
        {
            return ContactAnswer.Respond;
        }

        int most = Math.Min(_simulator.MaxContactsToDetect, _simulator.MaxContactsToResolve);
        ContactCopy.Fill(Contacts, points, a, b, flip, most);
        return Ask(a, b) && AskSecond(b, a) ? ContactAnswer.Respond : ContactAnswer.Refuse;
    }

    public void OnSeparation(int colliderA, int colliderB)
    {
        if (IsClearing)
        {
            return;
        }

        bool found = Find(colliderA, colliderB, out Geom a, out Geom b, out _);
        bool passed = false;
        if (a is not null && b is not null)
        {
            Recorder.End(a, b);
            passed = OneWay.End(a, b);
        }

        // Of a pair that passed nobody was asked.
        if (passed)
        {
            return;
        }

        if (IsRemoving && (_simulator.Quirks & Farseer201Quirks.NoSeparationOnRemoval) != 0)
        {
            return;
        }

        if (found || (IsRemoving && a is not null && b is not null))
        {
            Separate(a!, b!);
        }
    }

    public void OnPush(int colliderA, int colliderB, in PushRecord push)
    {
        if (Find(colliderA, colliderB, out Geom a, out Geom b, out bool flip))
        {
            Recorder.Push(a, b, push, flip);
        }
    }

    public void ApplyForces(float dt) => _simulator.ApplyForces(dt);

    public void Keep(Exception exception) => _failure ??= ExceptionDispatchInfo.Capture(exception);

    /// <summary>Throws what a handler threw during the step.</summary>
    public void Rethrow()
    {
        ExceptionDispatchInfo? failure = _failure;
        _failure = null;
        failure?.Throw();
    }

    /// <summary>Tells both geoms, the older one first, that they have parted.</summary>
    private void Separate(Geom a, Geom b)
    {
        Tell(a, b);
        Tell(b, a);
    }

    private void Tell(Geom geom, Geom other)
    {
        try
        {
            geom.OnSeparation?.Invoke(geom, other);
        }
        catch (Exception exception)
        {
            Keep(exception);
        }
    }

    /// <summary>The handler of the younger geom sees the normals from itself to the other.</summary>
    private bool AskSecond(Geom geom, Geom other)
    {
        if (geom.OnCollision is null)
        {
            return true;
        }

        bool turn = (_simulator.Quirks & Farseer201Quirks.NormalsFromOlderGeom) == 0;
        for (int i = 0; turn && i < Contacts.Count; i++)
        {
            Contact contact = Contacts[i];
            contact.Normal = -contact.Normal;
            Contacts[i] = contact;
        }

        return Ask(geom, other);
    }

    /// <summary>
    /// A handler that empties the list leaves nothing to respond to, which is the same as returning false; one that throws refuses nothing.
    /// </summary>
    private bool Ask(Geom geom, Geom other)
    {
        try
        {
            return geom.OnCollision is null || (geom.OnCollision(geom, other, Contacts) && Contacts.Count > 0);
        }
        catch (Exception exception)
        {
            Keep(exception);
            return true;
        }
    }

    /// <summary>The two geoms, the one created first as a. False if one is gone already, though its collider still is there.</summary>
    private bool Find(int colliderA, int colliderB, out Geom a, out Geom b, out bool flip)
    {
        Geom? first = _table.Geom(colliderA);
        Geom? second = _table.Geom(colliderB);
        a = first!;
        b = second!;
        flip = false;
        if (first is null || second is null || first.IsDisposed || second.IsDisposed)
        {
            return false;
        }

        if (first.Id > second.Id)
        {
            a = second;
            b = first;
            flip = true;
        }

        return true;
    }
}
