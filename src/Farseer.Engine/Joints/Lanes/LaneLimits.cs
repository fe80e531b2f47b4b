using System.Runtime.CompilerServices;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>
/// Limits of joints of trees side by side, as in <see cref="JointSolver"/>: what those that hold are to reach, and which are passed or
/// pull.
/// </summary>
internal static unsafe class LaneLimits
{
    private const int Y = DoubleLanes.BundleLanes;
    private const int W = 2 * DoubleLanes.BundleLanes;

    /// <summary>What the limits of a joint are found to do, a bit a lane.</summary>
    internal struct Verdict
    {
        /// <summary>They are passed and do not hold yet. Of two the lower one.</summary>
        public int Lower;
        public int Upper;

        /// <summary>They hold and would pull.</summary>
        public int Pulls;

        /// <summary>What of it is to be done in some lanes: see also <see cref="TreeLimits.IsJustLetGo"/>.</summary>
        public readonly Verdict In(LanePlace* place, int lanes, bool release)
        {
            Verdict some;
            some.Pulls = release ? Pulls & lanes : 0;
            some.Lower = Lower & lanes & ~place->LetGoAbove;
            some.Upper = Upper & lanes & ~place->LetGoBelow;
            return some;
        }
    }

    /// <summary>The goal of a limit that holds; in a biased pass also where it is to be by the substep's end.</summary>
    public static void Aim(LaneJoint* joint, LanePlace* place, in LimitPace pace, bool relaxed)
    {
        WideDouble gap = HeldGap(joint);
        WideDouble target = Target(gap, WideDouble.Load(joint->Slop), LeastGap(joint, place), pace, relaxed, place->LimitTurns);
        WideDouble.Select(WideDouble.LoadMask(joint->Held), target, WideDouble.Zero).Store(joint->Goal + (place->HardRows * Y));
        if (!relaxed)
        {
            WideDouble.Select(gap > WideDouble.Zero, WideDouble.Zero, gap + (target * WideDouble.Splat(pace.Substep))).Store(joint->Stop);
        }
    }

    /// <summary>The change that takes a limit that holds to where it is to be by the substep's end.</summary>
    public static void AimToStop(LaneJoint* joint, LanePlace* place, WideDoubleMask takes, WideDouble h)
    {
        WideDouble way = (WideDouble.Load(joint->Stop) - HeldGap(joint)) / h;
        WideDouble.Select(takes & WideDouble.LoadMask(joint->Held), way, WideDouble.Zero).Store(joint->Goal + (place->HardRows * Y));
    }

    /// <summary>How far a limit that holds is from there, in terms of the joint's size.</summary>
    public static WideDouble Off(LaneJoint* joint, LanePlace* place, WideDouble h)
    {
        WideDouble way = WideDouble.Abs((WideDouble.Load(joint->Stop) - HeldGap(joint)) / h) * h;
        WideDouble size = place->LimitTurns ? WideDouble.Splat(1) : WideDouble.Load(joint->Size);
        return WideDouble.Select(WideDouble.LoadMask(joint->Held) & (size > WideDouble.Zero), way / size, WideDouble.Zero);
    }

    /// <summary>
    /// The lanes in which a limit that does not hold is passed at the present velocities, or what one that holds gave in all was a pull.
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static int Turned(in LaneBundle bundle, in LimitPace pace, bool relaxed)
    {
        int turned = 0;
        for (int i = 1; i < bundle.Count; i++)
        {
            if (bundle.Places[i].HasLimits)
            {
                LaneNode* node = bundle.Nodes + i;
                double* parent = bundle.Nodes[bundle.Places[i].Parent].Velocity;
                turned |= Turned(&node->Joint, bundle.Places + i, node->Velocity, parent, pace, relaxed);
            }
        }

        for (int i = 0; i < bundle.AnchorCount; i++)
        {
            LaneAnchor* anchor = bundle.Anchors + i;
            LanePlace* place = bundle.AnchorPlaces + i;
            if (place->HasLimits)
            {
                turned |= Turned(&anchor->Joint, place, bundle.Nodes[place->Parent].Velocity, anchor->Still, pace, relaxed);
            }
        }

        return turned;
    }

    private static int Turned(LaneJoint* joint, LanePlace* place, double* velocity, double* other, in LimitPace pace, bool relaxed)
    {
        Verdict verdict = Judge(joint, place, velocity, other, pace, relaxed);
        int turned = verdict.Lower | verdict.Upper;
        for (int lane = 0; lane < DoubleLanes.BundleLanes && place->Held != 0; lane += WideDouble.Count)
        {
            WideDoubleMask pulled = WideDouble.LoadMask(joint->Held + lane) & (WideDouble.Load(joint->Push + lane) < WideDouble.Zero);
            turned |= DoubleLanes.Bits(pulled) << lane;
        }

        return turned;
    }

    /// <summary>Looks at the limits of a joint after a solution: at the velocities, and at the multipliers of those that hold.</summary>
    /// <param name="joint">The joint, of the first lane.</param>
    /// <param name="place">What it is.</param>
    /// <param name="velocity">Of the child, or of the anchored body.</param>
    /// <param name="other">Of the other body.</param>
    /// <param name="pace">The substep.</param>
    /// <param name="relaxed">The relax pass.</param>
    public static Verdict Judge(LaneJoint* joint, LanePlace* place, double* velocity, double* other, in LimitPace pace, bool relaxed)
    {
        Verdict verdict = default;
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            LaneJoint* at = DoubleLanes.Shift(joint, lane);
            double* a = (place->LimitIsA ? velocity : other) + lane;
            double* b = (place->LimitIsA ? other : velocity) + lane;
            bool turns = place->LimitTurns;
            WideDouble speed;
            WideDouble terms;
            if (turns)
            {
                WideDouble ofA = WideDouble.Load(a + W);
                WideDouble ofB = WideDouble.Load(b + W);
                speed = ofB - ofA;
                terms = WideDouble.Abs(ofA) + WideDouble.Abs(ofB);
            }
            else
            {
                speed = LaneSolve.Dot(at->LineA, a) + LaneSolve.Dot(at->LineB, b);
                terms = Term(at->LineA, a, 0) + Term(at->LineA, a, Y) + Term(at->LineA, a, W)
                    + Term(at->LineB, b, 0) + Term(at->LineB, b, Y) + Term(at->LineB, b, W);
            }

            terms = WideDouble.Splat(TreeLimits.SpeedRounding) * terms;
            WideDouble slop = WideDouble.Load(at->Slop);
            WideDouble least = LeastGap(at, place);
            WideDoubleMask lower = speed < Target(WideDouble.Load(at->Gap), slop, least, pace, relaxed, turns) - terms;
            WideDoubleMask upper =
                WideDouble.Negate(speed) < Target(WideDouble.Load(at->Gap + Y), slop, least, pace, relaxed, turns) - terms;
            if (place->Held != 0)
            {
                WideDoubleMask held = WideDouble.LoadMask(at->Held);
                WideDouble push = WideDouble.Load(at->Push) + WideDouble.Load(at->Lambda + (place->HardRows * Y));
                verdict.Pulls |= DoubleLanes.Bits(held & ~(push >= WideDouble.Zero)) << lane;

                // Of the two ends of a range one holds.
                lower &= ~held;
                upper &= ~held;
            }

            verdict.Lower |= DoubleLanes.Bits(lower) << lane;
            verdict.Upper |= DoubleLanes.Bits(upper & ~lower) << lane;
        }

        return verdict;
    }

    /// <summary>After the move: limits that are open again, see <see cref="JointSolver"/>, and what they gave counts no longer.</summary>
    public static void LetGoOfOpen(LaneJoint* joint, LanePlace* place)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes && place->Held != 0; lane += WideDouble.Count)
        {
            LaneJoint* at = DoubleLanes.Shift(joint, lane);
            int open = DoubleLanes.Bits(WideDouble.LoadMask(at->Held) & (HeldGap(at) > LeastGap(at, place))) << lane;
            for (int k = lane; open >> k != 0; k++)
            {
                if ((open & (1 << k)) != 0)
                {
                    joint->Held[k] = 0;
                    joint->Push[k] = 0;
                }
            }

            place->Held &= (byte)~open;
        }

        place->BlockRows = (byte)(place->Held != 0 ? place->HardRows + 1 : place->HardRows);
    }

    /// <summary>Up to this gap a limit is at its place.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble LeastGap(LaneJoint* joint, LanePlace* place) =>
        WideDouble.Splat(TreeRows.Small) * (place->LimitTurns ? WideDouble.Splat(1) : WideDouble.Load(joint->Size));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble HeldGap(LaneJoint* joint) =>
        WideDouble.Select(WideDouble.LoadMask(joint->HeldAbove), WideDouble.Load(joint->Gap + Y), WideDouble.Load(joint->Gap));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble Term(double* s, double* v, int at) => WideDouble.Abs(WideDouble.Load(s + at) * WideDouble.Load(v + at));

    /// <summary>The speed of a limit that holds, and below which one is passed.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble Target(WideDouble gap, WideDouble slop, WideDouble least, in LimitPace pace, bool relaxed, bool turns)
    {
        WideDouble h = WideDouble.Splat(pace.Substep);
        WideDouble closing = WideDouble.Negate(gap) / h;
        WideDouble back = WideDouble.Zero;
        if (relaxed)
        {
            closing = WideDouble.Select(gap > least, WideDouble.Splat(double.NegativeInfinity), closing);
        }
        else
        {
            WideDouble fastest = WideDouble.Splat(TreeLimits.FastestReturn);
            WideDouble over = gap + slop;
            over = WideDouble.Select(over > WideDouble.Zero, WideDouble.Zero, over);
            back = WideDouble.Splat(-pace.Recovery) * over / h;
            back = turns ? WideDouble.Select(back > fastest, fastest, back) : back;
        }

        return WideDouble.Select(gap > WideDouble.Zero, closing, back);
    }
}
