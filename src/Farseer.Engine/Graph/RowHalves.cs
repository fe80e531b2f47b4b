using Farseer.Engine.Contacts;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Graph;

/// <summary>
/// Parts the rows of a large world that is solved as one in two: those of the first bodies and those of the others, each colour of one half
/// beside that of the other. Two workers then begin with a half each in every pass, and rows that are new come to theirs. Before, each
/// colour was cut where half of its rows were, and new rows lay behind all others, wherever their bodies were: of 45,000 times that a pass
/// over a pile of 10,000 discs touches a body the other worker had written to it last in 5,000; now in 600. A line that comes from another
/// processor takes as long as sixteen rows.
/// </summary>
/// <remarks>
/// The halves are the same for any number of workers, so that the order of the rows is, which bounces are taken in. Groups of islands
/// (<see cref="RowGroups"/>) go before; when most of them are tied, they are solved as one and are halved as well.
/// </remarks>
internal sealed unsafe class RowHalves
{
    /// <summary>Steps from one look to the next.</summary>
    private const int Wait = 16;

    /// <summary>Each half has at least so many of <see cref="Parts"/> of the rows, else they are halved anew.</summary>
    private const int LeastParts = 3;
    private const int Parts = 8;

    /// <summary>Of fewer rows nothing is told: the bodies themselves are halved.</summary>
    private const int LeastRows = 1024;

    private int _wait;

    /// <summary>
    /// The rows of fewer bodies are not halved. Default 6,144: one worker takes 1.007 of the time with halves of 10,000 bodies, 1.013 with
    /// those of a pyramid of 5,050, whose bodies are in the order of the rows anyway. Where there are so many, new rows go to their half
    /// from the first on, so that few need to be moved.
    /// </summary>
    [NotState(Why.Running)]
    public int LeastBodies { get; set; } = 6144;

    /// <summary>
    /// Rows of a colour that is halved, by default 512: half of as many are hardly worth sharing, and a record that is not full costs them
    /// most.
    /// </summary>
    [NotState(Why.Running)]
    public int LeastOfColor { get; set; } = 512;

    /// <summary>How often rows were parted.</summary>
    public int Partings { get; private set; }

    /// <summary>Parts the rows if it is worth it.</summary>
    public void Part(ConstraintGraph graph, Column<ContactRecord> records, int bodyEnd, byte* moves, Scratch scratch)
    {
        if (--_wait > 0)
        {
            return;
        }

        _wait = Wait;
        RowGroups groups = graph.Groups;
        if (bodyEnd < LeastBodies || !MayPart(graph))
        {
            return;
        }

        int middle = graph.RowCount < LeastRows ? (bodyEnd / 2) & ~1 : FindMiddle(graph, bodyEnd, moves, scratch);
        if (middle > 0 && middle != groups.Middle)
        {
            groups.Halve(middle, LeastOfColor);
            graph.Regroup(records, moves);
            Partings++;
        }
    }

    /// <summary>Whether the rows are neither halved evenly nor groups of islands.</summary>
    private static bool MayPart(ConstraintGraph graph)
    {
        RowGroups groups = graph.Groups;
        if (groups.Count > 1)
        {
            return graph.RowCount >= LeastRows && groups.TiedRows(graph.Used) * Parts >= graph.RowCount * (Parts - 1);
        }

        return !groups.AreHalves || (graph.RowCount >= LeastRows && !IsEven(FirstHalfRows(graph), graph.RowCount));
    }

    private static int FirstHalfRows(ConstraintGraph graph)
    {
        int rows = 0;
        foreach (GraphColor color in graph.Used)
        {
            rows += color.Group == 0 ? color.RowCount : 0;
        }

        return rows;
    }

    private static bool IsEven(int first, int all) => first * Parts >= all * LeastParts && (all - first) * Parts >= all * LeastParts;

    /// <summary>The body before whose rows half of all are; an even number, for two bodies have a cache line in common.</summary>
    private static int FindMiddle(ConstraintGraph graph, int bodyEnd, byte* moves, Scratch scratch)
    {
        int mark = scratch.Mark;
        int* counts = scratch.Take<int>(bodyEnd);
        for (int body = 0; body < bodyEnd; body++)
        {
            counts[body] = 0;
        }

        foreach (GraphColor color in graph.Used)
        {
            foreach (ContactBundle* bundle in color.Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes && bundle->Contact[lane] >= 0; lane++)
                {
                    int a = bundle->BodyA[lane];
                    int b = bundle->BodyB[lane];
                    counts[RowGroups.PlaceOf(a, b, moves[a] != 0, moves[b] != 0)]++;
                }
            }
        }

        int below = 0;
        int middle = 0;
        while (middle < bodyEnd && 2 * below < graph.RowCount)
        {
            below += counts[middle++];
        }

        scratch.Release(mark);
        return middle & ~1;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Value(ref _wait);
        Partings = s.Value(Partings);
    }
}
