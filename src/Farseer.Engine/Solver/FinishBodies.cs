using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Solver;

/// <summary>Ends a step: displacements of the solver go into the double poses, states that left their range are caught.</summary>
internal static unsafe class FinishBodies
{
    /// <summary>Moves the bodies of a range of the list, but for those that are out of range or fast: these are marked.</summary>
    /// <returns>True if there is one.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static bool Run(BodyStore bodies, int* list, int count, byte* marks)
    {
        var columns = new Columns(bodies);
        bool found = false;
        int* turning = stackalloc int[StableMath.Lanes];
        int turningCount = 0;
        for (int i = 0; i < count; i++)
        {
            int body = list[i];
            bool ordinary = IsInRange(columns, body, out double turned) && !IsFast(columns, body, turned);
            marks[i] = ordinary ? (byte)0 : (byte)1;
            found |= !ordinary;
            if (ordinary && Move(columns, body, turned))
            {
                turning[turningCount++] = body;
                if (turningCount == StableMath.Lanes)
                {
                    UpdateRotors(columns.Poses, turning);
                    turningCount = 0;
                }
            }
        }

        for (int i = 0; i < turningCount; i++)
        {
            UpdateRotor(ref columns.Poses[turning[i]]);
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
        var columns = new Columns(bodies);
        if (!IsInRange(columns, body, out double turned))
        {
            Forget(columns, body);
            return false;
        }

        if (IsFast(columns, body, turned))
        {
            fast.Add(bodies, body, bodies.Pose[body], bodies.State[body], isFree: false);
        }

        if (Move(columns, body, turned))
        {
            UpdateRotor(ref bodies.Pose[body]);
        }

        return true;
    }

    public static void ForgetTurn(BodyStore bodies, int body) => ForgetTurn(new Columns(bodies), body);

    public static void UpdateRotor(ref BodyPose pose)
    {
        StableMath.SinCos(pose.Angle, out double sin, out double cos);
        pose.Sin = (float)sin;
        pose.Cos = (float)cos;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsInRange(in Columns columns, int body, out double turned)
    {
        BodyState* state = columns.States + body;
        BodyPose* pose = columns.Poses + body;
        turned = (double)columns.Motions[body].Turned + columns.Drives[body].Lead;
        return StateRange.Holds(*state)
            & StateRange.Holds(pose->X + state->DeltaPosition.X, pose->Y + state->DeltaPosition.Y, pose->Angle + turned);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsFast(in Columns columns, int body, double turned)
    {
        BodyState* state = columns.States + body;
        BodySize* size = columns.Sizes + body;
        float way = Math.Abs(state->DeltaPosition.X) + Math.Abs(state->DeltaPosition.Y) + (Math.Abs((float)turned) * size->Reach);
        return way > size->Extent;
    }

    /// <returns>True if it turned: its rotor is then to be brought up to date.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool Move(in Columns columns, int body, double turned)
    {
        BodyState* state = columns.States + body;
        BodyPose* pose = columns.Poses + body;
        pose->X += state->DeltaPosition.X;
        pose->Y += state->DeltaPosition.Y;
        Forget(columns, body);
        if (turned == 0)
        {
            return false;
        }

        pose->Angle += turned;
        return true;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Forget(in Columns columns, int body)
    {
        columns.States[body].DeltaPosition = Vector2.Zero;
        ForgetTurn(columns, body);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void ForgetTurn(in Columns columns, int body)
    {
        columns.States[body].DeltaSin = 0;
        columns.States[body].DeltaCos = 1;
        columns.Motions[body].Turned = 0;
    }

    private static void UpdateRotors(BodyPose* poses, int* list)
    {
        double* angles = stackalloc double[StableMath.Lanes];
        float* sin = stackalloc float[StableMath.Lanes];
        float* cos = stackalloc float[StableMath.Lanes];
        for (int i = 0; i < StableMath.Lanes; i++)
        {
            angles[i] = poses[list[i]].Angle;
        }

        StableMath.SinCos(angles, sin, cos);
        for (int i = 0; i < StableMath.Lanes; i++)
        {
            poses[list[i]].Sin = sin[i];
            poses[list[i]].Cos = cos[i];
        }
    }

    /// <summary>Where the columns begin, looked up once for all bodies.</summary>
    private readonly struct Columns
    {
        public readonly BodyState* States;
        public readonly BodyPose* Poses;
        public readonly BodyMotion* Motions;
        public readonly BodyDrive* Drives;
        public readonly BodySize* Sizes;

        public Columns(BodyStore bodies)
        {
            States = bodies.State.Pointer;
            Poses = bodies.Pose.Pointer;
            Motions = bodies.Motion.Pointer;
            Drives = bodies.Drive.Pointer;
            Sizes = bodies.Size.Pointer;
        }
    }
}
