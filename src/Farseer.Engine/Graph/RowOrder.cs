using Farseer.Engine.Contacts;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Graph;

/// <summary>
/// Puts the rows of each colour in the order of their bodies. Rows come in the order in which pairs are found, so a pass over a colour reached the
/// bodies at random, and of two workers, each with its half of every colour, both wrote to all bodies: of 28,000 times that a pass over a pyramid of base 100
/// touches a body, the other worker had touched it last in 13,600 cases; in the order of bodies in 880.
/// </summary>
/// <remarks>
/// No result follows from it: rows of a colour share no body. Rows that may, those of the overflow, stay as they are.
/// </remarks>
internal sealed unsafe class RowOrder
{
    /// <summary>Part of all rows that have come since the last time, when they are put in order again.</summary>
    private const int NewPart = 2;

    /// <summary>A colour is left as it is if its rows lie among more than so many times as many bodies.</summary>
    private const int MostSpread = 32;

    // In scratch memory: the contact of each body, and the rows in their order.
    private int* _contactOf;
    private int* _rows;

    /// <summary>Fewer rows are near enough as they come: their bodies fit a first-level cache. Default 1,024.</summary>
    public int LeastRows { get; set; } = 1024;

    /// <summary>How often the rows were put in order.</summary>
    public int Sorts { get; private set; }

    /// <summary>Sorts the rows if enough of them are new.</summary>
    public void Sort(ConstraintGraph graph, Column<ContactRecord> records, int bodyEnd, byte* moves, Scratch scratch)
    {
        if (graph.RowCount < LeastRows || graph.NewRows * NewPart < graph.RowCount)
        {
            return;
        }

        int mark = scratch.Mark;
        _contactOf = scratch.Take<int>(bodyEnd);
        _rows = scratch.Take<int>(graph.RowCount);
        for (int i = 0; i < bodyEnd; i++)
        {
            _contactOf[i] = -1;
        }

        foreach (GraphColor color in graph.Used)
        {
            if (!color.IsSequential)
            {
                Sort(color, graph, records, moves);
            }
        }

        scratch.Release(mark);
        graph.ForgetNewRows();
        Sorts++;
    }

    private void Sort(GraphColor color, ConstraintGraph graph, Column<ContactRecord> records, byte* moves)
    {
        int first = int.MaxValue;
        int last = -1;
        int count = 0;
        foreach (ContactBundle* bundle in color.Bundles)
        {
            for (int lane = 0; lane < ContactBundle.Lanes && bundle->Contact[lane] >= 0; lane++)
            {
                int contact = bundle->Contact[lane];
                int body = Place(bundle->BodyA[lane], bundle->BodyB[lane], moves);
                _contactOf[body] = contact;
                _rows[count++] = records[contact].Row;
                first = body < first ? body : first;
                last = body > last ? body : last;
            }
        }

        bool near = last - (long)first <= (long)count * MostSpread;
        int next = 0;
        for (int body = first; near && body <= last; body++)
        {
            int contact = _contactOf[body];
            if (contact >= 0)
            {
                _contactOf[body] = -1;
                graph.Exchange(records[contact].Row, _rows[next++], records);
            }
        }

        if (!near)
        {
            Forget(color, moves);
        }
    }

    private void Forget(GraphColor color, byte* moves)
    {
        foreach (ContactBundle* bundle in color.Bundles)
        {
            for (int lane = 0; lane < ContactBundle.Lanes && bundle->Contact[lane] >= 0; lane++)
            {
                _contactOf[Place(bundle->BodyA[lane], bundle->BodyB[lane], moves)] = -1;
            }
        }
    }

    /// <summary>The body by which a row is placed, which no other row of its colour has: the first that moves.</summary>
    private static int Place(int a, int b, byte* moves)
    {
        if (moves[a] == 0 || moves[b] == 0)
        {
            return moves[a] != 0 ? a : b;
        }

        return a < b ? a : b;
    }
}
