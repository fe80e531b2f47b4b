using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Nets;

/// <summary>
/// Eight welds: a pivot and θ = θB - θA - Target, solved as one block of three rows. With s = jA + jB and the angular row eliminated,
/// what is left of the response is
/// <code>
/// Q' = 1 + (jA·jB/s)·d dᵀ,  d = pA - pB;  Q'⁻¹ = 1 - t/(1 + t·d²)·d dᵀ with t = jA·jB/s
/// </code>
/// Of two bodies that nothing can turn, s = 0, only the pivot is left.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct NetWeldBundle
{
    public const int Lanes = NetEnds.Lanes;

    public NetPivotBundle Pivot;

    /// <summary>jA/s, jB/s and 1/s; 0 for s = 0.</summary>
    public fixed float PartA[Lanes];
    public fixed float PartB[Lanes];
    public fixed float InverseTurn[Lanes];

    /// <summary>m times the angular impulse about the anchor, the angle's error now and at the start of the step, and the sum.</summary>
    public fixed float Impulse[Lanes];
    public fixed float Error[Lanes];
    public fixed float Base[Lanes];
    public fixed float Sum[Lanes];

    /// <summary>What was put into the angle from outside, and so is left out of its error.</summary>
    public fixed float Outside[Lanes];
}

/// <summary>The passes of a substep over welds of a colour, on lanes; each takes any run of its bundles.</summary>
internal static unsafe class NetWeldKernel
{
    /// <summary>The impulses of the substep before; from here on they count as given.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void WarmStart(NetWeldBundle* bundles, int count, BodyState* bodies)
    {
        for (int i = 0; i < count; i++)
        {
            NetWeldBundle* row = bundles + i;
            NetEnds* ends = &row->Pivot.Ends;
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                BodyLanes.GatherVelocities(bodies, ends->BodyA + lane, ends->BodyB + lane, out WideVelocity a, out WideVelocity b);
                Wide x = Wide.Load(row->Pivot.ImpulseX + lane);
                Wide y = Wide.Load(row->Pivot.ImpulseY + lane);
                Wide w = Wide.Load(row->Impulse + lane);
                (Wide.Load(row->Pivot.SumX + lane) + x).Store(row->Pivot.SumX + lane);
                (Wide.Load(row->Pivot.SumY + lane) + y).Store(row->Pivot.SumY + lane);
                (Wide.Load(row->Sum + lane) + w).Store(row->Sum + lane);
                Push(row, lane, ref a, ref b, x, y, w);
                BodyLanes.ScatterVelocity(bodies, ends->BodyA + lane, a);
                BodyLanes.ScatterVelocity(bodies, ends->BodyB + lane, b);
            }
        }
    }

    /// <summary>One sweep at the arms that the substep has.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Solve(NetWeldBundle* bundles, int count, BodyState* bodies, in NetSoftness softness)
    {
        Wide biasRate = Wide.Splat(softness.BiasRate);
        Wide massScale = Wide.Splat(softness.MassScale);
        Wide leak = Wide.Splat(softness.ImpulseScale);
        Wide fastest = Wide.Splat(softness.Fastest);
        for (int i = 0; i < count; i++)
        {
            NetWeldBundle* row = bundles + i;
            NetEnds* ends = &row->Pivot.Ends;
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                BodyLanes.GatherVelocities(bodies, ends->BodyA + lane, ends->BodyB + lane, out WideVelocity a, out WideVelocity b);
                Wide most = fastest * NetEnds.SizeOf(ends, lane);
                WideVelocity bias;
                bias.X = NetSoftness.Bias(biasRate, Wide.Load(row->Pivot.ErrorX + lane), most);
                bias.Y = NetSoftness.Bias(biasRate, Wide.Load(row->Pivot.ErrorY + lane), most);
                bias.W = NetSoftness.Bias(biasRate, Wide.Load(row->Error + lane), fastest);
                Step(row, lane, ref a, ref b, bias, massScale, leak);
                BodyLanes.ScatterVelocity(bodies, ends->BodyA + lane, a);
                BodyLanes.ScatterVelocity(bodies, ends->BodyB + lane, b);
            }
        }
    }

    /// <summary>The relax pass: the arms turn along with the bodies, and one sweep without errors follows.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void TurnAndRelax(NetWeldBundle* bundles, int count, BodyState* bodies, BodyMotion* motions)
    {
        for (int i = 0; i < count; i++)
        {
            NetWeldBundle* row = bundles + i;
            NetEnds* ends = &row->Pivot.Ends;
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                NetPivotKernel.Turn(&row->Pivot, lane, bodies, out _, out _);
                TurnAngle(row, lane, motions);
                BodyLanes.GatherVelocities(bodies, ends->BodyA + lane, ends->BodyB + lane, out WideVelocity a, out WideVelocity b);
                Step(row, lane, ref a, ref b, default, Wide.One, Wide.Zero);
                BodyLanes.ScatterVelocity(bodies, ends->BodyA + lane, a);
                BodyLanes.ScatterVelocity(bodies, ends->BodyB + lane, b);
            }
        }
    }

    /// <summary>Arms and errors where the step begins.</summary>
    /// <returns>True if any error came from outside.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static bool Begin(NetWeldBundle* bundles, int count, BodyState* bodies, BodyMotion* motions, float keep)
    {
        bool disturbed = false;
        for (int i = 0; i < count; i++)
        {
            NetWeldBundle* row = bundles + i;
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                disturbed |= NetPivotKernel.BeginLanes(&row->Pivot, lane, bodies, keep);
                Wide last = Wide.Load(row->Error + lane);
                TurnAngle(row, lane, motions);
                Wide outside = Wide.Load(row->Outside + lane);
                Wide shift = NetShift.Of(last, Wide.Load(row->Error + lane), outside, Wide.One, keep);
                Shift(row, lane, shift);
                disturbed |= NetShift.IsDisturbed(outside + shift);
            }
        }

        return disturbed;
    }

    /// <summary>Displaces the bodies to where less is left of what came from outside; the impulses stay as they are.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Pull(NetWeldBundle* bundles, int count, BodyState* bodies, in NetSoftness softness)
    {
        Wide rate = Wide.Splat(softness.BiasRate);
        Wide fastest = Wide.Splat(softness.Fastest);
        for (int i = 0; i < count; i++)
        {
            NetWeldBundle* row = bundles + i;
            NetEnds* ends = &row->Pivot.Ends;
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                Wide x = Wide.Load(row->Pivot.ImpulseX + lane);
                Wide y = Wide.Load(row->Pivot.ImpulseY + lane);
                Wide w = Wide.Load(row->Impulse + lane);
                BodyLanes.GatherVelocities(bodies, ends->BodyA + lane, ends->BodyB + lane, out WideVelocity a, out WideVelocity b);
                Wide most = fastest * NetEnds.SizeOf(ends, lane);
                WideVelocity bias;
                bias.X = NetSoftness.Bias(rate, Wide.Load(row->Pivot.OutsideX + lane), most);
                bias.Y = NetSoftness.Bias(rate, Wide.Load(row->Pivot.OutsideY + lane), most);
                bias.W = NetSoftness.Bias(rate, Wide.Load(row->Outside + lane), fastest);
                Step(row, lane, ref a, ref b, bias, Wide.One, Wide.Zero);
                BodyLanes.ScatterVelocity(bodies, ends->BodyA + lane, a);
                BodyLanes.ScatterVelocity(bodies, ends->BodyB + lane, b);
                x.Store(row->Pivot.ImpulseX + lane);
                y.Store(row->Pivot.ImpulseY + lane);
                w.Store(row->Impulse + lane);
            }
        }
    }

    /// <summary>The arms where the bodies are now; what a displacement changed of the errors is no motion.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Turn(NetWeldBundle* bundles, int count, BodyState* bodies, BodyMotion* motions, bool displaced)
    {
        for (int i = 0; i < count; i++)
        {
            NetWeldBundle* row = bundles + i;
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                NetPivotKernel.TurnLanes(&row->Pivot, lane, bodies, displaced);
                Wide last = Wide.Load(row->Error + lane);
                TurnAngle(row, lane, motions);
                if (displaced)
                {
                    Shift(row, lane, Wide.Load(row->Error + lane) - last);
                }
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Shift(NetWeldBundle* row, int lane, Wide angle)
    {
        (Wide.Load(row->Outside + lane) + angle).Store(row->Outside + lane);
        (Wide.Load(row->Base + lane) - angle).Store(row->Base + lane);
        (Wide.Load(row->Error + lane) - angle).Store(row->Error + lane);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void TurnAngle(NetWeldBundle* row, int lane, BodyMotion* motions)
    {
        BodyLanes.Gather((float*)motions, row->Pivot.Ends.BodyA + lane, out _, out _, out _, out Wide turnedA);
        BodyLanes.Gather((float*)motions, row->Pivot.Ends.BodyB + lane, out _, out _, out _, out Wide turnedB);
        (Wide.Load(row->Base + lane) + (turnedB - turnedA)).Store(row->Error + lane);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Step(
        NetWeldBundle* row, int lane, ref WideVelocity a, ref WideVelocity b, in WideVelocity bias, Wide massScale, Wide leak)
    {
        NetEnds* ends = &row->Pivot.Ends;
        NetEnds.Speed(ends, lane, a, b, out Wide x, out Wide y);
        x = x + bias.X;
        y = y + bias.Y;
        Wide w = (b.W - a.W) + bias.W;
        Wide ax = Wide.Load(ends->ArmAX + lane);
        Wide ay = Wide.Load(ends->ArmAY + lane);
        Wide bx = Wide.Load(ends->ArmBX + lane);
        Wide by = Wide.Load(ends->ArmBY + lane);
        Wide partA = Wide.Load(row->PartA + lane);
        Wide partB = Wide.Load(row->PartB + lane);

        // q/s, the mean of pA and pB by their shares in the turn; an angular impulse moves φ along it.
        Wide qx = Wide.Zero - ((partA * ay) + (partB * by));
        Wide qy = (partA * ax) + (partB * bx);
        x = x - (qx * w);
        y = y - (qy * w);
        Wide dx = by - ay;
        Wide dy = ax - bx;
        Wide t = Wide.Load(ends->TurnA + lane) * partB;
        Wide across = ((dx * x) + (dy * y)) * (t / (Wide.One + (t * ((dx * dx) + (dy * dy)))));
        Wide px = (dx * across) - x;
        Wide py = (dy * across) - y;

        // The angular row from the first line of its elimination: w + q·p + s·pw = 0.
        Wide pw = Wide.Zero - (w * Wide.Load(row->InverseTurn + lane)) - ((qx * px) + (qy * py));
        Wide oldX = Wide.Load(row->Pivot.ImpulseX + lane);
        Wide oldY = Wide.Load(row->Pivot.ImpulseY + lane);
        Wide oldW = Wide.Load(row->Impulse + lane);
        px = (massScale * px) - (leak * oldX);
        py = (massScale * py) - (leak * oldY);
        pw = (massScale * pw) - (leak * oldW);
        (oldX + px).Store(row->Pivot.ImpulseX + lane);
        (oldY + py).Store(row->Pivot.ImpulseY + lane);
        (oldW + pw).Store(row->Impulse + lane);
        Push(row, lane, ref a, ref b, px, py, pw);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Push(NetWeldBundle* row, int lane, ref WideVelocity a, ref WideVelocity b, Wide x, Wide y, Wide w)
    {
        NetEnds* ends = &row->Pivot.Ends;
        NetEnds.Push(ends, lane, ref a, ref b, x, y);
        a.W = a.W - (Wide.Load(ends->TurnA + lane) * w);
        b.W = b.W + (Wide.Load(ends->TurnB + lane) * w);
    }
}

/// <summary>The welds of one colour.</summary>
internal sealed unsafe class NetWelds : NetRows
{
    public NetWelds(bool sequential)
        : base(sizeof(NetWeldBundle), sequential)
    {
    }

    private NetWeldBundle* Bundles => (NetWeldBundle*)Memory;

    protected override void PlaceRows(int from, int to, NetPose* poses, float impulseScale)
    {
        for (int row = from; row < to; row++)
        {
            NetWeldBundle* bundle = (NetWeldBundle*)EndsOf(row);
            NetEnds* ends = &bundle->Pivot.Ends;
            int lane = LaneOf(row);
            ref NetAnchors anchors = ref AnchorsOf(row);
            float scale = NetPivots.Place(&bundle->Pivot, lane, poses, anchors, impulseScale);
            float turn = ends->TurnA[lane] + ends->TurnB[lane];
            float inverse = turn > 0 ? 1 / turn : 0;
            bundle->PartA[lane] = ends->TurnA[lane] * inverse;
            bundle->PartB[lane] = ends->TurnB[lane] * inverse;
            bundle->InverseTurn[lane] = inverse;
            double angle = (poses[ends->BodyB[lane]].Angle - poses[ends->BodyA[lane]].Angle) - anchors.Target;
            bundle->Base[lane] = (float)(angle - bundle->Outside[lane]);
            float impulse = bundle->Impulse[lane] * scale;
            bundle->Impulse[lane] = impulse;
            bundle->Sum[lane] = -impulse;
        }
    }

    public override bool Begin(int first, int count, in NetMotion motion, float keep) =>
        NetWeldKernel.Begin(Bundles + first, count, motion.States, motion.Motions, keep);

    public override void Pull(int first, int count, in NetMotion motion, in NetSoftness softness) =>
        NetWeldKernel.Pull(Bundles + first, count, motion.States, softness);

    public override void Turn(int first, int count, in NetMotion motion, bool displaced) =>
        NetWeldKernel.Turn(Bundles + first, count, motion.States, motion.Motions, displaced);

    public override void WarmStart(int first, int count, in NetMotion motion) =>
        NetWeldKernel.WarmStart(Bundles + first, count, motion.States);

    public override void Solve(int first, int count, in NetMotion motion, in NetSoftness softness) =>
        NetWeldKernel.Solve(Bundles + first, count, motion.States, softness);

    public override void TurnAndRelax(int first, int count, in NetMotion motion) =>
        NetWeldKernel.TurnAndRelax(Bundles + first, count, motion.States, motion.Motions);

    public override void Take(int row, in JointState state)
    {
        NetWeldBundle* bundle = (NetWeldBundle*)EndsOf(row);
        NetPivots.Take(&bundle->Pivot, LaneOf(row), state);
        bundle->Impulse[LaneOf(row)] = (float)state.Impulse[2];
        bundle->Sum[LaneOf(row)] = 0;
    }

    public override void Report(int row, ref JointState state, double dt)
    {
        NetWeldBundle* bundle = (NetWeldBundle*)EndsOf(row);
        int lane = LaneOf(row);
        NetPivots.Report(&bundle->Pivot, lane, ref state, dt);
        double inverse = InverseResponse(&bundle->Pivot.Ends, lane);
        state.Impulse[2] = bundle->Impulse[lane] * inverse;
        state.Torque = ((double)bundle->Sum[lane] + bundle->Impulse[lane]) * inverse / dt;
    }
}
