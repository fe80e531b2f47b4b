using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>Displacements and poses for trees side by side, and the arms and errors of their joints there.</summary>
internal static unsafe class LanePoses
{
    private const int Y = DoubleLanes.BundleLanes;
    private const int W = 2 * DoubleLanes.BundleLanes;

    /// <summary>The way of a substep by h·v; it and the velocities are noted as they are before corrections.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Move(LaneNode* nodes, int count, double h)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            WideDouble time = WideDouble.Splat(h);
            for (int i = 0; i < count; i++)
            {
                LaneNode* node = DoubleLanes.Shift(nodes + i, lane);
                for (int k = 0; k <= W; k += DoubleLanes.BundleLanes)
                {
                    WideDouble v = WideDouble.Load(node->Velocity + k);
                    WideDouble move = WideDouble.Load(node->Move + k) + (time * v);
                    v.Store(node->PlainVelocity + k);
                    move.Store(node->Move + k);
                    move.Store(node->PlainMove + k);
                }

                WideDouble.Zero.Store(node->Bent);
            }
        }

        Turn(nodes, count);
    }

    /// <summary>
    /// Of the lanes of a mask: moves by the changes that the velocities are now, and adds these to the velocities put aside.
    /// </summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void MoveOn(LaneNode* nodes, int count, double h, LaneTrees* trees)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            WideDoubleMask takes = WideDouble.LoadMask(trees->Corrects + lane);
            WideDouble time = WideDouble.Splat(h);
            WideDouble bent = WideDouble.Zero;
            for (int i = 0; i < count; i++)
            {
                LaneNode* node = DoubleLanes.Shift(nodes + i, lane);
                WideDouble turn = WideDouble.Load(node->Bent) + WideDouble.Abs(time * WideDouble.Load(node->Velocity + W));
                turn = WideDouble.Select(takes, turn, WideDouble.Load(node->Bent));
                turn.Store(node->Bent);
                bent = WideDouble.Select(WideDouble.IsNotNumber(turn) | (turn > bent), turn, bent);
                for (int k = 0; k <= W; k += DoubleLanes.BundleLanes)
                {
                    WideDouble change = WideDouble.Load(node->Velocity + k);
                    WideDouble saved = WideDouble.Load(node->Saved + k);
                    WideDouble move = WideDouble.Load(node->Move + k);
                    WideDouble.Select(takes, move + (time * change), move).Store(node->Move + k);
                    WideDouble.Select(takes, change + saved, saved).Store(node->Velocity + k);
                }
            }

            bent.Store(trees->Bent + lane);
        }

        Turn(nodes, count);
    }

    /// <summary>Sine and cosine of the turns.</summary>
    public static void Turn(LaneNode* nodes, int count)
    {
        for (int i = 0; i < count; i++)
        {
            StableMath.SinCos(nodes[i].Move + W, nodes[i].TurnSin, nodes[i].TurnCos);
        }
    }

    /// <summary>Where the bodies are, and arms and errors of the joints there.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Place(in LaneBundle bundle)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            LaneNode* first = DoubleLanes.Shift(bundle.Nodes, lane);
            for (int i = 0; i < bundle.Count; i++)
            {
                Place(first + i);
                if (i > 0)
                {
                    LaneNode* parent = first + bundle.Places[i].Parent;
                    if (bundle.Places[i].IsA)
                    {
                        LaneRows.Place(&first[i].Joint, bundle.Places + i, first[i].X, parent->X);
                    }
                    else
                    {
                        LaneRows.Place(&first[i].Joint, bundle.Places + i, parent->X, first[i].X);
                    }
                }
            }

            for (int i = 0; i < bundle.AnchorCount; i++)
            {
                LaneAnchor* anchor = DoubleLanes.Shift(bundle.Anchors + i, lane);
                LaneNode* node = first + bundle.AnchorPlaces[i].Parent;
                if (bundle.AnchorPlaces[i].IsA)
                {
                    LaneRows.Place(&anchor->Joint, bundle.AnchorPlaces + i, node->X, anchor->X);
                }
                else
                {
                    LaneRows.Place(&anchor->Joint, bundle.AnchorPlaces + i, anchor->X, node->X);
                }
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Place(LaneNode* node)
    {
        WideDouble middleCos = WideDouble.Load(node->MiddleCos);
        WideDouble middleSin = WideDouble.Load(node->MiddleSin);
        WideDouble turnCos = WideDouble.Load(node->TurnCos);
        WideDouble turnSin = WideDouble.Load(node->TurnSin);
        (WideDouble.Load(node->StartX) + WideDouble.Load(node->Move)).Store(node->X);
        (WideDouble.Load(node->StartY) + WideDouble.Load(node->Move + Y)).Store(node->Y);
        (WideDouble.Load(node->StartAngle) + (WideDouble.Load(node->Move + W) + WideDouble.Load(node->Lead))).Store(node->Angle);
        ((middleCos * turnCos) - (middleSin * turnSin)).Store(node->Cos);
        ((middleSin * turnCos) + (middleCos * turnSin)).Store(node->Sin);
    }
}
