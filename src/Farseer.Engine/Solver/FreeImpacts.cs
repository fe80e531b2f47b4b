using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;
using Farseer.Engine.Joints;
using Farseer.Engine.Numerics;
using Farseer.Engine.Springs;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <summary>
/// The points of contacts that nothing presses yet, of bodies that touch what cannot move, or one other such body, only. What happens when
/// they meet concerns nobody else, so it happens at its own moment whatever their restitution: without one a body stops there as exactly as
/// it bounces with one. That holds for the second corner of a box that stands on its first one as well. Such impacts are solved directly,
/// for what pushes and what rubs depend on each other: stopped first and rubbed afterwards, a box that lands on a corner turns too far.
/// (What others hold besides is stopped with all of them together, by the passes.)
/// </summary>
internal sealed unsafe class FreeImpacts
{
    private readonly Column<Entry> _entries = new Column<Entry>();

    /// <summary>Contacts of a body with what cannot move of which a point may meet.</summary>
    private readonly Column<int> _atRest = new Column<int>();
    private int _count;
    private int _next;

    /// <summary>Bundles with points that nothing presses yet.</summary>
    public int Count => _count;

    public SmallIslands Small { get; } = new SmallIslands();

    /// <summary>Makes room for all rows that there may be: later steps are not to allocate.</summary>
    public void Reserve(int bodies, int bundles)
    {
        _atRest.EnsureCapacity(bodies);
        _entries.EnsureCapacity(bundles);
        Small.Reserve(bodies, bundles);
    }

    /// <summary>Finds them among the rows.</summary>
    /// <param name="colors">The rows.</param>
    /// <param name="degrees">How many rows each body has.</param>
    /// <param name="joints">What they may hang on.</param>
    /// <param name="springs">The same.</param>
    /// <param name="islands">All islands.</param>
    public void Find(
        System.ReadOnlySpan<GraphColor> colors, int* degrees, JointSolver? joints, SpringStore? springs, IslandStore islands)
    {
        _count = 0;
        _next = 0;
        Small.Begin(islands);
        int place = 0;
        for (int k = 0; k < colors.Length; k++)
        {
            foreach (ContactBundle* row in colors[k].Bundles)
            {
                ContactBundle.AskAhead(row->Point0.Normal);
                int lanes = BounceKernel.UnloadedLanes(row, out int whole);
                if (lanes != 0)
                {
                    _entries[_count++] = new Entry { Row = row, Place = place, Lanes = lanes, Whole = whole };
                }

                place++;
            }
        }

        for (int step = 0; step < 2; step++)
        {
            for (int i = 0; i < _count; i++)
            {
                CountAtRest(_entries[i], step);
            }
        }

        for (int i = 0; i < _count; i++)
        {
            ref Entry entry = ref _entries[i];
            for (int lane = 0; entry.Lanes >> lane != 0; lane++)
            {
                if (((entry.Lanes >> lane) & 1) != 0)
                {
                    // What drives is to bounce once a substep, with both of its points.
                    bool free = IsFree(entry.Row, lane, degrees, joints, springs);
                    bool alone = free && !(entry.Row->Restitution[lane] > 1);
                    entry.Free |= free ? 1 << lane : 0;
                    entry.PointByPoint |= alone ? 1 << lane : 0;
                    if (free || ((entry.Whole >> lane) & 1) != 0)
                    {
                        Small.AskFor(entry.Row, lane, alone ? 1 : 2);
                    }
                }
            }
        }

        if (Small.Any)
        {
            Small.Find(colors, joints);
        }
    }

    /// <summary>One of the bundles, in the order of the rows.</summary>
    /// <param name="index">Which.</param>
    /// <param name="place">Which bundle of all it is.</param>
    public ContactBundle* BundleAt(int index, out int place)
    {
        place = _entries[index].Place;
        return _entries[index].Row;
    }

    /// <summary>
    /// The lanes of a bundle with such contacts, or with contacts between bodies that move of small islands that are asked for: what
    /// presses there now may part and meet again within the step. (What is already held by something that cannot move, and meets more of
    /// it, is the passes' business.) Bundles are asked for in the order of the rows.
    /// </summary>
    /// <param name="row">The bundle.</param>
    /// <param name="free">Those that concern nobody else.</param>
    /// <param name="pointByPoint">Those of which one point may strike while the other is pressed.</param>
    public int LanesOf(ContactBundle* row, out int free, out int pointByPoint)
    {
        free = 0;
        pointByPoint = 0;
        Entry entry = _next < _count && _entries[_next].Row == row ? _entries[_next++] : default;
        free = entry.Free & entry.Whole;
        int lanes = free;
        for (int lane = 0; Small.Any && lane < ContactBundle.Lanes; lane++)
        {
            int bit = 1 << lane;
            if (row->Contact[lane] >= 0 && Small.Has(row, lane))
            {
                lanes |= Mover(row, lane) < 0 ? bit : 0;

                pointByPoint |= entry.PointByPoint & bit;
            }
        }

        free |= pointByPoint;
        return lanes | pointByPoint;
    }

    /// <summary>Counts the contacts at what cannot move; 0 in <paramref name="step"/> begins anew.</summary>
    private void CountAtRest(in Entry entry, int step)
    {
        for (int lane = 0; entry.Lanes >> lane != 0; lane++)
        {
            if (((entry.Lanes >> lane) & 1) != 0 && Mover(entry.Row, lane) is int mover and >= 0)
            {
                _atRest[mover] = step * (_atRest[mover] + 1);
            }
        }
    }

    /// <summary>The one body of a contact that can move; -1: both can.</summary>
    private static int Mover(ContactBundle* row, int lane)
    {
        bool a = row->MassA[lane] + row->InertiaA[lane] > 0;
        bool b = row->MassB[lane] + row->InertiaB[lane] > 0;
        return a == b ? -1 : a ? row->BodyA[lane] : row->BodyB[lane];
    }

    /// <summary>Nobody else is concerned. Several of a body with what cannot move are one problem if they are of one moment.</summary>
    private bool IsFree(ContactBundle* row, int lane, int* degrees, JointSolver? joints, SpringStore? springs)
    {
        int mover = Mover(row, lane);
        if (mover >= 0)
        {
            return degrees[mover] == _atRest[mover] && !IsHeld(mover, joints, springs);
        }

        int a = row->BodyA[lane];
        int b = row->BodyB[lane];
        return degrees[a] == 1 && degrees[b] == 1 && !IsHeld(a, joints, springs) && !IsHeld(b, joints, springs);
    }

    private static bool IsHeld(int body, JointSolver? joints, SpringStore? springs) =>
        (joints != null && joints.Holds(body)) || (springs != null && springs.Touches(body));

    private struct Entry
    {
        public ContactBundle* Row;
        public int Place;
        public int Lanes;
        public int Whole;
        public int Free;
        public int PointByPoint;
    }
}
