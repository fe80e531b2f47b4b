using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Numerics;
using Farseer.Engine.Solver;

namespace Farseer.Engine.Simulation;

/// <summary>Takes bodies out whose state left its range, so that the others do not catch it.</summary>
internal sealed partial class World
{
    /// <summary>Bodies that the last step took out.</summary>
    public int QuarantinedCount => _lists.OutcastCount;

    public QuarantineRecord Quarantined(int index) => _lists.Outcast(index);

    /// <summary>Whether the step has disabled the body: it does so with all outcasts but the static ones.</summary>
    public bool IsQuarantined(int body) => (Bodies.Flags[body] & BodyFlags.Quarantined) != 0;

    private void CollectBodies()
    {
        _lists.ForgetOutcasts();
        _lists.Collect(_runner, Bodies);
        if (_lists.OutcastCount > 0)
        {
            Isolate();
            PurgeNow();
        }
    }

    private void FinishBodiesOfStep()
    {
        // What was found at the start is isolated already, unless a callback enabled it since.
        _lists.Finish(_runner, Bodies, Scratch);
        if (_lists.OutcastCount > 0)
        {
            BodyLists.StopStatics(Bodies);
            Isolate();
        }
    }

    /// <summary>Before the solver reads the static bodies; the others are looked at when their drives are prepared.</summary>
    private void CollectStaticsAfterCallbacks()
    {
        int before = _lists.OutcastCount;
        _lists.CollectStatics(Bodies);
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
            bool isStatic = (Bodies.Flags[body] & BodyFlags.Static) != 0;
            Bodies.Flags[body] = isStatic
                ? Bodies.Flags[body] & ~BodyFlags.Quarantined
                : (Bodies.Flags[body] & ~BodyFlags.Enabled) | BodyFlags.Quarantined | BodyFlags.Moved;
            ref BodyState state = ref Bodies.State[body];
            state.LinearVelocity = Vector2.Zero;
            state.AngularVelocity = 0;
            state.DeltaPosition = Vector2.Zero;
            state.DeltaSin = 0;
            state.DeltaCos = 1;
            Bodies.Motion[body] = default;
            Bodies.ClearResidual(body);
            ref BodyPose pose = ref Bodies.Pose[body];
            if (!StateRange.Holds(pose.X, pose.Y, pose.Angle))
            {
                pose = default;
                FinishBodies.UpdateRotor(ref pose);
            }

            if (!isStatic)
            {
                MarkStale(body);
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
        for (int entry = Joints.First(body); entry >= 0; entry = Joints.Next(entry))
        {
            int joint = entry >> 1;
            ref JointState state = ref Joints.States[joint];
            double error = state.Error;
            state = default;
            state.Error = FloatBits.IsFinite(error) ? error : 0;
            Joints.Ranges[joint] = default;
            _jointSolver?.Nets.Edited(joint, afresh: true);
        }
    }
}
