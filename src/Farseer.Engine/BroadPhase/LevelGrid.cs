using System.Collections.Generic;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>
/// The fastest pair finder: what moves is sorted each time into uniform grids, one a size class (<see cref="GridLevel"/>); what has been
/// still for a while waits in a packed tree (<see cref="PackedTree"/>), which only moved boxes ask. O(active + pairs), where active are
/// the boxes that moved lately; a standing world costs a look at its flags. Scale-free: cells are measured in boxes.
/// </summary>
/// <remarks>
/// The larger box of a pair asks the grid of the smaller: few large boxes then cost a few rows of cells each, while the other way
/// round every small box would ask every coarser grid.
/// A box is put into the tree when keeping it in the grids has cost as much as rebuilding the tree: at worst twice the cost of knowing
/// in advance. The rule counts boxes, not time, so runs repeat exactly.
/// </remarks>
internal sealed unsafe partial class LevelGrid : IBroadPhase, IStageWork
{
    // The cost of building one box into the tree, in boxes sorted into a grid.
    private const int BuildCost = 4;

    // Boxes that are worth another worker's while, some 2 µs.
    private const int LeastBoxes = 128;

    // Hits of a box in the tree, for which there is room.
    private const int UsualHits = 1024;

    // There from the start: a size class that comes late, as fast boxes make one, allocates nothing.
    private const int UsualLevels = 8;

    [NotState(Why.OfOneStep)]
    private readonly List<GridLevel> _grids = new List<GridLevel>(UsualLevels);
    private readonly SizeLevels _levels = new SizeLevels();
    private readonly PackedTree _tree = new PackedTree();
    private readonly FewSeekers _few = new FewSeekers();
    private readonly MainGroup _mainGroup = new MainGroup();
    [NotState(Why.OfOneStep)]
    private IndexList[] _hits = { new IndexList() };
    [NotState(Why.OfOneStep)]
    private PairBuffer[] _found = { new PairBuffer() };
    [NotState(Why.Running)]
    private StageRunner? _runner;
    [NotState(Why.Elsewhere)]
    private ProxyStore _proxies = null!;
    [NotState(Why.OfOneStep)]
    private PairBuffer _pairs = null!;
    [NotState(Why.OfOneStep)]
    private GridLevel? _coarse;
    [NotState(Why.OfOneStep)]
    private GridLevel? _fine;
    private int _reserved;
    private long _debt;

    public void Added(ProxyStore proxies, int proxy)
    {
        Know(proxies, proxy + 1);
        Leave(proxy);
        _mainGroup.Change(proxies.Info[proxy]);

        // Who searched before may have been a user, who may have left out what he liked.
        proxies.Sought[proxy] = Box.Empty;
    }

    public void Removed(ProxyStore proxies, int proxy)
    {
        Know(proxies, proxy + 1);
        Leave(proxy);
        _mainGroup.Change(proxies.Info[proxy]);
    }

    /// <summary>From now on workers share the search.</summary>
    public void Share(StageRunner runner) => _runner = runner;

    public void Collect(ProxyStore proxies, PairBuffer pairs)
    {
        Know(proxies, proxies.End);
        Reserve(proxies.End);
        int seekers = GatherActive(proxies);
        _mainGroup.Find(proxies);
        if (_mainGroup.Group != 0)
        {
            _few.Collect(proxies, _mainGroup.All.Pointer, seekers == 0 ? 0 : _mainGroup.All.Count, _mainGroup.Group, pairs);
            return;
        }

        _debt += _resting.Count;
        if (_debt > 0 && _debt >= (long)BuildCost * (_tree.Count + _resting.Count))
        {
            Settle(proxies);
        }

        if (seekers == 0)
        {
            return;
        }

        _proxies = proxies;
        _pairs = pairs;
        BeginSearch();
        if (_tree.Count > 0)
        {
            Search(null, null, _active.Count);
        }

        if (seekers <= FewSeekers.Most)
        {
            _few.Collect(proxies, _active.Pointer, _active.Count, mainGroup: 0, pairs);
        }
        else
        {
            SearchGrids(proxies);
        }

        EndSearch();
    }

    private void SearchGrids(ProxyStore proxies)
    {
        int mark = proxies.Scratch.Mark;
        _levels.Assign(_runner, proxies.Scratch, proxies.Fat.Pointer, _active.Pointer, _active.Count);
        while (_grids.Count < System.Math.Max(_levels.Count, UsualLevels))
        {
            _grids.Add(new GridLevel());
        }

        for (int l = 0; l < _levels.Count; l++)
        {
            _grids[l].Build(_runner, proxies, _levels.Members(l), _levels.Size(l), _levels.MaxSize(l));
        }

        for (int coarse = 0; coarse < _levels.Count; coarse++)
        {
            GridLevel grid = _grids[coarse];
            if (grid.Seekers > 0)
            {
                Search(grid, null, grid.Count);
            }

            for (int fine = 0; fine < coarse; fine++)
            {
                if (grid.Seekers + _grids[fine].Seekers > 0)
                {
                    Search(grid, _grids[fine], grid.Count);
                }
            }
        }

        proxies.Scratch.Release(mark);
    }

    /// <summary>
    /// A range of the active boxes asks the tree, or one of a level the level itself or a finer one; or blocks of boxes are gathered.
    /// </summary>
    void IStageWork.Run(int worker, int from, int to)
    {
        if (_gathers)
        {
            for (int block = from; block < to; block++)
            {
                Gather(block);
            }

            return;
        }

        PairBuffer pairs = worker == 0 ? _pairs : _found[worker];
        if (_coarse == null)
        {
            AskTree(pairs, _hits[worker], from, to);
        }
        else if (_fine == null)
        {
            _coarse.CollectWithin(pairs, from, to);
        }
        else
        {
            AskFiner(_coarse, _fine, pairs, from, to);
        }
    }

    private static void AskFiner(GridLevel coarse, GridLevel fine, PairBuffer pairs, int from, int to)
    {
        for (int i = from; i < to; i++)
        {
            if (fine.Seekers > 0 || PairRule.Seeks(coarse.Entries[i].Key))
            {
                fine.CollectAgainst(coarse.Entries + i, coarse.Sought(i), pairs);
            }
        }
    }

    private void BeginSearch()
    {
        int workers = _runner == null ? 1 : _runner.Workers;
        int had = _found.Length;
        if (workers > had)
        {
            System.Array.Resize(ref _found, workers);
            System.Array.Resize(ref _hits, workers);
            for (int i = had; i < workers; i++)
            {
                _found[i] = new PairBuffer();
                _hits[i] = new IndexList();
            }
        }
    }

    private void Search(GridLevel? coarse, GridLevel? fine, int count)
    {
        _coarse = coarse;
        _fine = fine;
        StageRunner.Share(_runner, this, count, LeastBoxes);
    }

    // Who found which pairs changes from run to run: all get the room that one of them needed.
    private void EndSearch()
    {
        int pairs = 0;
        int hits = 0;
        for (int i = 0; i < _found.Length; i++)
        {
            _pairs.Take(_found[i]);
            pairs = System.Math.Max(pairs, _found[i].Capacity);
            hits = System.Math.Max(hits, _hits[i].Capacity);
        }

        for (int i = 0; i < _found.Length; i++)
        {
            _found[i].Reserve(pairs);
            _hits[i].Reserve(hits);
        }
    }

    // Rebuilds the tree with the resting boxes in it. They leave the list of the grids at once, so that none is found twice.
    private void Settle(ProxyStore proxies)
    {
        for (int slot = 0; slot < _tree.SlotCount; slot++)
        {
            int proxy = _tree.Proxy(slot);
            if (proxy >= 0)
            {
                _resting.Add(proxy);
            }
        }

        _tree.Build(proxies.Scratch, proxies.Fat.Pointer, _resting.Pointer, _resting.Count);
        for (int slot = 0; slot < _tree.SlotCount; slot++)
        {
            _residence.Pointer[_tree.Proxy(slot)].TreeSlot = slot;
        }

        int kept = 0;
        int* active = _active.Pointer;
        for (int i = 0; i < _active.Count; i++)
        {
            if (_residence.Pointer[active[i]].TreeSlot == NotInTree)
            {
                active[kept++] = active[i];
            }
        }

        _active.SetCount(kept);
        _debt = 0;
    }

    private void AskTree(PairBuffer pairs, IndexList hits, int from, int to)
    {
        Box* boxes = _proxies.Fat.Pointer;
        ProxyInfo* info = _proxies.Info.Pointer;
        Box* sought = _proxies.Sought.Pointer;
        for (int i = from; i < to; i++)
        {
            int proxy = _active.Pointer[i];
            if (!PairRule.Seeks(info[proxy].Flags))
            {
                continue;
            }

            hits.Clear();
            _tree.Overlap(boxes[proxy], hits);
            for (int k = 0; k < hits.Count; k++)
            {
                int other = hits.Pointer[k];
                if ((info[other].Flags & ProxyFlags.Alive) != 0 && PairRule.Wants(info[proxy], info[other])
                    && !Box.Overlap(sought[proxy], sought[other]))
                {
                    pairs.Add(proxy, other);
                }
            }
        }
    }

    private void Reserve(int count)
    {
        if (count <= _reserved)
        {
            return;
        }

        _reserved = _residence.Capacity;
        _active.Reserve(_reserved);
        _resting.Reserve(_reserved);
        _tree.Reserve(_reserved);
        _hits[0].Reserve(System.Math.Min(_reserved, UsualHits));
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        _active.Visit(s);
        _resting.Visit(s);
        s.Column(_residence);
        s.Value(ref _end);
        _levels.Visit(s);
        _tree.Visit(s);
        _mainGroup.Visit(s);
        s.Value(ref _reserved);
        s.Value(ref _debt);
    }
}
