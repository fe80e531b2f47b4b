using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Solver;

/// <summary>Ends a step: displacements of the solver go into the double poses, states that left their range are caught.</summary>
internal static unsafe class FinishBodies
{
    /// <summary>Moves the bodies of a range of the list, but for those that are out of range or fast: these are marked.</summary>
    /// <returns>True if there is one.</returns>
    public static bool Run(BodyStore bodies, int* list, int count, byte* marks)
    {
        bool found = false;
        for (int i = 0; i < count; i++)
        {
            int body = list[i];
            bool ordinary = IsInRange(bodies, body, out double turned) && !IsFast(bodies, body, turned);
            marks[i] = ordinary ? (byte)0 : (byte)1;
            found |= !ordinary;
            if (ordinary)
            {
                Move(bodies, body, turned);
            }
        }

        return found;
    }

    /// <summary>Ends the step for a marked body.</summary>
    /// <param name="bodies">The store.</param>
    /// <param name="body">The body.</param>
    /// <param name="fast">Where to note it if it moved by more than its size.</param>
    /// <returns>False if it is out of range: it keeps its pose.</returns>
    public static bool RunMarked(BodyStore bodies, int body, FastList fast)
    {
        if (!IsInRange(bodies, body, out double turned))
        {
            Forget(bodies, body);
            return false;
        }

        if (IsFast(bodies, body, turned))
        {
            fast.Add(bodies, body, bodies.Pose[body], bodies.State[body], isFree: false);
        }

        Move(bodies, body, turned);
        return true;
    }

    private static bool IsInRange(BodyStore bodies, int body, out double turned)
    {
        ref BodyState state = ref bodies.State[body];
        ref BodyPose pose = ref bodies.Pose[body];
        turned = (double)bodies.Motion[body].Turned + bodies.Drive[body].Lead;
        return StateRange.Holds(state)
            & StateRange.Holds(pose.X + state.DeltaPosition.X, pose.Y + state.DeltaPosition.Y, pose.Angle + turned);
    }

    private static bool IsFast(BodyStore bodies, int body, double turned)
    {
        ref BodyState state = ref bodies.State[body];
        BodySize size = bodies.Size[body];
        float way = Math.Abs(state.DeltaPosition.X) + Math.Abs(state.DeltaPosition.Y) + (Math.Abs((float)turned) * size.Reach);
        return way > size.Extent;
    }

    private static void Move(BodyStore bodies, int body, double turned)
    {
        ref BodyState state = ref bodies.State[body];
        ref BodyPose pose = ref bodies.Pose[body];
        pose.X += state.DeltaPosition.X;
        pose.Y += state.DeltaPosition.Y;
        if (turned != 0)
        {
            pose.Angle += turned;
            UpdateRotor(ref pose);
        }

        Forget(bodies, body);
    }

    private static void Forget(BodyStore bodies, int body)
    {
        bodies.State[body].DeltaPosition = Vector2.Zero;
        ForgetTurn(bodies, body);
    }

    public static void ForgetTurn(BodyStore bodies, int body)
    {
        ref BodyState state = ref bodies.State[body];
        state.DeltaSin = 0;
        state.DeltaCos = 1;
        bodies.Motion[body].Turned = 0;
    }

    public static void UpdateRotor(ref BodyPose pose)
    {
        StableMath.SinCos(pose.Angle, out double sin, out double cos);
        pose.Sin = (float)sin;
        pose.Cos = (float)cos;
    }
}
