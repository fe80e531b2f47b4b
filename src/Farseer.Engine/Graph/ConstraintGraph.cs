using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Graph;

/// <summary>
/// Colours contacts so that those of one colour can be solved side by side. A body remembers its colours in a mask; a new
/// contact starts at a colour drawn from its pair and takes the first that neither body has. Greedy lowest-first colouring
/// solves all contacts of one kind (left supports, right supports) together, which pushes large pyramids sideways: of 20 rows,
/// at 5 substeps, it left 29 mm/s of sway, the drawn colours 0.2. Contacts with a static or kinematic body have colours of their own,
/// solved last, so that the ground has the last word.
/// </summary>
internal sealed unsafe class ConstraintGraph
{
    /// <summary>Colours of contacts between two bodies that can move.</summary>
    public const int DynamicColors = 40;

    /// <summary>Colours among which a new contact draws.</summary>
    private const int DrawnColors = 8;

    /// <summary>All colours but the overflow, which is the last of the array; bits of the masks.</summary>
    public const int MaskedColors = 63;

    /// <summary>Contacts between moving bodies for which no colour was free.</summary>
    public const int DynamicOverflow = MaskedColors;

    /// <summary>Contacts with the ground for which no colour was free.</summary>
    public const int StaticOverflow = MaskedColors + 1;

    public const int ColorCount = MaskedColors + 2;

    /// <summary>The rows of contacts asleep, behind all colours: kept with their impulses, and solved by nobody.</summary>
    public const int Dormant = ContactRecord.DormantRow;

    private readonly Column<ulong> _masks = new Column<ulong>();
    private readonly Column<int> _degree = new Column<int>();
    private readonly GraphColor[] _colors = new GraphColor[ColorCount + 1];

    private readonly GraphColor[] _inOrder = new GraphColor[ColorCount];

    // The colours that have rows: a small world has one or two, and to ask all of them in every pass was most of its step.
    private readonly GraphColor[] _solved = new GraphColor[ColorCount];
    private readonly GraphColor[] _used = new GraphColor[ColorCount];
    private int _usedCount;
    private bool _usedChanged;

    public ConstraintGraph()
    {
        for (int i = 0; i < ColorCount; i++)
        {
            _colors[i] = new GraphColor(i >= MaskedColors);
        }

        int next = 0;
        for (int i = 0; i < DynamicColors; i++)
        {
            _inOrder[next++] = _colors[i];
        }

        _inOrder[next++] = _colors[DynamicOverflow];
        for (int i = DynamicColors; i < MaskedColors; i++)
        {
            _inOrder[next++] = _colors[i];
        }

        _inOrder[next] = _colors[StaticOverflow];
        System.Diagnostics.Debug.Assert(Dormant == ColorCount, "the colour of those asleep is none of the others");
        _colors[Dormant] = new GraphColor();
    }

    public int RowCount { get; private set; }

    /// <summary>Rows were added or removed since the islands were last built.</summary>
    public bool Changed { get; set; }

    /// <summary>The colours in the order of solving: moving pairs, their overflow, ground pairs, their overflow.</summary>
    public GraphColor[] InOrder => _inOrder;

    /// <summary>The colours that have rows, in the order of solving. Valid until a row is added or removed.</summary>
    public ReadOnlySpan<GraphColor> Solved
    {
        get
        {
            FindUsed();
            return new ReadOnlySpan<GraphColor>(_solved, 0, _usedCount);
        }
    }

    /// <summary>The same by their number.</summary>
    public ReadOnlySpan<GraphColor> Used
    {
        get
        {
            FindUsed();
            return new ReadOnlySpan<GraphColor>(_used, 0, _usedCount);
        }
    }

    public GraphColor this[int color] => _colors[color];

    /// <summary>Number of rows at a body.</summary>
    public int Degree(int body) => _degree[body];

    public int* Degrees => _degree.Pointer;

    public void EnsureBodies(int capacity)
    {
        _masks.EnsureCapacity(capacity);
        _degree.EnsureCapacity(capacity);
    }

    public void Add(int contact, ref ContactRecord record, bool movesA, bool movesB)
    {
        int color = Choose(record.BodyA, record.BodyB, movesA, movesB);
        GraphColor rows = _colors[color];
        _usedChanged |= rows.RowCount == 0;
        int row = rows.AddRow();
        ContactBundle* bundle = rows.BundleOf(row);
        int lane = rows.LaneOf(row);
        ContactRowWriter.Name(bundle, lane, contact, record);
        record.Color = color;
        record.Row = row;
        Mark(record.BodyA, color, movesA);
        Mark(record.BodyB, color, movesB);
        RowCount++;
        Changed = true;
    }

    public void Remove(ref ContactRecord record, Column<ContactRecord> records)
    {
        int color = record.Color;
        int row = record.Row;
        int moved = _colors[color].RemoveRow(row);
        if (moved >= 0)
        {
            records[moved].Row = row;
        }

        _usedChanged |= _colors[color].RowCount == 0;
        Unmark(record.BodyA, color);
        Unmark(record.BodyB, color);
        record.Color = -1;
        RowCount--;
        Changed = true;
    }

    /// <summary>Lays a row to rest as it is.</summary>
    public void LayDown(ref ContactRecord record, Column<ContactRecord> records)
    {
        GraphColor from = _colors[record.Color];
        GraphColor to = _colors[Dormant];
        int row = to.AddRow();
        ContactRowWriter.MoveLane(from.BundleOf(record.Row), from.LaneOf(record.Row), to.BundleOf(row), to.LaneOf(row));
        Remove(ref record, records);
        record.Color = Dormant;
        record.Row = row;
    }

    /// <summary>Takes a row up again, with the impulses that it had.</summary>
    public void TakeUp(int contact, ref ContactRecord record, Column<ContactRecord> records, bool movesA, bool movesB)
    {
        GraphColor from = _colors[Dormant];
        int row = record.Row;
        Add(contact, ref record, movesA, movesB);
        GraphColor to = _colors[record.Color];
        ContactRowWriter.MoveLane(from.BundleOf(row), from.LaneOf(row), to.BundleOf(record.Row), to.LaneOf(record.Row));
        int moved = from.RemoveRow(row);
        if (moved >= 0)
        {
            records[moved].Row = row;
        }
    }

    private void FindUsed()
    {
        if (!_usedChanged)
        {
            return;
        }

        _usedChanged = false;
        _usedCount = 0;
        int solved = 0;
        for (int i = 0; i < ColorCount; i++)
        {
            if (_colors[i].RowCount > 0)
            {
                _used[_usedCount++] = _colors[i];
            }

            if (_inOrder[i].RowCount > 0)
            {
                _solved[solved++] = _inOrder[i];
            }
        }
    }

    private int Choose(int a, int b, bool movesA, bool movesB)
    {
        if (movesA && movesB)
        {
            return Draw(_masks[a] | _masks[b], a, b);
        }

        return LowestClear(movesA ? _masks[a] : _masks[b], DynamicColors, MaskedColors, StaticOverflow);
    }

    private static int Draw(ulong mask, int a, int b)
    {
        uint hash = ((uint)a * 73856093u) ^ ((uint)b * 19349663u);
        hash ^= hash >> 15;
        hash *= 0x2C1B3C6Du;
        hash ^= hash >> 12;
        int start = (int)(hash % DrawnColors);
        for (int i = 0; i < DrawnColors; i++)
        {
            int color = (start + i) % DrawnColors;
            if ((mask & (1UL << color)) == 0)
            {
                return color;
            }
        }

        return LowestClear(mask, DrawnColors, DynamicColors, DynamicOverflow);
    }

    private static int LowestClear(ulong mask, int from, int to, int overflow)
    {
        for (int i = from; i < to; i++)
        {
            if ((mask & (1UL << i)) == 0)
            {
                return i;
            }
        }

        return overflow;
    }

    private void Mark(int body, int color, bool moves)
    {
        _degree[body]++;
        if (moves && color < MaskedColors)
        {
            _masks[body] |= 1UL << color;
        }
    }

    private void Unmark(int body, int color)
    {
        _degree[body]--;
        if (color < MaskedColors)
        {
            _masks[body] &= ~(1UL << color);
        }
    }
}
