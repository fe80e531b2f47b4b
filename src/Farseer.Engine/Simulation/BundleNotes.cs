using Farseer.Engine.Contacts;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// What the updates of many bundles add up to, and which of them something follows from: these are few, and so one thread walks over them
/// afterwards, in their order. To look at the outcomes of all took it up to a sixtieth of a step, most of it waiting for what the other
/// workers had written.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class BundleNotes
{
    /// <summary>Sums from one worker's to the next: two cache lines.</summary>
    private const int Spread = 8;

    private readonly Column<BundleSums> _sums = new Column<BundleSums>();
    private byte* _notes;

    /// <summary>Makes room for so many bundles, in scratch memory, and begins the sums.</summary>
    public void Begin(StageRunner runner, Scratch scratch, int count)
    {
        _notes = scratch.Take<byte>(count);
        _sums.EnsureCapacity(runner.Workers * Spread);
        for (int i = 0; i < runner.Workers; i++)
        {
            _sums[i * Spread] = default;
        }
    }

    /// <summary>Writes down which pairs of a bundle something follows from: each bundle once.</summary>
    public void Note(int bundle, int lanes) => _notes[bundle] = (byte)lanes;

    /// <summary>Adds what a range came to.</summary>
    public void Add(int worker, in BundleSums sums) => _sums[worker * Spread].Add(sums);

    /// <summary>What all ranges came to.</summary>
    public BundleSums Total(StageRunner runner)
    {
        BundleSums total = default;
        for (int i = 0; i < runner.Workers; i++)
        {
            total.Add(_sums[i * Spread]);
        }

        return total;
    }

    /// <summary>The first noted bundle of a range, or <paramref name="to"/>.</summary>
    public int Next(int from, int to) => ByteMarks.Next(_notes, from, to);
}

/// <summary>Numbers of pairs that the narrow phase counts: 16 bytes.</summary>
internal struct BundleSums
{
    public int Touching;
    public int TouchingNow;
    public int Hulls;

    /// <summary>A pair has a listener.</summary>
    public bool AnyHeard;

    /// <summary>A contact can bounce.</summary>
    public bool AnyBounce;

    /// <summary>Adds the pairs of a bundle.</summary>
    public void Add(in ContactFates fates)
    {
        Touching += BitSet.CountBits(fates.Touching);
        TouchingNow += BitSet.CountBits(fates.TouchingNow);
        Hulls += BitSet.CountBits(fates.Hulls);
        AnyHeard |= fates.Heard != 0;
    }

    /// <summary>Notes whether contacts of a bundle can bounce.</summary>
    public unsafe void NoteBounces(ContactBundle* bundle) => AnyBounce |= BounceKernel.Bounces(bundle);

    public void Add(in BundleSums other)
    {
        Touching += other.Touching;
        TouchingNow += other.TouchingNow;
        Hulls += other.Hulls;
        AnyHeard |= other.AnyHeard;
        AnyBounce |= other.AnyBounce;
    }
}
