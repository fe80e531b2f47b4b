using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Nets;

/// <summary>
/// The bodies of eight joints of a net and the arms to their anchors, a lane each: the front of every kind of bundle. With the sum m of
/// both inverse masses and jA, jB the inverse inertias over m, responses are m times something of the order of 1, and impulses are
/// kept as m times themselves, speeds. So all that the passes compute with is of the order of speeds and lengths, however light or
/// heavy the bodies. Arms are those at the start of the substep, turned from the foreseen middle of the step; errors count what
/// changed since the step began, so they keep all their digits.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct NetEnds
{
    public const int Lanes = WideLanes.BundleLanes;

    public fixed int BodyA[Lanes];
    public fixed int BodyB[Lanes];

    /// <summary>Shares of an impulse's speed that the bodies take, inverse mass over m, and jA, jB.</summary>
    public fixed float ShareA[Lanes];
    public fixed float ShareB[Lanes];
    public fixed float TurnA[Lanes];
    public fixed float TurnB[Lanes];

    /// <summary>Arms in the present substep.</summary>
    public fixed float ArmAX[Lanes];
    public fixed float ArmAY[Lanes];
    public fixed float ArmBX[Lanes];
    public fixed float ArmBY[Lanes];

    /// <summary>Arms where the bodies are foreseen to be in the middle of the step.</summary>
    public fixed float MiddleAX[Lanes];
    public fixed float MiddleAY[Lanes];
    public fixed float MiddleBX[Lanes];
    public fixed float MiddleBY[Lanes];

    /// <summary>m; 0 where neither body can be moved.</summary>
    public fixed float Response[Lanes];

    /// <summary>Index of the joint; -1 in an empty lane.</summary>
    public fixed int Joint[Lanes];

    /// <summary>Turns the arms, and says how far the anchors have come from where the step foresaw them: anchor B less anchor A.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void TurnArms(NetEnds* e, int lane, BodyState* bodies, out Wide x, out Wide y)
    {
        WideDelta a;
        WideDelta b = default;
        if (Wide.Count <= MatrixTurn.MostLanes)
        {
            BodyLanes.GatherDeltas(bodies, e->BodyA + lane, e->BodyB + lane, out a, out b);
        }
        else
        {
            BodyLanes.GatherDelta(bodies, e->BodyA + lane, out a);
        }

        Turn(a, Wide.Load(e->MiddleAX + lane), Wide.Load(e->MiddleAY + lane), out Wide ax, out Wide ay);
        (Wide.Load(e->MiddleAX + lane) + ax).Store(e->ArmAX + lane);
        (Wide.Load(e->MiddleAY + lane) + ay).Store(e->ArmAY + lane);
        if (Wide.Count > MatrixTurn.MostLanes)
        {
            BodyLanes.GatherDelta(bodies, e->BodyB + lane, out b);
        }

        Turn(b, Wide.Load(e->MiddleBX + lane), Wide.Load(e->MiddleBY + lane), out Wide bx, out Wide by);
        (Wide.Load(e->MiddleBX + lane) + bx).Store(e->ArmBX + lane);
        (Wide.Load(e->MiddleBY + lane) + by).Store(e->ArmBY + lane);
        x = (b.X - a.X) + (bx - ax);
        y = (b.Y - a.Y) + (by - ay);
    }

    /// <summary>How fast anchor B moves against anchor A.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Speed(NetEnds* e, int lane, in WideVelocity a, in WideVelocity b, out Wide x, out Wide y)
    {
        x = (b.X - a.X) - ((b.W * Wide.Load(e->ArmBY + lane)) - (a.W * Wide.Load(e->ArmAY + lane)));
        y = (b.Y - a.Y) + ((b.W * Wide.Load(e->ArmBX + lane)) - (a.W * Wide.Load(e->ArmAX + lane)));
    }

    /// <summary>How large the joints are: both arms, each as the way along the axes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide SizeOf(NetEnds* e, int lane) =>
        (Wide.Abs(Wide.Load(e->ArmAX + lane)) + Wide.Abs(Wide.Load(e->ArmAY + lane)))
        + (Wide.Abs(Wide.Load(e->ArmBX + lane)) + Wide.Abs(Wide.Load(e->ArmBY + lane)));

    /// <summary>Gives B the impulse at its anchor, and A its opposite.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Push(NetEnds* e, int lane, ref WideVelocity a, ref WideVelocity b, Wide x, Wide y)
    {
        Wide shareA = Wide.Load(e->ShareA + lane);
        Wide shareB = Wide.Load(e->ShareB + lane);
        a.X = a.X - (shareA * x);
        a.Y = a.Y - (shareA * y);
        b.X = b.X + (shareB * x);
        b.Y = b.Y + (shareB * y);
        a.W = a.W - (Wide.Load(e->TurnA + lane) * ((Wide.Load(e->ArmAX + lane) * y) - (Wide.Load(e->ArmAY + lane) * x)));
        b.W = b.W + (Wide.Load(e->TurnB + lane) * ((Wide.Load(e->ArmBX + lane) * y) - (Wide.Load(e->ArmBY + lane) * x)));
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
}

/// <summary>The anchors of a joint in the frames of its bodies, and its wanted length or angle.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct NetAnchors
{
    public double AX;
    public double AY;
    public double BX;
    public double BY;
    public double Target;
}

/// <summary>How the rows of a pass respond: softly with a bias, or hard without.</summary>
internal readonly struct NetSoftness
{
    /// <summary>Share of an error from outside that goes in a step: the usual bias factor.</summary>
    private const double Hurry = 0.2;

    /// <summary>Speed of recovery per unit of error, 1/s.</summary>
    public readonly float BiasRate;
    public readonly float MassScale;
    public readonly float ImpulseScale;

    /// <summary>The fastest recovery in terms of a joint's size, 1/s; <see cref="JointPass.NetHurry"/>.</summary>
    public readonly float Fastest;

    private NetSoftness(float biasRate, float massScale, float impulseScale, float fastest)
    {
        Fastest = fastest;
        BiasRate = biasRate;
        MassScale = massScale;
        ImpulseScale = impulseScale;
    }

    /// <summary>Displacements, as speeds, that take out what came from outside.</summary>
    public static NetSoftness Displacing(in JointStep step) =>
        new NetSoftness((float)(Hurry / step.PullTime), 1, 0, (float)(JointPass.NetHurry / step.PullTime));

    /// <summary>No error, no leak.</summary>
    public static NetSoftness Hard => new NetSoftness(0, 1, 0, 0);

    /// <summary>The speed at which an error of a joint of a size goes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Bias(Wide rate, Wide error, Wide fastest)
    {
        Wide speed = rate * error;
        return Wide.Max(Wide.Zero - fastest, Wide.Min(fastest, speed));
    }

    /// <summary>As soft as <see cref="JointPass"/> says, tied to the substep as contacts are.</summary>
    public static NetSoftness Soft(in JointStep step) => new NetSoftness(
        (float)(step.ErrorScale * JointPass.NetBias / step.Substep),
        (float)(JointPass.NetProduct / (1 + JointPass.NetProduct)),
        (float)(1 / (1 + JointPass.NetProduct)),
        (float)(JointPass.NetHurry / step.PullTime));
}
