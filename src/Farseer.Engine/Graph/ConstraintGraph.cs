using System;
using Farseer.Engine.Constraints;
using Farseer.Engine.Contacts;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Graph;

/// <summary>
/// Colours contacts so that those of one colour can be solved side by side; which colour a contact gets is for
/// <see cref="BodyColors"/> to say.
/// </summary>
internal sealed unsafe class ConstraintGraph
{
    public const int ColorCount = BodyColors.Count;

    /// <summary>The rows of contacts asleep, behind all colours: kept with their impulses, and solved by nobody.</summary>
    public const int Dormant = ContactRecord.DormantRow;

    /// <summary>Changes remembered between two searches for islands: looking at one costs some ten rows of a search.</summary>
    private const int MostChanges = 1024;

    private readonly Column<GraphChange> _changes = new Column<GraphChange>();
    private readonly BodyColors _bodies = new BodyColors();
    private readonly RowArena _arena = new RowArena();
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
        _changes.EnsureCapacity(MostChanges);
        for (int i = 0; i < ColorCount; i++)
        {
            _colors[i] = new GraphColor(_arena, i >= BodyColors.Masked, BodyColors.IsGrounded(i));
        }

        for (int i = 0; i < ColorCount; i++)
        {
            _inOrder[i] = _colors[BodyColors.InOrder(i)];
        }

        System.Diagnostics.Debug.Assert(Dormant == ColorCount, "the colour of those asleep is none of the others");
        _colors[Dormant] = new GraphColor(_arena);
    }

    public int RowCount { get; private set; }

    /// <summary>Rows were added or removed since the islands were last brought up to date.</summary>
    public bool Changed { get; private set; }

    /// <summary>What came and went since then, unless there was too much of it to look at one by one.</summary>
    public GraphChange* Changes => _changes.Pointer;

    public int ChangeCount { get; private set; }

    public bool ChangesAreKnown => ChangeCount <= Math.Min(MostChanges, (RowCount / 4) + 1);

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

    /// <summary>Where the rows of all colours are.</summary>
    public RowArena Arena => _arena;

    /// <summary>The bundle of a row, whatever its colour.</summary>
    public ContactBundle* BundleOf(int row) => _arena.BundleOf(row);

    /// <summary>Number of rows at a body.</summary>
    public int Degree(int body) => _degree[body];

    public int* Degrees => _degree.Pointer;

    public void EnsureBodies(int capacity)
    {
        _bodies.EnsureBodies(capacity);
        _degree.EnsureCapacity(capacity);
    }

    public void Add(int contact, ref ContactRecord record, bool movesA, bool movesB)
    {
        int color = _bodies.Choose(record.BodyA, record.BodyB, movesA, movesB);
        GraphColor rows = _colors[color];
        _usedChanged |= rows.RowCount == 0;
        int row = rows.AddRow();
        ContactRowWriter.Name(_arena.BundleOf(row), RowArena.LaneOf(row), contact, record);
        record.Color = (sbyte)color;
        record.Row = row;
        Mark(record.BodyA, color, movesA);
        Mark(record.BodyB, color, movesB);
        RowCount++;
        Note(record, contact);
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
        Note(record, GraphChange.Gone);
    }

    /// <summary>Lays a row to rest as it is.</summary>
    public void LayDown(ref ContactRecord record, Column<ContactRecord> records)
    {
        int row = _colors[Dormant].AddRow();
        Move(record.Row, row);
        Remove(ref record, records);
        record.Color = Dormant;
        record.Row = row;
    }

    /// <summary>Takes a row up again, with the impulses that it had.</summary>
    public void TakeUp(int contact, ref ContactRecord record, Column<ContactRecord> records, bool movesA, bool movesB)
    {
        int row = record.Row;
        Add(contact, ref record, movesA, movesB);
        Move(row, record.Row);
        int moved = _colors[Dormant].RemoveRow(row);
        if (moved >= 0)
        {
            records[moved].Row = row;
        }
    }

    /// <summary>The islands are up to date.</summary>
    public void ForgetChanges()
    {
        Changed = false;
        ChangeCount = 0;
    }

    private void Move(int from, int to) =>
        ContactRowWriter.MoveLane(_arena.BundleOf(from), RowArena.LaneOf(from), _arena.BundleOf(to), RowArena.LaneOf(to));

    private void Note(in ContactRecord record, int contact)
    {
        Changed = true;
        if (ChangeCount < MostChanges)
        {
            _changes[ChangeCount] = new GraphChange { BodyA = record.BodyA, BodyB = record.BodyB, Contact = contact };
        }

        ChangeCount = Math.Min(ChangeCount + 1, MostChanges + 1);
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

    private void Mark(int body, int color, bool moves)
    {
        _degree[body]++;
        _bodies.Mark(body, color, moves);
    }

    private void Unmark(int body, int color)
    {
        _degree[body]--;
        _bodies.Unmark(body, color);
    }
}
