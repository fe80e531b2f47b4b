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

    /// <summary>The place of its bundle among all.</summary>
    public int Place;
}

/// <summary>
/// Islands whose contacts are few enough to be solved directly, those of them in which something new has come to touch: their rows, island
/// by island.
/// </summary>
internal sealed unsafe class SmallIslands
{
    /// <summary>Contacts of the largest, which have two points each.</summary>
    public const int MostContacts = ContactSystem.MostPoints / 2;

    /// <summary>
    /// First rows of islands that are not asked for, or whose bodies hang on joints: these answer as more than themselves.
    /// </summary>
    private const int Unasked = -2;
    private const int Jointed = -3;

    private readonly Column<int> _heads = new Column<int>();
    private readonly Column<SmallIslandRow> _entries = new Column<SmallIslandRow>();
    private IslandStore? _islands;
    private int _count;
    private int _next;

    /// <summary>Some island is asked for.</summary>
    public bool Any { get; private set; }

    public ref SmallIslandRow this[int entry] => ref _entries[entry];

    /// <summary>The first row of a small island; the entries name the next one, -1 behind the last.</summary>
    public int First(int island) => _heads[island];

    public int IslandOf(ContactBundle* row, int lane) => _islands!.OfSlot[row->Slot[lane]];

    /// <summary>A contact is one of an island that is asked for.</summary>
    public bool Has(ContactBundle* row, int lane) => _heads[IslandOf(row, lane)] > Unasked;

    /// <summary>Makes room for all rows that there may be.</summary>
    public void Reserve(int bodies, int bundles)
    {
        _heads.EnsureCapacity(bodies + 1);
        _entries.EnsureCapacity(bundles * ContactBundle.Lanes);
    }

    /// <summary>Lets go of the world.</summary>
    public void Forget() => _islands = null;

    /// <summary>Begins without any.</summary>
    public void Begin(IslandStore islands)
    {
        _islands = islands;
        _count = 0;
        _next = 0;
        Any = false;
        int end = Math.Max(1, islands.Count);
        for (int i = 0; i < end; i++)
        {
            _heads[i] = Unasked;
        }
    }

    /// <summary>Asks for the island of a contact, if it is small and has so many contacts.</summary>
    public void AskFor(ContactBundle* row, int lane, int least)
    {
        int island = IslandOf(row, lane);
        if (_islands!.Count > 0 && _islands.RowsOf(island) is int rows && rows >= least && rows <= MostContacts)
        {
            _heads[island] = -1;
            Any = true;
        }
    }

    /// <summary>Lists the rows of the islands that are asked for.</summary>
    public void Find(ReadOnlySpan<GraphColor> colors, JointSolver? joints)
    {
        int place = 0;
        for (int k = 0; k < colors.Length; k++)
        {
            foreach (ContactBundle* row in colors[k].Bundles)
            {
                ContactBundle.AskAhead(row->Slot);
                for (int lane = 0; lane < ContactBundle.Lanes; lane++)
                {
                    if (row->Contact[lane] >= 0 && _heads[IslandOf(row, lane)] > Unasked)
                    {
                        Note(row, lane, place, joints);
                    }
                }

                place++;
            }
        }
    }

    /// <summary>Names the place where the impacts of a bundle are described. Bundles are named in the order of the rows.</summary>
    /// <param name="place">Which bundle of all it is.</param>
    /// <param name="bounce">Where they are described.</param>
    public void Bind(int place, int bounce)
    {
        for (; _next < _count && _entries[_next].Place <= place; _next++)
        {
            if (_entries[_next].Place == place)
            {
                _entries[_next].Bounce = bounce;
            }
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

    private void Note(ContactBundle* row, int lane, int place, JointSolver? joints)
    {
        int island = IslandOf(row, lane);
        if (joints != null && (joints.Holds(row->BodyA[lane]) || joints.Holds(row->BodyB[lane])))
        {
            _heads[island] = Jointed;
            return;
        }

        _entries[_count] = new SmallIslandRow { Row = row, Lane = lane, Bounce = -1, Next = -1, Place = place };
        Insert(island, _count++);
    }
}
