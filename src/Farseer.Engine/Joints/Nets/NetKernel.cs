#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Nets;

/// <summary>How the rows of a pass respond: softly with a bias, or hard without.</summary>
internal readonly struct NetSoftness
{
    /// <summary>Speed of recovery per unit of error, 1/s.</summary>
    public readonly float BiasRate;
    public readonly float MassScale;
    public readonly float ImpulseScale;

    private NetSoftness(float biasRate, float massScale, float impulseScale)
    {
        BiasRate = biasRate;
        MassScale = massScale;
        ImpulseScale = impulseScale;
    }

    /// <summary>No error, no leak.</summary>
    public static NetSoftness Hard => new NetSoftness(0, 1, 0);

    /// <summary>As soft as <see cref="JointPass"/> says, tied to the substep as contacts are.</summary>
    public static NetSoftness Soft(double substep) => new NetSoftness(
        (float)(JointPass.NetBias / substep), (float)(JointPass.NetProduct / (1 + JointPass.NetProduct)), (float)(1 / (1 + JointPass.NetProduct)));
}

/// <summary>The passes of a substep over the pivots of a colour, on lanes; each takes any run of a colour's bundles.</summary>
internal static unsafe class NetKernel
{
    /// <summary>The impulses of the substep before; from here on they count as given.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void WarmStart(NetBundle* bundles, int count, BodyState* bodies)
    {
        for (int i = 0; i < count; i++)
        {
            NetBundle* row = bundles + i;
            for (int lane = 0; lane < NetBundle.Lanes; lane += Wide.Count)
            {
                BodyLanes.GatherVelocity(bodies, row->BodyA + lane, out WideVelocity a);
                BodyLanes.GatherVelocity(bodies, row->BodyB + lane, out WideVelocity b);
                Wide x = Wide.Load(row->ImpulseX + lane);
                Wide y = Wide.Load(row->ImpulseY + lane);
                (Wide.Load(row->SumX + lane) + x).Store(row->SumX + lane);
                (Wide.Load(row->SumY + lane) + y).Store(row->SumY + lane);
                Apply(row, lane, ref a, ref b, x, y);
                BodyLanes.ScatterVelocity(bodies, row->BodyA + lane, a);
                BodyLanes.ScatterVelocity(bodies, row->BodyB + lane, b);
            }
        }
    }

    /// <summary>One sweep at the arms that the substep has.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Solve(NetBundle* bundles, int count, BodyState* bodies, in NetSoftness softness)
    {
        Wide biasRate = Wide.Splat(softness.BiasRate);
        Wide massScale = Wide.Splat(softness.MassScale);
        Wide leak = Wide.Splat(softness.ImpulseScale);
        for (int i = 0; i < count; i++)
        {
            NetBundle* row = bundles + i;
            for (int lane = 0; lane < NetBundle.Lanes; lane += Wide.Count)
            {
                BodyLanes.GatherVelocity(bodies, row->BodyA + lane, out WideVelocity a);
                BodyLanes.GatherVelocity(bodies, row->BodyB + lane, out WideVelocity b);
                Wide biasX = biasRate * Wide.Load(row->ErrorX + lane);
                Wide biasY = biasRate * Wide.Load(row->ErrorY + lane);
                Step(row, lane, ref a, ref b, biasX, biasY, massScale, leak);
                BodyLanes.ScatterVelocity(bodies, row->BodyA + lane, a);
                BodyLanes.ScatterVelocity(bodies, row->BodyB + lane, b);
            }
        }
    }

    /// <summary>The relax pass: the arms turn along with the bodies, and one sweep without errors follows.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void TurnAndRelax(NetBundle* bundles, int count, BodyState* bodies)
    {
        for (int i = 0; i < count; i++)
        {
            NetBundle* row = bundles + i;
            for (int lane = 0; lane < NetBundle.Lanes; lane += Wide.Count)
            {
                TurnArms(row, lane, bodies, out _, out _);
                BodyLanes.GatherVelocity(bodies, row->BodyA + lane, out WideVelocity a);
                BodyLanes.GatherVelocity(bodies, row->BodyB + lane, out WideVelocity b);
                Step(row, lane, ref a, ref b, Wide.Zero, Wide.Zero, Wide.One, Wide.Zero);
                BodyLanes.ScatterVelocity(bodies, row->BodyA + lane, a);
                BodyLanes.ScatterVelocity(bodies, row->BodyB + lane, b);
            }
        }
    }

    /// <summary>Arms and errors where the step begins.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Begin(NetBundle* bundles, int count, BodyState* bodies)
    {
        for (int i = 0; i < count; i++)
        {
            NetBundle* row = bundles + i;
            for (int lane = 0; lane < NetBundle.Lanes; lane += Wide.Count)
            {
                TurnArms(row, lane, bodies, out Wide x, out Wide y);
                x.Store(row->StartX + lane);
                y.Store(row->StartY + lane);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void TurnArms(NetBundle* row, int lane, BodyState* bodies, out Wide errorX, out Wide errorY)
    {
        BodyLanes.GatherDelta(bodies, row->BodyA + lane, out WideDelta a);
        Turn(a, Wide.Load(row->MiddleAX + lane), Wide.Load(row->MiddleAY + lane), out Wide ax, out Wide ay);
        (Wide.Load(row->MiddleAX + lane) + ax).Store(row->ArmAX + lane);
        (Wide.Load(row->MiddleAY + lane) + ay).Store(row->ArmAY + lane);
        BodyLanes.GatherDelta(bodies, row->BodyB + lane, out WideDelta b);
        Turn(b, Wide.Load(row->MiddleBX + lane), Wide.Load(row->MiddleBY + lane), out Wide bx, out Wide by);
        (Wide.Load(row->MiddleBX + lane) + bx).Store(row->ArmBX + lane);
        (Wide.Load(row->MiddleBY + lane) + by).Store(row->ArmBY + lane);
        errorX = Wide.Load(row->BaseX + lane) + ((b.X - a.X) + (bx - ax));
        errorY = Wide.Load(row->BaseY + lane) + ((b.Y - a.Y) + (by - ay));
        errorX.Store(row->ErrorX + lane);
        errorY.Store(row->ErrorY + lane);
    }

    /// <summary>What a turn adds to an arm; cos - 1 = -sin²/(1 + cos) keeps the digits of a small turn.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Turn(in WideDelta d, Wide x, Wide y, out Wide dx, out Wide dy)
    {
        Wide shrink = Wide.Select(
            d.Cos > Wide.Zero, (d.Sin * d.Sin) / (Wide.One + Wide.Max(d.Cos, Wide.Zero)), Wide.One - d.Cos);
        dx = Wide.Zero - ((shrink * x) + (d.Sin * y));
        dy = (d.Sin * x) - (shrink * y);
    }

    /// <summary>The impulse that brings dφ/dt to minus the bias, by the share that the softness lets through.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Step(
        NetBundle* row, int lane, ref WideVelocity a, ref WideVelocity b, Wide biasX, Wide biasY, Wide massScale, Wide leak)
    {
        Wide ax = Wide.Load(row->ArmAX + lane);
        Wide ay = Wide.Load(row->ArmAY + lane);
        Wide bx = Wide.Load(row->ArmBX + lane);
        Wide by = Wide.Load(row->ArmBY + lane);
        Wide x = ((b.X - a.X) - ((b.W * by) - (a.W * ay))) + biasX;
        Wide y = ((b.Y - a.Y) + ((b.W * bx) - (a.W * ax))) + biasY;
        Wide ja = Wide.Load(row->TurnA + lane);
        Wide jb = Wide.Load(row->TurnB + lane);
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
        Apply(row, lane, ref a, ref b, px, py);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Apply(NetBundle* row, int lane, ref WideVelocity a, ref WideVelocity b, Wide x, Wide y)
    {
        Wide shareA = Wide.Load(row->ShareA + lane);
        Wide shareB = Wide.Load(row->ShareB + lane);
        a.X = a.X - (shareA * x);
        a.Y = a.Y - (shareA * y);
        b.X = b.X + (shareB * x);
        b.Y = b.Y + (shareB * y);
        a.W = a.W - (Wide.Load(row->TurnA + lane) * ((Wide.Load(row->ArmAX + lane) * y) - (Wide.Load(row->ArmAY + lane) * x)));
        b.W = b.W + (Wide.Load(row->TurnB + lane) * ((Wide.Load(row->ArmBX + lane) * y) - (Wide.Load(row->ArmBY + lane) * x)));
    }
}
