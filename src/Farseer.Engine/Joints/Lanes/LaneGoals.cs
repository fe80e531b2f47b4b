using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif

namespace Farseer.Engine.Joints.Lanes;

/// <summary>What the hinges are to reach, and which trees need more than lanes can give: a limit that is passed, an error from outside.</summary>
internal static unsafe class LaneGoals
{
    private const int W = 2 * DoubleLanes.BundleLanes;

    /// <summary>The velocities that take the errors away within the substep.</summary>
    /// <returns>Lanes with an error that was put there from outside: their goals are not right.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static int Biased(LaneNode* nodes, int count, LaneAnchor* anchors, int anchorCount, double h)
    {
        int disturbed = 0;
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            WideDoubleMask large = ~(WideDouble.Zero <= WideDouble.Zero);
            WideDouble time = WideDouble.Splat(h);
            for (int i = 1; i < count; i++)
            {
                large |= Bias(&DoubleLanes.Shift(nodes + i, lane)->Joint, time);
            }

            for (int i = 0; i < anchorCount; i++)
            {
                LaneAnchor* anchor = DoubleLanes.Shift(anchors + i, lane);
                large |= Bias(&anchor->Joint, time);
                Lessen(anchor, WideDouble.Load(anchor->Joint.Goal), WideDouble.Load(anchor->Joint.Goal + 4));
            }

            disturbed |= DoubleLanes.Bits(large) << lane;
        }

        return disturbed;
    }

    /// <summary>Standstill.</summary>
    public static void Relaxed(LaneNode* nodes, int count, LaneAnchor* anchors, int anchorCount)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            for (int i = 1; i < count; i++)
            {
                LaneNode* node = DoubleLanes.Shift(nodes + i, lane);
                WideDouble.Zero.Store(node->Joint.Goal);
                WideDouble.Zero.Store(node->Joint.Goal + 4);
            }

            for (int i = 0; i < anchorCount; i++)
            {
                Lessen(DoubleLanes.Shift(anchors + i, lane), WideDouble.Zero, WideDouble.Zero);
            }
        }
    }

    /// <summary>The errors, in terms of the hinges' sizes; and in the lanes that take part what takes them away.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void FindWorst(LaneNode* nodes, int count, LaneAnchor* anchors, int anchorCount, LaneTrees* trees)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            WideDouble worst = WideDouble.Zero;
            for (int i = 1; i < count; i++)
            {
                worst = Worse(worst, &DoubleLanes.Shift(nodes + i, lane)->Joint);
            }

            for (int i = 0; i < anchorCount; i++)
            {
                worst = Worse(worst, &DoubleLanes.Shift(anchors + i, lane)->Joint);
            }

            worst.Store(trees->Worst + lane);
        }
    }

    /// <summary>The velocity changes that take the errors away, in the lanes of the mask; in the others none.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Correction(LaneNode* nodes, int count, LaneAnchor* anchors, int anchorCount, double h, LaneTrees* trees)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            WideDoubleMask takes = WideDouble.LoadMask(trees->Corrects + lane);
            WideDouble time = WideDouble.Splat(h);
            for (int i = 1; i < count; i++)
            {
                Correct(&DoubleLanes.Shift(nodes + i, lane)->Joint, takes, time);
            }

            for (int i = 0; i < anchorCount; i++)
            {
                Correct(&DoubleLanes.Shift(anchors + i, lane)->Joint, takes, time);
            }
        }
    }

    /// <summary>The lanes in which a limit is passed at the present velocities.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static int Passed(LaneNode* nodes, LanePlace* places, int count, double h, bool relaxed)
    {
        int passed = 0;
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            WideDoubleMask any = ~(WideDouble.Zero <= WideDouble.Zero);
            LaneNode* first = DoubleLanes.Shift(nodes, lane);
            WideDouble time = WideDouble.Splat(h);
            for (int i = 1; i < count; i++)
            {
                if (!places[i].HasLimits)
                {
                    continue;
                }

                LaneJoint* joint = &first[i].Joint;
                WideDouble own = WideDouble.Load(first[i].Velocity + W);
                WideDouble other = WideDouble.Load(first[places[i].Parent].Velocity + W);
                WideDouble speed = places[i].IsA ? other - own : own - other;
                WideDouble terms = WideDouble.Splat(JointSolver.SpeedRounding) * (WideDouble.Abs(own) + WideDouble.Abs(other));
                WideDouble bend = WideDouble.Load(joint->Bend);
                any |= speed < LimitSpeed(bend - WideDouble.Load(joint->Lower), time, relaxed) - terms;
                any |= WideDouble.Negate(speed) < LimitSpeed(WideDouble.Load(joint->Upper) - bend, time, relaxed) - terms;
            }

            passed |= DoubleLanes.Bits(any) << lane;
        }

        return passed;
    }

    /// <summary>The speed below which a limit is passed, of a gap: see <see cref="JointSolver"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble LimitSpeed(WideDouble gap, WideDouble h, bool relaxed)
    {
        WideDouble closing = WideDouble.Negate(gap) / h;
        WideDouble back = WideDouble.Zero;
        if (!relaxed)
        {
            WideDouble fastest = WideDouble.Splat(JointSolver.FastestReturn);
            back = WideDouble.Splat(-JointPass.LimitRecovery) * gap / h;
            back = WideDouble.Select(back > fastest, fastest, back);
        }

        return WideDouble.Select(gap > WideDouble.Zero, closing, back);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDoubleMask Bias(LaneJoint* joint, WideDouble h)
    {
        WideDouble x = WideDouble.Load(joint->Error);
        WideDouble y = WideDouble.Load(joint->Error + 4);
        WideDouble small = WideDouble.Splat(JointSolver.Small) * WideDouble.Load(joint->Size);
        (WideDouble.Negate(x) / h).Store(joint->Goal);
        (WideDouble.Negate(y) / h).Store(joint->Goal + 4);
        return ~(WideDouble.Abs(x) <= small) | ~(WideDouble.Abs(y) <= small);
    }

    /// <summary>What cannot be moved may yet be moving.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Lessen(LaneAnchor* anchor, WideDouble x, WideDouble y)
    {
        (x - LaneSolve.Dot(anchor->OtherS, anchor->Still)).Store(anchor->Joint.Goal);
        (y - LaneSolve.Dot(anchor->OtherS + 12, anchor->Still)).Store(anchor->Joint.Goal + 4);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble Worse(WideDouble worst, LaneJoint* joint)
    {
        WideDouble size = WideDouble.Load(joint->Size);
        worst = Worse(worst, WideDouble.Load(joint->Error), size);
        return Worse(worst, WideDouble.Load(joint->Error + 4), size);
    }

    /// <summary>The larger one; what is no number stays.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble Worse(WideDouble worst, WideDouble error, WideDouble size)
    {
        WideDouble share = WideDouble.Select(size > WideDouble.Zero, WideDouble.Abs(error) / size, WideDouble.Zero);
        return WideDouble.Select(WideDouble.IsNotNumber(worst) | (share <= worst), worst, share);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Correct(LaneJoint* joint, WideDoubleMask takes, WideDouble h)
    {
        WideDouble.Select(takes, WideDouble.Negate(WideDouble.Load(joint->Error)) / h, WideDouble.Zero).Store(joint->Goal);
        WideDouble.Select(takes, WideDouble.Negate(WideDouble.Load(joint->Error + 4)) / h, WideDouble.Zero).Store(joint->Goal + 4);
    }
}
