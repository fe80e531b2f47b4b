using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Nets;

/// <summary>
/// Eight rods: φ = |d| - L with d from anchor A to anchor B, n = d/|d|, dφ/dt = n·(vB + ωB×rB - vA - ωA×rA), response
/// m·(1 + jA·(rA×n)² + jB·(rB×n)²). With d0 at the middle of the step and δ what was added since,
/// <code>
/// φ = (d0² - L² + (d0 + d)·δ)/(|d| + L)
/// </code>
/// whose first two terms are subtracted in double: a long rod has no larger error than a short one.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct NetRodBundle
{
    public const int Lanes = NetEnds.Lanes;

    public NetEnds Ends;

    /// <summary>n in the present substep.</summary>
    public fixed float AxisX[Lanes];
    public fixed float AxisY[Lanes];

    /// <summary>m times the impulse along n in the present substep.</summary>
    public fixed float Impulse[Lanes];

    /// <summary>φ in the present substep and at the start of the step.</summary>
    public fixed float Error[Lanes];
    public fixed float Start[Lanes];

    /// <summary>d0, d0² - L² and L.</summary>
    public fixed float BaseX[Lanes];
    public fixed float BaseY[Lanes];
    public fixed float Excess[Lanes];
    public fixed float Length[Lanes];

    /// <summary>Sum of the impulses of the step; n turns in it.</summary>
    public fixed float SumX[Lanes];
    public fixed float SumY[Lanes];

    /// <summary>What was put into φ from outside; <see cref="Length"/> is longer by it.</summary>
    public fixed float Outside[Lanes];
}

/// <summary>The passes of a substep over rods of a colour, on lanes; each takes any run of its bundles.</summary>
internal static unsafe class NetRodKernel
{
    /// <summary>The impulses of the substep before.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void WarmStart(NetRodBundle* bundles, int count, BodyState* bodies)
    {
        for (int i = 0; i < count; i++)
        {
            NetRodBundle* row = bundles + i;
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                BodyLanes.GatherVelocities(bodies, row->Ends.BodyA + lane, row->Ends.BodyB + lane, out WideVelocity a, out WideVelocity b);
                Push(row, lane, ref a, ref b, Wide.Load(row->Impulse + lane));
                BodyLanes.ScatterVelocity(bodies, row->Ends.BodyA + lane, a);
                BodyLanes.ScatterVelocity(bodies, row->Ends.BodyB + lane, b);
            }
        }
    }

    /// <summary>One sweep at the arms that the substep has.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Solve(NetRodBundle* bundles, int count, BodyState* bodies, in NetSoftness softness)
    {
        Wide biasRate = Wide.Splat(softness.BiasRate);
        Wide massScale = Wide.Splat(softness.MassScale);
        Wide leak = Wide.Splat(softness.ImpulseScale);
        Wide fastest = Wide.Splat(softness.Fastest);
        for (int i = 0; i < count; i++)
        {
            NetRodBundle* row = bundles + i;
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                BodyLanes.GatherVelocities(bodies, row->Ends.BodyA + lane, row->Ends.BodyB + lane, out WideVelocity a, out WideVelocity b);
                Wide most = fastest * SizeOf(row, lane);
                Step(row, lane, ref a, ref b, NetSoftness.Bias(biasRate, Wide.Load(row->Error + lane), most), massScale, leak);
                BodyLanes.ScatterVelocity(bodies, row->Ends.BodyA + lane, a);
                BodyLanes.ScatterVelocity(bodies, row->Ends.BodyB + lane, b);
            }
        }
    }

    /// <summary>The relax pass: the arms turn along with the bodies, and one sweep without errors follows.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void TurnAndRelax(NetRodBundle* bundles, int count, BodyState* bodies)
    {
        for (int i = 0; i < count; i++)
        {
            NetRodBundle* row = bundles + i;
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                Turn(row, lane, bodies);
                BodyLanes.GatherVelocities(bodies, row->Ends.BodyA + lane, row->Ends.BodyB + lane, out WideVelocity a, out WideVelocity b);
                Step(row, lane, ref a, ref b, Wide.Zero, Wide.One, Wide.Zero);
                BodyLanes.ScatterVelocity(bodies, row->Ends.BodyA + lane, a);
                BodyLanes.ScatterVelocity(bodies, row->Ends.BodyB + lane, b);
            }
        }
    }

    /// <summary>Arms and errors where the step begins.</summary>
    /// <returns>True if any error came from outside.</returns>
    [MethodImpl(KernelMethod.Optimized)]
    public static bool Begin(NetRodBundle* bundles, int count, BodyState* bodies, float keep)
    {
        bool disturbed = false;
        for (int i = 0; i < count; i++)
        {
            NetRodBundle* row = bundles + i;
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                Wide last = Wide.Load(row->Error + lane);
                Turn(row, lane, bodies);
                Wide error = Wide.Load(row->Error + lane);
                Wide outside = Wide.Load(row->Outside + lane);
                (error + outside).Store(row->Start + lane);
                Wide shift = NetShift.Of(last, error, outside, SizeOf(row, lane), keep);
                Shift(row, lane, shift);
                disturbed |= NetShift.IsDisturbed(outside + shift);
            }
        }

        return disturbed;
    }

    /// <summary>Displaces the bodies to where less is left of what came from outside; the impulses stay as they are.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Pull(NetRodBundle* bundles, int count, BodyState* bodies, in NetSoftness softness)
    {
        Wide rate = Wide.Splat(softness.BiasRate);
        Wide fastest = Wide.Splat(softness.Fastest);
        for (int i = 0; i < count; i++)
        {
            NetRodBundle* row = bundles + i;
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                Wide kept = Wide.Load(row->Impulse + lane);
                Wide keptX = Wide.Load(row->SumX + lane);
                Wide keptY = Wide.Load(row->SumY + lane);
                BodyLanes.GatherVelocities(bodies, row->Ends.BodyA + lane, row->Ends.BodyB + lane, out WideVelocity a, out WideVelocity b);
                Wide bias = NetSoftness.Bias(rate, Wide.Load(row->Outside + lane), fastest * SizeOf(row, lane));
                Step(row, lane, ref a, ref b, bias, Wide.One, Wide.Zero);
                BodyLanes.ScatterVelocity(bodies, row->Ends.BodyA + lane, a);
                BodyLanes.ScatterVelocity(bodies, row->Ends.BodyB + lane, b);
                kept.Store(row->Impulse + lane);
                keptX.Store(row->SumX + lane);
                keptY.Store(row->SumY + lane);
            }
        }
    }

    /// <summary>The arms where the bodies are now; what a displacement changed of φ is no motion.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Turn(NetRodBundle* bundles, int count, BodyState* bodies, bool displaced)
    {
        for (int i = 0; i < count; i++)
        {
            NetRodBundle* row = bundles + i;
            for (int lane = 0; lane < NetEnds.Lanes; lane += Wide.Count)
            {
                Wide last = Wide.Load(row->Error + lane);
                Turn(row, lane, bodies);
                if (displaced)
                {
                    Shift(row, lane, Wide.Load(row->Error + lane) - last);
                }
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Wide SizeOf(NetRodBundle* row, int lane) => NetEnds.SizeOf(&row->Ends, lane) + Wide.Load(row->Length + lane);

    /// <summary>Of φ, so much came from outside: L grows by it, and L² by that times the sum of both lengths.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Shift(NetRodBundle* row, int lane, Wide change)
    {
        Wide length = Wide.Load(row->Length + lane);
        Wide longer = Wide.Max(length + change, Wide.Zero);
        change = Wide.Select(longer > Wide.Zero, change, longer - length);
        longer.Store(row->Length + lane);
        (Wide.Load(row->Excess + lane) - (change * (longer + length))).Store(row->Excess + lane);
        (Wide.Load(row->Outside + lane) + change).Store(row->Outside + lane);
        (Wide.Load(row->Error + lane) - change).Store(row->Error + lane);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Turn(NetRodBundle* row, int lane, BodyState* bodies)
    {
        NetEnds.TurnArms(&row->Ends, lane, bodies, out Wide movedX, out Wide movedY);
        Wide baseX = Wide.Load(row->BaseX + lane);
        Wide baseY = Wide.Load(row->BaseY + lane);
        Wide x = baseX + movedX;
        Wide y = baseY + movedY;
        Wide distance = Wide.Sqrt((x * x) + (y * y));
        WideMask apart = distance > Wide.Zero;

        // Anchors in one place have no direction; as in the scalar rows it is the x axis then. An empty lane has no length either.
        Wide inverse = Wide.One / Wide.Select(apart, distance, Wide.One);
        Wide.Select(apart, x * inverse, Wide.One).Store(row->AxisX + lane);
        Wide.Select(apart, y * inverse, Wide.Zero).Store(row->AxisY + lane);
        Wide sum = distance + Wide.Load(row->Length + lane);
        Wide excess = Wide.Load(row->Excess + lane) + (((baseX + x) * movedX) + ((baseY + y) * movedY));
        (excess / Wide.Select(sum > Wide.Zero, sum, Wide.One)).Store(row->Error + lane);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Step(NetRodBundle* row, int lane, ref WideVelocity a, ref WideVelocity b, Wide bias, Wide massScale, Wide leak)
    {
        NetEnds.Speed(&row->Ends, lane, a, b, out Wide x, out Wide y);
        Wide nx = Wide.Load(row->AxisX + lane);
        Wide ny = Wide.Load(row->AxisY + lane);
        Wide speed = ((nx * x) + (ny * y)) + bias;
        Wide ca = (Wide.Load(row->Ends.ArmAX + lane) * ny) - (Wide.Load(row->Ends.ArmAY + lane) * nx);
        Wide cb = (Wide.Load(row->Ends.ArmBX + lane) * ny) - (Wide.Load(row->Ends.ArmBY + lane) * nx);
        Wide response = (Wide.One + (Wide.Load(row->Ends.TurnA + lane) * ca * ca)) + (Wide.Load(row->Ends.TurnB + lane) * cb * cb);
        Wide old = Wide.Load(row->Impulse + lane);
        Wide p = Wide.Zero - ((massScale * speed) / response) - (leak * old);
        (old + p).Store(row->Impulse + lane);
        Push(row, lane, ref a, ref b, p);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Push(NetRodBundle* row, int lane, ref WideVelocity a, ref WideVelocity b, Wide p)
    {
        Wide x = p * Wide.Load(row->AxisX + lane);
        Wide y = p * Wide.Load(row->AxisY + lane);
        (Wide.Load(row->SumX + lane) + x).Store(row->SumX + lane);
        (Wide.Load(row->SumY + lane) + y).Store(row->SumY + lane);
        NetEnds.Push(&row->Ends, lane, ref a, ref b, x, y);
    }
}

/// <summary>The rods of one colour.</summary>
internal sealed unsafe class NetRods : NetRows
{
    public NetRods(bool sequential)
        : base(sizeof(NetRodBundle), sequential)
    {
    }

    private NetRodBundle* Bundles => (NetRodBundle*)Memory;

    protected override void PlaceRows(int from, int to, NetPose* poses, float impulseScale)
    {
        for (int row = from; row < to; row++)
        {
            NetRodBundle* bundle = (NetRodBundle*)EndsOf(row);
            int lane = LaneOf(row);
            double length = AnchorsOf(row).Target + bundle->Outside[lane];
            bundle->Impulse[lane] *= PlaceEnds(&bundle->Ends, lane, poses, AnchorsOf(row), impulseScale, out double x, out double y);
            bundle->BaseX[lane] = (float)x;
            bundle->BaseY[lane] = (float)y;
            bundle->Excess[lane] = (float)((x * x) + (y * y) - (length * length));
            bundle->Length[lane] = (float)length;
            bundle->SumX[lane] = 0;
            bundle->SumY[lane] = 0;
        }
    }

    public override bool Begin(int first, int count, in NetMotion motion, float keep) =>
        NetRodKernel.Begin(Bundles + first, count, motion.States, keep);

    public override void Pull(int first, int count, in NetMotion motion, in NetSoftness softness) =>
        NetRodKernel.Pull(Bundles + first, count, motion.States, softness);

    public override void Turn(int first, int count, in NetMotion motion, bool displaced) =>
        NetRodKernel.Turn(Bundles + first, count, motion.States, displaced);

    public override void WarmStart(int first, int count, in NetMotion motion) =>
        NetRodKernel.WarmStart(Bundles + first, count, motion.States);

    public override void Solve(int first, int count, in NetMotion motion, in NetSoftness softness) =>
        NetRodKernel.Solve(Bundles + first, count, motion.States, softness);

    public override void TurnAndRelax(int first, int count, in NetMotion motion) =>
        NetRodKernel.TurnAndRelax(Bundles + first, count, motion.States);

    public override void Take(int row, in JointState state)
    {
        NetRodBundle* bundle = (NetRodBundle*)EndsOf(row);
        int lane = LaneOf(row);
        bundle->Impulse[lane] = (float)state.Impulse[0];
        bundle->SumX[lane] = 0;
        bundle->SumY[lane] = 0;
        bundle->Start[lane] = (float)state.Error;
    }

    public override void Report(int row, ref JointState state, double dt)
    {
        NetRodBundle* bundle = (NetRodBundle*)EndsOf(row);
        int lane = LaneOf(row);
        double inverse = InverseResponse(&bundle->Ends, lane);
        state.Impulse[0] = bundle->Impulse[lane] * inverse;
        state.Error = bundle->Start[lane];
        state.ForceX = bundle->SumX[lane] * inverse / dt;
        state.ForceY = bundle->SumY[lane] * inverse / dt;
        state.Torque = 0;
    }
}
