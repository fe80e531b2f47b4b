using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>
/// Tests every moved box against every other: O(moved · n), no state, nothing to go wrong. The measure the other algorithms are
/// checked against, and the fastest below some dozen boxes.
/// </summary>
internal sealed unsafe class BruteForce : IBroadPhase
{
    public void Added(ProxyStore proxies, int proxy)
    {
    }

    public void Removed(ProxyStore proxies, int proxy)
    {
    }

    public void Visit(StateStream s)
    {
    }

    public void Collect(ProxyStore proxies, PairBuffer pairs)
    {
        Box* boxes = proxies.Fat.Pointer;
        ProxyInfo* info = proxies.Info.Pointer;
        int end = proxies.End;
        for (int i = 0; i < end; i++)
        {
            if (!PairRule.Seeks(info[i].Flags))
            {
                continue;
            }

            for (int j = 0; j < end; j++)
            {
                // A pair of two moved boxes is reported by the lower one.
                if (Box.Overlap(boxes[i], boxes[j])
                    && (info[j].Flags & ProxyFlags.Alive) != 0
                    && (j > i || !PairRule.Seeks(info[j].Flags))
                    && PairRule.Wants(info[i], info[j]))
                {
                    pairs.Add(i, j);
                }
            }
        }
    }
}
