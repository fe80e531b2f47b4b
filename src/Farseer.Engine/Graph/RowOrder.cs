using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Contacts;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Graph;

/// <summary>
/// Puts the rows of each colour in the order of their bodies. Rows come in the order in which pairs are found, so a pass over a colour
/// reached the bodies at random, and of two workers, each with its half of every colour, both wrote to all bodies: of 28,000 times that a
/// pass over a pyramid of base 100 touches a body, the other worker had touched it last in 13,600 cases; in the order of bodies in 880.
/// Pairs of one kind come together: a kernel of the narrow phase works on whole bundles, and of a heap of several kinds of shape a bundle
/// as they come takes up to four kernels.
/// </summary>
/// <remarks>
/// Passes come to the same bits in any order, since rows of a colour share no body; those that may, of heavy bodies and of the overflow,
/// stay as they are. Bounces and fast pairs are taken in the order of the rows, so where there are such a run is another one than without,
/// but the same for any number of workers.
/// </remarks>
internal sealed unsafe class RowOrder : IStageWork
{
    /// <summary>Part of all rows that have come since the last time, when they are put in order again.</summary>
    private const int NewPart = 2;

    /// <summary>A colour is left as it is if its rows lie among more than so many times as many bodies.</summary>
    private const int MostSpread = 32;

    // In scratch memory: for each worker the contact of each body, and for each colour its rows in their order.
    private int* _contactOf;
    private int* _rows;
    private int* _firstRow;
    [NotState(Why.OfOneStep)]
    private int _bodyEnd;
    [NotState(Why.Elsewhere)]
    private ConstraintGraph _graph = null!;
    [NotState(Why.Elsewhere)]
    private Column<ContactRecord> _records = null!;
    private byte* _moves;

    /// <summary>Fewer rows are near enough as they come: their bodies fit a first-level cache. Default 1,024.</summary>
    [NotState(Why.Running)]
    public int LeastRows { get; set; } = 1024;

    /// <summary>How often the rows were put in order.</summary>
    public int Sorts { get; private set; }

    /// <summary>Sorts the rows if enough of them are new. Colours share no row, so each is for any worker.</summary>
    public void Sort(StageRunner runner, ConstraintGraph graph, Column<ContactRecord> records, int bodyEnd, byte* moves, Scratch scratch)
    {
        if (graph.RowCount < LeastRows || graph.NewRows * NewPart < graph.RowCount)
        {
            return;
        }

        if (graph.Groups.AreHalves)
        {
            // Rows of colours that have grown, and of bodies that began or ceased to move.
            graph.Regroup(records, moves);
        }

        ReadOnlySpan<GraphColor> colors = graph.Used;
        int workers = runner.IsShared(colors.Length, 1) ? runner.Workers : 1;
        int mark = scratch.Mark;
        _contactOf = scratch.Take<int>(bodyEnd * workers);
        _rows = scratch.Take<int>(graph.RowCount);
        _firstRow = scratch.Take<int>(colors.Length);
        _bodyEnd = bodyEnd;
        _graph = graph;
        _records = records;
        _moves = moves;
        for (int i = 0; i < bodyEnd * workers; i++)
        {
            _contactOf[i] = -1;
        }

        int rows = 0;
        for (int i = 0; i < colors.Length; i++)
        {
            _firstRow[i] = rows;
            rows += colors[i].RowCount;
        }

        runner.Run(this, colors.Length, 1);
        scratch.Release(mark);
        graph.ForgetNewRows();
        Sorts++;
    }

    void IStageWork.Run(int worker, int from, int to)
    {
        ReadOnlySpan<GraphColor> colors = _graph.Used;
        for (int i = from; i < to; i++)
        {
            if (!colors[i].HasOrder)
            {
                Sort(colors[i], _contactOf + (worker * _bodyEnd), _rows + _firstRow[i]);
            }
        }
    }

    private void Sort(GraphColor color, int* contactOf, int* rows)
    {
        ConstraintGraph graph = _graph;
        Column<ContactRecord> records = _records;
        byte* moves = _moves;
        int first = int.MaxValue;
        int last = -1;
        int count = 0;
        int* next = stackalloc int[ContactRecord.Kinds + 1];
        Unsafe.InitBlock(next, 0, (ContactRecord.Kinds + 1) * sizeof(int));
        foreach (ContactBundle* bundle in color.Bundles)
        {
            for (int lane = 0; lane < ContactBundle.Lanes && bundle->Contact[lane] >= 0; lane++)
            {
                int body = Place(bundle->BodyA[lane], bundle->BodyB[lane], moves);
                ref ContactRecord record = ref records[bundle->Contact[lane]];
                rows[count++] = record.Row;
                next[(int)record.Kind + 1]++;
                first = body < first ? body : first;
                last = body > last ? body : last;
            }
        }

        if (last - first > (long)count * MostSpread)
        {
            return;
        }

        for (int i = 0; i < count; i++)
        {
            ContactBundle* bundle = graph.BundleOf(rows[i]);
            int lane = RowArena.LaneOf(rows[i]);
            contactOf[Place(bundle->BodyA[lane], bundle->BodyB[lane], moves)] = bundle->Contact[lane];
        }

        for (int kind = 1; kind < ContactRecord.Kinds; kind++)
        {
            next[kind] += next[kind - 1];
        }

        for (int body = first; body <= last; body++)
        {
            int contact = contactOf[body];
            if (contact >= 0)
            {
                contactOf[body] = -1;
                graph.Exchange(records[contact].Row, rows[next[(int)records[contact].Kind]++], records);
            }
        }
    }

    /// <summary>The body by which a row is placed, which no other row of its colour has: the first that moves.</summary>
    private static int Place(int a, int b, byte* moves) => RowGroups.PlaceOf(a, b, moves[a] != 0, moves[b] != 0);

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        Sorts = s.Value(Sorts);
    }
}
