using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Islands;

/// <summary>
/// Sorts the rows of a large world into groups of islands that stay near while they are solved. That costs about as much as a third of a
/// step, so it is done only where the rows as they lie are far away, and seldom where it did not last.
/// </summary>
internal sealed unsafe class IslandGroups
{
    /// <summary>Fewest groups that are worth it: a world with fewer rows is near enough as it is.</summary>
    private const int LeastGroups = 4;

    /// <summary>Part of all rows that may be far before they are sorted anew.</summary>
    private const int FarPart = 4;

    /// <summary>Steps until the next look; doubled if there was nothing to gain, or if it did not last.</summary>
    private const int LeastWait = 16;
    private const int MostWait = 1024;

    // In scratch memory, while the islands are packed.
    private int* _ends;
    private int* _groupOf;
    private int _wait;
    private int _nextWait = 1;

    /// <summary>Rows of a group, by default 0.4 MB: with its bodies it stays in a second-level cache.</summary>
    [NotState(Why.Running)]
    public int GroupRows { get; set; } = 2300;

    /// <summary>How often the rows were sorted.</summary>
    public int Sorts { get; private set; }

    /// <summary>Sorts the rows if it is worth it. The islands are up to date.</summary>
    public void Sort(IslandStore islands, ConstraintGraph graph, Column<ContactRecord> records, byte* moves, Scratch scratch)
    {
        if (graph.RowCount / LeastGroups < GroupRows || --_wait > 0)
        {
            return;
        }

        _wait = LeastWait;
        if (graph.Groups.TiedRows(graph.Used) * FarPart <= graph.RowCount)
        {
            _nextWait = LeastWait;
            return;
        }

        int mark = scratch.Mark;
        _ends = scratch.Take<int>(islands.Count);
        _groupOf = scratch.Take<int>(islands.Count);
        int groups = Pack(islands, graph, moves);
        if (groups > 0)
        {
            Regroup(groups, islands, graph, records, moves);
        }

        scratch.Release(mark);
        _wait = _nextWait;
        _nextWait = Math.Min(2 * Math.Max(_nextWait, LeastWait), MostWait);
    }

    private void Regroup(int groups, IslandStore islands, ConstraintGraph graph, Column<ContactRecord> records, byte* moves)
    {
        graph.Groups.Begin(groups);
        for (int body = 0; body < islands.BodyEnd; body++)
        {
            int island = islands.Of(body);
            graph.Groups.Put(body, moves[body] != 0 && island >= 0 && graph.Degree(body) > 0 ? _groupOf[island] : 0);
        }

        graph.Regroup(records, moves);
        Sorts++;
    }

    /// <summary>
    /// Fills group after group with the islands in their order, which is that of their first bodies; group 0 stays empty.
    /// </summary>
    /// <returns>How many groups there are; 0: most rows are of islands that are too large.</returns>
    private int Pack(IslandStore islands, ConstraintGraph graph, byte* moves)
    {
        for (int i = 0; i < islands.Count; i++)
        {
            _ends[i] = 0;
        }

        for (int body = 0; body < islands.BodyEnd; body++)
        {
            if (moves[body] != 0 && islands.Of(body) >= 0)
            {
                _ends[islands.Of(body)] += graph.Degree(body);
            }
        }

        // A row between two bodies has two ends.
        int most = Math.Max(2 * GroupRows, 2 * graph.RowCount / (RowGroups.Most / 2));
        int large = 0;
        int group = 1;
        int filled = 0;
        for (int i = 0; i < islands.Count; i++)
        {
            large += _ends[i] > 2 * most ? _ends[i] : 0;
            if (filled > 0 && filled + _ends[i] > most)
            {
                group++;
                filled = 0;
            }

            filled += _ends[i];
            _groupOf[i] = group;
        }

        return large > graph.RowCount || group < LeastGroups || group >= RowGroups.Most ? 0 : group + 1;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Value(ref _wait);
        s.Value(ref _nextWait);
        Sorts = s.Value(Sorts);
    }
}
