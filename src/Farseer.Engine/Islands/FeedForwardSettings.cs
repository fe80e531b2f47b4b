using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Islands;

/// <summary>
/// The time constant of the feed-forward of each island, and whether it is deep. The feed-forward acts as an integral term on
/// an oscillator and is stable only if it is slow against the island's slowest mode. With Δ the sum over the levels of the
/// static sag, g/Δ estimates the square of that mode's frequency; τ = 16·√(Δ/g) stood in every scene, below 8 tall stacks
/// swing themselves up.
/// </summary>
internal sealed unsafe class FeedForwardSettings : IStageWork
{
    /// <summary>Seconds.</summary>
    public const float ShortestTime = 0.05f;

    private const float TimeFactor = 16f;
    private const float LongestTime = 20f;

    /// <summary>Safely below the square of a time that is as short as it may be, (0.05 s / 16)².</summary>
    private const float ShortSquare = 9.7e-6f;

    /// <summary>What a bound is taken by, so that no rounding lets something pass that the quotients would not.</summary>
    private const float NearlyAll = 0.999f;

    /// <summary>
    /// The same in substeps, for each time that a contact holds the weight of its lighter body. Under a load of R times its own weight
    /// a box damps the mode by 1/√R only, for the passes give the load R times less than it gives the box; a feed-forward quicker than
    /// about R/4 substeps swings it up: 1:10⁵ was thrown over.
    /// </summary>
    private const float LoadFactor = 0.25f;

    /// <summary>Bundles that are worth another worker's while, some 0.5 µs.</summary>
    private const int LeastBundles = 32;

    [NotState(Why.OfOneStep)]
    private ColorRanges _ranges = null!;
    private readonly DeepStacks _deepStacks = new DeepStacks();
    [NotState(Why.Elsewhere)]
    private IslandStore _islands = null!;
    private float* _sags;
    private readonly Column<float> _deep = new Column<float>();
    private float* _rate;
    [NotState(Why.OfOneStep)]
    private ContactCoefficients _coefficients;
    private int _slots;
    [NotState(Why.OfOneStep)]
    private bool _writes;
    private bool _anyDeep;
    private bool _isOneForAll;

    /// <summary>Some row has a surface far from its body.</summary>
    [NotState(Why.OfOneStep)]
    public bool AnyFar { get; private set; }

    /// <summary>Whether an island is pushed apart in this step.</summary>
    public bool IsDeep(int island) => _deep[island] > 0;

    /// <summary>Makes room for the islands of so many bodies.</summary>
    public void Reserve(int bodyEnd)
    {
        _deep.EnsureCapacity(bodyEnd);
        _deepStacks.Reserve(bodyEnd);
    }

    /// <summary>Writes rate and deepness into every row.</summary>
    /// <returns>True if any island is deep.</returns>
    public bool Apply(StageRunner runner, IslandStore islands, ConstraintGraph graph, in ContactCoefficients c, bool cold, Scratch scratch)
    {
        _islands = islands;
        int mark = scratch.Mark;
        _rate = scratch.Take<float>(Math.Max(1, islands.Count));
        _ranges = graph.NumberBundles(runner.Workers);
        CollectSag(runner, islands, c, scratch);
        _anyDeep = _deepStacks.Find(islands, graph, c, cold, scratch, _deep.Pointer, _anyDeep);
        _isOneForAll = FindRates(islands, c) && !_anyDeep;
        _writes = true;
        runner.Run(this, _ranges.Count, LeastBundles);
        scratch.Release(mark);
        return _anyDeep;
    }

    /// <summary>The rate of each island, from the sags of its levels.</summary>
    /// <returns>True if all have the same.</returns>
    private bool FindRates(IslandStore islands, in ContactCoefficients c)
    {
        float weight = c.Sag(c.Gravity * c.Substep);
        float* sags = _sags;
        float* rates = _rate;
        int* firstSlot = islands.FirstSlot;
        float fastest = Math.Min(1f, c.Substep / ShortestTime);

        // Single bodies and low stacks have the shortest time of all: to know that takes no quotient.
        float shortSag = NearlyAll * ShortSquare * c.Gravity;
        float shortLoad = NearlyAll * ShortestTime / (LoadFactor * c.Substep) * weight;
        bool same = true;
        int slot = firstSlot[0];
        for (int i = 0; i < islands.Count; i++)
        {
            float sag = 0;
            float largest = 0;
            for (int end = firstSlot[i + 1]; slot < end; slot++)
            {
                sag += sags[slot];
                largest = Math.Max(largest, sags[slot]);
            }

            if (sag < shortSag && largest < shortLoad)
            {
                rates[i] = fastest;
            }
            else
            {
                rates[i] = Math.Min(1f, c.Substep / TimeOf(sag, largest / weight, c));
            }

            same &= rates[i] == rates[0];
        }

        return same;
    }

    /// <summary>The time constant of an island, s.</summary>
    private static float TimeOf(float sag, float weights, in ContactCoefficients c) =>
        c.Gravity > 0 ? Math.Max(SlowestTime(sag / c.Gravity), LoadFactor * weights * c.Substep) : LongestTime;

    void IStageWork.Run(int worker, int from, int to)
    {
        while (from < to)
        {
            BundleRuns runs = _ranges.From(from, to, out from);
            while (runs.Next())
            {
                if (_writes)
                {
                    WriteRows(runs.Bundles, runs.Count);
                }
                else
                {
                    CollectSag(runs.Bundles, runs.Count, _sags + ((long)worker * _slots), _coefficients);
                }
            }
        }
    }

    /// <summary>By the slowest mode of an island.</summary>
    /// <param name="square">The square of its time, 1/ω², s².</param>
    private static float SlowestTime(float square)
    {
        // A single body on something: no root is needed to know.
        if (square < ShortSquare)
        {
            return ShortestTime;
        }

        float time = TimeFactor * (float)Math.Sqrt(square);
        return time < ShortestTime ? ShortestTime : time > LongestTime ? LongestTime : time;
    }

    /// <summary>Each worker finds the largest sags of its rows; the largest of these are those of all rows, in any order.</summary>
    private void CollectSag(StageRunner runner, IslandStore islands, in ContactCoefficients c, Scratch scratch)
    {
        _slots = islands.SlotCount;
        int workers = runner.IsShared(_ranges.Count, LeastBundles) ? runner.Workers : 1;
        _sags = scratch.Take<float>(Math.Max(1, workers * _slots));
        new Span<float>(_sags, workers * _slots).Clear();
        _deep.EnsureCapacity(islands.Count);
        new Span<float>(_deep.Pointer, islands.Count).Clear();

        _coefficients = c;
        _writes = false;
        _anyDeep = false;
        AnyFar = false;
        runner.Run(this, _ranges.Count, LeastBundles);
        for (int i = 0; i < _slots; i++)
        {
            for (int k = i + _slots; k < workers * _slots; k += _slots)
            {
                _sags[i] = Math.Max(_sags[i], _sags[k]);
            }
        }
    }

    [MethodImpl(KernelMethod.Optimized)]
    private void CollectSag(ContactBundle* rows, int count, float* slotSag, in ContactCoefficients c)
    {
        float* sags = stackalloc float[ContactBundle.Lanes];
        for (ContactBundle* row = rows; count > 0; count--, row = ContactBundle.Next(row))
        {
            ContactBundle.AskAhead(row->Point0.Normal);
            ContactBundle.AskAhead(row->Point1.Normal);
            ContactBundle.AskAhead(row->K11);
            ContactBundle.AskAhead(row->Flags);
            ContactBundle.AskAhead(row->Slot);
            int marked = 0;
            int above = 0;
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                Wide load = Wide.Max(
                    Wide.Load(row->Point0.Normal + lane) * Wide.Load(row->K11 + lane),
                    Wide.Load(row->Point1.Normal + lane) * Wide.Load(row->K22 + lane));
                Wide sag = WideCoefficients.Sag(c, load);
                sag.Store(sags + lane);
                above |= WideLanes.Bits(sag > WideTable.Read(slotSag, row->Slot + lane)) << lane;
                WideMask far = ContactBundle.Has(row, lane, ContactBundle.FarMark);
                marked |= WideLanes.Bits(ContactBundle.Has(row, lane, ContactBundle.DeepMark) | far) << lane;
            }

            // An empty lane has no sag, and changes nothing in slot 0. Lanes of the same slot may all be above what it was.
            for (int lane = 0; above != 0; lane++, above >>= 1)
            {
                int slot = row->Slot[lane];
                if ((above & 1) != 0 && sags[lane] > slotSag[slot])
                {
                    slotSag[slot] = sags[lane];
                }
            }

            // The mark of an empty lane says nothing: it was given to all lanes of the bundle.
            for (int lane = 0; marked != 0; lane++, marked >>= 1)
            {
                if ((marked & 1) == 0 || row->Contact[lane] < 0)
                {
                    continue;
                }

                if ((row->Flags[lane] & ContactBundle.FarMark) != 0)
                {
                    AnyFar = true;
                }

                if ((row->Flags[lane] & ContactBundle.DeepMark) != 0)
                {
                    _deep[_islands.OfSlot[row->Slot[lane]]] = 1;
                    _anyDeep = true;
                }
            }
        }
    }

    /// <summary>Most bundles are of one island, or all islands alike: their columns are written in one go.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    private void WriteRows(ContactBundle* rows, int count)
    {
        if (_isOneForAll)
        {
            WriteAll(rows, count);
            return;
        }

        float* rates = _rate;
        float* deeps = _deep.Pointer;
        int* ofSlot = _islands.OfSlot;
        int* firstSlot = _islands.FirstSlot;
        int* islands = stackalloc int[ContactBundle.Lanes];
        for (ContactBundle* row = rows; count > 0; count--, row = ContactBundle.Next(row))
        {
            ContactBundle.AskAhead(row->Slot);
            ContactBundle.AskAhead(row->FeedRate);
            ContactBundle.AskAhead(row->Flags);
            int first = ofSlot[row->Slot[0]];
            if (IsOfOne(row->Slot, firstSlot[first], firstSlot[first + 1]))
            {
                WideMask deep = deeps[first] > 0 ? WideLanes.AllSet : ~WideLanes.AllSet;
                for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
                {
                    Wide.Splat(rates[first]).Store(row->FeedRate + lane);
                    ContactBundle.Mark(row, lane, deep, ContactBundle.DeepMark);
                }

                continue;
            }

            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                WideTable.ReadThrough(rates, ofSlot, row->Slot + lane, islands + lane).Store(row->FeedRate + lane);
                ContactBundle.Mark(row, lane, WideTable.Read(deeps, islands + lane) > Wide.Zero, ContactBundle.DeepMark);
            }
        }
    }

    /// <summary>None is deep, and all have one rate.</summary>
    private void WriteAll(ContactBundle* rows, int count)
    {
        Wide rate = Wide.Splat(_rate[0]);
        for (ContactBundle* row = rows; count > 0; count--, row = ContactBundle.Next(row))
        {
            ContactBundle.AskAhead(row->FeedRate);
            ContactBundle.AskAhead(row->Flags);
            for (int lane = 0; lane < ContactBundle.Lanes; lane += Wide.Count)
            {
                rate.Store(row->FeedRate + lane);
                ContactBundle.Mark(row, lane, ~WideLanes.AllSet, ContactBundle.DeepMark);
            }
        }
    }

    /// <summary>All slots of a bundle are those of one island.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsOfOne(int* slots, int from, int end)
    {
        bool all = true;
        for (int lane = 0; lane < ContactBundle.Lanes; lane++)
        {
            all &= (uint)(slots[lane] - from) < (uint)(end - from);
        }

        return all;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        _deepStacks.Visit(s);
        s.Column(_deep);
        s.Value(ref _slots);
        s.Value(ref _anyDeep);
        s.Value(ref _isOneForAll);
    }
}
