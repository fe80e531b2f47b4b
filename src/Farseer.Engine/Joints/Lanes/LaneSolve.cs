using System.Runtime.CompilerServices;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif

namespace Farseer.Engine.Joints.Lanes;

/// <summary>
/// <see cref="TreeSolve"/> and what <see cref="TreeReactions"/> makes of it, for trees side by side, to the last bit. The goals must be
/// written.
/// </summary>
internal static unsafe class LaneSolve
{
    private const int Half = 3 * DoubleLanes.BundleLanes;

    [MethodImpl(KernelMethod.Optimized)]
    public static void Run(LaneNode* nodes, LanePlace* places, int count, LaneAnchor* anchors, LanePlace* anchorPlaces, int anchorCount)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            LaneNode* first = DoubleLanes.Shift(nodes, lane);
            for (int i = 0; i < anchorCount; i++)
            {
                LaneAnchor* anchor = DoubleLanes.Shift(anchors + i, lane);
                LaneNode* node = first + anchorPlaces[i].Parent;
                Meet(anchor, node->Velocity);
                WideDouble.Zero.Store(node->Got);
                WideDouble.Zero.Store(node->Got + 4);
                WideDouble.Zero.Store(node->Got + 8);
            }

            for (int i = count - 1; i > 0; i--)
            {
                LaneNode* node = first + i;
                double* parent = first[places[i].Parent].Velocity;
                Residual(node, node->Velocity, parent, out WideDouble r0, out WideDouble r1);
                Spread(node->W, r0, r1, parent);
            }

            for (int i = 1; i < count; i++)
            {
                LaneNode* node = first + i;
                LaneNode* parent = first + places[i].Parent;
                Residual(node, node->Velocity, parent->Velocity, out WideDouble r0, out WideDouble r1);
                Spread(node->G, r0, r1, node->Velocity);
                double* e = node->Joint.E;
                WideDouble l0 = (WideDouble.Load(e) * r0) + (WideDouble.Load(e + 4) * r1);
                WideDouble l1 = (WideDouble.Load(e + 8) * r0) + (WideDouble.Load(e + 12) * r1);
                l0.Store(node->Joint.Lambda);
                l1.Store(node->Joint.Lambda + 4);
                if (places[i].Anchored)
                {
                    Push(node->Joint.S, l0, l1, node->Got);
                }

                if (places[places[i].Parent].Anchored)
                {
                    Push(node->ParentS, l0, l1, parent->Got);
                }
            }

            for (int i = anchorCount - 1; i >= 0; i--)
            {
                Answer(DoubleLanes.Shift(anchors + i, lane), first[anchorPlaces[i].Parent].Got);
            }
        }
    }

    /// <summary>Adds the impulses to what the hinges gave to their bodies B.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Give(LaneNode* nodes, LanePlace* places, int count, LaneAnchor* anchors, LanePlace* anchorPlaces, int anchorCount)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            for (int i = 1; i < count; i++)
            {
                LaneNode* node = DoubleLanes.Shift(nodes + i, lane);
                Give(&node->Joint, places[i].IsA ? node->ParentS : node->Joint.S);
            }

            for (int i = 0; i < anchorCount; i++)
            {
                LaneAnchor* anchor = DoubleLanes.Shift(anchors + i, lane);
                Give(&anchor->Joint, anchorPlaces[i].IsA ? anchor->OtherS : anchor->Joint.S);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Give(LaneJoint* joint, double* b)
    {
        Push(b, WideDouble.Load(joint->Lambda), WideDouble.Load(joint->Lambda + 4), joint->Given);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static WideDouble Dot(double* s, double* v) =>
        (WideDouble.Load(s) * WideDouble.Load(v)) + (WideDouble.Load(s + 4) * WideDouble.Load(v + 4)) + (WideDouble.Load(s + 8) * WideDouble.Load(v + 8));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Residual(LaneNode* node, double* v, double* parent, out WideDouble r0, out WideDouble r1)
    {
        double* c = node->Joint.S;
        double* p = node->ParentS;
        r0 = WideDouble.Load(node->Joint.Goal) - Dot(c, v) - Dot(p, parent);
        r1 = WideDouble.Load(node->Joint.Goal + 4) - Dot(c + Half, v) - Dot(p + Half, parent);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Spread(double* m, WideDouble r0, WideDouble r1, double* v)
    {
        for (int k = 0; k < 3; k++)
        {
            int at = k * DoubleLanes.BundleLanes;
            (WideDouble.Load(v + at) + (WideDouble.Load(m + at) * r0) + (WideDouble.Load(m + Half + at) * r1)).Store(v + at);
        }
    }

    /// <summary>r += sᵀ·λ.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Push(double* s, WideDouble l0, WideDouble l1, double* r) => Spread(s, l0, l1, r);

    private static void Meet(LaneAnchor* anchor, double* v)
    {
        double* s = anchor->Joint.S;
        WideDouble r0 = WideDouble.Load(anchor->Joint.Goal) - Dot(s, v);
        WideDouble r1 = WideDouble.Load(anchor->Joint.Goal + 4) - Dot(s + Half, v);
        r0.Store(anchor->Residual);
        r1.Store(anchor->Residual + 4);
        for (int k = 0; k < 3; k++)
        {
            int at = k * DoubleLanes.BundleLanes;
            WideDouble sum = WideDouble.Load(v + at);
            WideDouble terms = WideDouble.Abs(sum);
            WideDouble term = WideDouble.Load(anchor->Gain + at) * r0;
            sum += term;
            terms += WideDouble.Abs(term);
            term = WideDouble.Load(anchor->Gain + Half + at) * r1;
            sum += term;
            terms += WideDouble.Abs(term);
            WideDoubleMask still = WideDouble.Abs(sum) <= WideDouble.Splat(TreeSolve.Rounding) * terms;
            WideDouble.Select(still, WideDouble.Zero, sum).Store(v + at);
        }
    }

    /// <summary>The multipliers of an anchor, with what its body got since.</summary>
    private static void Answer(LaneAnchor* anchor, double* got)
    {
        double* h = anchor->Joint.E;
        WideDouble r0 = WideDouble.Load(anchor->Residual);
        WideDouble r1 = WideDouble.Load(anchor->Residual + 4);
        WideDouble l0 = WideDouble.Zero + (WideDouble.Load(h) * r0) + (WideDouble.Load(h + 4) * r1);
        WideDouble l1 = WideDouble.Zero + (WideDouble.Load(h + 8) * r0) + (WideDouble.Load(h + 12) * r1);
        l0 -= Dot(anchor->Gain, got);
        l1 -= Dot(anchor->Gain + Half, got);
        l0.Store(anchor->Joint.Lambda);
        l1.Store(anchor->Joint.Lambda + 4);
        Push(anchor->Joint.S, l0, l1, got);
    }
}
