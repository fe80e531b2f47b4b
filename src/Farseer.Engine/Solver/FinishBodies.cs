using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif

namespace Farseer.Engine.Solver;

/// <summary>Ends a step: displacements of the solver go into the double poses, states that left their range are caught.</summary>
internal static unsafe class FinishBodies
{
    /// <summary>Marks of bodies.</summary>
    public const byte OutOfRange = 1;
    public const byte MovedFast = 2;

    /// <summary>
    /// Moves the bodies of a range of the list, but for those that are out of range. These are marked, and those that moved by more than
    /// their size.
    /// </summary>
    /// <param name="bodies">The store.</param>
    /// <param name="list">The range.</param>
    /// <param name="count">Bodies of it.</param>
    /// <param name="marks">A mark for each.</param>
    /// <param name="starts">Where those began that moved fast and are to be looked after.</param>
    /// <returns>True if one is marked.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static bool Run(BodyStore bodies, int* list, int count, byte* marks, FastMotion* starts)
    {
        var columns = new Columns(bodies);
        bool found = false;
        int* turning = stackalloc int[StableMath.Lanes];
        int turningCount = 0;
        for (int i = 0; i < count; i++)
        {
            int body = list[i];
            if (!IsInRange(columns, body, out double turned))
            {
                marks[i] = OutOfRange;
                found = true;
                continue;
            }

            bool fast = IsFast(columns, body, turned) && FastList.IsLookedAfter(bodies, body);
            marks[i] = fast ? MovedFast : (byte)0;
            if (fast)
            {
                starts[i] = FastList.Begin(body, columns.Poses[body], columns.States[body], isFree: false);
                found = true;
            }

            if (Move(columns, body, turned))
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

    /// <summary>Ends the step for a body that is out of range: it keeps its pose.</summary>
    public static void Forget(BodyStore bodies, int body) => Forget(new Columns(bodies), body);

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
#if NET8_0_OR_GREATER
        return StateRange.Holds(*state) & StateRange.Holds(Moved(pose, state), pose->Angle + turned);
#else
        return StateRange.Holds(*state)
            & StateRange.Holds(pose->X + state->DeltaPosition.X, pose->Y + state->DeltaPosition.Y, pose->Angle + turned);
#endif
    }

#if NET8_0_OR_GREATER
    /// <summary>Where a body gets to.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<double> Moved(BodyPose* pose, BodyState* state) =>
        Vector128.Load((double*)pose) + Vector128.WidenLower(state->DeltaPosition.AsVector128());
#endif

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
#if NET8_0_OR_GREATER
        Moved(pose, state).Store((double*)pose);
#else
        pose->X += state->DeltaPosition.X;
        pose->Y += state->DeltaPosition.Y;
#endif
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
