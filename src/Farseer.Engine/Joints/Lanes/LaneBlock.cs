using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>
/// The elimination of edges and anchors of one or three rows (welds, rods, gears), as in <see cref="TreeFactor"/> operation by operation.
/// The last row may be that of a limit that holds in some lanes only: in the others it is 0, its own response is taken for 1, and what is
/// left of the formulas are those of a row less.
/// </summary>
internal static unsafe class LaneBlock
{
    /// <summary>Doubles of working space.</summary>
    public const int Space = (4 * LaneMatrix.Row * 3) + (3 * LaneMatrix.Step);

    public static void EliminateAnchor(LaneAnchor* anchor, LaneNode* node, LanePlace* place, double* space)
    {
        int n = place->BlockRows;
        long* held = place->Held != 0 ? anchor->Joint.Held : null;
        double* sy = space;
        double* k = sy + (3 * LaneMatrix.Row);
        double* own = space + (12 * LaneMatrix.Row);
        double* s = anchor->Joint.S;
        LaneMatrix.Multiply(s, n, node->SubtreeMass, sy);
        LaneMatrix.MultiplyTransposed(sy, s, n, k);
        SetOwn(s, n, node, own);
        Fill(held, own + ((n - 1) * LaneMatrix.Step));
        Fill(held, Last(k, n));
        AddRegular(k, n, own, IsSingular(k, n, own));
        Invert(k, n, anchor->Joint.E, held);
        LaneMatrix.MultiplySquare(anchor->Joint.E, n, sy, anchor->Gain);
        LaneMatrix.SubtractOuter(node->SubtreeMass, sy, anchor->Gain, n);
    }

    public static void EliminateEdge(LaneNode* node, LaneNode* parent, LanePlace* place, double* space)
    {
        int n = place->BlockRows;
        long* held = place->Held != 0 ? node->Joint.Held : null;
        double* sy = space;
        double* spy = sy + (3 * LaneMatrix.Row);
        double* k = spy + (3 * LaneMatrix.Row);
        double* h = k + (3 * LaneMatrix.Row);
        double* own = space + (12 * LaneMatrix.Row);
        double* s = node->Joint.S;
        LaneMatrix.Multiply(s, n, node->SubtreeMass, sy);
        LaneMatrix.MultiplyTransposed(sy, s, n, k);
        SetOwn(s, n, node, own);
        Fill(held, own + ((n - 1) * LaneMatrix.Step));
        Fill(held, Last(k, n));
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

        Fill(held, Last(h, n));
        WideDoubleMask singular = IsSingular(h, n, own);
        AddRegular(h, n, own, singular);
        AddRegular(k, n, own, singular);
        Invert(k, n, node->Joint.E, held);
        LaneMatrix.MultiplySquare(node->Joint.E, n, sy, node->G);
        Invert(h, n, k, held);
        LaneMatrix.MultiplySquare(k, n, spy, node->W);
        LaneMatrix.SubtractOuter(parent->SubtreeMass, spy, node->W, n);
    }

    private static double* Last(double* k, int n) => k + (((n * n) - 1) * LaneMatrix.Step);

    private static void SetOwn(double* s, int n, LaneNode* node, double* own)
    {
        for (int i = 0; i < n; i++)
        {
            LaneFactor.Own(s + (i * LaneMatrix.Row), node).Store(own + (i * LaneMatrix.Step));
        }
    }

    /// <summary>1 in the lanes in which no limit holds, of blocks that have some.</summary>
    private static void Fill(long* held, double* at)
    {
        if (held != null)
        {
            WideDouble.Select(WideDouble.LoadMask(held), WideDouble.Load(at), WideDouble.Splat(1)).Store(at);
        }
    }

    private static void Invert(double* k, int n, double* r, long* held)
    {
        if (held == null)
        {
            LaneMatrix.Invert(k, n, r);
            return;
        }

        // Regular only adds to the response that is taken for 1.
        Fill(held, Last(k, n));
        LaneMatrix.Invert(k, n, r);
        if (n < 3)
        {
            return;
        }

        // Of two rows the element above the diagonal is taken, of three that below.
        WideDouble f = LaneMatrix.Inverse(LaneMatrix.Determinant(k, 3));
        double* at = r + LaneMatrix.Step;
        WideDouble off = WideDouble.Negate(f) * WideDouble.Load(k + LaneMatrix.Step);
        WideDouble both = WideDouble.Select(WideDouble.LoadMask(held), WideDouble.Load(at), off);
        both.Store(at);
        both.Store(r + (3 * LaneMatrix.Step));
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
