using Farseer.Engine.Storage;

namespace Farseer.Engine.Graph;

/// <summary>
/// Groups of islands whose rows lie side by side, so that they stay near while all passes of all substeps are over them. A row whose
/// bodies are of two groups goes to group 0, which all begin in, and ties both to it: tied groups are solved together with it,
/// colour by colour, until the rows are sorted anew.
/// </summary>
internal sealed class RowGroups
{
    /// <summary>A record has a byte for its group.</summary>
    public const int Most = 256;

    // Of bodies with a row; others have none, and take that of the first they touch.
    private readonly Column<byte> _group = new Column<byte>();
    private readonly bool[] _tied = new bool[Most];

    public RowGroups() => _tied[0] = true;

    /// <summary>Groups in use, group 0 with them.</summary>
    public int Count { get; private set; } = 1;

    /// <summary>Solved together with group 0, which itself is.</summary>
    public bool IsTied(int group) => _tied[group];

    public int Of(int body) => _group[body];

    public void EnsureBodies(int capacity) => _group.EnsureCapacity(capacity);

    /// <summary>Begins anew with so many groups, of which none is tied.</summary>
    public void Begin(int count)
    {
        Count = count;
        for (int i = 1; i < Most; i++)
        {
            _tied[i] = false;
        }
    }

    public void Put(int body, int group) => _group[body] = (byte)group;

    /// <summary>The group of a row.</summary>
    public int Of(int a, int b, bool movesA, bool movesB) => movesA && movesB ? Tie(a, b) : _group[movesA ? a : b];

    /// <summary>The group of a new row. A body without another one joins that of its neighbour.</summary>
    public int Choose(int a, int b, bool movesA, bool movesB, int degreeA, int degreeB)
    {
        if (Count == 1)
        {
            return 0;
        }

        if (!movesA || !movesB)
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
}
