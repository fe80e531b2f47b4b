using System.Runtime.CompilerServices;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>
/// The elimination of <see cref="TreeFactor"/> for trees side by side, to the last bit; what has two rows is written out, the rest is in
/// <see cref="LaneBlock"/>. T and full masses, which rows need, are found by <see cref="LaneWalks"/>.
/// </summary>
internal static unsafe class LaneFactor
{
    private const int Half = LaneMatrix.Row;

    /// <summary>Writes the Jacobians of all joints at the present poses, and factors.</summary>
    /// <param name="bundle">The trees.</param>
    /// <param name="begin">The Jacobians of the anchors are those of the step's start, and are there.</param>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Run(in LaneBundle bundle, bool begin)
    {
        double* space = stackalloc double[LaneBlock.Space];
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            LaneNode* first = DoubleLanes.Shift(bundle.Nodes, lane);
            for (int i = 0; i < bundle.Count; i++)
            {
                Reset(first + i);
            }

            for (int i = 0; i < bundle.AnchorCount; i++)
            {
                LaneAnchor* anchor = DoubleLanes.Shift(bundle.Anchors + i, lane);
                LanePlace* place = bundle.AnchorPlaces + i;
                if (!begin)
                {
                    LaneRows.Write(&anchor->Joint, anchor->OtherS, place);
                }

                if (place->Held != 0)
                {
                    LaneRows.WriteHeld(&anchor->Joint, anchor->OtherS, place);
                }

                if (place->BlockRows == 2 && place->HardRows == 2)
                {
                    EliminateAnchor(anchor, first + place->Parent);
                }
                else if (place->BlockRows > 0)
                {
                    LaneBlock.EliminateAnchor(anchor, first + place->Parent, place, space);
                }
            }

            for (int i = bundle.Count - 1; i > 0; i--)
            {
                LaneNode* node = first + i;
                LanePlace* place = bundle.Places + i;
                LaneRows.Write(&node->Joint, node->ParentS, place);
                if (place->Held != 0)
                {
                    LaneRows.WriteHeld(&node->Joint, node->ParentS, place);
                }

                if (place->BlockRows == 2 && place->HardRows == 2)
                {
                    EliminateEdge(node, first + place->Parent);
                }
                else
                {
                    LaneBlock.EliminateEdge(node, first + place->Parent, place, space);
                }
            }
        }
    }

    private static void Reset(LaneNode* node)
    {
        double* y = node->SubtreeMass;
        WideDouble mass = WideDouble.Load(node->InverseMass);
        for (int i = 0; i < 9; i++)
        {
            (i == 8 ? WideDouble.Load(node->InverseInertia) : i % 4 == 0 ? mass : WideDouble.Zero).Store(y + (i * DoubleLanes.BundleLanes));
        }
    }

    /// <summary>The response of a body to a row by its own mass.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static WideDouble Own(double* s, LaneNode* node)
    {
        WideDouble x = WideDouble.Load(s);
        WideDouble y = WideDouble.Load(s + 4);
        WideDouble w = WideDouble.Load(s + 8);
        return (((x * x) + (y * y)) * WideDouble.Load(node->InverseMass)) + (w * w * WideDouble.Load(node->InverseInertia));
    }

    private static void EliminateAnchor(LaneAnchor* anchor, LaneNode* node)
    {
        double* s = anchor->Joint.S;
        double* y = node->SubtreeMass;
        LaneMatrix.Multiply(s, y, out WideDouble a00, out WideDouble a01, out WideDouble a02);
        LaneMatrix.Multiply(s + Half, y, out WideDouble a10, out WideDouble a11, out WideDouble a12);
        WideDouble k00 = LaneMatrix.Dot(a00, a01, a02, s);
        WideDouble k01 = LaneMatrix.Dot(a00, a01, a02, s + Half);
        WideDouble k10 = LaneMatrix.Dot(a10, a11, a12, s);
        WideDouble k11 = LaneMatrix.Dot(a10, a11, a12, s + Half);
        WideDouble own0 = Own(s, node);
        WideDouble own1 = Own(s + Half, node);
        WideDouble regular = WideDouble.Splat(TreeFactor.Regular);
        WideDoubleMask isRegular = (k00 * k11) - (k01 * k10) > WideDouble.Splat(TreeFactor.Singular) * (own0 * own1);
        k00 = WideDouble.Select(isRegular, k00, k00 + (regular * own0));
        k11 = WideDouble.Select(isRegular, k11, k11 + (regular * own1));
        LaneMatrix.InvertTwo(k00, k01, k10, k11, out WideDouble h00, out WideDouble h01, out WideDouble h11);
        double* h = anchor->Joint.E;
        h00.Store(h);
        h01.Store(h + 4);
        h01.Store(h + 8);
        h11.Store(h + 12);
        double* gain = anchor->Gain;
        Respond(gain, h00, h01, h11, a00, a10);
        Respond(gain + 4, h00, h01, h11, a01, a11);
        Respond(gain + 8, h00, h01, h11, a02, a12);
        TakeRow(y, gain, a00, a10);
        TakeRow(y + Half, gain, a01, a11);
        TakeRow(y + (2 * Half), gain, a02, a12);
    }

    private static void EliminateEdge(LaneNode* node, LaneNode* parent)
    {
        double* s = node->Joint.S;
        double* y = node->SubtreeMass;
        LaneMatrix.Multiply(s, y, out WideDouble a00, out WideDouble a01, out WideDouble a02);
        LaneMatrix.Multiply(s + Half, y, out WideDouble a10, out WideDouble a11, out WideDouble a12);
        WideDouble k00 = LaneMatrix.Dot(a00, a01, a02, s);
        WideDouble k01 = LaneMatrix.Dot(a00, a01, a02, s + Half);
        WideDouble k10 = LaneMatrix.Dot(a10, a11, a12, s);
        WideDouble k11 = LaneMatrix.Dot(a10, a11, a12, s + Half);
        WideDouble own0 = Own(s, node);
        WideDouble own1 = Own(s + Half, node);
        WideDouble regular = WideDouble.Splat(TreeFactor.Regular);
        WideDouble singular = WideDouble.Splat(TreeFactor.Singular);
        WideDoubleMask isRegular = (k00 * k11) - (k01 * k10) > singular * (own0 * own1);
        k00 = WideDouble.Select(isRegular, k00, k00 + (regular * own0));
        k11 = WideDouble.Select(isRegular, k11, k11 + (regular * own1));

        double* p = node->ParentS;
        double* z = parent->SubtreeMass;
        LaneMatrix.Multiply(p, z, out WideDouble b00, out WideDouble b01, out WideDouble b02);
        LaneMatrix.Multiply(p + Half, z, out WideDouble b10, out WideDouble b11, out WideDouble b12);
        WideDouble h00 = LaneMatrix.Dot(b00, b01, b02, p) + k00;
        WideDouble h01 = LaneMatrix.Dot(b00, b01, b02, p + Half) + k01;
        WideDouble h10 = LaneMatrix.Dot(b10, b11, b12, p) + k10;
        WideDouble h11 = LaneMatrix.Dot(b10, b11, b12, p + Half) + k11;
        own0 += Own(p, parent);
        own1 += Own(p + Half, parent);
        isRegular = (h00 * h11) - (h01 * h10) > singular * (own0 * own1);
        h00 = WideDouble.Select(isRegular, h00, h00 + (regular * own0));
        h11 = WideDouble.Select(isRegular, h11, h11 + (regular * own1));
        k00 = WideDouble.Select(isRegular, k00, k00 + (regular * own0));
        k11 = WideDouble.Select(isRegular, k11, k11 + (regular * own1));

        LaneMatrix.InvertTwo(k00, k01, k10, k11, out WideDouble e00, out WideDouble e01, out WideDouble e11);
        double* e = node->Joint.E;
        e00.Store(e);
        e01.Store(e + 4);
        e01.Store(e + 8);
        e11.Store(e + 12);
        double* g = node->G;
        Combine(e00, e01, a00, a10).Store(g);
        Combine(e00, e01, a01, a11).Store(g + 4);
        Combine(e00, e01, a02, a12).Store(g + 8);
        Combine(e01, e11, a00, a10).Store(g + 12);
        Combine(e01, e11, a01, a11).Store(g + 16);
        Combine(e01, e11, a02, a12).Store(g + 20);
        LaneMatrix.InvertTwo(h00, h01, h10, h11, out WideDouble i00, out WideDouble i01, out WideDouble i11);
        double* w = node->W;
        Respond(w, i00, i01, i11, b00, b10);
        Respond(w + 4, i00, i01, i11, b01, b11);
        Respond(w + 8, i00, i01, i11, b02, b12);
        TakeRow(z, w, b00, b10);
        TakeRow(z + Half, w, b01, b11);
        TakeRow(z + (2 * Half), w, b02, b12);
    }

    /// <summary>Zero first, as a sum starts: of a product that is -0 it makes 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static WideDouble Combine(WideDouble f, WideDouble g, WideDouble a, WideDouble b) => WideDouble.Zero + (f * a) + (g * b);

    /// <summary>A column of w = h·b, of two rows, for a symmetric h.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Respond(double* w, WideDouble h00, WideDouble h01, WideDouble h11, WideDouble b0, WideDouble b1)
    {
        Combine(h00, h01, b0, b1).Store(w);
        Combine(h01, h11, b0, b1).Store(w + Half);
    }

    /// <summary>A row of y -= bᵀ·w, by the column of b.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void TakeRow(double* y, double* w, WideDouble b0, WideDouble b1)
    {
        for (int c = 0; c < Half; c += LaneMatrix.Step)
        {
            (WideDouble.Load(y + c) - (b0 * WideDouble.Load(w + c)) - (b1 * WideDouble.Load(w + Half + c))).Store(y + c);
        }
    }
}
