using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>
/// The search of a world in which few boxes look for pairs: these lie side by side in lanes, and every other box is tested against eight of
/// them at once. That costs 1 to 2 ns a box for each eight, where sorting all boxes into a grid costs some 20: a pile at rest, of which a
/// few bodies leave their boxes in each step, is like that.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class FewSeekers
{
    /// <summary>Up to here it is cheaper than a grid.</summary>
    public const int Most = 48;

    private readonly BoxRows _rows = new BoxRows();
    private readonly Column<int> _seekers = new Column<int>();

    /// <summary>
    /// Pairs of the boxes of the list that seek with all of the list; with a main group, of the boxes outside of it instead. There are at
    /// most <see cref="Most"/> of them.
    /// </summary>
    public void Collect(ProxyStore proxies, int* list, int count, int mainGroup, PairBuffer pairs)
    {
        Box* boxes = proxies.Fat.Pointer;
        ProxyInfo* info = proxies.Info.Pointer;
        _seekers.EnsureCapacity(Math.Min(count, Most));
        _rows.EnsureCapacity(Math.Min(count, Most));
        int* seekers = _seekers.Pointer;
        int found = 0;
        for (int i = 0; i < count; i++)
        {
            if (IsOne(info[list[i]], mainGroup))
            {
                seekers[found++] = list[i];
            }
        }

        _rows.SetCount(found);
        WideBoxes wide = _rows.Wide;
        for (int i = 0; i < found; i++)
        {
            wide.Set(i, boxes[seekers[i]]);
        }

        if (found > 0)
        {
            Ask(proxies, list, count, found, mainGroup, pairs);
        }
    }

    private static bool IsOne(in ProxyInfo info, int mainGroup) => mainGroup == 0 ? PairRule.Seeks(info.Flags) : info.Group != mainGroup;

    [MethodImpl(KernelMethod.Optimized)]
    private void Ask(ProxyStore proxies, int* list, int count, int found, int mainGroup, PairBuffer pairs)
    {
        Box* boxes = proxies.Fat.Pointer;
        ProxyInfo* info = proxies.Info.Pointer;
        int* seekers = _seekers.Pointer;
        WideBoxes wide = _rows.Wide;
        for (int i = 0; i < count; i++)
        {
            int proxy = list[i];
            var box = new SpreadBox(boxes[proxy]);
            for (int k = 0; k < found; k += WideBoxes.Width)
            {
                // Behind the last one there are empty boxes.
                for (uint mask = wide.Overlaps(k, box); mask != 0; mask &= mask - 1)
                {
                    int seeker = seekers[k + WideBoxes.LowestLane(mask)];

                    // Two that seek find each other twice, and each finds itself.
                    bool once = seeker < proxy || !IsOne(info[proxy], mainGroup);
                    if (once && PairRule.Wants(info[proxy], info[seeker]))
                    {
                        pairs.Add(proxy, seeker);
                    }
                }
            }
        }
    }
}
