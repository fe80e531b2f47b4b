using System;
using System.Collections.Generic;
using System.Diagnostics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics;

/// <content>The update and how long its parts took.</content>
public partial class PhysicsSimulator
{
    private readonly List<Body> _pending = new List<Body>();
    private readonly List<Body> _listeners = new List<Body>();
    [NotState(Why.Calm)]
    private bool _isUpdating;

    internal bool IsUpdating => _isUpdating;

    /// <summary>True measures the times below; false, the default, costs nothing.</summary>
    [NotState(Why.Running)]
    public bool EnableDiagnostics { get; set; }

    /// <summary>Milliseconds that the last update took in all; −1 until measured.</summary>
    [NotState(Why.Running)]
    public float UpdateTime { get; private set; } = -1;

    /// <summary>Milliseconds for taking items in and out; −1 until measured.</summary>
    [NotState(Why.Running)]
    public float CleanUpTime { get; private set; } = -1;

    /// <summary>Milliseconds for finding the pairs; −1 until measured.</summary>
    [NotState(Why.Running)]
    public float BroadPhaseCollisionTime { get; private set; } = -1;

    /// <summary>Milliseconds for the contacts of the pairs, with their events; −1 until measured.</summary>
    [NotState(Why.Running)]
    public float NarrowPhaseCollisionTime { get; private set; } = -1;

    /// <summary>Milliseconds for forces and stored impulses; −1 until measured.</summary>
    [NotState(Why.Running)]
    public float ApplyForcesTime { get; private set; } = -1;

    /// <summary>Milliseconds for solving the contacts; −1 until measured.</summary>
    [NotState(Why.Running)]
    public float ApplyImpulsesTime { get; private set; } = -1;

    /// <summary>Milliseconds for bringing the new positions to the bodies; −1 until measured.</summary>
    [NotState(Why.Running)]
    public float UpdatePositionsTime { get; private set; } = -1;

    /// <summary>Advances the simulation.</summary>
    /// <param name="dt">Time to advance, seconds; finite and at least 0. Zero takes in what was added, and out what was removed, and does
    /// nothing else.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="dt"/> is negative or not finite.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">The call comes from a handler of an update under way.</exception>
    public void Update(float dt) => Update(dt, dt);

    /// <summary>Advances the simulation.</summary>
    /// <param name="dt">Time to advance, seconds; finite and at least 0. Zero takes in what was added, and out what was removed, and does
    /// nothing else.</param>
    /// <param name="dtReal">Time that really passed, seconds; finite and at least 0. <see cref="Scaling"/> goes by it.</param>
    /// <exception cref="ArgumentOutOfRangeException">A time is negative or not finite.</exception>
    /// <exception cref="ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="InvalidOperationException">Called by a handler of an update, or while an item is saved or restored.</exception>
    public void Update(float dt, float dtReal)
    {
        ThrowIfDisposed();
        Require.NotNegative(dt, nameof(dt));
        Require.NotNegative(dtReal, nameof(dtReal));
        RequireOutside(nameof(Update));
        float step = ScaledTime(dt, dtReal);
        if (step == 0 && dt > 0)
        {
            return;
        }

        _isUpdating = true;
        try
        {
            long start = EnableDiagnostics ? Stopwatch.GetTimestamp() : 0;
            TakeInAndOut();
            long taken = EnableDiagnostics ? Stopwatch.GetTimestamp() : 0;
            if (step > 0)
            {
                _poses.Keep(World);
            }

            if (step > 0 && Enabled)
            {
                bool heard = StepSignals.AreHeard;
                World.Profile.Enabled = EnableDiagnostics || heard;
                _arbiters.IsStale = true;
                if (_relay.Collider is null)
                {
                    // A user's collider finds the list as the original kept it: the pairs in contact and nothing else.
                    _arbiters.Fresh(World);
                    _arbiters.IsStale = true;
                }

                if (InactivityController.Enabled && !InactivityController.IsDisposed)
                {
                    InactivityController.WakeAhead(step);
                }

                StepCount++;
                StepWorld(step);
                if (heard)
                {
                    TellStep();
                }

                if (World.BodyStage.QuarantinedCount > 0)
                {
                    TellQuarantined();
                }

                TellListeners();
            }
            else if (step > 0)
            {
                Pause();
            }

            if (EnableDiagnostics && step > 0)
            {
                Measure(start, taken);
            }
        }
        finally
        {
            _isUpdating = false;
        }

        _relay.Recorder.Publish(BodyList);
        if (_disposeWaits)
        {
            Dispose();
        }
        else if (_clearWaits)
        {
            Clear();
        }

        _relay.Rethrow();
    }

    internal void NotePending(Body body)
    {
        if (!body.IsPendingNoted)
        {
            body.IsPendingNoted = true;
            _pending.Add(body);
        }
    }

    internal void NoteListener(Body body)
    {
        if (!body.IsListenerNoted && body.Updated is not null)
        {
            body.IsListenerNoted = true;
            _listeners.Add(body);
        }
    }

    /// <summary>
    /// The part of the step where forces act: controllers, springs, then stored impulses become velocity, and with a quirk forces too.
    /// </summary>
    internal void ApplyForces(float dt)
    {
        UpdateControls(dt);
        bool dividedTwice = (_quirks & Farseer201Quirks.ImpulseDividedByMassTwice) != 0;
        int kept = 0;
        for (int i = 0; i < _pending.Count; i++)
        {
            Body body = _pending[i];
            if (ReferenceEquals(body.Simulator, this) && body.Membership != Membership.None && !body.Enabled)
            {
                // A disabled body keeps its impulse until it is enabled again.
                _pending[kept++] = body;
                continue;
            }

            body.IsPendingNoted = false;
            if (ReferenceEquals(body.Simulator, this) && body.Link.IsSimulated)
            {
                body.UsePending(dt, dividedTwice);
            }
        }

        _pending.RemoveRange(kept, _pending.Count - kept);
        if ((_quirks & Farseer201Quirks.ForcesActAtOnce) != 0)
        {
            for (int i = 0; i < BodyList.Count; i++)
            {
                BodyList[i].UseForces(dt);
            }
        }

        PullScaled();
    }

    /// <summary>Runs a user's own broad phase on the arbiter list.</summary>
    internal List<Arbiter> RunUserBroadPhase()
    {
        try
        {
            _broadPhaseCollider.Update();
        }
        catch (Exception exception)
        {
            _relay.Keep(exception);
        }

        return _arbiters.List;
    }

    private static float Milliseconds(double seconds) => (float)(seconds * 1000);

    private static double Seconds(long ticks) => ticks / (double)Stopwatch.Frequency;

    private float ScaledTime(float dt, float dtReal)
    {
        if (dt == 0 || !_scaling.Enabled)
        {
            return dt;
        }

        if (dtReal > _scaling.UpdateInterval)
        {
            _scaling.IncreaseUpdateInterval();
        }
        else if (dtReal < _scaling.UpdateInterval)
        {
            _scaling.DecreaseUpdateInterval();
        }

        return _scaling.GetUpdateInterval(dt);
    }

    private void Pause()
    {
        if ((_quirks & Farseer201Quirks.ForcesAccumulateWhilePaused) != 0)
        {
            return;
        }

        for (int i = 0; i < _table.BodyEnd; i++)
        {
            Body? body = _table.Body(i);
            if (body is not null)
            {
                body.Link.ForceRef = default;
                body.DropSwing();
            }
        }
    }

    private void TellListeners()
    {
        int kept = 0;
        for (int i = 0; i < _listeners.Count; i++)
        {
            Body body = _listeners[i];
            if (!ReferenceEquals(body.Simulator, this) || body.Updated is null || body.IsDisposed)
            {
                body.IsListenerNoted = false;
                continue;
            }

            _listeners[kept++] = body;
            try
            {
                body.TellIfMoved();
            }
            catch (Exception exception)
            {
                _relay.Keep(exception);
            }
        }

        _listeners.RemoveRange(kept, _listeners.Count - kept);
    }

    private void Measure(long start, long taken)
    {
        StepProfile profile = World.Profile;
        double before = Seconds(taken - start);
        UpdateTime = Milliseconds(Seconds(Stopwatch.GetTimestamp() - start));
        CleanUpTime = Milliseconds(before + (Enabled ? profile[StepStage.DeferredChanges] : 0));
        if (Enabled)
        {
            BroadPhaseCollisionTime = Milliseconds(profile[StepStage.BroadPhase]);
            NarrowPhaseCollisionTime = Milliseconds(profile[StepStage.NarrowPhase]);
            ApplyForcesTime = Milliseconds(profile[StepStage.Forces]);
            ApplyImpulsesTime = Milliseconds(profile[StepStage.GraphAndIslands] + profile[StepStage.Solve]);
            UpdatePositionsTime = Milliseconds(profile[StepStage.Finish] + profile[StepStage.Continuous] + profile[StepStage.Sleep]);
        }
    }
}
