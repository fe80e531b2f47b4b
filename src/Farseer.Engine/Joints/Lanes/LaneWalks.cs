using System.Runtime.CompilerServices;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>
/// <see cref="TreeWalk"/> for trees side by side, with the masses that it needs and the multipliers that follow, to the last bit. The walk
/// is the same in all lanes; a lane in which nothing was applied is left as it is by masks.
/// </summary>
internal unsafe struct LaneWalks
{
    public LaneNode* Nodes;
    public LaneWalk* Walks;
    public LanePlace* Places;
    public LaneAnchor* Anchors;
    public LanePlace* AnchorPlaces;
    public int Count;
    public int AnchorCount;

    /// <summary>The node that is up to date.</summary>
    private int _current;

    /// <summary>T of the edges, and the masses within the whole tree: see <see cref="TreeFactor.CompleteMasses"/>.</summary>
    public readonly void Complete(double* space)
    {
        for (int i = 0; i < Count; i++)
        {
            LaneNode* node = Nodes + i;
            LaneWalk* walk = Walks + i;
            for (int k = 0; k < 9; k++)
            {
                WideDouble.Load(node->SubtreeMass + (k * LaneMatrix.Step)).Store(walk->FullMass + (k * LaneMatrix.Step));
            }

            if (i == 0)
            {
                continue;
            }

            int n = Places[i].BlockRows;
            SetT(node, walk, n);
            LaneMatrix.Multiply(node->Joint.S, n, node->SubtreeMass, space);
            LaneMatrix.SubtractOuter(walk->FullMass, node->G, space, n);
            LaneMatrix.Multiply(walk->T, 3, Walks[Places[i].Parent].FullMass, space);
            for (int r = 0; r < 3; r++)
            {
                WideDouble x = WideDouble.Load(space + (r * LaneMatrix.Row));
                WideDouble y = WideDouble.Load(space + (r * LaneMatrix.Row) + 4);
                WideDouble w = WideDouble.Load(space + (r * LaneMatrix.Row) + 8);
                for (int c = 0; c < 3; c++)
                {
                    double* at = walk->FullMass + (((r * 3) + c) * LaneMatrix.Step);
                    (WideDouble.Load(at) + LaneMatrix.Dot(x, y, w, walk->T + (c * LaneMatrix.Row))).Store(at);
                }
            }
        }
    }

    public void Begin()
    {
        _current = 0;
        for (int i = 0; i < Count; i++)
        {
            LaneNode* node = Nodes + i;
            LaneWalk* walk = Walks + i;
            double* parent = i == 0 ? node->Velocity : Nodes[Places[i].Parent].Velocity;
            for (int at = 0; at < LaneMatrix.Row; at += LaneMatrix.Step)
            {
                WideDouble.Zero.Store(walk->Pending + at);
                WideDouble.Zero.Store(walk->Through + at);
                WideDouble.Zero.Store(node->Got + at);
                WideDouble.Load(node->Velocity + at).Store(walk->Start + at);
                WideDouble.Load(parent + at).Store(walk->Seen + at);
            }
        }
    }

    /// <summary>Makes a body current, in the lanes of a mask. In the others nothing is done, but the walk stands there as well.</summary>
    public void Visit(int target, WideDoubleMask acts)
    {
        int up = _current;
        _current = target;
        for (; !IsBelow(target, up); up = Places[up].Parent)
        {
            Climb(up, acts);
        }

        Descend(up, target, acts);
    }

    /// <summary>Applies an impulse to the current body, in the lanes of a mask.</summary>
    public void Apply(int index, double* row, WideDouble impulse, WideDoubleMask acts)
    {
        LaneWalk* walk = Walks + index;
        WideDouble x = WideDouble.Load(row) * impulse;
        WideDouble y = WideDouble.Load(row + 4) * impulse;
        WideDouble w = WideDouble.Load(row + 8) * impulse;
        Push(walk->FullMass, x, y, w, Nodes[index].Velocity, acts);
        Note(walk->Pending, x, y, w, acts);
        Note(walk->Through, x, y, w, acts);
        Note(Nodes[index].Got, x, y, w, acts);
    }

    /// <summary>Brings every velocity up to date in the lanes of a mask, and adds what the joints answered to what they gave.</summary>
    public void End(WideDoubleMask carries)
    {
        Visit(0, carries);
        for (int i = 1; i < Count; i++)
        {
            Cross(i, carries);
        }

        Answer();
    }

    /// <summary>What the joints answered to what was brought: of velocities and Through, of those before and of Got.</summary>
    public readonly void Answer()
    {
        for (int i = 1; i < Count; i++)
        {
            React(i);
        }

        for (int i = AnchorCount - 1; i >= 0; i--)
        {
            LaneAnchor* anchor = Anchors + i;
            double* got = Nodes[AnchorPlaces[i].Parent].Got;
            for (int r = 0; r < AnchorPlaces[i].BlockRows; r++)
            {
                (WideDouble.Zero
                    - LaneSolve.Dot(anchor->Gain + (r * LaneMatrix.Row), got)).Store(anchor->Joint.Lambda + (r * LaneMatrix.Step));
            }

            LaneSolve.Push(anchor->Joint.S, anchor->Joint.Lambda, AnchorPlaces[i].BlockRows, got);
        }
    }

    private static void SetT(LaneNode* node, LaneWalk* walk, int n)
    {
        for (int r = 0; r < 3; r++)
        {
            for (int c = 0; c < 3; c++)
            {
                WideDouble sum = WideDouble.Zero;
                for (int i = 0; i < n; i++)
                {
                    int at = i * LaneMatrix.Row;
                    sum -=
                        WideDouble.Load(node->G + at + (r * LaneMatrix.Step)) * WideDouble.Load(node->ParentS + at + (c * LaneMatrix.Step));
                }

                sum.Store(walk->T + (((r * 3) + c) * LaneMatrix.Step));
            }
        }
    }

    /// <summary>In pre-order an ancestor comes before all that is below it.</summary>
    private readonly bool IsBelow(int node, int ancestor)
    {
        while (node > ancestor)
        {
            node = Places[node].Parent;
        }

        return node == ancestor;
    }

    private readonly void Descend(int from, int target, WideDoubleMask acts)
    {
        if (target != from)
        {
            Descend(from, Places[target].Parent, acts);
            Cross(target, acts);
        }
    }

    private readonly void Climb(int index, WideDoubleMask acts)
    {
        LaneWalk* walk = Walks + index;
        int above = Places[index].Parent;
        LaneWalk* parent = Walks + above;
        double* velocity = Nodes[above].Velocity;
        double* d = walk->Pending;
        TransposedTimes(walk->T, d, out WideDouble x, out WideDouble y, out WideDouble w);
        for (int at = 0; at < LaneMatrix.Row; at += LaneMatrix.Step)
        {
            WideDouble.Select(acts, WideDouble.Zero, WideDouble.Load(d + at)).Store(d + at);
        }

        Note(parent->Pending, x, y, w, acts);
        Note(parent->Through, x, y, w, acts);
        Push(parent->FullMass, x, y, w, velocity, acts);
        for (int at = 0; at < LaneMatrix.Row; at += LaneMatrix.Step)
        {
            WideDouble.Select(acts, WideDouble.Load(velocity + at), WideDouble.Load(walk->Seen + at)).Store(walk->Seen + at);
        }
    }

    /// <summary>Takes the parent's change since the last crossing down to the child.</summary>
    private readonly void Cross(int index, WideDoubleMask acts)
    {
        LaneWalk* walk = Walks + index;
        double* v = Nodes[Places[index].Parent].Velocity;
        WideDouble x = WideDouble.Load(v) - WideDouble.Load(walk->Seen);
        WideDouble y = WideDouble.Load(v + 4) - WideDouble.Load(walk->Seen + 4);
        WideDouble w = WideDouble.Load(v + 8) - WideDouble.Load(walk->Seen + 8);
        Push(walk->T, x, y, w, Nodes[index].Velocity, acts);
        for (int at = 0; at < LaneMatrix.Row; at += LaneMatrix.Step)
        {
            WideDouble.Select(acts, WideDouble.Load(v + at), WideDouble.Load(walk->Seen + at)).Store(walk->Seen + at);
        }
    }

    /// <summary>The multipliers of an edge: see <see cref="TreeReactions.EndWalk"/>.</summary>
    private readonly void React(int index)
    {
        LaneNode* node = Nodes + index;
        LaneWalk* walk = Walks + index;
        int above = Places[index].Parent;
        double* v = Nodes[above].Velocity;
        double* start = Walks[above].Start;
        WideDouble x = WideDouble.Load(v) - WideDouble.Load(start);
        WideDouble y = WideDouble.Load(v + 4) - WideDouble.Load(start + 4);
        WideDouble w = WideDouble.Load(v + 8) - WideDouble.Load(start + 8);
        int n = Places[index].BlockRows;
        for (int r = 0; r < n; r++)
        {
            WideDouble answer = WideDouble.Zero;
            for (int k = 0; k < n; k++)
            {
                WideDouble fall = (WideDouble.Load(node->ParentS + (k * LaneMatrix.Row)) * x)
                    + (WideDouble.Load(node->ParentS + (k * LaneMatrix.Row) + 4) * y)
                    + (WideDouble.Load(node->ParentS + (k * LaneMatrix.Row) + 8) * w);
                answer += WideDouble.Load(node->Joint.E + (((r * n) + k) * LaneMatrix.Step)) * fall;
            }

            WideDouble through = WideDouble.Negate(LaneSolve.Dot(node->G + (r * LaneMatrix.Row), walk->Through));
            (through - answer).Store(node->Joint.Lambda + (r * LaneMatrix.Step));
        }

        if (Places[index].Anchored)
        {
            LaneSolve.Push(node->Joint.S, node->Joint.Lambda, n, node->Got);
        }

        if (Places[above].Anchored)
        {
            LaneSolve.Push(node->ParentS, node->Joint.Lambda, n, Nodes[above].Got);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void TransposedTimes(double* t, double* d, out WideDouble x, out WideDouble y, out WideDouble w)
    {
        WideDouble d0 = WideDouble.Load(d);
        WideDouble d1 = WideDouble.Load(d + 4);
        WideDouble d2 = WideDouble.Load(d + 8);
        x = (WideDouble.Load(t) * d0) + (WideDouble.Load(t + 12) * d1) + (WideDouble.Load(t + 24) * d2);
        y = (WideDouble.Load(t + 4) * d0) + (WideDouble.Load(t + 16) * d1) + (WideDouble.Load(t + 28) * d2);
        w = (WideDouble.Load(t + 8) * d0) + (WideDouble.Load(t + 20) * d1) + (WideDouble.Load(t + 32) * d2);
    }

    /// <summary>v += m·(x, y, w).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Push(double* m, WideDouble x, WideDouble y, WideDouble w, double* v, WideDoubleMask acts)
    {
        Note(v, LaneMatrix.Dot(x, y, w, m), LaneMatrix.Dot(x, y, w, m + 12), LaneMatrix.Dot(x, y, w, m + 24), acts);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Note(double* sum, WideDouble x, WideDouble y, WideDouble w, WideDoubleMask acts)
    {
        WideDouble s0 = WideDouble.Load(sum);
        WideDouble s1 = WideDouble.Load(sum + 4);
        WideDouble s2 = WideDouble.Load(sum + 8);
        WideDouble.Select(acts, s0 + x, s0).Store(sum);
        WideDouble.Select(acts, s1 + y, s1).Store(sum + 4);
        WideDouble.Select(acts, s2 + w, s2).Store(sum + 8);
    }
}
