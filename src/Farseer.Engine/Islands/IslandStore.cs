using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Islands;

/// <summary>
/// Groups of bodies that touch, and in each the support levels: how many contacts away the ground is. They are found anew
/// only when rows came or went. Each level of an island has a slot.
/// </summary>
internal sealed unsafe partial class IslandStore
{
    private readonly Column<int> _level = new Column<int>();
    private readonly Column<int> _start = new Column<int>();
    private readonly Column<int> _neighbours = new Column<int>();
    private readonly Column<int> _islandOf = new Column<int>();
    private readonly Column<int> _firstSlot = new Column<int>();

    // In scratch memory, while the islands are built.
    private int* _queue;
    private Edge* _edges;
    private int _edgeCount;

    public int Count { get; private set; }

    /// <summary>One past the last slot.</summary>
    public int SlotCount { get; private set; }

    /// <summary>The island of a body that had a row when the islands were last built.</summary>
    public int Of(int body) => _islandOf[body];

    /// <summary>How many contacts away the ground is from such a body; -1: nothing carries it.</summary>
    public int LevelOf(int body) => _level[body];

    /// <summary>One past the highest body when the islands were last built.</summary>
    public int BodyEnd => _bodyEnd;

    /// <summary>First slot of each island; the entry after the last island is <see cref="SlotCount"/>.</summary>
    public int* FirstSlot => _firstSlot.Pointer;

    /// <summary>Finds islands and levels of all rows and writes both into the rows.</summary>
    /// <param name="graph">The rows.</param>
    /// <param name="bodyEnd">One past the highest body.</param>
    /// <param name="moves">1 for a body that can move.</param>
    /// <param name="scratch">Where room is found meanwhile.</param>
    public void Build(ConstraintGraph graph, int bodyEnd, byte* moves, Scratch scratch)
    {
        Reserve(bodyEnd, graph.RowCount);
        int mark = scratch.Mark;
        _queue = scratch.Take<int>(bodyEnd + 1);
        _edges = scratch.Take<Edge>(graph.RowCount + 1);
        _bodyEnd = bodyEnd;
        int queued = CollectEdges(graph, bodyEnd, moves);
        FindLevels(bodyEnd, queued);
        NumberIslands(bodyEnd, moves);
        scratch.Release(mark);
        WriteRows(graph, moves);
    }

    /// <summary>Makes room for so many bodies and rows.</summary>
    public void Reserve(int bodyEnd, int rows)
    {
        _level.EnsureCapacity(bodyEnd);
        _islandOf.EnsureCapacity(bodyEnd);
        _start.EnsureCapacity(bodyEnd + 1);
        _firstSlot.EnsureCapacity(bodyEnd + 1);
        _neighbours.EnsureCapacity(2 * Math.Max(rows, 2 * bodyEnd));
    }

    /// <summary>One walk over the rows: lists the pairs of moving bodies and queues the bodies on the ground.</summary>
    /// <returns>How many bodies are queued.</returns>
    private int CollectEdges(ConstraintGraph graph, int bodyEnd, byte* moves)
    {
        int* start = _start.Pointer;
        int* level = _level.Pointer;
        int* queue = _queue;
        Edge* edges = _edges;
        for (int i = 0; i < bodyEnd; i++)
        {
            start[i] = 0;
            level[i] = -1;
        }

        start[bodyEnd] = 0;
        int queued = 0;
        int edgeCount = 0;
        foreach (GraphColor color in graph.Used)
        {
            foreach (ContactBundle* row in color.Bundles)
            {
                ContactBundle.AskAhead(row->BodyA);
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    // In an empty lane both are the dummy, which does not move and carries nothing.
                    int a = row->BodyA[lane];
                    int b = row->BodyB[lane];
                    if ((moves[a] & moves[b]) != 0)
                    {
                        edges[edgeCount].A = a;
                        edges[edgeCount++].B = b;
                        start[a + 1]++;
                        start[b + 1]++;
                    }
                    else if (a != b)
                    {
                        int body = moves[a] != 0 ? a : b;
                        if (level[body] < 0)
                        {
                            level[body] = 0;
                            queue[queued++] = body;
                        }
                    }
                }
            }
        }

        _edgeCount = edgeCount;
        return queued;
    }

    /// <summary>Breadth first from the bodies on the ground; bodies that nothing carries keep the level -1.</summary>
    private void FindLevels(int bodyEnd, int queued)
    {
        int* start = _start.Pointer;
        int* level = _level.Pointer;
        int* queue = _queue;
        int* neighbours = _neighbours.Pointer;
        for (int i = 0; i < bodyEnd; i++)
        {
            start[i + 1] += start[i];
        }

        // After filling, start[i] is the end of body i's range (and start[i - 1] its beginning).
        Edge* edges = _edges;
        for (int i = 0; i < _edgeCount; i++)
        {
            neighbours[start[edges[i].A]++] = edges[i].B;
            neighbours[start[edges[i].B]++] = edges[i].A;
        }

        for (int head = 0; head < queued; head++)
        {
            int body = queue[head];
            int next = level[body] + 1;
            int end = body == 0 ? 0 : start[body];
            for (int k = body == 0 ? 0 : start[body - 1]; k < end; k++)
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
    private void NumberIslands(int bodyEnd, byte* moves)
    {
        int* islandOf = _islandOf.Pointer;
        for (int i = 0; i < bodyEnd; i++)
        {
            islandOf[i] = -1;
        }

        Count = 0;
        for (int i = 0; i < bodyEnd; i++)
        {
            if (moves[i] != 0 && islandOf[i] < 0)
            {
                _firstSlot[Count] = Flood(i, Count);
                Count++;
            }
        }

        int* firstSlot = _firstSlot.Pointer;
        int total = 0;
        for (int i = 0; i < Count; i++)
        {
            int levels = Math.Max(firstSlot[i], 1);
            firstSlot[i] = total;
            total += levels;
        }

        firstSlot[Count] = total;
        SlotCount = total;
    }

    /// <returns>How many levels the island has.</returns>
    private int Flood(int first, int island)
    {
        int* start = _start.Pointer;
        int* level = _level.Pointer;
        int* queue = _queue;
        int* neighbours = _neighbours.Pointer;
        int* islandOf = _islandOf.Pointer;
        int levels = 0;
        int queued = 1;
        queue[0] = first;
        islandOf[first] = island;
        for (int head = 0; head < queued; head++)
        {
            int body = queue[head];
            levels = Math.Max(levels, level[body] + 1);
            for (int k = start[body - 1]; k < start[body]; k++)
            {
                int other = neighbours[k];
                queue[queued] = other;
                queued += Reach(ref islandOf[other], island);
            }
        }

        return levels;
    }

    private void WriteRows(ConstraintGraph graph, byte* moves)
    {
        foreach (GraphColor color in graph.Used)
        {
            foreach (ContactBundle* row in color.Bundles)
            {
                ContactBundle.AskAhead(row->BodyA);
                ContactBundle.AskAhead(row->Island);
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    if (row->BodyA[lane] != row->BodyB[lane])
                    {
                        WriteLane(row, lane, moves);
                    }
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
            row->Island[lane] = 0;
            row->Level[lane] = 0;
            return;
        }

        // A contact belongs to the level of its upper body; the ground carries level 0.
        int* level = _level.Pointer;
        int body = moves[a] != 0 ? a : b;
        int other = moves[b] != 0 ? b : body;
        int height = Math.Max(0, Math.Max(level[body], level[other]));
        int island = _islandOf[body];
        row->Island[lane] = island;
        row->Level[lane] = _firstSlot[island] + height;
    }

    private struct Edge
    {
        public int A;
        public int B;
    }
}
