using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints;

/// <summary>
/// Lets the joints that a user wrote take part in a substep. They were written for an engine in which a step is what a substep is
/// here: prepared once, with warm start, then solved several times. So each substep is a whole step to them, and the poses that
/// they see are those of the substep.
/// </summary>
internal sealed unsafe class UserJointPass
{
    /// <summary>More sweeps than this a substep gain nothing.</summary>
    private const int MostSweeps = 8;

    private readonly Column<BodyPose> _saved = new Column<BodyPose>();

    public void Run(IUserJoints joints, BodyStore bodies, int* list, int count, int sweeps, float inverseSubstep)
    {
        _saved.EnsureCapacity(Math.Max(1, count));
        for (int i = 0; i < count; i++)
        {
            int body = list[i];
            _saved[i] = bodies.Pose[body];
            if (body != 0)
            {
                Advance(ref bodies.Pose[body], bodies.State[body], (double)bodies.Motion[body].Turned + bodies.Drive[body].Lead);
            }
        }

        joints.Prepare(inverseSubstep);
        for (int sweep = Math.Min(sweeps, MostSweeps); sweep > 0; sweep--)
        {
            joints.Solve();
        }

        for (int i = 0; i < count; i++)
        {
            bodies.Pose[list[i]] = _saved[i];
        }
    }

    private static void Advance(ref BodyPose pose, in BodyState state, double turned)
    {
        pose.X += state.DeltaPosition.X;
        pose.Y += state.DeltaPosition.Y;
        if (turned != 0)
        {
            pose.Angle += turned;
            StableMath.SinCos(pose.Angle, out double sin, out double cos);
            pose.Sin = (float)sin;
            pose.Cos = (float)cos;
        }
    }
}
