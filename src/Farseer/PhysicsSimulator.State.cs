using System;
using System.Collections.Generic;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Interfaces;

namespace FarseerGames.FarseerPhysics;

/// <content>Saving and restoring in place.</content>
public partial class PhysicsSimulator
{
    private StateRoster? _present;

    /// <summary>Captures the state into a new object: see <see cref="Capture(PhysicsSimulatorState)"/>.</summary>
    /// <returns>The state.</returns>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">An update runs, or an item of your own does not implement <see cref="ISavedState"/>.</exception>
    public PhysicsSimulatorState Capture()
    {
        var state = new PhysicsSimulatorState();
        Capture(state);
        return state;
    }

    /// <summary>
    /// Captures everything that influences a later update or event: poses, velocities, impulses from which the next step starts, sleep, springs,
    /// controllers, what waits to be taken in or out, filters, handlers and settings. After <see cref="Restore"/> the same calls give the same bits.
    /// </summary>
    /// <remarks>Not captured: tags and names, the number of workers, diagnostics, and the state of objects that handlers refer to.</remarks>
    /// <param name="state">Where to; what it held is lost.</param>
    /// <exception cref="ArgumentNullException"><paramref name="state"/> is null.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">
    /// An update runs; or a joint, spring, controller or broad phase of your own does not implement <see cref="ISavedState"/>, whose type is named.
    /// </exception>
    public void Capture(PhysicsSimulatorState state)
    {
        ThrowIfDisposed();
        Require.NotNull(state, nameof(state));
        RequireOutside(nameof(Capture));
        StateRoster present = _present ??= new StateRoster();
        Gather(present);
        CheckSavers(present);
        StateStream s = state.Stream;
        state.Owner = null;
        Gather(state.Roster);
        s.BeginWriting();
        Visit(s, state.Roster);
        s.EndWriting();
        state.Owner = this;
    }

    /// <summary>
    /// Goes back to a state. Objects stay the same instances: what was added since is taken out and stays where it is, belonging to no simulator; what
    /// was removed or disposed since is back.
    /// </summary>
    /// <param name="state">A state of this simulator.</param>
    /// <exception cref="ArgumentNullException"><paramref name="state"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="state"/> holds nothing, or is of another simulator.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">
    /// An update runs, or something that is to come back belongs to another simulator by now; nothing is changed then.
    /// </exception>
    public void Restore(PhysicsSimulatorState state)
    {
        ThrowIfDisposed();
        Require.NotNull(state, nameof(state));
        RequireOutside(nameof(Restore));
        if (!ReferenceEquals(state.Owner, this))
        {
            throw new ArgumentException(state.Owner is null ? "The state holds nothing." : "The state is of another simulator.", nameof(state));
        }

        StateRoster roster = state.Roster;
        StateRoster present = _present ??= new StateRoster();
        Gather(present);
        if (!present.IsSameAs(roster))
        {
            RequireFree(roster);
            roster.Index();
            TakeOutNew(present, roster);
        }

        present.Clear();
        StateStream s = state.Stream;
        s.BeginReading();
        Visit(s, roster);
        s.EndReading();
    }

    private static bool IsUsersOwn(object item) => item.GetType().Assembly != typeof(PhysicsSimulator).Assembly;

    private static void CheckSaver(object item)
    {
        if (IsUsersOwn(item) && item is not ISavedState)
        {
            throw new InvalidOperationException(
                "The state cannot be captured: " + item.GetType().FullName + " does not implement " + nameof(ISavedState) + ".");
        }
    }

    private static void VisitOwn(StateStream s, object item)
    {
        if (!IsUsersOwn(item) || item is not ISavedState own)
        {
            return;
        }

        int size = s.Value(s.IsReading ? 0 : own.StateSize);
        if (size < 0)
        {
            throw new InvalidOperationException(item.GetType().FullName + "." + nameof(ISavedState.StateSize) + " must not be negative.");
        }

        Span<byte> bytes = s.Take(size);
        if (s.IsReading)
        {
            own.RestoreState(bytes);
        }
        else
        {
            bytes.Clear();
            own.SaveState(bytes);
        }
    }

    private static void TakeOutNew(StateRoster present, StateRoster roster)
    {
        foreach (Joint joint in present.Joints)
        {
            if (!roster.Has(joint))
            {
                joint.TakeOut();
            }
        }

        foreach (Spring spring in present.Springs)
        {
            if (!roster.Has(spring))
            {
                spring.TakeOut();
            }
        }

        foreach (Controller controller in present.Controllers)
        {
            if (!roster.Has(controller))
            {
                controller.TakeOut();
            }
        }

        foreach (Geom geom in present.Geoms)
        {
            if (!roster.Has(geom))
            {
                geom.TakeOut();
            }
        }

        foreach (Body body in present.Bodies)
        {
            if (!roster.Has(body))
            {
                body.TakeOut();
            }
        }
    }

    private void RequireOutside(string call)
    {
        if (_isUpdating)
        {
            throw new InvalidOperationException(call + " must not be called from a handler of the same simulator's update.");
        }
    }

    private void RequireFree(StateRoster roster)
    {
        foreach (Body body in roster.Bodies)
        {
            RequireFree(body, body.Simulator);
        }

        foreach (Geom geom in roster.Geoms)
        {
            RequireFree(geom, geom.Simulator);
        }

        foreach (Joint joint in roster.Joints)
        {
            RequireFree(joint, joint.Simulator);
        }

        foreach (Spring spring in roster.Springs)
        {
            RequireFree(spring, spring.Simulator);
        }

        foreach (Controller controller in roster.Controllers)
        {
            RequireFree(controller, controller.Simulator);
        }
    }

    private void RequireFree(object item, PhysicsSimulator? simulator)
    {
        if (simulator is not null && !ReferenceEquals(simulator, this))
        {
            throw new InvalidOperationException("A " + item.GetType().Name + " that is to come back belongs to another simulator by now.");
        }
    }

    private void CheckSavers(StateRoster roster)
    {
        CheckSaver(_broadPhaseCollider);
        foreach (Joint joint in roster.Joints)
        {
            CheckSaver(joint);
        }

        foreach (Spring spring in roster.Springs)
        {
            CheckSaver(spring);
        }

        foreach (Controller controller in roster.Controllers)
        {
            CheckSaver(controller);
        }
    }

    private void Gather(StateRoster r)
    {
        r.Clear();
        for (int i = 0; i < _table.BodyEnd; i++)
        {
            if (_table.Body(i) is { } body)
            {
                r.EnterOnce(r.Bodies, body);
            }
        }

        for (int i = 0; i < _table.GeomEnd; i++)
        {
            if (_table.Geom(i) is { } geom)
            {
                r.EnterOnce(r.Geoms, geom);
            }
        }

        Gather(r, BodyList);
        Gather(r, _bodiesIn);
        Gather(r, _bodiesOut);
        Gather(r, _bodiesDisposed);
        Gather(r, _pending);
        Gather(r, _listeners);
        Gather(r, GeomList);
        Gather(r, _geomsIn);
        Gather(r, _geomsOut);
        Gather(r, _geomsDisposed);
        Gather(r, _geomsChanged);
        GatherItems(r);
        GatherParts(r);
    }

    private void GatherItems(StateRoster r)
    {
        Gather(r.Joints, JointList);
        Gather(r.Joints, _joints.Waiting);
        Gather(r.Joints, _jointsDisposed);
        Gather(r.Springs, SpringList);
        Gather(r.Springs, _springs.Waiting);
        Gather(r.Controllers, ControllerList);
        Gather(r.Controllers, _controllers.Waiting);
        r.Enter(r.Controllers, InactivityController);
        foreach ((Joint joint, Body taken) in _jointsChanged)
        {
            r.Enter(r.Joints, joint);
            Enter(r, taken);
        }

        foreach (Joint joint in r.Joints)
        {
            Enter(r, joint.FirstBody);
            Enter(r, joint.SecondBody);
            Enter(r, joint.Link.First);
            Enter(r, joint.Link.Second);
        }

        void Gather<T>(List<T> list, List<T> items)
            where T : class, IItem
        {
            foreach (T item in items)
            {
                if (item.Simulator is null || ReferenceEquals(item.Simulator, this))
                {
                    r.Enter(list, item);
                }
            }
        }
    }

    /// <summary>The bodies of geoms and the geoms of bodies, until there are no more.</summary>
    private void GatherParts(StateRoster r)
    {
        int nextBody = 0;
        int nextGeom = 0;
        while (nextBody < r.Bodies.Count || nextGeom < r.Geoms.Count)
        {
            for (; nextBody < r.Bodies.Count; nextBody++)
            {
                Body body = r.Bodies[nextBody];
                for (int i = 0; i < body.GeomCount; i++)
                {
                    Enter(r, body.GeomAt(i));
                }
            }

            for (; nextGeom < r.Geoms.Count; nextGeom++)
            {
                Enter(r, r.Geoms[nextGeom].Body);
                Enter(r, r.Geoms[nextGeom].Link.AttachedBody);
            }
        }
    }

    private void Gather(StateRoster r, List<Body> bodies)
    {
        foreach (Body body in bodies)
        {
            Enter(r, body);
        }
    }

    private void Gather(StateRoster r, List<Geom> geoms)
    {
        foreach (Geom geom in geoms)
        {
            Enter(r, geom);
        }
    }

    // What is in the world stands in the table, and was entered from there.
    private void Enter(StateRoster r, Body? body)
    {
        if (body is not null && !ReferenceEquals(body.Link.World, World)
            && (body.Simulator is null || ReferenceEquals(body.Simulator, this)))
        {
            r.Enter(r.Bodies, body);
        }
    }

    private void Enter(StateRoster r, Geom geom)
    {
        if (!geom.Link.IsAttached && (geom.Simulator is null || ReferenceEquals(geom.Simulator, this)))
        {
            r.Enter(r.Geoms, geom);
        }
    }

    private void Visit(StateStream s, StateRoster roster)
    {
        World.Visit(s);
        VisitSettings(s);
        VisitLists(s);
        foreach (Body body in roster.Bodies)
        {
            body.Visit(s);
        }

        foreach (Geom geom in roster.Geoms)
        {
            geom.Visit(s);
        }

        foreach (Joint joint in roster.Joints)
        {
            joint.Visit(s);
        }

        foreach (Spring spring in roster.Springs)
        {
            spring.Visit(s);
        }

        foreach (Controller controller in roster.Controllers)
        {
            controller.Visit(s);
        }

        if (s.IsReading)
        {
            FillTables(roster);
        }

        VisitOwn(s, _broadPhaseCollider);
        VisitOwn(s, roster.Joints);
        VisitOwn(s, roster.Springs);
        VisitOwn(s, roster.Controllers);
    }

    private static void VisitOwn<T>(StateStream s, List<T> items)
        where T : class
    {
        foreach (T item in items)
        {
            VisitOwn(s, item);
        }
    }

    private void VisitSettings(StateStream s)
    {
        s.Value(ref _biasFactor);
        s.Value(ref _maxContactsToDetect);
        s.Value(ref _maxContactsToResolve);
        s.Value(ref _quirks);
        s.Value(ref _errorBudget);
        s.Value(ref _allowedPenetration);
        Enabled = s.Value(Enabled);
        StepCount = s.Value(StepCount);
        s.Reference(ref BodyQuarantined);
        _scaling = s.Reference(_scaling)!;
        _scaling.Visit(s);
        _broadPhaseCollider = s.Reference(_broadPhaseCollider)!;
        _relay.Collider = s.Reference(_relay.Collider);
        _relay.Collider?.Visit(s);
        Report = StepReport.Visit(s, Report);
        if (s.IsReading)
        {
            _arbiters.IsStale = true;
        }
    }

    private void VisitLists(StateStream s)
    {
        s.References(BodyList);
        s.References(GeomList);
        s.References(JointList);
        s.References(SpringList);
        s.References(ControllerList);
        _joints.Visit(s);
        _springs.Visit(s);
        _controllers.Visit(s);
        s.References(_bodiesIn);
        s.References(_bodiesOut);
        s.References(_bodiesDisposed);
        s.References(_pending);
        s.References(_listeners);
        s.References(_geomsIn);
        s.References(_geomsOut);
        s.References(_geomsDisposed);
        s.References(_geomsChanged);
        s.References(_jointsDisposed);
        s.References(_jointRelay.Written);
        s.Value(ref _geomsWaiting);
        s.Value(ref _clearWaits);
        s.Value(ref _jointBodiesChanged);
        s.Reference(ref _lastForm);
        int changed = s.Value(_jointsChanged.Count);
        for (int i = 0; i < changed && !s.IsReading; i++)
        {
            s.Reference(_jointsChanged[i].Joint);
            s.Reference(_jointsChanged[i].Taken);
        }

        if (s.IsReading)
        {
            _jointsChanged.Clear();
            for (int i = 0; i < changed; i++)
            {
                Joint joint = s.Reference<Joint>(null)!;
                _jointsChanged.Add((joint, s.Reference<Body>(null)!));
            }
        }
    }

    private void FillTables(StateRoster roster)
    {
        _table.Clear();
        _jointRelay.ClearTable();
        foreach (Body body in roster.Bodies)
        {
            if (ReferenceEquals(body.Link.World, World))
            {
                _table.SetBody(body.Link.Handle.Index, body);
            }
        }

        foreach (Geom geom in roster.Geoms)
        {
            if (geom.Link.IsAttached)
            {
                _table.SetGeom(geom.Link.Handle.Index, geom);
            }
        }

        foreach (Joint joint in roster.Joints)
        {
            if (joint.Link.IsAttached)
            {
                _jointRelay.Set(joint.Link.Index, joint);
            }
        }
    }
}
