using Farseer.Engine.Contacts;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <summary>
/// The bundles in which a body's contacts lie: after an impact only those at its bodies can have another. Asking every bundle of a
/// large pile in each of many rounds was dearer than the impacts.
/// </summary>
internal sealed unsafe class ImpactNeighbors
{
    /// <summary>Ends of a bundle's contacts: two a lane.</summary>
    private const int Ends = 2 * ContactBundle.Lanes;

    // A chain for each body: an end names the next one of its body, -1 the last.
    private readonly Column<int> _first = new Column<int>();
    private readonly Column<int> _next = new Column<int>();
    private readonly BitSet _marked = new BitSet();
    private bool _linked;
    private int _bodyEnd;

    /// <summary>The bundles marked since the last call of <see cref="Take"/>, in ascending order.</summary>
    public IndexList Taken { get; } = new IndexList();

    /// <summary>Makes room.</summary>
    public void Reserve(int capacity, int bodies)
    {
        _first.EnsureCapacity(bodies);
        _next.EnsureCapacity(capacity * Ends);
        Taken.Reserve(capacity);
        _marked.Set(capacity);
    }

    /// <summary>Forgets all.</summary>
    /// <param name="capacity">Bundles that there may be.</param>
    /// <param name="bodyEnd">One past the highest body.</param>
    public void Begin(int capacity, int bodyEnd)
    {
        Reserve(capacity, bodyEnd);
        _linked = false;
        _bodyEnd = bodyEnd;
        _marked.ClearAll();
    }

    /// <summary>Finds the bundles of all bodies, once a step.</summary>
    public void Link(BounceLanes* bounces, int count)
    {
        if (_linked)
        {
            return;
        }

        _linked = true;
        _next.EnsureCapacity(count * Ends);
        new System.Span<int>(_first.Pointer, _bodyEnd).Fill(-1);

        for (int i = 0; i < count; i++)
        {
            ContactBundle* row = bounces[i].Row;
            for (int lane = 0; lane < ContactBundle.Lanes; lane++)
            {
                int end = (i * Ends) + (2 * lane);
                Link(row->BodyA[lane], row->MassA[lane] + row->InertiaA[lane], end);
                Link(row->BodyB[lane], row->MassB[lane] + row->InertiaB[lane], end + 1);
            }
        }
    }

    /// <summary>Marks the bundles of a body that an impact changed.</summary>
    public void Mark(int body)
    {
        for (int end = _first[body]; end >= 0; end = _next[end])
        {
            _marked.Set(end / Ends);
        }
    }

    /// <summary>Moves what is marked to <see cref="Taken"/>.</summary>
    public void Take()
    {
        Taken.Clear();
        for (int i = _marked.Next(0); i >= 0; i = _marked.Next(i + 1))
        {
            Taken.Add(i);
        }

        _marked.ClearAll();
    }

    private void Link(int body, float answer, int end)
    {
        if (answer > 0)
        {
            _next[end] = _first[body];
            _first[body] = end;
        }
    }
}
