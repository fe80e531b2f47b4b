using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Islands;

/// <summary>
/// Groups of bodies that touch, and in each the support levels: how many contacts away the ground is. They are found anew
/// only when rows came or went. Each level of an island has a slot.
/// </summary>
/// <remarks>
/// Neighbours are listed colour by colour, since rows of one colour share no body that moves: workers that have parts of it write to lists
/// of their own. In which order a list names them follows from who was first where islands are kept, and nothing follows from that: levels
/// are the lengths of shortest ways, islands are numbered by their lowest bodies.
/// </remarks>
internal sealed unsafe partial class IslandStore : IStageWork
{
    /// <summary>
    /// Bundles of a colour whose neighbours are worth another worker's while, and bundles of any that are written, some 1 µs.
    /// </summary>
    private const int LeastBundles = 24;

    /// <summary>Rows from which on levels and islands are searched at the same time, each by one worker.</summary>
    private const int LeastRows = 128;

    private const int Searches = 2;

    private readonly Column<int> _level = new Column<int>();
    private readonly Column<int> _begin = new Column<int>();
    private readonly Column<int> _end = new Column<int>();
    private readonly Column<int> _neighbours = new Column<int>();
    private readonly Column<int> _islandOf = new Column<int>();
    private readonly Column<int> _firstSlot = new Column<int>();
    private readonly Column<int> _ofSlot = new Column<int>();
    [NotState(Why.OfOneStep)]
    private ColorRanges _ranges = null!;

    // In scratch memory, while the islands are built: the bodies that each of the searches has reached.
    private int* _queue;

    // By body, meanwhile too: the slot of its island at its level, 0 if it does not move.
    private int* _slotOf;
    private int* _flooded;
    [NotState(Why.OfOneStep)]
    private GraphColor _color = null!;
    private readonly Column<int> _rowsOf = new Column<int>();
    private int* _degrees;
    private byte* _moves;
    [NotState(Why.OfOneStep)]
    private Part _part;

    private enum Part
    {
        List,
        Search,
        Write,
    }

    public int Count { get; private set; }

    /// <summary>One past the last slot.</summary>
    public int SlotCount { get; private set; }

    /// <summary>The island of a body that had a row when the islands were last built.</summary>
    public int Of(int body) => _islandOf[body];

    /// <summary>How many contacts away the ground is from such a body; -1: nothing carries it.</summary>
    public int LevelOf(int body) => _level[body];

    /// <summary>One past the highest body when the islands were last built.</summary>
    public int BodyEnd => _bodyEnd;

    /// <summary>Contacts of an island.</summary>
    public int RowsOf(int island) => _rowsOf[island];

    /// <summary>Some island has as few contacts as these at most.</summary>
    public bool AnySmaller(int rows)
    {
        for (int i = 0; i < Count; i++)
        {
            if (_rowsOf[i] <= rows)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>First slot of each island; the entry after the last island is <see cref="SlotCount"/>.</summary>
    public int* FirstSlot => _firstSlot.Pointer;

    /// <summary>The island of each slot.</summary>
    public int* OfSlot => _ofSlot.Pointer;

    /// <summary>Finds islands and levels of all rows and writes both into the rows.</summary>
    /// <param name="runner">Who shares the work out.</param>
    /// <param name="graph">The rows.</param>
    /// <param name="bodyEnd">One past the highest body.</param>
    /// <param name="moves">1 for a body that can move.</param>
    /// <param name="scratch">Where room is found meanwhile.</param>
    public void Build(StageRunner runner, ConstraintGraph graph, int bodyEnd, byte* moves, Scratch scratch)
    {
        Reserve(bodyEnd, graph.RowCount);
        int mark = scratch.Mark;
        _queue = scratch.Take<int>(bodyEnd + 1);
        _flooded = scratch.Take<int>(bodyEnd + 1);
        _bodyEnd = bodyEnd;
        _moves = moves;
        _degrees = graph.Degrees;
        Begin();
        _part = Part.List;
        foreach (GraphColor color in graph.Used)
        {
            // Rows at the ground may share it, those of a heavy body may share that, and those of the overflow any body.
            _color = color;
            runner.Run(this, color.BundleCount, color.IsGrounded || color.HasOrder ? int.MaxValue : LeastBundles);
        }

        _part = Part.Search;
        runner.Run(this, Searches, graph.RowCount < LeastRows ? Searches : 1);
        NumberSlots();
        _slotOf = scratch.Take<int>(bodyEnd + 1);
        FindSlotsOfBodies();
        _ranges = graph.NumberBundles(runner.Workers);
        _part = Part.Write;
        runner.Run(this, _ranges.Count, LeastBundles);
        scratch.Release(mark);
    }

    /// <summary>Makes room for so many bodies and rows.</summary>
    public void Reserve(int bodyEnd, int rows)
    {
        _level.EnsureCapacity(bodyEnd);
        _islandOf.EnsureCapacity(bodyEnd);
        _begin.EnsureCapacity(bodyEnd);
        _end.EnsureCapacity(bodyEnd);
        _firstSlot.EnsureCapacity(bodyEnd + 1);
        _rowsOf.EnsureCapacity(bodyEnd + 1);
        _ofSlot.EnsureCapacity(bodyEnd + 1);
        _neighbours.EnsureCapacity(2 * Math.Max(rows, 2 * bodyEnd));
    }

    void IStageWork.Run(int worker, int from, int to)
    {
        switch (_part)
        {
            case Part.List:
                ListNeighbours(from, to);
                break;
            case Part.Search:
                for (int search = from; search < to; search++)
                {
                    if (search == 0)
                    {
                        FindLevels();
                    }
                    else
                    {
                        NumberIslands();
                    }
                }

                break;
            case Part.Write:
                WriteRows(from, to);
                break;
        }
    }

    /// <summary>Empty lists with room for a neighbour a row; those of rows at the ground stay without.</summary>
    private void Begin()
    {
        int* begin = _begin.Pointer;
        int* end = _end.Pointer;
        int* level = _level.Pointer;
        int* islandOf = _islandOf.Pointer;
        int next = 0;
        for (int i = 0; i < _bodyEnd; i++)
        {
            begin[i] = next;
            end[i] = next;
            level[i] = -1;
            islandOf[i] = -1;
            next += _degrees[i];
        }
    }

    /// <summary>Lists the neighbours that bundles of a colour make, and gives the bodies on the ground their level.</summary>
    private void ListNeighbours(int from, int to)
    {
        int* end = _end.Pointer;
        int* level = _level.Pointer;
        int* neighbours = _neighbours.Pointer;
        byte* moves = _moves;
        foreach (ContactBundle* row in new BundleWalk(_color.Part(from, to)))
        {
            ContactBundle.AskAhead(row->BodyA);
            for (int lane = 0; lane < ContactBundle.Lanes; lane++)
            {
                // In an empty lane both are the dummy, which does not move and carries nothing.
                int a = row->BodyA[lane];
                int b = row->BodyB[lane];
                if ((moves[a] & moves[b]) != 0)
                {
                    neighbours[end[a]++] = b;
                    neighbours[end[b]++] = a;
                }
                else if (a != b)
                {
                    level[moves[a] != 0 ? a : b] = 0;
                }
            }
        }
    }

    /// <summary>Breadth first from the bodies on the ground; bodies that nothing carries keep the level -1.</summary>
    private void FindLevels()
    {
        int* begin = _begin.Pointer;
        int* end = _end.Pointer;
        int* level = _level.Pointer;
        int* queue = _queue;
        int* neighbours = _neighbours.Pointer;
        int queued = 0;
        for (int i = 0; i < _bodyEnd; i++)
        {
            queue[queued] = i;
            queued += level[i] == 0 ? 1 : 0;
        }

        for (int head = 0; head < queued; head++)
        {
            int body = queue[head];
            int next = level[body] + 1;
            for (int k = begin[body]; k < end[body]; k++)
            {
                int other = neighbours[k];
                queue[queued] = other;
                queued += Reach(ref level[other], next);
            }
        }
    }

    /// <summary>
    /// Gives a body that has no mark yet this one. Whether it has cannot be foreseen, so there is no branch: half of the search
    /// was spent on wrong guesses.
    /// </summary>
    /// <returns>1 if it had none.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Reach(ref int mark, int value)
    {
        int old = mark;
        int fresh = (int)((uint)old >> 31);
        mark = old ^ ((old ^ value) & -fresh);
        return fresh;
    }

    /// <summary>Floods each island from its lowest body, so that the islands are numbered by these.</summary>
    private void NumberIslands()
    {
        int* islandOf = _islandOf.Pointer;
        Count = 0;
        for (int i = 0; i < _bodyEnd; i++)
        {
            if (_moves[i] != 0 && islandOf[i] < 0)
            {
                Flood(i, Count);
                Count++;
            }
        }
    }

    private void Flood(int first, int island)
    {
        int* begin = _begin.Pointer;
        int* end = _end.Pointer;
        int* queue = _flooded;
        int* neighbours = _neighbours.Pointer;
        int* islandOf = _islandOf.Pointer;
        int queued = 1;
        int ends = 0;
        queue[0] = first;
        islandOf[first] = island;
        for (int head = 0; head < queued; head++)
        {
            // A row between two bodies that move is a neighbour of both, and counts half at each; one with what cannot move is nobody's
            // neighbour.
            int body = queue[head];
            ends += (2 * _degrees[body]) - (end[body] - begin[body]);
            for (int k = begin[body]; k < end[body]; k++)
            {
                int other = neighbours[k];
                queue[queued] = other;
                queued += Reach(ref islandOf[other], island);
            }
        }

        _rowsOf[island] = ends / 2;
    }

    /// <summary>A slot for each level of each island, for one at least.</summary>
    private void NumberSlots()
    {
        int* islandOf = _islandOf.Pointer;
        int* level = _level.Pointer;
        int* firstSlot = _firstSlot.Pointer;
        for (int i = 0; i < Count; i++)
        {
            firstSlot[i] = 1;
        }

        for (int i = 0; i < _bodyEnd; i++)
        {
            int island = islandOf[i];
            if (island >= 0 && level[i] >= firstSlot[island])
            {
                firstSlot[island] = level[i] + 1;
            }
        }

        // The slot of a row whose bodies cannot move any more is 0, also where there is no island.
        int* ofSlot = _ofSlot.Pointer;
        ofSlot[0] = 0;
        int total = 0;
        for (int i = 0; i < Count; i++)
        {
            int levels = firstSlot[i];
            firstSlot[i] = total;
            for (int end = total + levels; total < end; total++)
            {
                ofSlot[total] = i;
            }
        }

        firstSlot[Count] = total;
        SlotCount = total;
    }

    private void FindSlotsOfBodies()
    {
        int* islandOf = _islandOf.Pointer;
        int* level = _level.Pointer;
        int* firstSlot = _firstSlot.Pointer;
        for (int i = 0; i < _bodyEnd; i++)
        {
            _slotOf[i] = _moves[i] != 0 ? firstSlot[islandOf[i]] + Math.Max(0, level[i]) : 0;
        }
    }

    /// <summary>As <see cref="WriteLane"/>: of the slots of both bodies the higher one is that of the upper body.</summary>
    private void WriteRows(int from, int to)
    {
        float* slotOf = (float*)_slotOf;
        while (from < to)
        {
            foreach (ContactBundle* row in new BundleWalk(_ranges.From(from, to, out from)))
            {
                ContactBundle.AskAhead(row->BodyA);
                ContactBundle.AskAhead(row->Slot);
                for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
                {
                    Wide a = WideTable.Read(slotOf, row->BodyA + lane);
                    WideTable.LargerNumber(a, WideTable.Read(slotOf, row->BodyB + lane)).Store((float*)row->Slot + lane);
                }
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void WriteLane(ContactBundle* row, int lane, byte* moves)
    {
        int a = row->BodyA[lane];
        int b = row->BodyB[lane];

        // Both were taken out of motion since the step began: the row goes at the start of the next.
        if ((moves[a] | moves[b]) == 0)
        {
            row->Slot[lane] = 0;
            return;
        }

        // A contact belongs to the level of its upper body; the ground carries level 0.
        int* level = _level.Pointer;
        int body = moves[a] != 0 ? a : b;
        int other = moves[b] != 0 ? b : body;
        int height = Math.Max(0, Math.Max(level[body], level[other]));
        int island = _islandOf[body];
        row->Slot[lane] = _firstSlot[island] + height;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Value(ref _bodyEnd);
        s.Column(_level);
        s.Column(_begin);
        s.Column(_end);
        s.Column(_neighbours);
        s.Column(_islandOf);
        s.Column(_firstSlot);
        s.Column(_ofSlot);
        s.Column(_rowsOf);
        Count = s.Value(Count);
        SlotCount = s.Value(SlotCount);
    }
}
