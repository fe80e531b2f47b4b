using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Joints;
using Farseer.Engine.Numerics;
using Farseer.Engine.Solver;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Which bodies take part in a step, also when a handler switches them within it; and takes those out whose state left its range, so that
/// the others do not catch it.
/// </summary>
internal sealed class BodyStage : WorldPhase
{
    private readonly Removals _removals;

    /// <summary>
    /// Bodies were enabled, disabled, made static or kinematic, or no longer so, since the bodies were sorted; and such a thing happened
    /// within the step.
    /// </summary>
    private bool _bodiesSwitched;
    private bool _switchedWithin;

    public BodyStage(WorldStores stores, Removals removals)
        : base(stores)
    {
        _removals = removals;
    }

    /// <summary>Bodies were switched within the step, which then move, or stay, from there on.</summary>
    public bool SwitchedWithin => _switchedWithin;

    /// <summary>A body was enabled, disabled, made static or kinematic, or is no longer so.</summary>
    public void NoteSwitched() => _bodiesSwitched = true;

    /// <summary>Bodies that the last step took out.</summary>
    public int QuarantinedCount => _lists.OutcastCount;

    public QuarantineRecord Quarantined(int index) => _lists.Outcast(index);

    /// <summary>Whether the step has disabled the body: it does so with all outcasts but the static ones.</summary>
    public bool IsQuarantined(int body) => (_bodies.Flags[body] & BodyFlags.Quarantined) != 0;

    public void Collect()
    {
        _bodiesSwitched = false;
        _switchedWithin = false;
        _lists.ForgetOutcasts();
        _lists.Collect(_stores.Runner, _bodies);
        if (_lists.OutcastCount > 0)
        {
            Isolate();
            _removals.PurgeNow();
        }
    }

    public void Finish()
    {
        // What was found at the start is isolated already, unless a callback enabled it since.
        _lists.Finish(_stores.Runner, _bodies, _stores.Scratch);
        if (_lists.OutcastCount > 0)
        {
            BodyLists.StopStatics(_bodies);
            Isolate();
        }
    }

    /// <summary>Before the solver reads the static bodies; the others are looked at when their drives are prepared.</summary>
    public void CollectStatics()
    {
        int before = _lists.OutcastCount;
        _lists.CollectStatics(_bodies);
        if (_lists.OutcastCount > before)
        {
            Isolate();
        }
    }

    /// <summary>
    /// Disables the outcasts and lets them stand still at the last place that was in range: enabling
    /// them is then enough to use them again. Their contacts end as those of any body that is disabled. A static body only loses
    /// its velocity: it has no use for one, and what stands on it must not fall.
    /// </summary>
    private void Isolate()
    {
        for (int i = 0; i < _lists.OutcastCount; i++)
        {
            int body = _lists.Outcast(i).Body;
            bool isStatic = (_bodies.Flags[body] & BodyFlags.Static) != 0;
            _bodies.Flags[body] = isStatic
                ? _bodies.Flags[body] & ~BodyFlags.Quarantined
                : (_bodies.Flags[body] & ~BodyFlags.Enabled) | BodyFlags.Quarantined | BodyFlags.Moved;
            ref BodyState state = ref _bodies.State[body];
            state.LinearVelocity = Vector2.Zero;
            state.AngularVelocity = 0;
            state.DeltaPosition = Vector2.Zero;
            state.DeltaSin = 0;
            state.DeltaCos = 1;
            _bodies.Motion[body] = default;
            _bodies.ClearResidual(body);
            ref BodyPose pose = ref _bodies.Pose[body];
            if (!StateRange.Holds(pose.X, pose.Y, pose.Angle))
            {
                pose = default;
                FinishBodies.UpdateRotor(ref pose);
            }

            if (!isStatic)
            {
                _removals.MarkStale(body);
            }

            ForgetJoints(body);
        }
    }

    /// <summary>
    /// What the joints of a body gave in this step was no number, or was given to a body that is out: they tell of no forces, and start
    /// anew.
    /// </summary>
    private void ForgetJoints(int body)
    {
        for (int entry = _joints.First(body); entry >= 0; entry = _joints.Next(entry))
        {
            int joint = entry >> 1;
            ref JointState state = ref _joints.States[joint];
            double error = state.Error;
            state = default;
            state.Error = FloatBits.IsFinite(error) ? error : 0;
            _joints.Ranges[joint] = default;
            _stores.JointSolver?.Nets.Edited(joint, afresh: true);
        }
    }

    /// <summary>A body that was enabled, disabled or made static by a callback moves, or stays, from this step on.</summary>
    /// <returns>True if there was one.</returns>
    public unsafe bool SortSwitched(float dt)
    {
        if (!_bodiesSwitched)
        {
            return false;
        }

        _bodiesSwitched = false;
        _switchedWithin = true;
        int before = _lists.OutcastCount;
        _lists.CollectAgain(_stores.Runner, _bodies, dt);
        if (_lists.OutcastCount > before)
        {
            Isolate();
        }

        foreach (GraphColor color in _graph.Used)
        {
            foreach (ContactBundle* row in color.Bundles)
            {
                ContactRowWriter.HoldStill(row, _lists.Moves);
            }
        }

        return true;
    }

    /// <summary>A body that was made static when the step was solved already has got its velocity back from there.</summary>
    public unsafe void StopSwitched()
    {
        for (int i = 0; _bodiesSwitched && i < _lists.ActiveCount; i++)
        {
            int body = _lists.Active[i];
            if ((_bodies.Flags[body] & BodyFlags.Static) != 0)
            {
                _bodies.State[body].LinearVelocity = Vector2.Zero;
                _bodies.State[body].AngularVelocity = 0;
            }
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Of(nameof(BodyStage)).Value(ref _bodiesSwitched);
        s.Value(ref _switchedWithin);
    }
}
