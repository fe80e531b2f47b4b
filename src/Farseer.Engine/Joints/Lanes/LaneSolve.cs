using System.Runtime.CompilerServices;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>
/// <see cref="TreeSolve"/> and what <see cref="TreeReactions"/> makes of it, for trees side by side, to the last bit. The goals must be
/// written.
/// </summary>
internal static unsafe class LaneSolve
{
    private const int Half = LaneMatrix.Row;
    private const int Step = LaneMatrix.Step;

    [MethodImpl(KernelMethod.Optimized)]
    public static void Run(in LaneBundle bundle)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            LaneNode* first = DoubleLanes.Shift(bundle.Nodes, lane);
            for (int i = 0; i < bundle.AnchorCount; i++)
            {
                LaneAnchor* anchor = DoubleLanes.Shift(bundle.Anchors + i, lane);
                LaneNode* node = first + bundle.AnchorPlaces[i].Parent;
                Meet(anchor, node->Velocity, bundle.AnchorPlaces[i].BlockRows);
                WideDouble.Zero.Store(node->Got);
                WideDouble.Zero.Store(node->Got + 4);
                WideDouble.Zero.Store(node->Got + 8);
            }

            for (int i = bundle.Count - 1; i > 0; i--)
            {
                LaneNode* node = first + i;
                double* parent = first[bundle.Places[i].Parent].Velocity;
                int n = bundle.Places[i].BlockRows;
                Residual(node, node->Velocity, parent, n, out WideDouble r0, out WideDouble r1, out WideDouble r2);
                SpreadWhere(node->W, r0, r1, r2, n, parent, bundle.Places[i].Held != 0 ? node->Joint.Held : null);
            }

            for (int i = 1; i < bundle.Count; i++)
            {
                LaneNode* node = first + i;
                LaneNode* parent = first + bundle.Places[i].Parent;
                int n = bundle.Places[i].BlockRows;
                Residual(node, node->Velocity, parent->Velocity, n, out WideDouble r0, out WideDouble r1, out WideDouble r2);
                SpreadWhere(node->G, r0, r1, r2, n, node->Velocity, bundle.Places[i].Held != 0 ? node->Joint.Held : null);
                Multiply(node->Joint.E, r0, r1, r2, n, out WideDouble l0, out WideDouble l1, out WideDouble l2);
                StoreRows(l0, l1, l2, n, node->Joint.Lambda);
                if (bundle.Places[i].Anchored)
                {
                    Spread(node->Joint.S, l0, l1, l2, n, node->Got);
                }

                if (bundle.Places[bundle.Places[i].Parent].Anchored)
                {
                    Spread(node->ParentS, l0, l1, l2, n, parent->Got);
                }
            }

            for (int i = bundle.AnchorCount - 1; i >= 0; i--)
            {
                Answer(
                    DoubleLanes.Shift(bundle.Anchors + i, lane),
                    first[bundle.AnchorPlaces[i].Parent].Got,
                    bundle.AnchorPlaces[i].BlockRows);
            }
        }
    }

    /// <summary>Adds the impulses to what the joints gave to their bodies B, and those of limits that hold to what these gave.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Give(in LaneBundle bundle)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            for (int i = 1; i < bundle.Count; i++)
            {
                LaneNode* node = DoubleLanes.Shift(bundle.Nodes + i, lane);
                Give(&node->Joint, bundle.Places[i].IsA ? node->ParentS : node->Joint.S, bundle.Places + i);
                if (bundle.Places[i].Second != LaneForm.None)
                {
                    GiveSecond(node, bundle.Places + i);
                }
            }

            for (int i = 0; i < bundle.AnchorCount; i++)
            {
                LaneAnchor* anchor = DoubleLanes.Shift(bundle.Anchors + i, lane);
                Give(&anchor->Joint, bundle.AnchorPlaces[i].IsA ? anchor->OtherS : anchor->Joint.S, bundle.AnchorPlaces + i);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Give(LaneJoint* joint, double* b, LanePlace* place)
    {
        Push(b, joint->Lambda, place->Second == LaneForm.None ? place->BlockRows : place->Rows, joint->Given);
        if (place->Held != 0)
        {
            WideDouble push = WideDouble.Load(joint->Push);
            WideDouble more = push + WideDouble.Load(joint->Lambda + (place->HardRows * Step));
            WideDouble.Select(WideDouble.LoadMask(joint->Held), more, push).Store(joint->Push);
        }
    }

    /// <summary>
    /// What the rows behind those of the first joint gave: a servo's or a limit's of the second, and behind the servo's a limit's of the
    /// first.
    /// </summary>
    private static void GiveSecond(LaneNode* node, LanePlace* place)
    {
        int row = place->Rows;
        bool any = place->Second == LaneForm.Servo || place->Held != 0;
        if (any)
        {
            double* b = (place->SecondIsA ? node->ParentS : node->Joint.S) + (row * Half) + (2 * Step);
            double* turn = node->Joint.Given + Half;
            (WideDouble.Load(turn) + (WideDouble.Load(b) * WideDouble.Load(node->Joint.Lambda + (row * Step)))).Store(turn);
        }

        if (any && place->BlockRows > row + 1)
        {
            row++;
            double* b = (place->IsA ? node->ParentS : node->Joint.S) + (row * Half);
            Spread(b, WideDouble.Load(node->Joint.Lambda + (row * Step)), WideDouble.Zero, WideDouble.Zero, 1, node->Joint.Given);
        }
    }

    /// <summary>r += sᵀ·λ of n rows.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void Push(double* s, double* lambda, int n, double* r) =>
        Spread(s, WideDouble.Load(lambda), WideDouble.Load(lambda + 4), WideDouble.Load(lambda + 8), n, r);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static WideDouble Dot(double* s, double* v) =>
        (WideDouble.Load(s) * WideDouble.Load(v)) + (WideDouble.Load(s + 4) * WideDouble.Load(v + 4))
        + (WideDouble.Load(s + 8) * WideDouble.Load(v + 8));

    /// <summary>What n rows lack; rows that are not there have none.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Residual(LaneNode* node, double* v, double* parent, int n, out WideDouble r0, out WideDouble r1, out WideDouble r2)
    {
        double* c = node->Joint.S;
        double* p = node->ParentS;
        double* goal = node->Joint.Goal;
        r0 = WideDouble.Load(goal) - Dot(c, v) - Dot(p, parent);
        r1 = WideDouble.Zero;
        r2 = WideDouble.Zero;
        if (n > 1)
        {
            r1 = WideDouble.Load(goal + 4) - Dot(c + Half, v) - Dot(p + Half, parent);
        }

        if (n > 2)
        {
            r2 = WideDouble.Load(goal + 8) - Dot(c + (2 * Half), v) - Dot(p + (2 * Half), parent);
        }
    }

    /// <summary>v += mᵀ·r, of which the last row may be that of a limit, which holds in some lanes only.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void SpreadWhere(double* m, WideDouble r0, WideDouble r1, WideDouble r2, int n, double* v, long* held)
    {
        if (held == null)
        {
            Spread(m, r0, r1, r2, n, v);
            return;
        }

        // -0 and 0 are 0: a lane without the row keeps its sign.
        WideDoubleMask where = WideDouble.LoadMask(held);
        if (n == 3)
        {
            Spread(m, r0, r1, r2, n, v, where);
            return;
        }

        // An edge has a row of its own beside that of its limit.
        double* last = m + Half;
        for (int at = 0; at < Half; at += Step)
        {
            WideDouble plain = WideDouble.Load(v + at) + (WideDouble.Load(m + at) * r0);
            WideDouble.Select(where, plain + (WideDouble.Load(last + at) * r1), plain).Store(v + at);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Spread(double* m, WideDouble r0, WideDouble r1, WideDouble r2, int n, double* v) =>
        Spread(m, r0, r1, r2, n, v, WideDouble.Zero <= WideDouble.Zero);

    /// <summary>v += mᵀ·r.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Spread(double* m, WideDouble r0, WideDouble r1, WideDouble r2, int n, double* v, WideDoubleMask third)
    {
        if (n == 0)
        {
            return;
        }

        WideDouble x = WideDouble.Load(v) + (WideDouble.Load(m) * r0);
        WideDouble y = WideDouble.Load(v + 4) + (WideDouble.Load(m + 4) * r0);
        WideDouble w = WideDouble.Load(v + 8) + (WideDouble.Load(m + 8) * r0);
        if (n > 1)
        {
            x += WideDouble.Load(m + 12) * r1;
            y += WideDouble.Load(m + 16) * r1;
            w += WideDouble.Load(m + 20) * r1;
        }

        if (n > 2)
        {
            x = WideDouble.Select(third, x + (WideDouble.Load(m + 24) * r2), x);
            y = WideDouble.Select(third, y + (WideDouble.Load(m + 28) * r2), y);
            w = WideDouble.Select(third, w + (WideDouble.Load(m + 32) * r2), w);
        }

        x.Store(v);
        y.Store(v + 4);
        w.Store(v + 8);
    }

    /// <summary>l = m·r of n×n.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Multiply(
        double* m,
        WideDouble r0,
        WideDouble r1,
        WideDouble r2,
        int n,
        out WideDouble l0,
        out WideDouble l1,
        out WideDouble l2)
    {
        l1 = WideDouble.Zero;
        l2 = WideDouble.Zero;
        if (n == 2)
        {
            l0 = (WideDouble.Load(m) * r0) + (WideDouble.Load(m + 4) * r1);
            l1 = (WideDouble.Load(m + 8) * r0) + (WideDouble.Load(m + 12) * r1);
        }
        else if (n == 1)
        {
            l0 = WideDouble.Load(m) * r0;
        }
        else
        {
            l0 = LaneMatrix.Dot(r0, r1, r2, m);
            l1 = LaneMatrix.Dot(r0, r1, r2, m + 12);
            l2 = LaneMatrix.Dot(r0, r1, r2, m + 24);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void StoreRows(WideDouble r0, WideDouble r1, WideDouble r2, int n, double* rows)
    {
        r0.Store(rows);
        if (n > 1)
        {
            r1.Store(rows + 4);
        }

        if (n > 2)
        {
            r2.Store(rows + 8);
        }
    }

    private static void Meet(LaneAnchor* anchor, double* v, int n)
    {
        double* s = anchor->Joint.S;
        for (int i = 0; i < n; i++)
        {
            (WideDouble.Load(anchor->Joint.Goal + (i * Step)) - Dot(s + (i * Half), v)).Store(anchor->Residual + (i * Step));
        }

        for (int at = 0; at < Half; at += Step)
        {
            WideDouble sum = WideDouble.Load(v + at);
            WideDouble terms = WideDouble.Abs(sum);
            for (int i = 0; i < n; i++)
            {
                WideDouble term = WideDouble.Load(anchor->Gain + (i * Half) + at) * WideDouble.Load(anchor->Residual + (i * Step));
                sum += term;
                terms += WideDouble.Abs(term);
            }

            WideDoubleMask still = WideDouble.Abs(sum) <= WideDouble.Splat(TreeSolve.Rounding) * terms;
            WideDouble.Select(still, WideDouble.Zero, sum).Store(v + at);
        }
    }

    /// <summary>The multipliers of an anchor, with what its body got since.</summary>
    private static void Answer(LaneAnchor* anchor, double* got, int n)
    {
        if (n == 0)
        {
            return;
        }

        double* residual = anchor->Residual;
        WideDouble r0 = WideDouble.Load(residual);
        WideDouble r1 = WideDouble.Load(residual + 4);
        WideDouble r2 = WideDouble.Load(residual + 8);
        Multiply(anchor->Joint.E, r0, r1, r2, n, out WideDouble l0, out WideDouble l1, out WideDouble l2);
        l0 -= Dot(anchor->Gain, got);
        if (n > 1)
        {
            l1 -= Dot(anchor->Gain + Half, got);
        }

        if (n > 2)
        {
            l2 -= Dot(anchor->Gain + (2 * Half), got);
        }

        StoreRows(l0, l1, l2, n, anchor->Joint.Lambda);
        Spread(anchor->Joint.S, l0, l1, l2, n, got);
    }
}
