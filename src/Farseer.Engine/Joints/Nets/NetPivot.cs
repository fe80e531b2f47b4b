using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Nets;

/// <summary>
/// Eight pivots: φ = anchor B - anchor A, dφ/dt = vB + ωB×rB - vA - ωA×rA. Their response is m·Q with
/// <code>
/// Q = 1 + jA·pA pAᵀ + jB·pB pBᵀ,  p = (-r.y, r.x),  det Q = 1 + jA·rA² + jB·rB² + jA·jB·(rA×rB)²
/// </code>
/// which is at least 1 and loses nothing by cancellation.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct NetPivotBundle
{
    public const int Lanes = NetEnds.Lanes;

    public NetEnds Ends;

    /// <summary>m times the impulse of the present substep.</summary>
    public fixed float ImpulseX[Lanes];
    public fixed float ImpulseY[Lanes];

    /// <summary>φ in the present substep, and if both bodies had only turned to the middle of the step.</summary>
    public fixed float ErrorX[Lanes];
    public fixed float ErrorY[Lanes];
    public fixed float BaseX[Lanes];
    public fixed float BaseY[Lanes];

    /// <summary>Sum of the impulses of the substeps that have ended.</summary>
    public fixed float SumX[Lanes];
    public fixed float SumY[Lanes];

    /// <summary>φ at the start of the step.</summary>
    public fixed float StartX[Lanes];
    public fixed float StartY[Lanes];

    /// <summary>What was put into φ from outside, and so is left out of it above; see <see cref="NetShift"/>.</summary>
    public fixed float OutsideX[Lanes];
    public fixed float OutsideY[Lanes];
}

/// <summary>The passes of a substep over pivots of a colour, on lanes; each takes any run of its bundles.</summary>
internal static unsafe class NetPivotKernel
{
    /// <summary>The impulses of the substep before; from here on they count as given.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void WarmStart(NetPivotBundle* bundles, int count, BodyState* bodies)
    {
        for (int i = 0; i < count; i++)
        {
            NetPivotBundle* row = bundles + i;
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                BodyLanes.GatherVelocities(bodies, row->Ends.BodyA + lane, row->Ends.BodyB + lane, out WideVelocity a, out WideVelocity b);
                Wide x = Wide.Load(row->ImpulseX + lane);
                Wide y = Wide.Load(row->ImpulseY + lane);
                (Wide.Load(row->SumX + lane) + x).Store(row->SumX + lane);
                (Wide.Load(row->SumY + lane) + y).Store(row->SumY + lane);
                NetEnds.Push(&row->Ends, lane, ref a, ref b, x, y);
                BodyLanes.ScatterVelocity(bodies, row->Ends.BodyA + lane, a);
                BodyLanes.ScatterVelocity(bodies, row->Ends.BodyB + lane, b);
            }
        }
    }

    /// <summary>One sweep at the arms that the substep has.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Solve(NetPivotBundle* bundles, int count, BodyState* bodies, in NetSoftness softness)
    {
        Wide biasRate = Wide.Splat(softness.BiasRate);
        Wide massScale = Wide.Splat(softness.MassScale);
        Wide leak = Wide.Splat(softness.ImpulseScale);
        Wide fastest = Wide.Splat(softness.Fastest);
        for (int i = 0; i < count; i++)
        {
            NetPivotBundle* row = bundles + i;
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                BodyLanes.GatherVelocities(bodies, row->Ends.BodyA + lane, row->Ends.BodyB + lane, out WideVelocity a, out WideVelocity b);
                Wide most = fastest * NetEnds.SizeOf(&row->Ends, lane);
                Wide biasX = NetSoftness.Bias(biasRate, Wide.Load(row->ErrorX + lane), most);
                Wide biasY = NetSoftness.Bias(biasRate, Wide.Load(row->ErrorY + lane), most);
                Step(row, lane, ref a, ref b, biasX, biasY, massScale, leak);
                BodyLanes.ScatterVelocity(bodies, row->Ends.BodyA + lane, a);
                BodyLanes.ScatterVelocity(bodies, row->Ends.BodyB + lane, b);
            }
        }
    }

    /// <summary>The relax pass: the arms turn along with the bodies, and one sweep without errors follows.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void TurnAndRelax(NetPivotBundle* bundles, int count, BodyState* bodies)
    {
        for (int i = 0; i < count; i++)
        {
            NetPivotBundle* row = bundles + i;
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                Turn(row, lane, bodies, out _, out _);
                BodyLanes.GatherVelocities(bodies, row->Ends.BodyA + lane, row->Ends.BodyB + lane, out WideVelocity a, out WideVelocity b);
                Step(row, lane, ref a, ref b, Wide.Zero, Wide.Zero, Wide.One, Wide.Zero);
                BodyLanes.ScatterVelocity(bodies, row->Ends.BodyA + lane, a);
                BodyLanes.ScatterVelocity(bodies, row->Ends.BodyB + lane, b);
            }
        }
    }

    /// <summary>Arms and errors where the step begins.</summary>
    /// <returns>True if any error came from outside.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static bool Begin(NetPivotBundle* bundles, int count, BodyState* bodies, float keep)
    {
        bool disturbed = false;
        for (int i = 0; i < count; i++)
        {
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                disturbed |= BeginLanes(bundles + i, lane, bodies, keep);
            }
        }

        return disturbed;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static bool BeginLanes(NetPivotBundle* row, int lane, BodyState* bodies, float keep)
    {
        Wide lastX = Wide.Load(row->ErrorX + lane);
        Wide lastY = Wide.Load(row->ErrorY + lane);
        Turn(row, lane, bodies, out Wide x, out Wide y);
        Wide outsideX = Wide.Load(row->OutsideX + lane);
        Wide outsideY = Wide.Load(row->OutsideY + lane);
        (x + outsideX).Store(row->StartX + lane);
        (y + outsideY).Store(row->StartY + lane);
        Wide size = NetEnds.SizeOf(&row->Ends, lane);
        Wide shiftX = NetShift.Of(lastX, x, outsideX, size, keep);
        Wide shiftY = NetShift.Of(lastY, y, outsideY, size, keep);
        Shift(row, lane, shiftX, shiftY);
        return NetShift.IsDisturbed(outsideX + shiftX) | NetShift.IsDisturbed(outsideY + shiftY);
    }

    /// <summary>Displaces the bodies to where less is left of what came from outside; the impulses stay as they are.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Pull(NetPivotBundle* bundles, int count, BodyState* bodies, in NetSoftness softness)
    {
        Wide rate = Wide.Splat(softness.BiasRate);
        Wide fastest = Wide.Splat(softness.Fastest);
        for (int i = 0; i < count; i++)
        {
            NetPivotBundle* row = bundles + i;
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                Wide x = Wide.Load(row->ImpulseX + lane);
                Wide y = Wide.Load(row->ImpulseY + lane);
                BodyLanes.GatherVelocities(bodies, row->Ends.BodyA + lane, row->Ends.BodyB + lane, out WideVelocity a, out WideVelocity b);
                Wide most = fastest * NetEnds.SizeOf(&row->Ends, lane);
                Wide biasX = NetSoftness.Bias(rate, Wide.Load(row->OutsideX + lane), most);
                Wide biasY = NetSoftness.Bias(rate, Wide.Load(row->OutsideY + lane), most);
                Step(row, lane, ref a, ref b, biasX, biasY, Wide.One, Wide.Zero);
                BodyLanes.ScatterVelocity(bodies, row->Ends.BodyA + lane, a);
                BodyLanes.ScatterVelocity(bodies, row->Ends.BodyB + lane, b);
                x.Store(row->ImpulseX + lane);
                y.Store(row->ImpulseY + lane);
            }
        }
    }

    /// <summary>The arms where the bodies are now; what a displacement changed of φ is no motion.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Turn(NetPivotBundle* bundles, int count, BodyState* bodies, bool displaced)
    {
        for (int i = 0; i < count; i++)
        {
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                TurnLanes(bundles + i, lane, bodies, displaced);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void TurnLanes(NetPivotBundle* row, int lane, BodyState* bodies, bool displaced)
    {
        Wide lastX = Wide.Load(row->ErrorX + lane);
        Wide lastY = Wide.Load(row->ErrorY + lane);
        Turn(row, lane, bodies, out Wide x, out Wide y);
        if (displaced)
        {
            Shift(row, lane, x - lastX, y - lastY);
        }
    }

    /// <summary>The arms and φ where the bodies are now.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void Turn(NetPivotBundle* row, int lane, BodyState* bodies, out Wide x, out Wide y)
    {
        NetEnds.TurnArms(&row->Ends, lane, bodies, out Wide movedX, out Wide movedY);
        x = Wide.Load(row->BaseX + lane) + movedX;
        y = Wide.Load(row->BaseY + lane) + movedY;
        x.Store(row->ErrorX + lane);
        y.Store(row->ErrorY + lane);
    }

    /// <summary>Of φ, so much came from outside.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Shift(NetPivotBundle* row, int lane, Wide x, Wide y)
    {
        (Wide.Load(row->OutsideX + lane) + x).Store(row->OutsideX + lane);
        (Wide.Load(row->OutsideY + lane) + y).Store(row->OutsideY + lane);
        (Wide.Load(row->BaseX + lane) - x).Store(row->BaseX + lane);
        (Wide.Load(row->BaseY + lane) - y).Store(row->BaseY + lane);
        (Wide.Load(row->ErrorX + lane) - x).Store(row->ErrorX + lane);
        (Wide.Load(row->ErrorY + lane) - y).Store(row->ErrorY + lane);
    }

    /// <summary>The impulse that brings dφ/dt to minus the bias, by the share that the softness lets through.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Step(
        NetPivotBundle* row, int lane, ref WideVelocity a, ref WideVelocity b, Wide biasX, Wide biasY, Wide massScale, Wide leak)
    {
        NetEnds.Speed(&row->Ends, lane, a, b, out Wide x, out Wide y);
        x = x + biasX;
        y = y + biasY;
        Wide ax = Wide.Load(row->Ends.ArmAX + lane);
        Wide ay = Wide.Load(row->Ends.ArmAY + lane);
        Wide bx = Wide.Load(row->Ends.ArmBX + lane);
        Wide by = Wide.Load(row->Ends.ArmBY + lane);
        Wide ja = Wide.Load(row->Ends.TurnA + lane);
        Wide jb = Wide.Load(row->Ends.TurnB + lane);
        Wide jax = ja * ax;
        Wide jay = ja * ay;
        Wide jbx = jb * bx;
        Wide jby = jb * by;
        Wide nearX = (jax * ax) + (jbx * bx);
        Wide nearY = (jay * ay) + (jby * by);
        Wide mixed = (jax * ay) + (jbx * by);
        Wide area = (ax * by) - (ay * bx);
        Wide determinant = (Wide.One + (nearX + nearY)) + ((ja * area) * (jb * area));
        Wide scale = massScale / determinant;

        // Q⁻¹ = (1 + nearX, mixed; mixed, 1 + nearY)/det.
        Wide oldX = Wide.Load(row->ImpulseX + lane);
        Wide oldY = Wide.Load(row->ImpulseY + lane);
        Wide px = Wide.Zero - (scale * ((x + (nearX * x)) + (mixed * y))) - (leak * oldX);
        Wide py = Wide.Zero - (scale * ((y + (nearY * y)) + (mixed * x))) - (leak * oldY);
        (oldX + px).Store(row->ImpulseX + lane);
        (oldY + py).Store(row->ImpulseY + lane);
        NetEnds.Push(&row->Ends, lane, ref a, ref b, px, py);
    }
}

/// <summary>The pivots of one colour.</summary>
internal sealed unsafe class NetPivots : NetRows
{
    public NetPivots(bool sequential)
        : base(sizeof(NetPivotBundle), sequential)
    {
    }

    private NetPivotBundle* Bundles => (NetPivotBundle*)Memory;

    protected override void PlaceRows(int from, int to, NetPose* poses, float impulseScale)
    {
        for (int row = from; row < to; row++)
        {
            Place((NetPivotBundle*)EndsOf(row), LaneOf(row), poses, AnchorsOf(row), impulseScale);
        }
    }

    public override bool Begin(int first, int count, in NetMotion motion, float keep) =>
        NetPivotKernel.Begin(Bundles + first, count, motion.States, keep);

    public override void Pull(int first, int count, in NetMotion motion, in NetSoftness softness) =>
        NetPivotKernel.Pull(Bundles + first, count, motion.States, softness);

    public override void Turn(int first, int count, in NetMotion motion, bool displaced) =>
        NetPivotKernel.Turn(Bundles + first, count, motion.States, displaced);

    public override void WarmStart(int first, int count, in NetMotion motion) =>
        NetPivotKernel.WarmStart(Bundles + first, count, motion.States);

    public override void Solve(int first, int count, in NetMotion motion, in NetSoftness softness) =>
        NetPivotKernel.Solve(Bundles + first, count, motion.States, softness);

    public override void TurnAndRelax(int first, int count, in NetMotion motion) =>
        NetPivotKernel.TurnAndRelax(Bundles + first, count, motion.States);

    public override void Take(int row, in JointState state) => Take((NetPivotBundle*)EndsOf(row), LaneOf(row), state);

    public override void Report(int row, ref JointState state, double dt) =>
        Report((NetPivotBundle*)EndsOf(row), LaneOf(row), ref state, dt);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static float Place(NetPivotBundle* bundle, int lane, NetPose* poses, in NetAnchors anchors, float impulseScale)
    {
        float scale = PlaceEnds(&bundle->Ends, lane, poses, anchors, impulseScale, out double x, out double y);
        bundle->BaseX[lane] = (float)(x - bundle->OutsideX[lane]);
        bundle->BaseY[lane] = (float)(y - bundle->OutsideY[lane]);
        float impulseX = bundle->ImpulseX[lane] * scale;
        float impulseY = bundle->ImpulseY[lane] * scale;
        bundle->ImpulseX[lane] = impulseX;
        bundle->ImpulseY[lane] = impulseY;

        // The first warm start counts these as given; they were, in the step before.
        bundle->SumX[lane] = -impulseX;
        bundle->SumY[lane] = -impulseY;
        return scale;
    }

    internal static void Take(NetPivotBundle* bundle, int lane, in JointState state)
    {
        bundle->ImpulseX[lane] = (float)state.Impulse[0];
        bundle->ImpulseY[lane] = (float)state.Impulse[1];
        bundle->SumX[lane] = 0;
        bundle->SumY[lane] = 0;
        bundle->StartX[lane] = (float)state.Error;
        bundle->StartY[lane] = 0;
    }

    internal static void Report(NetPivotBundle* bundle, int lane, ref JointState state, double dt)
    {
        double inverse = InverseResponse(&bundle->Ends, lane);
        state.Impulse[0] = bundle->ImpulseX[lane] * inverse;
        state.Impulse[1] = bundle->ImpulseY[lane] * inverse;
        double x = bundle->StartX[lane];
        double y = bundle->StartY[lane];
        state.Error = Math.Sqrt((x * x) + (y * y));

        // The sum lacks the impulse of the last substep. A pivot has no moment about its anchor.
        state.ForceX = ((double)bundle->SumX[lane] + bundle->ImpulseX[lane]) * inverse / dt;
        state.ForceY = ((double)bundle->SumY[lane] + bundle->ImpulseY[lane]) * inverse / dt;
        state.Torque = 0;
    }
}
