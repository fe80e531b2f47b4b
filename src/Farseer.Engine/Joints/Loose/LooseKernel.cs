using System.Runtime.CompilerServices;
using Farseer.Engine.Joints.Lanes;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
#endif

namespace Farseer.Engine.Joints.Loose;

/// <summary>What <see cref="JointPass"/> does with the rows of one joint, for four, to the last bit.</summary>
internal static unsafe class LooseKernel
{
    private const int LanesOf = DoubleLanes.BundleLanes;

    /// <summary>One number of the bodies of the lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideDouble Gather(LooseBody* bodies, int number, int* index)
    {
#if NET8_0_OR_GREATER
        if (Avx2.IsSupported && Wide.Count == WideLanes.BundleLanes)
        {
            return Vector256.Create(
                ((double*)(bodies + index[0]))[number],
                ((double*)(bodies + index[1]))[number],
                ((double*)(bodies + index[2]))[number],
                ((double*)(bodies + index[3]))[number]).AsVector();
        }

        if (WideDouble.Count == 2)
        {
            return Vector128.Create(((double*)(bodies + index[0]))[number], ((double*)(bodies + index[1]))[number]).AsVector();
        }
#endif
        double* all = stackalloc double[LanesOf];
        for (int i = 0; i < WideDouble.Count; i++)
        {
            all[i] = ((double*)(bodies + index[i]))[number];
        }

        return WideDouble.Load(all);
    }

    /// <summary>Responses and springs at the present poses.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Prepare(LooseBundle* bundles, LooseRow* rows, LoosePlace* place, double h)
    {
        for (int lane = 0; lane < LanesOf; lane += WideDouble.Count)
        {
            LooseBundle* bundle = DoubleLanes.Shift(bundles, lane);
            WideDouble massA = WideDouble.Load(bundle->MassA);
            WideDouble inertiaA = WideDouble.Load(bundle->InertiaA);
            WideDouble massB = WideDouble.Load(bundle->MassB);
            WideDouble inertiaB = WideDouble.Load(bundle->InertiaB);
            if (place->SoftPoint)
            {
                LaneSoftRow* first = &DoubleLanes.Shift(rows, lane)->Soft;
                LaneSoftRow* second = &DoubleLanes.Shift(rows + 1, lane)->Soft;
                (Form(first->A, second->A, massA, inertiaA) + Form(first->B, second->B, massB, inertiaB)).Store(bundle->PointCoupling);
            }

            for (int k = 0; k < place->Rows; k++)
            {
                LooseRow* row = DoubleLanes.Shift(rows + k, lane);
                double* a = row->Soft.A;
                double* b = row->Soft.B;
                WideDouble plain = Form(a, a, massA, inertiaA) + Form(b, b, massB, inertiaB);
                WideDouble own = Own(a, massA, inertiaA) + Own(b, massB, inertiaB);
                LaneSweep.ResponseOf(plain, own).Store(row->Soft.Response);
                if (place->Type[k] == (byte)RowType.Spring)
                {
                    (OwnOfSpring(a, massA, inertiaA) + OwnOfSpring(b, massB, inertiaB)).Store(row->Soft.Own);
                    SetSprings(row, bundle, h);
                }
            }
        }
    }

    /// <summary>The impulses of the substep before.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void WarmStart(LooseBundle* bundles, LooseRow* rows, LoosePlace* place, LooseBody* bodies)
    {
        for (int lane = 0; lane < LanesOf; lane += WideDouble.Count)
        {
            LooseBundle* bundle = DoubleLanes.Shift(bundles, lane);
            Gather(bodies, place->BodyA + lane, out Velocity a);
            Gather(bodies, place->BodyB + lane, out Velocity b);
            for (int k = 0; k < place->Rows; k++)
            {
                LaneSoftRow* row = &DoubleLanes.Shift(rows + k, lane)->Soft;
                if (place->Type[k] == (byte)RowType.Spring)
                {
                    WideDouble.Zero.Store(row->Lambda);
                    continue;
                }

                WideDouble lambda = WideDouble.Load(row->Lambda) * WideDouble.Load(bundle->Early);
                lambda.Store(row->Lambda);
                lambda.Store(row->Start);
                LaneSweep.Give(bundle->Given, row->B, lambda);
                PushOwn(ref a, row->A, lambda, WideDouble.Load(bundle->MassA), WideDouble.Load(bundle->InertiaA));
                PushOwn(ref b, row->B, lambda, WideDouble.Load(bundle->MassB), WideDouble.Load(bundle->InertiaB));
            }

            Scatter(bodies, place->IntoA + lane, a);
            Scatter(bodies, place->IntoB + lane, b);
        }
    }

    /// <summary>See <see cref="JointPass.Resume"/>.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Resume(LooseBundle* bundles, LooseRow* rows, LoosePlace* place, LooseBody* bodies)
    {
        for (int lane = 0; lane < LanesOf; lane += WideDouble.Count)
        {
            LooseBundle* bundle = DoubleLanes.Shift(bundles, lane);
            WideDoubleMask free = WideDouble.Splat(1) > WideDouble.Load(bundle->Early);
            if (DoubleLanes.Bits(free) == 0)
            {
                continue;
            }

            Gather(bodies, place->BodyA + lane, out Velocity a);
            Gather(bodies, place->BodyB + lane, out Velocity b);
            Velocity oldA = a;
            Velocity oldB = b;
            for (int k = 0; k < place->Rows; k++)
            {
                LaneSoftRow* row = &DoubleLanes.Shift(rows + k, lane)->Soft;
                WideDouble start = WideDouble.Load(row->Start);
                WideDouble lambda = WideDouble.Load(row->Lambda);
                WideDouble.Select(free, lambda + start, lambda).Store(row->Lambda);
                LaneSweep.Give(bundle->Given, row->B, start, free);
                PushOwn(ref a, row->A, start, WideDouble.Load(bundle->MassA), WideDouble.Load(bundle->InertiaA));
                PushOwn(ref b, row->B, start, WideDouble.Load(bundle->MassB), WideDouble.Load(bundle->InertiaB));
            }

            Scatter(bodies, place->IntoA + lane, Choose(free, a, oldA));
            Scatter(bodies, place->IntoB + lane, Choose(free, b, oldB));
        }
    }

    private static Velocity Choose(WideDoubleMask where, in Velocity one, in Velocity other)
    {
        Velocity chosen;
        chosen.X = WideDouble.Select(where, one.X, other.X);
        chosen.Y = WideDouble.Select(where, one.Y, other.Y);
        chosen.W = WideDouble.Select(where, one.W, other.W);
        return chosen;
    }

    /// <summary>A sweep over the rows.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Solve(LooseBundle* bundles, LooseRow* rows, LoosePlace* place, LooseBody* bodies, in LimitPace pace, bool biased)
    {
        for (int lane = 0; lane < LanesOf; lane += WideDouble.Count)
        {
            LooseBundle* bundle = DoubleLanes.Shift(bundles, lane);
            Pair pair = default;
            Gather(bodies, place->BodyA + lane, out pair.A);
            Gather(bodies, place->BodyB + lane, out pair.B);
            pair.MassA = WideDouble.Load(bundle->MassA);
            pair.InertiaA = WideDouble.Load(bundle->InertiaA);
            pair.MassB = WideDouble.Load(bundle->MassB);
            pair.InertiaB = WideDouble.Load(bundle->InertiaB);
            WideDouble share = biased ? WideDouble.Load(bundle->Early) : WideDouble.Splat(1);
            if (place->SoftPoint)
            {
                SolvePoint(bundle, DoubleLanes.Shift(rows, lane), DoubleLanes.Shift(rows + 1, lane), ref pair, share);
            }

            for (int k = place->SoftPoint ? JointRows.OfPoint : 0; k < place->Rows; k++)
            {
                LooseRow* row = DoubleLanes.Shift(rows + k, lane);
                WideDouble old = WideDouble.Load(row->Soft.Lambda);
                WideDouble v = Dot(row->Soft.A, pair.A) + Dot(row->Soft.B, pair.B);
                WideDoubleMask answers = WideDouble.Load(row->Soft.Response) > WideDouble.Zero;
                WideDouble now;
                switch ((RowType)place->Type[k])
                {
                    case RowType.Motor:
                        now = LaneSweep.Bounded(&row->Soft, LaneSweep.MotorTo(&row->Soft, v, old), share);
                        break;
                    case RowType.Limit:
                        now = LimitTo(row, v, old, pace, biased);
                        break;
                    default:
                        if (!biased)
                        {
                            continue;
                        }

                        now = LaneSweep.SpringTo(&row->Soft, v, WideDouble.Load(row->Error), old);
                        if (place->Kind == JointKind.Target && k > 0)
                        {
                            PullAtMost(bundle, row - 1, ref pair, answers, now);
                            continue;
                        }

                        now = LaneSweep.Bounded(&row->Soft, now, share);
                        break;
                }

                Give(bundle, row, ref pair, WideDouble.Select(answers, now, old));
            }

            Scatter(bodies, place->IntoA + lane, pair.A);
            Scatter(bodies, place->IntoB + lane, pair.B);
        }
    }

    /// <summary>Both rows of a soft point at once; in turn where that asks for more than their bounds.</summary>
    private static void SolvePoint(LooseBundle* bundle, LooseRow* first, LooseRow* second, ref Pair pair, WideDouble share)
    {
        LaneSoftRow* p = &first->Soft;
        LaneSoftRow* q = &second->Soft;
        WideDouble damping0 = WideDouble.Load(p->Damping);
        WideDouble damping1 = WideDouble.Load(q->Damping);
        WideDouble response0 = WideDouble.Load(p->Response);
        WideDouble response1 = WideDouble.Load(q->Response);
        WideDouble k0 = response0 + damping0;
        WideDouble k1 = response1 + damping1;
        WideDouble k01 = WideDouble.Load(bundle->PointCoupling);
        WideDouble determinant = (k0 * k1) - (k01 * k01);
        WideDouble old0 = WideDouble.Load(p->Lambda);
        WideDouble old1 = WideDouble.Load(q->Lambda);
        WideDouble v0 = Dot(p->A, pair.A) + Dot(p->B, pair.B);
        WideDouble off0 = v0 - WideDouble.Load(p->Speed) + (damping0 * old0);
        WideDouble off1 = Dot(q->A, pair.A) + Dot(q->B, pair.B) - WideDouble.Load(q->Speed) + (damping1 * old1);
        WideDouble now0 = old0 + (((k01 * off1) - (k1 * off0)) / determinant);
        WideDouble now1 = old1 + (((k01 * off0) - (k0 * off1)) / determinant);
        WideDoubleMask answers0 = response0 > WideDouble.Zero;
        WideDoubleMask answers1 = response1 > WideDouble.Zero;
        WideDoubleMask both = answers0 & answers1 & (determinant > WideDouble.Splat(SmallMatrix.Lost) * (k0 * k1))
            & (now0 >= share * WideDouble.Load(p->Low)) & (now0 <= share * WideDouble.Load(p->High))
            & (now1 >= share * WideDouble.Load(q->Low)) & (now1 <= share * WideDouble.Load(q->High));
        WideDouble alone0 = WideDouble.Select(answers0, LaneSweep.Bounded(p, LaneSweep.MotorTo(p, v0, old0), share), old0);
        Give(bundle, first, ref pair, WideDouble.Select(both, now0, alone0));
        WideDouble v1 = Dot(q->A, pair.A) + Dot(q->B, pair.B);
        WideDouble alone1 = WideDouble.Select(answers1, LaneSweep.Bounded(q, LaneSweep.MotorTo(q, v1, old1), share), old1);
        Give(bundle, second, ref pair, WideDouble.Select(both, now1, alone1));
    }

    /// <summary>J·v.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble Dot(double* j, in Velocity v) => LaneMatrix.Dot(v.X, v.Y, v.W, j);

    /// <summary>The two springs towards a target are one force.</summary>
    private static void PullAtMost(LooseBundle* bundle, LooseRow* rows, ref Pair pair, WideDoubleMask answers, WideDouble across)
    {
        WideDouble along = WideDouble.Load(rows[0].Soft.Lambda);
        WideDouble length = WideDouble.Sqrt((along * along) + (across * across));
        WideDouble most = WideDouble.Load(rows[1].Soft.High);
        WideDouble share = WideDouble.Select(length > most, most / length, WideDouble.Splat(1));
        Give(bundle, rows, ref pair, WideDouble.Select(answers, share * along, along));
        Give(bundle, rows + 1, ref pair, WideDouble.Select(answers, share * across, WideDouble.Load(rows[1].Soft.Lambda)));
    }

    private static WideDouble LimitTo(LooseRow* row, WideDouble v, WideDouble old, in LimitPace pace, bool biased)
    {
        WideDouble h = WideDouble.Splat(pace.Substep);
        WideDouble gap = WideDouble.Load(row->Error);
        WideDouble response = WideDouble.Load(row->Soft.Response);
        WideDouble reach = WideDouble.Negate(v + (WideDouble.Select(gap > WideDouble.Zero, gap, WideDouble.Zero) / h));
        WideDouble need = biased ? reach : old * response;
        WideDoubleMask tie = need <= WideDouble.Splat(JointPass.Touching) * WideDouble.Abs(v);
        WideDouble change = reach / response;
        if (biased)
        {
            tie &= (old <= WideDouble.Zero) & (gap > WideDouble.Zero);
            WideDouble damping = WideDouble.Load(row->Soft.Damping);
            WideDouble over = gap + WideDouble.Load(row->Soft.Share);
            over = WideDouble.Select(over < WideDouble.Zero, over, WideDouble.Zero);
            WideDouble back = v + (WideDouble.Splat(pace.Recovery) * over / h) + (damping * old);
            change = WideDouble.Select(gap > WideDouble.Zero, change, WideDouble.Negate(back) / (response + damping));
        }

        WideDouble now = old + change;
        now = WideDouble.Select(now <= WideDouble.Zero, WideDouble.Zero, now);
        return WideDouble.Select(tie, old, now);
    }

    /// <summary>The row's impulse becomes another; both bodies feel the difference.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Give(LooseBundle* bundle, LooseRow* row, ref Pair pair, WideDouble now)
    {
        WideDouble impulse = now - WideDouble.Load(row->Soft.Lambda);
        now.Store(row->Soft.Lambda);
        LaneSweep.Give(bundle->Given, row->Soft.B, impulse);
        Push(ref pair.B, row->Soft.B, impulse, pair.MassB, pair.InertiaB);
        Push(ref pair.A, row->Soft.A, impulse, pair.MassA, pair.InertiaA);
    }

    /// <summary>By the inverse mass of a tree of one body, whose zeros take part: they decide about the sign of a sum of zeros.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Push(ref Velocity v, double* j, WideDouble impulse, WideDouble mass, WideDouble inertia)
    {
        WideDouble x = WideDouble.Load(j) * impulse;
        WideDouble y = WideDouble.Load(j + 4) * impulse;
        WideDouble w = WideDouble.Load(j + 8) * impulse;
        WideDouble x0 = WideDouble.Zero * x;
        WideDouble y0 = WideDouble.Zero * y;
        WideDouble w0 = WideDouble.Zero * w;
        v.X += (mass * x) + y0 + w0;
        v.Y += x0 + (mass * y) + w0;
        v.W += x0 + y0 + (inertia * w);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void PushOwn(ref Velocity v, double* j, WideDouble impulse, WideDouble mass, WideDouble inertia)
    {
        v.X += mass * (WideDouble.Load(j) * impulse);
        v.Y += mass * (WideDouble.Load(j + 4) * impulse);
        v.W += inertia * (WideDouble.Load(j + 8) * impulse);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble Form(double* p, double* q, WideDouble mass, WideDouble inertia)
    {
        WideDouble x = mass * WideDouble.Load(q);
        WideDouble y = mass * WideDouble.Load(q + 4);
        WideDouble w = inertia * WideDouble.Load(q + 8);
        return (WideDouble.Load(p) * x) + (WideDouble.Load(p + 4) * y) + (WideDouble.Load(p + 8) * w);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble Own(double* j, WideDouble mass, WideDouble inertia)
    {
        WideDouble x = WideDouble.Load(j);
        WideDouble y = WideDouble.Load(j + 4);
        WideDouble w = WideDouble.Load(j + 8);
        return (((x * x) + (y * y)) * mass) + (w * w * inertia);
    }

    /// <summary>The same, as springs take it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble OwnOfSpring(double* j, WideDouble mass, WideDouble inertia)
    {
        WideDouble x = WideDouble.Load(j);
        WideDouble y = WideDouble.Load(j + 4);
        WideDouble w = WideDouble.Load(j + 8);
        return (mass * ((x * x) + (y * y))) + (inertia * w * w);
    }

    /// <summary>Most feel their frequency as it is, substep after substep: then what follows from it stays.</summary>
    private static void SetSprings(LooseRow* row, LooseBundle* bundle, double h)
    {
        LaneSoftRow* soft = &row->Soft;
        for (int lane = 0; lane < WideDouble.Count; lane++)
        {
            double share = JointPass.SpringShare(soft->Response[lane], JointPass.LeastFreedom * soft->Own[lane], bundle->SpringMass[lane]);
            if (share != row->SpringShare[lane])
            {
                row->SpringShare[lane] = share;
                double hold = bundle->Hold[lane];
                JointPass.FindSpring(
                    share,
                    soft->Stiffness[lane],
                    soft->Damping[lane],
                    h,
                    hold,
                    out soft->Q[lane],
                    out soft->Kappa[lane],
                    out soft->Lead[lane]);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Gather(LooseBody* bodies, int* index, out Velocity v)
    {
        v.X = Gather(bodies, 0, index);
        v.Y = Gather(bodies, 1, index);
        v.W = Gather(bodies, 2, index);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Scatter(LooseBody* bodies, int* index, in Velocity v)
    {
        for (int i = 0; i < WideDouble.Count; i++)
        {
            Put(bodies + index[i], v.X[i], v.Y[i], v.W[i]);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Put(LooseBody* body, double x, double y, double w)
    {
        body->Velocity[0] = x;
        body->Velocity[1] = y;
        body->Velocity[2] = w;
    }

    private struct Velocity
    {
        public WideDouble X;
        public WideDouble Y;
        public WideDouble W;
    }

    private struct Pair
    {
        public Velocity A;
        public Velocity B;
        public WideDouble MassA;
        public WideDouble InertiaA;
        public WideDouble MassB;
        public WideDouble InertiaB;
    }
}
