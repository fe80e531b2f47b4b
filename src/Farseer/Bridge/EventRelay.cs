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
    private readonly ContactList _contacts = new ContactList(16);
    [NotState(Why.Calm)]
    private ExceptionDispatchInfo? _failure;

    public EventRelay(PhysicsSimulator simulator, ObjectTable table)
    {
        _simulator = simulator;
        _table = table;
    }

    /// <summary>The collider in use, whose handlers may refuse a pair; null for a user's own, which asks by itself.</summary>
    public EngineCollider? Collider { get; set; }

    /// <summary>True while a collider is being taken out: the engine then ends its contacts.</summary>
    [NotState(Why.Calm)]
    public bool IsRemoving { get; set; }

    /// <summary>True while everything is being taken out, which tells nobody.</summary>
    [NotState(Why.Calm)]
    public bool IsClearing { get; set; }

    /// <summary>Also while disposed geoms wait to leave. To ask for each pair whether its geoms live was a tenth of a tumbling scene.</summary>
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

    public bool OnContact(int colliderA, int colliderB, ReadOnlySpan<ContactPoint> points)
    {
        if (!Find(colliderA, colliderB, out Geom a, out Geom b, out bool flip))
        {
            return false;
        }

        int most = Math.Min(_simulator.MaxContactsToDetect, _simulator.MaxContactsToResolve);
        ContactCopy.Fill(_contacts, points, a, b, flip, most);
        try
        {
            return Ask(a, b) && Ask(b, a);
        }
        catch (Exception exception)
        {
            Keep(exception);
            return true;
        }
    }

    public void OnSeparation(int colliderA, int colliderB)
    {
        if ((IsRemoving && (_simulator.Quirks & Farseer201Quirks.NoSeparationOnRemoval) != 0) || IsClearing)
        {
            return;
        }

        if (Find(colliderA, colliderB, out Geom a, out Geom b, out _) || (IsRemoving && a is not null && b is not null))
        {
            Separate(a, b);
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
        try
        {
            a.OnSeparation?.Invoke(a, b);
            b.OnSeparation?.Invoke(b, a);
        }
        catch (Exception exception)
        {
            Keep(exception);
        }
    }

    /// <summary>A handler that empties the list leaves nothing to respond to, which is the same as returning false.</summary>
    private bool Ask(Geom geom, Geom other) =>
        geom.OnCollision is null || (geom.OnCollision(geom, other, _contacts) && _contacts.Count > 0);

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
