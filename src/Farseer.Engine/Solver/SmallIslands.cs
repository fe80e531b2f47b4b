using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <summary>A contact of a small island, and where its impacts are described; -1: it has none.</summary>
internal unsafe struct SmallIslandRow
{
    public ContactBundle* Row;
    public int Lane;
    public int Bounce;
    public int Next;
}

/// <summary>The islands whose contacts are few enough to be solved directly: their rows, island by island.</summary>
internal sealed unsafe class SmallIslands
{
    /// <summary>Contacts of the largest: twice as many points, for which a factor takes 0.1 ms.</summary>
    public const int MostContacts = 32;

    private const int TooMany = int.MaxValue / 2;

    private readonly Column<int> _rows = new Column<int>();
    private readonly Column<int> _heads = new Column<int>();
    private readonly Column<SmallIslandRow> _entries = new Column<SmallIslandRow>();
    private int* _islandOfSlot;
    private int _count;
    private int _next;

    public ref SmallIslandRow this[int entry] => ref _entries[entry];

    /// <summary>The first row of a small island; the entries name the next one, -1 behind the last.</summary>
    public int First(int island) => _heads[island];

    public int IslandOf(ContactBundle* row, int lane) => _islandOfSlot[row->Slot[lane]];

    /// <summary>The contact is not the only one of its island, which is small.</summary>
    public bool IsShared(ContactBundle* row, int lane) => Has(row, lane) && _rows[IslandOf(row, lane)] > 1;

    public bool Has(ContactBundle* row, int lane) => _rows[IslandOf(row, lane)] <= MostContacts;

    /// <summary>Makes room for so many bodies, and a row of each.</summary>
    public void Reserve(int bodies)
    {
        _rows.EnsureCapacity(bodies + 1);
        _heads.EnsureCapacity(bodies + 1);
        _entries.EnsureCapacity(bodies);
    }

    /// <summary>Lists the rows of small islands.</summary>
    /// <param name="colors">All rows.</param>
    /// <param name="islands">Of which.</param>
    /// <param name="joints">Bodies that hang on joints answer as more than themselves: their islands are none.</param>
    public void Find(ReadOnlySpan<GraphColor> colors, IslandStore islands, JointSolver? joints)
    {
        _count = 0;
        _next = 0;
        _islandOfSlot = islands.OfSlot;
        int end = Math.Max(1, islands.Count);
        for (int i = 0; i < end; i++)
        {
            _rows[i] = 0;
            _heads[i] = -1;
        }

        for (int step = 0; step < 2; step++)
        {
            for (int k = 0; k < colors.Length; k++)
            {
                foreach (ContactBundle* row in colors[k].Bundles)
                {
                    for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                    {
                        if (row->Contact[lane] >= 0)
                        {
                            Note(row, lane, joints, step > 0);
                        }
                    }
                }
            }
        }
    }

    /// <summary>Names the place where the impacts of a bundle are described. Bundles are named in the order of the rows.</summary>
    public void Bind(ContactBundle* row, int bounce)
    {
        for (; _next < _count && _entries[_next].Row == row; _next++)
        {
            _entries[_next].Bounce = bounce;
        }
    }

    /// <summary>In the order of their pieces: where their rows are, and how contacts are numbered, is to change no bit.</summary>
    private void Insert(int island, int entry)
    {
        long pair = PairOf(entry);
        int before = -1;
        for (int k = _heads[island]; k >= 0 && PairOf(k) < pair; k = _entries[k].Next)
        {
            before = k;
        }

        ref int link = ref before < 0 ? ref _heads[island] : ref _entries[before].Next;
        _entries[entry].Next = link;
        link = entry;
    }

    private long PairOf(int entry)
    {
        SmallIslandRow row = _entries[entry];
        return ((long)row.Row->PieceA[row.Lane] << 32) | (uint)row.Row->PieceB[row.Lane];
    }

    private void Note(ContactBundle* row, int lane, JointSolver? joints, bool list)
    {
        int island = IslandOf(row, lane);
        if (!list)
        {
            bool jointed = joints != null && (joints.Holds(row->BodyA[lane]) || joints.Holds(row->BodyB[lane]));
            _rows[island] = jointed ? TooMany : _rows[island] + 1;
        }
        else if (_rows[island] <= MostContacts)
        {
            _entries.EnsureCapacity(_count + 1);
            _entries[_count] = new SmallIslandRow { Row = row, Lane = lane, Bounce = -1, Next = -1 };
            Insert(island, _count++);
        }
    }
}
