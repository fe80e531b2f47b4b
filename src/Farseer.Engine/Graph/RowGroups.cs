using System;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Graph;

/// <summary>
/// Groups of islands whose rows lie side by side, so that they stay near while all passes of all substeps are over them. A row whose
/// bodies are of two groups goes to group 0, which all begin in, and ties both to it: tied groups are solved together with it,
/// colour by colour, until the rows are sorted anew. Where there are no groups of islands the rows may be halved instead, by their bodies:
/// see <see cref="RowHalves"/>.
/// </summary>
internal sealed class RowGroups
{
    /// <summary>A record has a byte for its group.</summary>
    public const int Most = 256;

    // Of bodies with a row; others have none, and take that of the first they touch.
    private readonly Column<byte> _group = new Column<byte>();
    private readonly bool[] _tied = new bool[Most];

    public RowGroups() => _tied[0] = true;

    /// <summary>Groups of islands in use, group 0 with them; 1: there are none.</summary>
    public int Count { get; private set; } = 1;

    /// <summary>The first body of the second half, whose rows are group 1, tied to group 0; 0: the rows are not halved.</summary>
    public int Middle { get; private set; }

    public bool AreHalves => Middle > 0;

    /// <summary>Rows of a colour that is halved.</summary>
    public int LeastOfColor { get; private set; }

    /// <summary>Groups that rows may be of.</summary>
    public int InUse => AreHalves ? 2 : Count;

    /// <summary>Solved together with group 0, which itself is.</summary>
    public bool IsTied(int group) => _tied[group];

    /// <summary>Rows that are solved together with group 0.</summary>
    /// <param name="colors">All colours that have rows.</param>
    public int TiedRows(ReadOnlySpan<GraphColor> colors)
    {
        int rows = 0;
        foreach (GraphColor color in colors)
        {
            rows += IsTied(color.Group) ? color.RowCount : 0;
        }

        return rows;
    }

    public int Of(int body) => _group[body];

    public void EnsureBodies(int capacity) => _group.EnsureCapacity(capacity);

    /// <summary>Begins anew with so many groups, of which none is tied.</summary>
    public void Begin(int count)
    {
        Count = count;
        Middle = 0;
        for (int i = 1; i < Most; i++)
        {
            _tied[i] = false;
        }
    }

    /// <summary>Parts the rows in two halves instead.</summary>
    /// <param name="middle">The first body of the second, above 0.</param>
    /// <param name="leastOfColor">Colours of fewer rows stay whole.</param>
    public void Halve(int middle, int leastOfColor)
    {
        Begin(1);
        Middle = middle;
        LeastOfColor = leastOfColor;
        _tied[1] = true;
    }

    public void Put(int body, int group) => _group[body] = (byte)group;

    /// <summary>The body that a row lies by: the first that moves.</summary>
    public static int PlaceOf(int a, int b, bool movesA, bool movesB) => movesA && movesB ? Math.Min(a, b) : movesA ? a : b;

    /// <summary>The group of a row.</summary>
    public int Of(int a, int b, bool movesA, bool movesB)
    {
        if (Count == 1)
        {
            return AreHalves && PlaceOf(a, b, movesA, movesB) >= Middle ? 1 : 0;
        }

        return movesA && movesB ? Tie(a, b) : _group[movesA ? a : b];
    }

    /// <summary>The group of a new row. A body without another one joins that of its neighbour.</summary>
    public int Choose(int a, int b, bool movesA, bool movesB, int degreeA, int degreeB)
    {
        if (Count == 1 || !movesA || !movesB)
        {
            return Of(a, b, movesA, movesB);
        }

        if (degreeA == 0)
        {
            _group[a] = _group[b];
        }
        else if (degreeB == 0)
        {
            _group[b] = _group[a];
        }

        return Tie(a, b);
    }

    /// <summary>The group of a row between two bodies that move.</summary>
    private int Tie(int a, int b)
    {
        int groupA = _group[a];
        int groupB = _group[b];
        if (groupA == groupB)
        {
            return groupA;
        }

        _tied[groupA] = true;
        _tied[groupB] = true;
        return 0;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_group);
        s.Array(_tied);
        Count = s.Value(Count);
        Middle = s.Value(Middle);
        LeastOfColor = s.Value(LeastOfColor);
    }
}
