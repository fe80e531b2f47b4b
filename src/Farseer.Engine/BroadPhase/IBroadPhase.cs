using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

[System.Flags]
internal enum ProxyFlags : int
{
    None = 0,
    Alive = 1,

    /// <summary>Belongs to a static body: two such proxies never pair.</summary>
    Static = 2,

    /// <summary>Its fat box was set anew in this step (or it is new): it must look for pairs.</summary>
    Moved = 4,
}

/// <summary>What the broad phase knows of a piece; the index is the piece's index.</summary>
internal struct ProxyInfo
{
    public int Body;
    public ProxyFlags Flags;

    /// <summary>Those of one group other than 0 never collide: a search may leave out their pairs.</summary>
    public int Group;
}

/// <summary>
/// The boxes of all pieces. A fat box is the tight box plus predicted motion; it changes only when the tight box leaves it.
/// </summary>
internal sealed class ProxyStore
{
    /// <summary>
    /// Worlds that need so much keep it: a step would be long enough to fill it again, and a thread is not to hold the memory of the
    /// largest.
    /// </summary>
    private const int LargeScratch = 1 << 18;

    private readonly ColumnSet _set = new ColumnSet();
    [NotState(Why.OfOneStep)]
    private Scratch? _lent;
    [NotState(Why.OfOneStep)]
    private Scratch? _own;

    public ProxyStore()
    {
        Fat = _set.Add<Box>();
        Info = _set.Add<ProxyInfo>();
        Sought = _set.Add<Box>();
    }

    public Column<Box> Fat { get; }

    public Column<ProxyInfo> Info { get; }

    /// <summary>
    /// The fat box around which a piece last found its pairs. Two whose boxes of then overlap are a pair already, so a search may leave
    /// them out; a box that overlaps nothing is that of a piece of which this is not known. Outside of searches and what follows from them
    /// it is the fat box itself.
    /// </summary>
    public Column<Box> Sought { get; }

    /// <summary>Memory for the time of a step: what was lent for it, else its own.</summary>
    public Scratch Scratch => _lent ?? (_own ??= new Scratch());

    /// <summary>Its own is so large that nobody need lend it any.</summary>
    public bool HasScratch => _own?.Capacity >= LargeScratch;

    /// <summary>Lends memory for a step.</summary>
    public void Lend(Scratch scratch) => _lent = scratch;

    /// <summary>Gives back what was lent.</summary>
    /// <returns>Null: it has become so large that it is kept.</returns>
    public Scratch? GiveBack()
    {
        Scratch? lent = _lent;
        _lent = null;
        if (lent?.Capacity >= LargeScratch)
        {
            _own = lent;
            return null;
        }

        return lent;
    }

    /// <summary>One past the highest proxy in use.</summary>
    public int End { get; set; }

    public ColumnSet Set => _set;

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(Fat);
        s.Column(Info);
        s.Column(Sought);
        End = s.Value(End);
    }
}

/// <summary>Finds overlapping fat boxes. Implementations differ in speed only: the sets of pairs are the same.</summary>
internal interface IBroadPhase
{
    void Added(ProxyStore proxies, int proxy);

    void Removed(ProxyStore proxies, int proxy);

    /// <summary>
    /// Appends every unordered pair of live proxies whose fat boxes overlap (touching counts), of which at least one is
    /// <see cref="ProxyFlags.Moved"/>, not both <see cref="ProxyFlags.Static"/>, of different bodies; each pair once, in any order. Pairs
    /// of one group may be left out, and those that <see cref="ProxyStore.Sought"/> tells to be known. Who gets another group is removed
    /// and added.
    /// </summary>
    void Collect(ProxyStore proxies, PairBuffer pairs);

    /// <summary>Writes, or reads, what it remembers from search to search.</summary>
    void Visit(StateStream s);
}
