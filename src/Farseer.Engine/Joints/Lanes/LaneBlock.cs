using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif

namespace Farseer.Engine.Joints.Lanes;

/// <summary>The elimination of edges and anchors of one or three rows (welds, rods, gears), as in <see cref="TreeFactor"/> operation by operation.</summary>
internal static unsafe class LaneBlock
{
    /// <summary>Doubles of working space.</summary>
    public const int Space = (4 * LaneMatrix.Row * 3) + (3 * LaneMatrix.Step);

    public static void EliminateAnchor(LaneAnchor* anchor, LaneNode* node, int n, double* space)
    {
        double* sy = space;
        double* k = sy + (3 * LaneMatrix.Row);
        double* own = space + (12 * LaneMatrix.Row);
        double* s = anchor->Joint.S;
        LaneMatrix.Multiply(s, n, node->SubtreeMass, sy);
        LaneMatrix.MultiplyTransposed(sy, s, n, k);
        SetOwn(s, n, node, own);
        AddRegular(k, n, own, IsSingular(k, n, own));
        LaneMatrix.Invert(k, n, anchor->Joint.E);
        LaneMatrix.MultiplySquare(anchor->Joint.E, n, sy, anchor->Gain);
        LaneMatrix.SubtractOuter(node->SubtreeMass, sy, anchor->Gain, n);
    }

    public static void EliminateEdge(LaneNode* node, LaneNode* parent, int n, double* space)
    {
        double* sy = space;
        double* spy = sy + (3 * LaneMatrix.Row);
        double* k = spy + (3 * LaneMatrix.Row);
        double* h = k + (3 * LaneMatrix.Row);
        double* own = space + (12 * LaneMatrix.Row);
        double* s = node->Joint.S;
        LaneMatrix.Multiply(s, n, node->SubtreeMass, sy);
        LaneMatrix.MultiplyTransposed(sy, s, n, k);
        SetOwn(s, n, node, own);
        AddRegular(k, n, own, IsSingular(k, n, own));
        LaneMatrix.Multiply(node->ParentS, n, parent->SubtreeMass, spy);
        LaneMatrix.MultiplyTransposed(spy, node->ParentS, n, h);
        for (int i = 0; i < n * n * LaneMatrix.Step; i += LaneMatrix.Step)
        {
            (WideDouble.Load(h + i) + WideDouble.Load(k + i)).Store(h + i);
        }

        for (int i = 0; i < n; i++)
        {
            double* at = own + (i * LaneMatrix.Step);
            (WideDouble.Load(at) + LaneFactor.Own(node->ParentS + (i * LaneMatrix.Row), parent)).Store(at);
        }

        WideDoubleMask singular = IsSingular(h, n, own);
        AddRegular(h, n, own, singular);
        AddRegular(k, n, own, singular);
        LaneMatrix.Invert(k, n, node->Joint.E);
        LaneMatrix.MultiplySquare(node->Joint.E, n, sy, node->G);
        LaneMatrix.Invert(h, n, k);
        LaneMatrix.MultiplySquare(k, n, spy, node->W);
        LaneMatrix.SubtractOuter(parent->SubtreeMass, spy, node->W, n);
    }

    private static void SetOwn(double* s, int n, LaneNode* node, double* own)
    {
        for (int i = 0; i < n; i++)
        {
            LaneFactor.Own(s + (i * LaneMatrix.Row), node).Store(own + (i * LaneMatrix.Step));
        }
    }

    private static WideDoubleMask IsSingular(double* k, int n, double* own)
    {
        WideDouble scale = WideDouble.Load(own);
        for (int i = 1; i < n; i++)
        {
            scale *= WideDouble.Load(own + (i * LaneMatrix.Step));
        }

        return ~(LaneMatrix.Determinant(k, n) > WideDouble.Splat(TreeFactor.Singular) * scale);
    }

    private static void AddRegular(double* k, int n, double* own, WideDoubleMask where)
    {
        for (int i = 0; i < n; i++)
        {
            double* at = k + (i * (n + 1) * LaneMatrix.Step);
            WideDouble plain = WideDouble.Load(at);
            WideDouble raised = plain + (WideDouble.Splat(TreeFactor.Regular) * WideDouble.Load(own + (i * LaneMatrix.Step)));
            WideDouble.Select(where, raised, plain).Store(at);
        }
    }
}
