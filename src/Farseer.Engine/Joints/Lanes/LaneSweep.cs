using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>Motors and springs of trees side by side: what <see cref="JointPass"/> does with those of one, to the last bit.</summary>
internal static unsafe class LaneSweep
{
    /// <summary>Jacobians and responses of the rows at the poses at which the trees are factored, and what springs are there.</summary>
    /// <returns>Lanes with a spring that its tree leaves no freedom.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static int Prepare(in LaneWalks trees, LaneSoft* softs, LaneSoftPlace* places, int count, double h, int lane)
    {
        double* space = stackalloc double[3 * LaneMatrix.Row];
        LaneWalks walks = trees;
        walks.Complete(space);
        WideDoubleMask stalled = ~(WideDouble.Zero <= WideDouble.Zero);
        for (int i = 0; i < count; i++)
        {
            LaneSoft* soft = DoubleLanes.Shift(softs + i, lane);
            LaneSoftPlace* place = places + i;
            WriteCross(walks, soft, place, space);
            stalled |= Prepare(walks, soft, &soft->Row0, place, place->Kind0, h);
            if (place->Rows > 1)
            {
                stalled |= Prepare(walks, soft, &soft->Row1, place, place->Kind1, h);
            }
        }

        return DoubleLanes.Bits(stalled) << lane;
    }

    /// <summary>The impulses of the substep before, on the bodies' own masses.</summary>
    public static void WarmStart(in LaneWalks walks, LaneSoft* softs, LaneSoftPlace* places, int count, int lane)
    {
        for (int i = 0; i < count; i++)
        {
            LaneSoft* soft = DoubleLanes.Shift(softs + i, lane);
            WarmStart(walks, soft, &soft->Row0, places + i, places[i].Kind0);
            if (places[i].Rows > 1)
            {
                WarmStart(walks, soft, &soft->Row1, places + i, places[i].Kind1);
            }
        }
    }

    /// <summary>See <see cref="JointPass.Resume"/>.</summary>
    public static void Resume(in LaneWalks walks, LaneSoft* softs, LaneSoftPlace* places, int count, int lane)
    {
        for (int i = 0; i < count; i++)
        {
            LaneSoft* soft = DoubleLanes.Shift(softs + i, lane);
            Resume(walks, soft, &soft->Row0, places + i, places[i].Kind0);
            if (places[i].Rows > 1)
            {
                Resume(walks, soft, &soft->Row1, places + i, places[i].Kind1);
            }
        }
    }

    /// <summary>Sweeps over all rows, in one walk.</summary>
    /// <param name="trees">The trees.</param>
    /// <param name="softs">Their rows.</param>
    /// <param name="places">What these are.</param>
    /// <param name="count">How many joints have some.</param>
    /// <param name="biased">The biased pass, in which springs pull.</param>
    /// <param name="sweeps">How often.</param>
    /// <param name="lane">The first lane.</param>
    /// <param name="lanes">The lanes in which it is done.</param>
    /// <returns>True if it brought an impulse: the joints are to be given what they answered.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static bool Run(
        in LaneWalks trees, LaneSoft* softs, LaneSoftPlace* places, int count, bool biased, int sweeps, int lane, long* lanes)
    {
        LaneWalks walks = trees;
        WideDoubleMask all = WideDouble.LoadMask(lanes + lane);
        WideDoubleMask carries = ~(WideDouble.Zero <= WideDouble.Zero);
        walks.Begin();
        for (int turn = 0; turn < sweeps * count; turn++)
        {
            int i = turn % count;
            LaneSoft* soft = DoubleLanes.Shift(softs + i, lane);
            LaneSoftPlace* place = places + i;
            if (place->NodeA >= 0)
            {
                walks.Visit(place->NodeA, all);
            }

            if (place->NodeB >= 0)
            {
                walks.Visit(place->NodeB, all);
            }

            WideDouble share = biased ? WideDouble.Load(soft->Early) : WideDouble.Splat(1);
            carries |= Solve(ref walks, &soft->Row0, place, place->Kind0, biased, share, all);
            if (place->Rows > 1)
            {
                carries |= Solve(ref walks, &soft->Row1, place, place->Kind1, biased, share, all);
            }
        }

        if (DoubleLanes.Bits(carries) == 0)
        {
            return false;
        }

        walks.End(carries);
        return true;
    }

    /// <summary>What to divide by, of the response of a row and that of its bodies alone: see <see cref="RowEnds"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideDouble ResponseOf(WideDouble plain, WideDouble own)
    {
        WideDouble least = WideDouble.Splat(RowEnds.Dead * RowEnds.Dead) * own;
        WideDouble k = WideDouble.Select(plain < least, least, plain);
        WideDouble ratio = WideDouble.Select(k > WideDouble.Zero, WideDouble.Splat(RowEnds.Dead) * own / k, WideDouble.Zero);
        WideDouble square = ratio * ratio;
        return k * (WideDouble.Splat(1) + (square * square));
    }

    /// <summary>The impulse that a spring is to have given in the substep.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideDouble SpringTo(LaneSoftRow* row, WideDouble v, WideDouble error, WideDouble old)
    {
        WideDouble q = WideDouble.Load(row->Q);
        WideDouble response = WideDouble.Load(row->Response);
        WideDouble pull = (q * v) + (WideDouble.Load(row->Kappa) * (error + WideDouble.Load(row->Ahead))) + (response * old);
        return old - (pull / (response * (WideDouble.Splat(1) + q)));
    }

    /// <summary>The same of a motor.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideDouble MotorTo(LaneSoftRow* row, WideDouble v, WideDouble old)
    {
        WideDouble damping = WideDouble.Load(row->Damping);
        WideDouble off = v - WideDouble.Load(row->Speed) + (damping * old);
        return old - (WideDouble.Load(row->Share) * off / (WideDouble.Load(row->Response) + damping));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideDouble Bounded(LaneSoftRow* row, WideDouble impulse, WideDouble share)
    {
        WideDouble low = share * WideDouble.Load(row->Low);
        WideDouble high = share * WideDouble.Load(row->High);
        impulse = WideDouble.Select(impulse > high, high, impulse);
        return WideDouble.Select(impulse < low, low, impulse);
    }

    private static LaneJoint* JointOf(in LaneWalks walks, LaneSoftPlace* place) =>
        place->Joint >= 0 ? &walks.Nodes[place->Joint].Joint : &walks.Anchors[~place->Joint].Joint;

    /// <summary>The response of body A to an impulse on B: T of the child and the mass of its parent.</summary>
    private static void WriteCross(in LaneWalks walks, LaneSoft* soft, LaneSoftPlace* place, double* space)
    {
        if (place->Joint < 0)
        {
            return;
        }

        double* t = walks.Walks[place->Joint].T;
        double* mass = walks.Walks[walks.Places[place->Joint].Parent].FullMass;
        if (place->NodeA == place->Joint)
        {
            LaneMatrix.Multiply(t, 3, mass, soft->Cross);
        }
        else
        {
            LaneMatrix.MultiplyTransposed(mass, t, 3, soft->Cross);
        }
    }

    private static WideDoubleMask Prepare(
        in LaneWalks walks, LaneSoft* soft, LaneSoftRow* row, LaneSoftPlace* place, in LaneSoftKind kind, double h)
    {
        LaneJoint* joint = JointOf(walks, place);
        if (kind.Along)
        {
            CopyRow(joint->LineA, row->A);
            CopyRow(joint->LineB, row->B);
        }
        else
        {
            WriteAngle(row->A, WideDouble.Splat(-1));
            WriteAngle(row->B, WideDouble.Splat(1));
        }

        WideDouble plain = WideDouble.Zero;
        WideDouble own = WideDouble.Zero;
        if (place->NodeA >= 0)
        {
            plain += Form(walks.Walks[place->NodeA].FullMass, row->A, row->A);
            own += LaneFactor.Own(row->A, walks.Nodes + place->NodeA);
        }

        if (place->NodeB >= 0)
        {
            plain += Form(walks.Walks[place->NodeB].FullMass, row->B, row->B);
            own += LaneFactor.Own(row->B, walks.Nodes + place->NodeB);
        }

        WideDouble ends = plain;
        if (place->Joint >= 0)
        {
            WideDouble cross = Form(soft->Cross, row->A, row->B);
            plain += cross + cross;
        }

        WideDouble response = ResponseOf(plain, own);
        response.Store(row->Response);
        if (kind.IsSpring)
        {
            ends.Store(row->Own);
            SetSprings(walks, soft, row, place, h);
            return ~(response > WideDouble.Zero);
        }

        own.Store(row->Own);
        WideDoubleMask stalled = ~(response > WideDouble.Zero) | ~(plain > WideDouble.Splat(RowEnds.Dead) * own);
        WideDouble.StoreMask(stalled, row->Stalled);
        return ~(WideDouble.Zero <= WideDouble.Zero);
    }

    private static void SetSprings(in LaneWalks walks, LaneSoft* soft, LaneSoftRow* row, LaneSoftPlace* place, double h)
    {
        for (int lane = 0; lane < WideDouble.Count; lane++)
        {
            double own = OwnOf(walks, place->NodeA, row->A, lane) + OwnOf(walks, place->NodeB, row->B, lane);
            double least = JointPass.LeastFreedom * Math.Min(own, row->Own[lane]);
            double share = JointPass.SpringShare(row->Response[lane], least, soft->SpringMass[lane]);
            double hold = soft->Hold[lane];
            JointPass.FindSpring(
                share, row->Stiffness[lane], row->Damping[lane], h, hold, out row->Q[lane], out row->Kappa[lane], out row->Lead[lane]);
        }
    }

    /// <summary>J M⁻¹ Jᵀ with the mass of the body alone.</summary>
    private static double OwnOf(in LaneWalks walks, int node, double* j, int lane) => node < 0
        ? 0
        : (walks.Nodes[node].InverseMass[lane] * ((j[lane] * j[lane]) + (j[4 + lane] * j[4 + lane])))
            + (walks.Nodes[node].InverseInertia[lane] * j[8 + lane] * j[8 + lane]);

    private static void WarmStart(in LaneWalks walks, LaneSoft* soft, LaneSoftRow* row, LaneSoftPlace* place, in LaneSoftKind kind)
    {
        if (kind.IsSpring)
        {
            WideDouble.Zero.Store(row->Lambda);
            return;
        }

        WideDouble lambda = WideDouble.Load(row->Lambda) * WideDouble.Load(soft->Early);
        lambda.Store(row->Lambda);
        lambda.Store(row->Start);
        WideDoubleMask all = WideDouble.Zero <= WideDouble.Zero;
        Give(JointOf(walks, place)->Given, row->B, lambda, all);
        PushOwn(walks, place->NodeA, row->A, lambda, all);
        PushOwn(walks, place->NodeB, row->B, lambda, all);
    }

    private static void Resume(in LaneWalks walks, LaneSoft* soft, LaneSoftRow* row, LaneSoftPlace* place, in LaneSoftKind kind)
    {
        WideDoubleMask free = WideDouble.Splat(1) > WideDouble.Load(soft->Early);
        if (kind.IsSpring || DoubleLanes.Bits(free) == 0)
        {
            return;
        }

        WideDouble start = WideDouble.Load(row->Start);
        WideDouble lambda = WideDouble.Load(row->Lambda);
        WideDouble.Select(free, lambda + start, lambda).Store(row->Lambda);
        Give(JointOf(walks, place)->Given, row->B, start, free);
        PushOwn(walks, place->NodeA, row->A, start, free);
        PushOwn(walks, place->NodeB, row->B, start, free);
    }

    /// <summary>Adds what an impulse along a row gives to body B.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Give(double* given, double* row, WideDouble impulse)
    {
        for (int at = 0; at < LaneMatrix.Row; at += LaneMatrix.Step)
        {
            (WideDouble.Load(given + at) + (WideDouble.Load(row + at) * impulse)).Store(given + at);
        }
    }

    /// <summary>The same in some lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Give(double* given, double* row, WideDouble impulse, WideDoubleMask where)
    {
        for (int at = 0; at < LaneMatrix.Row; at += LaneMatrix.Step)
        {
            WideDouble before = WideDouble.Load(given + at);
            WideDouble.Select(where, before + (WideDouble.Load(row + at) * impulse), before).Store(given + at);
        }
    }

    private static void PushOwn(in LaneWalks walks, int index, double* j, WideDouble impulse, WideDoubleMask where)
    {
        if (index >= 0)
        {
            LaneNode* node = walks.Nodes + index;
            for (int at = 0; at < LaneMatrix.Row; at += LaneMatrix.Step)
            {
                WideDouble mass = WideDouble.Load(at < 2 * LaneMatrix.Step ? node->InverseMass : node->InverseInertia);
                WideDouble before = WideDouble.Load(node->Velocity + at);
                WideDouble.Select(where, before + (mass * (WideDouble.Load(j + at) * impulse)), before).Store(node->Velocity + at);
            }
        }
    }

    /// <returns>The lanes in which it gave an impulse.</returns>
    private static WideDoubleMask Solve(
        ref LaneWalks walks,
        LaneSoftRow* row,
        LaneSoftPlace* place,
        in LaneSoftKind kind,
        bool biased,
        WideDouble share,
        WideDoubleMask all)
    {
        WideDoubleMask none = ~(WideDouble.Zero <= WideDouble.Zero);
        if (kind.IsSpring && !biased)
        {
            return none;
        }

        double* still = place->Joint < 0 ? walks.Anchors[~place->Joint].Still : null;
        double* a = place->NodeA < 0 ? still : walks.Nodes[place->NodeA].Velocity;
        double* b = place->NodeB < 0 ? still : walks.Nodes[place->NodeB].Velocity;
        WideDouble v = LaneSolve.Dot(row->A, a) + LaneSolve.Dot(row->B, b);
        WideDouble old = WideDouble.Load(row->Lambda);
        LaneJoint* joint = JointOf(walks, place);
        WideDouble now;
        if (kind.IsSpring)
        {
            now = SpringTo(row, v, WideDouble.Load(joint->Travel), old);
        }
        else
        {
            now = MotorTo(row, v, old);

            // A stalled motor pushes with what it has: see JointPass.
            WideDouble own = WideDouble.Load(row->Own);
            WideDouble pressed = WideDouble.Select(own > WideDouble.Zero, (WideDouble.Load(row->Speed) - v) / own, old);
            now = WideDouble.Select(WideDouble.LoadMask(row->Stalled), pressed, now);
        }

        now = WideDouble.Select(all, Bounded(row, now, share), old);
        now.Store(row->Lambda);
        WideDouble impulse = now - old;
        WideDoubleMask acts = all & ~((impulse >= WideDouble.Zero) & (impulse <= WideDouble.Zero));
        if (DoubleLanes.Bits(acts) != 0)
        {
            Give(joint->Given, row->B, impulse);
            Apply(ref walks, row, place, impulse, acts);
        }

        return acts;
    }

    /// <summary>B is current before and after.</summary>
    private static void Apply(ref LaneWalks walks, LaneSoftRow* row, LaneSoftPlace* place, WideDouble impulse, WideDoubleMask acts)
    {
        if (place->NodeB >= 0)
        {
            walks.Apply(place->NodeB, row->B, impulse, acts);
        }

        if (place->NodeA >= 0)
        {
            if (place->Joint >= 0)
            {
                walks.Visit(place->NodeA, acts);
            }

            walks.Apply(place->NodeA, row->A, impulse, acts);
            if (place->Joint >= 0)
            {
                walks.Visit(place->NodeB, acts);
            }
        }
    }

    private static WideDouble Form(double* m, double* p, double* q)
    {
        WideDouble x = LaneSolve.Dot(m, q);
        WideDouble y = LaneSolve.Dot(m + LaneMatrix.Row, q);
        WideDouble w = LaneSolve.Dot(m + (2 * LaneMatrix.Row), q);
        return LaneMatrix.Dot(x, y, w, p);
    }

    private static void CopyRow(double* from, double* to)
    {
        for (int at = 0; at < LaneMatrix.Row; at += LaneMatrix.Step)
        {
            WideDouble.Load(from + at).Store(to + at);
        }
    }

    private static void WriteAngle(double* row, WideDouble turn)
    {
        WideDouble.Zero.Store(row);
        WideDouble.Zero.Store(row + 4);
        turn.Store(row + 8);
    }
}
