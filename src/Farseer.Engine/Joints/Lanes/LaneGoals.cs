using System.Runtime.CompilerServices;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>What the joints are to reach, and which trees need more than lanes can give: an error from outside.</summary>
internal static unsafe class LaneGoals
{
    private const int Y = DoubleLanes.BundleLanes;
    private const int W = 2 * DoubleLanes.BundleLanes;

    /// <summary>
    /// The velocities that take the errors away within the substep, and with motors and springs what is foreseen of their bends.
    /// </summary>
    /// <returns>Lanes with an error that was put there from outside: their goals are not right.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static int Biased(in LaneBundle bundle, LaneWalk* walks, in LimitPace pace)
    {
        int disturbed = 0;
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            WideDoubleMask large = ~(WideDouble.Zero <= WideDouble.Zero);
            for (int i = 1; i < bundle.Count; i++)
            {
                LaneBends* bends = walks == null ? null : &DoubleLanes.Shift(walks + i, lane)->Bends;
                large |= Bias(&DoubleLanes.Shift(bundle.Nodes + i, lane)->Joint, bundle.Places + i, bends, pace);
            }

            for (int i = 0; i < bundle.AnchorCount; i++)
            {
                LaneAnchor* anchor = DoubleLanes.Shift(bundle.Anchors + i, lane);
                large |= Bias(&anchor->Joint, bundle.AnchorPlaces + i, walks == null ? null : &anchor->Bends, pace);
                Lessen(anchor, bundle.AnchorPlaces[i].BlockRows);
            }

            disturbed |= DoubleLanes.Bits(large) << lane;
        }

        return disturbed;
    }

    /// <summary>Standstill, and the speeds of servos.</summary>
    public static void Relaxed(in LaneBundle bundle, in LimitPace pace)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            for (int i = 1; i < bundle.Count; i++)
            {
                Rest(&DoubleLanes.Shift(bundle.Nodes + i, lane)->Joint, bundle.Places + i, pace);
            }

            for (int i = 0; i < bundle.AnchorCount; i++)
            {
                LaneAnchor* anchor = DoubleLanes.Shift(bundle.Anchors + i, lane);
                Rest(&anchor->Joint, bundle.AnchorPlaces + i, pace);
                Lessen(anchor, bundle.AnchorPlaces[i].BlockRows);
            }
        }
    }

    /// <summary>The errors, in terms of the joints' sizes; and in the lanes that take part what takes them away.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void FindWorst(in LaneBundle bundle, double h, LaneTrees* trees)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            WideDouble worst = WideDouble.Zero;
            for (int i = 1; i < bundle.Count; i++)
            {
                worst = Worse(worst, &DoubleLanes.Shift(bundle.Nodes + i, lane)->Joint, bundle.Places + i, h);
            }

            for (int i = 0; i < bundle.AnchorCount; i++)
            {
                worst = Worse(worst, &DoubleLanes.Shift(bundle.Anchors + i, lane)->Joint, bundle.AnchorPlaces + i, h);
            }

            worst.Store(trees->Worst + lane);
        }
    }

    /// <summary>The velocity changes that take the errors away, in the lanes of the mask; in the others none.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Correction(in LaneBundle bundle, double h, LaneTrees* trees)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            WideDoubleMask takes = WideDouble.LoadMask(trees->Corrects + lane);
            WideDouble time = WideDouble.Splat(h);
            for (int i = 1; i < bundle.Count; i++)
            {
                Correct(&DoubleLanes.Shift(bundle.Nodes + i, lane)->Joint, bundle.Places + i, takes, time);
            }

            for (int i = 0; i < bundle.AnchorCount; i++)
            {
                Correct(&DoubleLanes.Shift(bundle.Anchors + i, lane)->Joint, bundle.AnchorPlaces + i, takes, time);
            }
        }
    }

    /// <summary>
    /// What the joints are off by after a way straight on, and what that will be in the next substep: see <see cref="JointSolver"/>.
    /// </summary>
    public static void Foresee(in LaneBundle bundle, LaneWalk* walks, double h)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            for (int i = 1; i < bundle.Count; i++)
            {
                Foresee(
                    &DoubleLanes.Shift(bundle.Nodes + i, lane)->Joint, bundle.Places + i, &DoubleLanes.Shift(walks + i, lane)->Bends, h);
            }

            for (int i = 0; i < bundle.AnchorCount; i++)
            {
                LaneAnchor* anchor = DoubleLanes.Shift(bundle.Anchors + i, lane);
                Foresee(&anchor->Joint, bundle.AnchorPlaces + i, &anchor->Bends, h);
            }
        }
    }

    private static void Foresee(LaneJoint* joint, LanePlace* place, LaneBends* bends, double h)
    {
        WideDouble* change = stackalloc WideDouble[3];
        WideDouble largest = WideDouble.Zero;
        WideDouble largestChange = WideDouble.Zero;
        for (int row = 0; row < place->Rows; row++)
        {
            int at = row * Y;
            WideDouble bend = (WideDouble.Load(joint->Error + at) / WideDouble.Splat(h * h)) + WideDouble.Load(bends->Foreseen + at);
            change[row] = bend - WideDouble.Load(bends->Bend + at);
            bend.Store(bends->Bend + at);
            WideDouble size = SizeOf(joint, place, row);
            WideDouble share = WideDouble.Select(size > WideDouble.Zero, WideDouble.Splat(1) / size, WideDouble.Zero);
            largest = Larger(largest, share * WideDouble.Abs(bend));
            largestChange = Larger(largestChange, share * WideDouble.Abs(change[row]));
        }

        WideDoubleMask alike = largestChange <= WideDouble.Splat(TreePositions.Alike) * largest;
        for (int row = 0; row < place->Rows; row++)
        {
            WideDouble next = WideDouble.Load(bends->Bend + (row * Y)) + change[row];
            WideDouble.Select(alike, next, WideDouble.Zero).Store(bends->Foreseen + (row * Y));
        }
    }

    /// <summary>What is no number stays.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble Larger(WideDouble one, WideDouble other) =>
        WideDouble.Select(WideDouble.IsNotNumber(one) | (other <= one), one, other);

    /// <summary>What an error of a row is small against.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble SizeOf(LaneJoint* joint, LanePlace* place, int row) =>
        ((place->Turning >> row) & 1) != 0 ? WideDouble.Splat(1) : WideDouble.Load(joint->Size);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDoubleMask Bias(LaneJoint* joint, LanePlace* place, LaneBends* bends, in LimitPace pace)
    {
        WideDouble h = WideDouble.Splat(pace.Substep);
        WideDoubleMask large = ~(WideDouble.Zero <= WideDouble.Zero);
        if (place->Form == LaneForm.Servo)
        {
            WideDouble.Load(joint->Axis).Store(joint->Goal);
        }
        else if (place->Rows > 0)
        {
            large = BiasRow(joint, place, 0, h);
        }

        if (place->Rows > 1)
        {
            large |= BiasRow(joint, place, 1, h);
        }

        if (place->Rows > 2)
        {
            large |= BiasRow(joint, place, 2, h);
        }

        for (int row = 0; bends != null && row < place->Rows && place->Form != LaneForm.Servo; row++)
        {
            double* goal = joint->Goal + (row * Y);
            (WideDouble.Load(goal) - (WideDouble.Load(bends->Foreseen + (row * Y)) * h)).Store(goal);
        }

        Turn(joint, place);
        if (place->Held != 0)
        {
            LaneLimits.Aim(joint, place, pace, false);
        }

        return large;
    }

    /// <summary>A second joint that is a servo has its row behind those of the first.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Turn(LaneJoint* joint, LanePlace* place)
    {
        if (place->Second == LaneForm.Servo)
        {
            WideDouble.Load(joint->SecondSpeed).Store(joint->Goal + (place->Rows * Y));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDoubleMask BiasRow(LaneJoint* joint, LanePlace* place, int row, WideDouble h)
    {
        WideDouble error = WideDouble.Load(joint->Error + (row * Y));
        (WideDouble.Negate(error) / h).Store(joint->Goal + (row * Y));
        return ~(WideDouble.Abs(error) <= WideDouble.Splat(TreeRows.Small) * SizeOf(joint, place, row));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Rest(LaneJoint* joint, LanePlace* place, in LimitPace pace)
    {
        WideDouble first = place->Form == LaneForm.Servo ? WideDouble.Load(joint->Axis) : WideDouble.Zero;
        first.Store(joint->Goal);
        WideDouble.Zero.Store(joint->Goal + Y);
        WideDouble.Zero.Store(joint->Goal + W);
        Turn(joint, place);
        if (place->Held != 0)
        {
            LaneLimits.Aim(joint, place, pace, true);
        }
    }

    /// <summary>What cannot be moved may yet be moving.</summary>
    private static void Lessen(LaneAnchor* anchor, int rows)
    {
        for (int row = 0; row < rows; row++)
        {
            double* goal = anchor->Joint.Goal + (row * Y);
            (WideDouble.Load(goal) - LaneSolve.Dot(anchor->OtherS + (row * LaneMatrix.Row), anchor->Still)).Store(goal);
        }
    }

    /// <summary>The larger one, of the tree's and those of a joint's rows and of the limit that holds. A servo has no error.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble Worse(WideDouble worst, LaneJoint* joint, LanePlace* place, double h)
    {
        if (place->Held != 0)
        {
            worst = Larger(worst, LaneLimits.Off(joint, place, WideDouble.Splat(h)));
        }

        worst = place->Rows > 0 ? WorseRow(worst, joint, place, 0) : worst;
        if (place->Rows > 1)
        {
            worst = WorseRow(worst, joint, place, 1);
        }

        return place->Rows > 2 ? WorseRow(worst, joint, place, 2) : worst;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble WorseRow(WideDouble worst, LaneJoint* joint, LanePlace* place, int row)
    {
        WideDouble size = SizeOf(joint, place, row);
        WideDouble error = WideDouble.Abs(WideDouble.Load(joint->Error + (row * Y)));
        WideDouble share = WideDouble.Select(size > WideDouble.Zero, error / size, WideDouble.Zero);
        return Larger(worst, share);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Correct(LaneJoint* joint, LanePlace* place, WideDoubleMask takes, WideDouble h)
    {
        if (place->Form == LaneForm.Servo)
        {
            WideDouble.Zero.Store(joint->Goal);
        }
        else
        {
            CorrectRow(joint, 0, takes, h);
        }

        if (place->Rows > 1)
        {
            CorrectRow(joint, Y, takes, h);
        }

        if (place->Rows > 2)
        {
            CorrectRow(joint, W, takes, h);
        }

        if (place->Second == LaneForm.Servo)
        {
            WideDouble.Zero.Store(joint->Goal + (place->Rows * Y));
        }

        if (place->Held != 0)
        {
            LaneLimits.AimToStop(joint, place, takes, h);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void CorrectRow(LaneJoint* joint, int at, WideDoubleMask takes, WideDouble h) =>
        WideDouble.Select(takes, WideDouble.Negate(WideDouble.Load(joint->Error + at)) / h, WideDouble.Zero).Store(joint->Goal + at);
}
