using System;
using System.Collections.Generic;
using Farseer.Engine.Bodies;
using Farseer.Engine.Constraints;
using Farseer.Engine.Contacts;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Graph;

/// <summary>
/// Colours contacts so that those of one colour can be solved side by side; which colour a contact gets is for
/// <see cref="BodyColors"/> to say.
/// </summary>
internal sealed unsafe partial class ConstraintGraph
{
    public const int ColorCount = BodyColors.Count;

    /// <summary>The rows of contacts asleep, behind all colours: kept with their impulses, and solved by nobody.</summary>
    public const int Dormant = ContactRecord.DormantRow;

    /// <summary>Changes remembered between two searches for islands: looking at one costs some ten rows of a search.</summary>
    private const int MostChanges = 1024;

    /// <summary>
    /// Pairs of a world so small that its steps take as long as its bundles are many, however few lanes of them are filled: there a row
    /// takes a colour that has a lane to spare. Pyramids of 6 to 36 boxes have 6 to 13 bundles for 7 to 15, and take 0.83 to 0.94 of the
    /// time; one of 55 has as many as before, and took 1.06 of it.
    /// </summary>
    private const int FewPairs = 128;

    /// <summary>
    /// The first rows of such a world are drawn as anywhere, else a stack would have two colours, its odd and its even contacts: as
    /// accurate, but a stack of ten far from the origin was left with 1.3 µm/s instead of 1.1.
    /// </summary>
    private const int FirstRows = 2;

    /// <summary>
    /// What a body at least answers an impulse with, in units of what a heavy one answers it with: eight rows side by side on that one then
    /// find it wrong by a ninth at most. A drum or a rotor answers with thousandths.
    /// </summary>
    private const float HeavyRatio = 64f;
    private const int NoBody = -1;

    /// <summary>Part of all rows that are moved at once to another group, those of one colour.</summary>
    private const int MovedPart = 8;

    private readonly Column<GraphChange> _changes = new Column<GraphChange>();
    private readonly BodyColors _bodies = new BodyColors();
    private readonly RowArena _arena = new RowArena();
    private readonly Column<int> _degree = new Column<int>();
    // By group and colour; the first also has the colour of those asleep. All of a group are made with its first row: one that is used late
    // is not to allocate then.
    private readonly List<GraphColor[]> _colors = new List<GraphColor[]>();
    [NotState(Why.OfOneStep)]
    private readonly IndexList _moving = new IndexList();
    [NotState(Why.OfOneStep)]
    private readonly Column<int> _counts = new Column<int>();

    [NotState(Why.OfOneStep)]
    private ColorRanges? _ranges;

    private bool _usedChanged;
    private bool _isSmall;
    [NotState(Why.Elsewhere)]
    private BodyStore? _store;
    private int _sharedRows;

    public ConstraintGraph() =>
        System.Diagnostics.Debug.Assert(Dormant == ColorCount, "the colour of those asleep is none of the others");

    public int RowCount { get; private set; }

    /// <summary>Rows that came since they were last put in order.</summary>
    public int NewRows { get; private set; }

    /// <summary>Rows were added or removed since the islands were last brought up to date.</summary>
    public bool Changed { get; private set; }

    /// <summary>What came and went since then, unless there was too much of it to look at one by one.</summary>
    public GraphChange* Changes => _changes.Pointer;

    public int ChangeCount { get; private set; }

    public bool ChangesAreKnown => ChangeCount <= Math.Min(MostChanges, (RowCount / 4) + 1);

    /// <summary>Which rows lie side by side.</summary>
    public RowGroups Groups { get; } = new RowGroups();

    /// <summary>Where the rows of all colours are.</summary>
    public RowArena Arena => _arena;

    /// <summary>Numbers bundles with these from now on; null: with its own.</summary>
    public void Use(ColorRanges? ranges) => _ranges = ranges;

    /// <summary>The bundle of a row, whatever its colour.</summary>
    public ContactBundle* BundleOf(int row) => _arena.BundleOf(row);

    /// <summary>Number of rows at a body.</summary>
    public int Degree(int body) => _degree[body];

    public int* Degrees => _degree.Pointer;

    public void EnsureBodies(int capacity)
    {
        _bodies.EnsureBodies(capacity);
        _degree.EnsureCapacity(capacity);
        Groups.EnsureBodies(capacity);
    }

    /// <summary>Says where the masses are; before, none outweighs another.</summary>
    public void Weigh(BodyStore bodies) => _store = bodies;

    /// <summary>Says how many pairs the world has.</summary>
    public void NotePairs(int count) => _isSmall = count <= FewPairs;

    /// <summary>Makes room for so many rows.</summary>
    public void Reserve(int rows)
    {
        _arena.Reserve(rows);
        _moving.Reserve(rows / MovedPart);
    }

    public void Add(int contact, ref ContactRecord record, bool movesA, bool movesB)
    {
        NeedGroups(1);
        int color = _bodies.Choose(record.BodyA, record.BodyB, movesA, movesB, _isSmall && RowCount >= FirstRows ? ColorsToFill() : 0);
        int heavy = movesA && movesB && color >= BodyColors.Drawn ? TryShare(record, ref color) : NoBody;
        int group =
            IsWhole(color) ? 0 : Groups.Choose(record.BodyA, record.BodyB, movesA, movesB, _degree[record.BodyA], _degree[record.BodyB]);
        GraphColor rows = _colors[group][color];
        _usedChanged |= rows.RowCount == 0;
        int row = rows.AddRow();
        ContactLanes.Name(_arena.BundleOf(row), RowArena.LaneOf(row), contact, record);
        record.Color = (sbyte)color;
        record.Group = (byte)group;
        record.Row = row;
        Mark(record.BodyA, color, movesA && record.BodyA != heavy);
        Mark(record.BodyB, color, movesB && record.BodyB != heavy);
        RowCount++;
        NewRows++;
        Note(record, contact);
    }

    public void Remove(ref ContactRecord record, Column<ContactRecord> records)
    {
        int color = record.Color;
        TakeOut(_colors[record.Group][color], record.Row, records);
        Unmark(record.BodyA, color);
        Unmark(record.BodyB, color);
        record.Color = -1;
        record.Group = 0;
        RowCount--;
        _sharedRows -= BodyColors.IsShared(color) ? 1 : 0;
        Note(record, GraphChange.Gone);
    }

    /// <summary>Lays a row to rest as it is.</summary>
    public void LayDown(ref ContactRecord record, Column<ContactRecord> records)
    {
        int row = _colors[0][Dormant].AddRow();
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
        TakeOut(_colors[0][Dormant], row, records);
    }

    /// <summary>
    /// Moves all rows to the groups of their bodies. Rows of one colour share no body, and those of one group keep their order, so that no
    /// result follows from it but by rounding where the contacts of an island are listed.
    /// </summary>
    /// <param name="records">Where the rows are.</param>
    /// <param name="moves">1 for a body that can move.</param>
    public void Regroup(Column<ContactRecord> records, byte* moves)
    {
        NeedGroups(Groups.InUse);
        for (int color = 0; color < ColorCount; color++)
        {
            ListMoving(color, moves);
            for (int i = 0; i < _moving.Count; i++)
            {
                ref ContactRecord record = ref records[_moving[i]];
                int group = GroupOf(color, record.BodyA, record.BodyB, moves);
                int row = _colors[group][color].AddRow();
                Move(record.Row, row);
                TakeOut(_colors[record.Group][color], record.Row, records);
                record.Row = row;
                record.Group = (byte)group;
            }
        }

        _usedChanged = true;
    }

    /// <summary>
    /// Gives rows that may no longer be solved side by side a colour of their own: those that bounce, whose impacts have an order, and
    /// those of bodies whose masses are others now.
    /// </summary>
    public void RecallShared(Column<ContactRecord> records)
    {
        if (_sharedRows == 0)
        {
            return;
        }

        _moving.Clear();
        for (int color = BodyColors.FirstShared; color < BodyColors.Dynamic; color++)
        {
            for (int i = 0; i < _colors.Count; i++)
            {
                foreach (ContactBundle* bundle in _colors[i][color].Bundles)
                {
                    for (int lane = 0; lane < ContactBundle.Lanes && bundle->Contact[lane] >= 0; lane++)
                    {
                        if (bundle->Restitution[lane] != 0 || !IsStillHeavy(bundle->BodyA[lane], bundle->BodyB[lane], color))
                        {
                            _moving.Add(bundle->Contact[lane]);
                        }
                    }
                }
            }
        }

        for (int i = 0; i < _moving.Count; i++)
        {
            Recall(ref records[_moving[i]], records);
        }
    }

    /// <summary>Lets two rows of a colour change places.</summary>
    public void Exchange(int row, int other, Column<ContactRecord> records)
    {
        if (row == other)
        {
            return;
        }

        ContactBundle* bundle = _arena.BundleOf(row);
        ContactBundle* otherBundle = _arena.BundleOf(other);
        int lane = RowArena.LaneOf(row);
        int otherLane = RowArena.LaneOf(other);
        ContactLanes.ExchangeLanes(bundle, lane, otherBundle, otherLane);
        records[bundle->Contact[lane]].Row = row;
        records[otherBundle->Contact[otherLane]].Row = other;
    }

    /// <summary>The rows are in order.</summary>
    public void ForgetNewRows() => NewRows = 0;

    /// <summary>Lays a row to rest for as long as others are solved: no island is to hear of it.</summary>
    public void SetAside(ref ContactRecord record, Column<ContactRecord> records)
    {
        bool changed = Changed;
        int count = ChangeCount;
        LayDown(ref record, records);
        Changed = changed;
        ChangeCount = count;
    }

    /// <summary>Takes up a row of two bodies that can move which was set aside.</summary>
    public void PutBack(int contact, ref ContactRecord record, Column<ContactRecord> records)
    {
        bool changed = Changed;
        int count = ChangeCount;
        TakeUp(contact, ref record, records, movesA: true, movesB: true);
        NewRows--;
        Changed = changed;
        ChangeCount = count;
    }

    /// <summary>The islands are up to date.</summary>
    public void ForgetChanges()
    {
        Changed = false;
        ChangeCount = 0;
    }

    /// <summary>Gives a row whose bodies can both move a shared colour if one of them is heavy enough.</summary>
    /// <returns>That one.</returns>
    private int TryShare(in ContactRecord record, ref int color)
    {
        int heavy = Heavier(record.BodyA, record.BodyB);
        int shared = heavy == NoBody ? -1 : _bodies.ChooseShared(heavy == record.BodyA ? record.BodyB : record.BodyA, heavy);
        if (shared < 0)
        {
            return NoBody;
        }

        color = shared;
        _sharedRows++;
        return heavy;
    }

    /// <summary>The body that outweighs the other by far, whatever part of it is met.</summary>
    private int Heavier(int a, int b) => _store == null ? NoBody : Outweighs(_store, a, b) ? a : Outweighs(_store, b, a) ? b : NoBody;

    /// <summary>The one that is heavy now is so since the row came: the other has its colour.</summary>
    private bool IsStillHeavy(int a, int b, int color)
    {
        int heavy = Heavier(a, b);
        return heavy != NoBody && !_bodies.Has(heavy, color);
    }

    private static bool Outweighs(BodyStore bodies, int heavy, int light)
    {
        float reach = bodies.Size[heavy].Reach;
        float answer = bodies.Mass[heavy].InverseMass + (bodies.Mass[heavy].InverseInertia * reach * reach);
        return HeavyRatio * answer <= bodies.Mass[light].InverseMass;
    }

    private void Recall(ref ContactRecord record, Column<ContactRecord> records)
    {
        int shared = record.Color;
        _bodies.Unmark(record.BodyA, shared);
        _bodies.Unmark(record.BodyB, shared);
        int color = _bodies.Choose(record.BodyA, record.BodyB, movesA: true, movesB: true);
        _bodies.Mark(record.BodyA, color, moves: true);
        _bodies.Mark(record.BodyB, color, moves: true);
        int row = _colors[record.Group][color].AddRow();
        Move(record.Row, row);
        TakeOut(_colors[record.Group][shared], record.Row, records);
        record.Color = (sbyte)color;
        record.Row = row;
        _usedChanged = true;
        _sharedRows--;
    }

    /// <summary>The colours that a row can join without another bundle.</summary>
    private ulong ColorsToFill()
    {
        ulong colors = 0;
        for (int i = 0; i < BodyColors.Drawn; i++)
        {
            colors |= _colors[0][i].RowCount % ContactBundle.Lanes != 0 ? 1UL << i : 0;
        }

        return colors;
    }

    private int GroupOf(int color, int a, int b, byte* moves) => IsWhole(color) ? 0 : Groups.Of(a, b, moves[a] != 0, moves[b] != 0);

    /// <summary>Not halved: rows that one worker solves in their order, and colours of few.</summary>
    private bool IsWhole(int color) =>
        Groups.AreHalves && (_colors[0][color].HasOrder || _colors[0][color].RowCount + _colors[1][color].RowCount < Groups.LeastOfColor);

    /// <summary>Lists the contacts of a colour whose rows are in another group than they belong to, and takes room for them.</summary>
    private void ListMoving(int color, byte* moves)
    {
        _moving.Clear();
        _counts.EnsureCapacity(Groups.InUse);
        for (int i = 0; i < Groups.InUse; i++)
        {
            _counts[i] = 0;
        }

        for (int i = 0; i < _colors.Count; i++)
        {
            foreach (ContactBundle* bundle in _colors[i][color].Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    int group = GroupOf(color, bundle->BodyA[lane], bundle->BodyB[lane], moves);
                    if (bundle->Contact[lane] >= 0 && group != i)
                    {
                        _moving.Add(bundle->Contact[lane]);
                        _counts[group]++;
                    }
                }
            }
        }

        for (int i = 0; i < Groups.InUse; i++)
        {
            if (_counts[i] > 0)
            {
                _colors[i][color].Reserve(_counts[i]);
            }
        }
    }

    private void TakeOut(GraphColor color, int row, Column<ContactRecord> records)
    {
        int moved = color.RemoveRow(row);
        if (moved >= 0)
        {
            records[moved].Row = row;
        }

        _usedChanged |= color.RowCount == 0;
    }

    /// <summary>Makes the colours of so many groups.</summary>
    private void NeedGroups(int count)
    {
        while (_colors.Count < count)
        {
            int group = _colors.Count;
            var colors = new GraphColor[ColorCount + 1];
            for (int i = 0; i < ColorCount; i++)
            {
                int color = BodyColors.InOrder(i);
                colors[color] =
                    new GraphColor(_arena, color >= BodyColors.Masked, BodyColors.IsGrounded(color), i, group, BodyColors.IsShared(color));
            }

            colors[Dormant] = new GraphColor(_arena);
            _colors.Add(colors);
        }
    }

    private void Move(int from, int to) =>
        ContactLanes.MoveLane(_arena.BundleOf(from), RowArena.LaneOf(from), _arena.BundleOf(to), RowArena.LaneOf(to));

    private void Note(in ContactRecord record, int contact)
    {
        Changed = true;
        if (ChangeCount < MostChanges)
        {
            _changes.EnsureCapacity(Math.Max(ChangeCount + 1, Math.Min(MostChanges, _arena.Capacity * ContactBundle.Lanes)));
            _changes[ChangeCount] = new GraphChange { BodyA = record.BodyA, BodyB = record.BodyB, Contact = contact };
        }

        ChangeCount = Math.Min(ChangeCount + 1, MostChanges + 1);
    }

    private void Mark(int body, int color, bool moves)
    {
        _degree[body]++;
        _bodies.Mark(body, color, moves);
    }

    private void Unmark(int body, int color)
    {
        _bodies.Unmark(body, color);
        if (--_degree[body] == 0)
        {
            Groups.Put(body, 0);
            _bodies.Clear(body);
        }
    }
}
