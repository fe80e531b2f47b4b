using System;
using System.Collections.Generic;
using System.Runtime.ExceptionServices;
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
    // Who is here now, and who was in the state that is gone back to.
    [NotState(Why.OfOneStep)]
    private StateRoster? _roster;
    [NotState(Why.OfOneStep)]
    private StateRoster? _former;


    /// <summary>For <see cref="Write"/> and <see cref="Read"/> to fill: empty between calls.</summary>
    internal StateRoster Present => _roster ??= new StateRoster();

    /// <summary>For <see cref="Read"/> to fill: empty between calls.</summary>
    internal StateRoster Former => _former ??= new StateRoster();

    /// <summary>Captures the state into a new object: see <see cref="Capture(PhysicsSimulatorState)"/>.</summary>
    /// <returns>The state.</returns>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">
    /// An update runs, or an item of your own does not implement <see cref="ISavedState"/>.
    /// </exception>
    public PhysicsSimulatorState Capture()
    {
        var state = new PhysicsSimulatorState();
        Capture(state);
        return state;
    }

    /// <summary>
    /// Captures everything that influences a later update or event: poses, velocities, impulses from which the next step starts,
    /// sleep, springs, controllers, what waits to be taken in or out, filters, handlers and settings. After <see cref="Restore"/>
    /// the same calls give the same bits.
    /// </summary>
    /// <remarks>
    /// Not captured: tags and names, the number of workers, diagnostics, and the state of objects that handlers refer to.
    /// </remarks>
    /// <param name="state">The state to fill; what it held is lost, also if an exception is thrown: it holds nothing then.</param>
    /// <exception cref="ArgumentNullException"><paramref name="state"/> is null.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">
    /// An update runs; or a joint, spring, controller or broad phase of your own does not implement <see cref="ISavedState"/>: its
    /// type is named.
    /// </exception>
    public void Capture(PhysicsSimulatorState state)
    {
        ThrowIfDisposed();
        Require.NotNull(state, nameof(state));
        RequireOutside(nameof(Capture));
        state.Owner = null;
        Write(state.Stream, Present);
        state.Owner = this;
    }

    /// <summary>
    /// Goes back to a state. Objects stay the same instances: what was added since is taken out and stays where it is, belonging to
    /// no simulator; what was removed or disposed since is back.
    /// </summary>
    /// <remarks>
    /// A body has the geoms of then: one that was made since on a body that is in the state is without a body
    /// (<see cref="Geom.SetBody"/> gives it one). What <see cref="ISavedState.RestoreState"/> of an item of your own throws is thrown
    /// here once everything else is restored: only that item is as it left itself, and restoring again is allowed.
    /// </remarks>
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
            throw new ArgumentException(
                state.Owner is null ? "The state holds nothing." : "The state is of another simulator.", nameof(state));
        }

        Read(state.Stream, Present, Former)?.Throw();
    }

    /// <summary>Captures into a stream; the simulator is not in an update.</summary>
    internal void Write(StateStream s, StateRoster present)
    {
        ThrowIfDisposed();
        RequireOutside(nameof(Capture));
        Gather(present);
        present.IsInUse = true;
        try
        {
            CheckSavers(present);
            s.BeginWriting();
            present.Visit(s);
            Visit(s, present);
            s.EndWriting(present.Round);
        }
        finally
        {
            present.IsInUse = false;
            present.Clear();
        }
    }

    /// <summary>Restores from a stream. What is refused is thrown, and changes nothing.</summary>
    /// <returns>What an item of the user's own threw; everything else is restored then.</returns>
    internal ExceptionDispatchInfo? Read(StateStream s, StateRoster present, StateRoster former)
    {
        ThrowIfDisposed();
        RequireOutside(nameof(Restore));
        present.IsInUse = true;
        try
        {
            long stepBefore = StepCount;
            Gather(present);
            s.BeginReading();
            StateRoster roster = present;
            if (!present.IsNext(s))
            {
                s.BeginReading();
                former.Visit(s);
                RequireFree(former);
                former.Index();
                TakeOutNew(present, former);
                roster = former;
            }

            ExceptionDispatchInfo? failure = Visit(s, roster);
            s.EndReading();
            StepSignals.TellRollback(stepBefore, s.Length);
            return failure;
        }
        finally
        {
            present.IsInUse = false;
            present.Clear();
            former.Clear();
        }
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

    private static void VisitOwn(StateStream s, object item, ref ExceptionDispatchInfo? failure)
    {
        if (item is not ISavedState own || !IsUsersOwn(item))
        {
            return;
        }

        int size = s.Value(s.IsReading ? 0 : own.StateSize);
        if (size < 0)
        {
            throw new InvalidOperationException(item.GetType().FullName + "." + nameof(ISavedState.StateSize) + " must not be negative.");
        }

        Span<byte> bytes = s.Of("Own", -1, item).Take(size, nameof(ISavedState));
        if (!s.IsReading)
        {
            bytes.Clear();
            own.SaveState(bytes);
            return;
        }

        try
        {
            own.RestoreState(bytes);
        }
        catch (Exception exception)
        {
            // Everybody else is to be restored nevertheless.
            failure ??= ExceptionDispatchInfo.Capture(exception);
        }
    }

    private void RequireOutside(string call)
    {
        if (_isUpdating)
        {
            throw new InvalidOperationException(call + " must not be called from a handler of the same simulator's update.");
        }

        if (_roster is { IsInUse: true })
        {
            throw new InvalidOperationException(call + " must not be called while an item of the same simulator is saved or restored.");
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
        CheckSavers(roster.Joints);
        CheckSavers(roster.Springs);
        CheckSavers(roster.Controllers);
    }

    private static void CheckSavers<T>(List<T> items)
        where T : class
    {
        Type? checkedBefore = null;
        foreach (T item in items)
        {
            if (item.GetType() != checkedBefore)
            {
                CheckSaver(item);
                checkedBefore = item.GetType();
            }
        }
    }

    /// <returns>What the first item of the user's own threw while it was read; all else is read then as well.</returns>
    private ExceptionDispatchInfo? Visit(StateStream s, StateRoster roster)
    {
        // First what nearly never changes: the same place of a state is still right then.
        roster.VisitItems(s);
        World.Visit(s);
        s.Section();
        VisitSettings(s.Of("Simulator"));
        VisitLists(s);
        s.Section();
        for (int i = 0; i < roster.Springs.Count; i++)
        {
            Spring spring = roster.Springs[i];
            spring.Visit(s.Of(nameof(Spring), i, spring));
        }

        s.Section();
        for (int i = 0; i < roster.Controllers.Count; i++)
        {
            Controller controller = roster.Controllers[i];
            controller.Visit(s.Of(nameof(Controller), i, controller));
        }

        if (s.IsReading)
        {
            FillTables(roster);
        }

        ExceptionDispatchInfo? failure = null;
        s.Section();
        VisitOwn(s.Of("Own"), _broadPhaseCollider, ref failure);
        VisitOwn(s, roster.Joints, ref failure);
        VisitOwn(s, roster.Springs, ref failure);
        VisitOwn(s, roster.Controllers, ref failure);
        return failure;
    }

    private static void VisitOwn<T>(StateStream s, List<T> items, ref ExceptionDispatchInfo? failure)
        where T : class
    {
        Type? ofThisLibrary = null;
        foreach (T item in items)
        {
            if (item.GetType() == ofThisLibrary)
            {
                continue;
            }

            if (IsUsersOwn(item))
            {
                VisitOwn(s, item, ref failure);
            }
            else
            {
                ofThisLibrary = item.GetType();
            }
        }
    }

    private void VisitSettings(StateStream s)
    {
        s.Value(ref _biasFactor);
        s.Value(ref _maxContactsToDetect);
        s.Value(ref _maxContactsToResolve);
        s.Value(ref _quirks);
        s.Value(ref _errorBudget);
        Enabled = s.Value(Enabled);
        StepCount = s.Value(StepCount);
        s.Reference(ref BodyQuarantined);
        _scaling = s.Reference(_scaling)!;
        _scaling.Visit(s);
        Defaults.Visit(s);
        _broadPhaseCollider = s.Reference(_broadPhaseCollider)!;
        _relay.Collider = s.Reference(_relay.Collider);
        _relay.Collider?.Visit(s);
        _relay.Recorder.Visit(s);
        _relay.OneWay.Visit(s);
        _surfaces.Visit(s);
        _poses.Visit(s);
        Report = StepReport.Visit(s, Report);
        if (s.IsReading)
        {
            _arbiters.IsStale = true;
        }
    }

    private void VisitLists(StateStream s)
    {
        BodyList.Visit(s);
        GeomList.Visit(s);
        JointList.Visit(s);
        SpringList.Visit(s);
        ControllerList.Visit(s);
        _joints.Visit(s);
        _springs.Visit(s);
        _controllers.Visit(s);
        s.References(_bodiesIn);
        s.References(_bodiesOut);
        s.References(_bodiesDisposed);
        s.References(_pending);
        s.References(_scaled);
        s.References(_railed);
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
