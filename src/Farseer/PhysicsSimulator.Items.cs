using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics;

/// <content>
/// What comes and goes. Additions and removals, also those from within handlers, wait for the next update, which takes them in
/// before the broad phase: geoms, bodies, controllers, springs; then out in the same order.
/// </content>
public partial class PhysicsSimulator
{
    private readonly List<Geom> _geomsIn = new List<Geom>();
    private readonly List<Body> _bodiesIn = new List<Body>();
    private readonly List<Geom> _geomsOut = new List<Geom>();
    private readonly List<Body> _bodiesOut = new List<Body>();
    private readonly List<Geom> _geomsDisposed = new List<Geom>();
    private readonly List<Body> _bodiesDisposed = new List<Body>();
    private readonly List<Geom> _geomsChanged = new List<Geom>();
    private int _geomsWaiting;
    private GeomForm? _lastForm;
    private bool _clearWaits;

    /// <summary>Adds a body; it takes part from the next update on. One that was added before is ignored.</summary>
    /// <param name="body">The body.</param>
    /// <exception cref="ArgumentNullException"><paramref name="body"/> is null.</exception>
    /// <exception cref="ArgumentException">The body is in another simulator.</exception>
    /// <exception cref="ObjectDisposedException">The simulator or the body is disposed.</exception>
    public void Add(Body body)
    {
        ThrowIfDisposed();
        Require.NotNull(body, nameof(body)).ThrowIfDisposed();
        if (body.Simulator is not null && !ReferenceEquals(body.Simulator, this))
        {
            throw new ArgumentException("The body belongs to another simulator.", nameof(body));
        }

        switch (body.Membership)
        {
            case Membership.RemoveQueued:
                body.Membership = Membership.Added;
                return;
            case Membership.None:
                body.Membership = Membership.AddQueued;
                body.Simulator = this;
                _bodiesIn.Add(body);
                return;
        }
    }

    /// <summary>
    /// Adds a geom; it takes part from the next update on. One that was added before is ignored. Its body need not be added: it is then an
    /// obstacle that nothing moves.
    /// </summary>
    /// <param name="geometry">The geom.</param>
    /// <exception cref="ArgumentNullException"><paramref name="geometry"/> is null.</exception>
    /// <exception cref="ArgumentException">
    /// The geom or its body is in another simulator, or it has no body or no vertices.
    /// </exception>
    /// <exception cref="ObjectDisposedException">The simulator or the geom is disposed.</exception>
    public void Add(Geom geometry)
    {
        ThrowIfDisposed();
        Require.NotNull(geometry, nameof(geometry)).ThrowIfDisposed();
        if (geometry.Body is null || geometry.Form is null)
        {
            throw new ArgumentException("The geom has no " + (geometry.Body is null ? "body" : "vertices") + " yet.", nameof(geometry));
        }

        if ((geometry.Simulator is not null && !ReferenceEquals(geometry.Simulator, this))
            || (geometry.Body.Simulator is not null && !ReferenceEquals(geometry.Body.Simulator, this)))
        {
            throw new ArgumentException("The geom or its body belongs to another simulator.", nameof(geometry));
        }

        switch (geometry.Membership)
        {
            case Membership.RemoveQueued:
                geometry.Membership = Membership.Added;
                return;
            case Membership.None:
                geometry.Membership = Membership.AddQueued;
                geometry.Simulator = this;
                geometry.Body.Simulator = this;
                _geomsIn.Add(geometry);
                _geomsWaiting++;
                return;
        }
    }

    /// <summary>
    /// Removes a body at the next update. As in the original its geoms stay: without it they are obstacles that nothing moves, for a level
    /// is often made of geoms whose bodies are in no simulator. <see cref="RemoveWithParts"/> takes them out too.
    /// </summary>
    /// <param name="body">The body; one that is in no simulator is ignored.</param>
    /// <exception cref="ArgumentNullException"><paramref name="body"/> is null.</exception>
    /// <exception cref="ArgumentException">The body belongs to another simulator.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public void Remove(Body body)
    {
        ThrowIfDisposed();
        Require.NotNull(body, nameof(body));
        if (body.Simulator is not null && !ReferenceEquals(body.Simulator, this))
        {
            throw new ArgumentException("The body belongs to another simulator.", nameof(body));
        }

        if (body.Membership == Membership.AddQueued)
        {
            body.Membership = Membership.None;
            ReleaseIfUnused(body);
        }
        else if (body.Membership == Membership.Added)
        {
            body.Membership = Membership.RemoveQueued;
            _bodiesOut.Add(body);
        }
    }

    /// <summary>
    /// Removes a body at the next update, and with it its geoms and the joints and springs of the library that hold it. None of them is
    /// disposed. (An addition to the original.)
    /// </summary>
    /// <param name="body">The body; one that is in no simulator is ignored, and its parts go.</param>
    /// <exception cref="ArgumentNullException"><paramref name="body"/> is null.</exception>
    /// <exception cref="ArgumentException">The body belongs to another simulator.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public void RemoveWithParts(Body body)
    {
        Remove(body);
        for (int i = 0; i < body.GeomCount; i++)
        {
            Geom geom = body.GeomAt(i);
            if (ReferenceEquals(geom.Simulator, this))
            {
                Remove(geom);
            }
        }

        _joints.RemoveWhere(j => ReferenceEquals(j.FirstBody, body) || ReferenceEquals(j.SecondBody, body));
        _springs.RemoveWhere(s => ReferenceEquals(s.FirstBody, body) || ReferenceEquals(s.SecondBody, body));
    }

    /// <summary>Removes a geom at the next update.</summary>
    /// <param name="geometry">The geom; one that is in no simulator is ignored.</param>
    /// <exception cref="ArgumentNullException"><paramref name="geometry"/> is null.</exception>
    /// <exception cref="ArgumentException">The geom belongs to another simulator.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public void Remove(Geom geometry)
    {
        ThrowIfDisposed();
        Require.NotNull(geometry, nameof(geometry));
        if (geometry.Simulator is not null && !ReferenceEquals(geometry.Simulator, this))
        {
            throw new ArgumentException("The geom belongs to another simulator.", nameof(geometry));
        }

        if (geometry.Membership == Membership.AddQueued)
        {
            _geomsWaiting--;
            Forget(geometry);
        }
        else if (geometry.Membership == Membership.Added)
        {
            geometry.Membership = Membership.RemoveQueued;
            _geomsOut.Add(geometry);
        }
    }

    /// <summary>
    /// Takes everything out at once, without events; from within a handler, at the end of the update. The settings stay. The items
    /// are not disposed and can be added again. What a handler of a list throws is thrown when all is out and all have been told.
    /// </summary>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    public void Clear()
    {
        ThrowIfDisposed();
        if (_isUpdating)
        {
            _clearWaits = true;
            return;
        }

        _clearWaits = false;
        Geom[] geoms;
        Body[] bodies;
        _relay.IsClearing = true;
        try
        {
            DropQueued();
            ClearJoints();
            for (int i = 0; i < _table.GeomEnd; i++)
            {
                if (_table.Geom(i) is { } geom)
                {
                    Release(geom);
                }
            }

            for (int i = 0; i < _table.BodyEnd; i++)
            {
                if (_table.Body(i) is { } body)
                {
                    Release(body);
                }
            }

            geoms = GeomList.Empty();
            bodies = BodyList.Empty();
            ClearControls();
        }
        finally
        {
            _relay.IsClearing = false;
        }

        ForgetPending();
        _relay.Recorder.Clear();
        _relay.OneWay.Clear();
        _arbiters.Clear();
        _arbiters.IsStale = false;

        // All is out before anybody hears of it, whatever he does or throws then.
        GeomList.Tell(geoms, _relay);
        BodyList.Tell(bodies, _relay);
        _relay.Rethrow();
    }

    internal void NoteDisposed(Body body)
    {
        _bodiesDisposed.Add(body);
        _jointBodiesChanged = true;
    }

    /// <summary>Disposed geoms wait to be taken out.</summary>
    internal bool HasDisposedGeoms => _geomsDisposed.Count > 0;

    internal void NoteDisposed(Geom geom) => _geomsDisposed.Add(geom);

    /// <summary>A geom in the simulator, or on its way there, got another outline or left a body.</summary>
    internal void NoteChanged(Geom geom, Body? left)
    {
        if (geom.Membership == Membership.Added || geom.Membership == Membership.RemoveQueued)
        {
            _geomsChanged.Add(geom);
            geom.WaitsForRemake = true;
        }

        // A body that still carries colliders is let go when these are made anew.
        if (left is not null && left.Link.Colliders == 0)
        {
            ReleaseIfUnused(left);
        }
    }

    private static void Forget(Geom geom)
    {
        geom.Membership = Membership.None;
        geom.Simulator = null;
        ReleaseIfUnused(geom.Body);
    }

    /// <summary>A body belongs to a simulator as long as it, or a geom of it, is in it or waits for it.</summary>
    private static void ReleaseIfUnused(Body body)
    {
        if (body.Membership != Membership.None || body.JointCount > 0)
        {
            return;
        }

        for (int i = 0; i < body.GeomCount; i++)
        {
            if (body.GeomAt(i).Membership != Membership.None)
            {
                return;
            }
        }

        body.Simulator = null;
    }

    private void ForgetPending()
    {
        foreach (Body body in _pending)
        {
            body.IsPendingNoted = false;
        }

        _pending.Clear();
    }

    private void DropQueued()
    {
        foreach (Geom geom in _geomsIn)
        {
            if (geom.Membership == Membership.AddQueued)
            {
                Forget(geom);
            }
        }

        foreach (Body body in _bodiesIn)
        {
            if (body.Membership == Membership.AddQueued)
            {
                body.Membership = Membership.None;
                ReleaseIfUnused(body);
            }
        }

        _geomsIn.Clear();
        _bodiesIn.Clear();
        _geomsOut.Clear();
        _bodiesOut.Clear();
        _geomsDisposed.Clear();
        _bodiesDisposed.Clear();
        foreach (Geom geom in _geomsChanged)
        {
            geom.WaitsForRemake = false;
        }

        _geomsChanged.Clear();
        _geomsWaiting = 0;
    }
}
