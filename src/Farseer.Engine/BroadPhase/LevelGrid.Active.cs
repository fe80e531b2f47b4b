using System;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <content>Which boxes are sorted into the grids, and which rest in the tree.</content>
internal sealed unsafe partial class LevelGrid
{
    // Collects without motion after which a box is thought to rest.
    private const int RestAfter = 16;

    // Boxes that are gathered together, some 1 µs.
    private const int GatherBlock = 1024;

    private const int NotInTree = -1;

    private readonly IndexList _active = new IndexList();
    private readonly IndexList _resting = new IndexList();
    private readonly Column<Residence> _residence = new Column<Residence>(1);

    // In scratch memory, while boxes are gathered.
    private GatherSums* _gathered;
    [NotState(Why.OfOneStep)]
    private bool _gathers;
    private int _end;

    // Lists the live boxes outside the tree, and those of them that rest; moved boxes leave the tree. Returns how many seek pairs.
    private int GatherActive(ProxyStore proxies)
    {
        int mark = proxies.Scratch.Mark;
        int blocks = (proxies.End + GatherBlock - 1) / GatherBlock;
        _gathered = proxies.Scratch.Take<GatherSums>(blocks);
        _proxies = proxies;
        _gathers = true;
        StageRunner.Share(_runner, this, blocks, 1);
        _gathers = false;
        int active = 0;
        int resting = 0;
        int seekers = 0;
        for (int block = 0; block < blocks; block++)
        {
            GatherSums sums = _gathered[block];
            Append(_active.Pointer, active, block, sums.Active);
            Append(_resting.Pointer, resting, block, sums.Resting);
            active += sums.Active;
            resting += sums.Resting;
            seekers += sums.Seekers;
            if (sums.AnyLeaves)
            {
                LeaveAll(block);
            }
        }

        _active.SetCount(active);
        _resting.SetCount(resting);
        proxies.Scratch.Release(mark);
        return seekers;
    }

    // Each block lists its boxes from its first place on: there are not more of them than places.
    private void Gather(int block)
    {
        ProxyInfo* info = _proxies.Info.Pointer;
        Residence* residence = _residence.Pointer;
        int first = block * GatherBlock;
        int end = Math.Min(first + GatherBlock, _proxies.End);
        int* active = _active.Pointer + first;
        int* resting = _resting.Pointer + first;
        GatherSums sums = default;
        for (int i = first; i < end; i++)
        {
            ProxyFlags flags = info[i].Flags;
            if ((flags & ProxyFlags.Alive) == 0)
            {
                continue;
            }

            if ((flags & ProxyFlags.Moved) != 0)
            {
                sums.AnyLeaves |= residence[i].TreeSlot != NotInTree;
                residence[i].StillFor = 0;
                sums.Seekers++;
                active[sums.Active++] = i;
            }
            else if (residence[i].TreeSlot == NotInTree)
            {
                active[sums.Active++] = i;
                residence[i].StillFor++;
                if (residence[i].StillFor >= RestAfter || (flags & ProxyFlags.Static) != 0)
                {
                    resting[sums.Resting++] = i;
                }
            }
        }

        _gathered[block] = sums;
    }

    private static void Append(int* list, int count, int block, int added)
    {
        int* from = list + (block * GatherBlock);
        if (list + count != from)
        {
            // To a place before it, so that what overlaps is read before it is written.
            Buffer.MemoryCopy(from, list + count, (long)added * sizeof(int), (long)added * sizeof(int));
        }
    }

    // The tree is for one thread. Few boxes are in it that move.
    private void LeaveAll(int block)
    {
        ProxyInfo* info = _proxies.Info.Pointer;
        int end = Math.Min((block + 1) * GatherBlock, _proxies.End);
        for (int i = block * GatherBlock; i < end; i++)
        {
            const ProxyFlags Both = ProxyFlags.Alive | ProxyFlags.Moved;
            if ((info[i].Flags & Both) == Both)
            {
                Leave(i);
            }
        }
    }

    private void Know(ProxyStore proxies, int end)
    {
        if (end > _end)
        {
            _residence.EnsureCapacity(System.Math.Max(end, proxies.Info.Capacity));
            for (int i = _end; i < end; i++)
            {
                _residence.Pointer[i].TreeSlot = NotInTree;
            }

            _end = end;
        }
    }

    private void Leave(int proxy)
    {
        ref Residence residence = ref _residence[proxy];
        if (residence.TreeSlot != NotInTree)
        {
            _tree.Remove(residence.TreeSlot);
            residence.TreeSlot = NotInTree;
        }

        residence.StillFor = 0;
    }

    // What a block of boxes came to.
    private struct GatherSums
    {
        public int Active;
        public int Resting;
        public int Seekers;
        public bool AnyLeaves;
    }

    private struct Residence
    {
        /// <summary>The slot in the tree, or −1 while the box is in the grids.</summary>
        public int TreeSlot;

        /// <summary>Collects since the box last moved.</summary>
        public int StillFor;
    }
}
