using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Joints;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Runs the narrow phase over all pairs and moves pairs in and out of the graph, in an order set by the state alone.</summary>
internal sealed unsafe class ContactStage : IStageWork
{
    /// <summary>Rows to be taken from one to the one that is asked for.</summary>
    private const int RowsAhead = 2;

    /// <summary>Pairs from one that comes or goes to that whose record is asked for, and to that whose place in the map is.</summary>
    private const int RecordsAhead = 12;
    private const int KeysAhead = 6;

    /// <summary>
    /// Pairs that come to an end, some 5 µs, from which on the map forgets them at the same time as everything else does.
    /// </summary>
    private const int ManyDropped = 128;
    private const int Sides = 2;

    private bool _startedCold;
    private readonly ContactSides _sides = new ContactSides();
    [NotState(Why.OfOneStep)]
    private StepTools _tools = null!;
    private ScratchList<int> _lost;
    private ScratchList<int> _dropped;
    private ScratchList<ulong> _gainKeys;
    private ScratchList<int> _gained;
    private int _touching;
    private int _touchingNow;
    private int _hulls;

    /// <summary>Pairs without rows that were looked at in the last step.</summary>
    private int _looked;
    private ScratchList<ulong> _droppedKeys;
    [NotState(Why.Elsewhere)]
    private ContactStore _contacts = null!;
    [NotState(Why.Elsewhere)]
    private ConstraintGraph _graph = null!;

    /// <summary>Fast pairs that may have nothing to do with any other.</summary>
    public LonePairs Lone { get; } = new LonePairs();

    /// <summary>A contact of the graph can bounce.</summary>
    public bool AnyBounce { get; private set; }

    /// <summary>
    /// At least half of the pairs that touch do so for the first time in this step or the one before: an impact late in a step
    /// ends in the next.
    /// </summary>
    public bool ColdStart { get; private set; }

    /// <summary>A pair has a listener.</summary>
    public bool AnyHeard { get; private set; }

    /// <param name="runner">Who shares the work out.</param>
    /// <param name="tools">What it works with.</param>
    /// <param name="sleep">Its bodies may sleep.</param>
    /// <param name="input">Columns and numbers of this step.</param>
    /// <param name="graph">The rows.</param>
    /// <param name="joints">What holds bodies besides rows.</param>
    /// <param name="allHeld">Every body is in the solver's hands.</param>
    public void Update(
        StageRunner runner,
        StepTools tools,
        SleepStage sleep,
        ContactUpdateInput input,
        ConstraintGraph graph,
        JointStore joints,
        bool allHeld)
    {
        _tools = tools;
        ContactStore contacts = input.Contacts;
        Scratch scratch = input.Scratch;
        int mark = scratch.Mark;
        _tools.ContactUpdate.Begin(scratch.Lasting<WorkerLanes>(runner.Workers));
        graph.NotePairs(contacts.Count);
        _tools.Idle.Begin(input, _hulls, _looked + graph.RowCount);
        if (contacts.Count > 0)
        {
            _tools.ContactUpdate.WriteSides(runner, input, _sides);
        }

        _tools.Idle.FindSteps(runner, input);
        if (_sides.AnyHeard)
        {
            contacts.KeepManifolds();
        }

        input.Sides = _sides.Pointer;
        input.Hulls = _sides.Hulls;
        input.Pairs = _tools.ContactUpdate.Pairs;
        AnyBounce = false;
        AnyHeard = false;
        _touching = 0;
        _touchingNow = 0;
        _hulls = 0;
        _lost = new ScratchList<int>(scratch);
        _dropped = new ScratchList<int>(scratch);
        _droppedKeys = new ScratchList<ulong>(scratch);
        _gainKeys = new ScratchList<ulong>(scratch);
        _gained = new ScratchList<int>(scratch);
        _tools.FastPairs.Begin(scratch);
        _tools.Struck.Begin(runner, input.Bodies, joints, scratch);
        _tools.Meetings.Begin(input.Bodies.State.Capacity, scratch);
        Lone.Begin(input.Bodies.State.Capacity);
        UpdateGraph(runner, input, graph);
        UpdateIdle(runner, input);
        if (sleep.AsleepCount > 0)
        {
            WakeGained(sleep, contacts);
            _tools.FastPairs.Wake(sleep, contacts);
        }

        Take(runner, contacts, graph);
        Give(runner, input, graph);
        _tools.FastPairs.Decide(runner, input, graph, joints, allHeld, _tools.Struck, Lone);
        _tools.Meetings.Find(runner, input, graph, joints);
        if (_tools.Struck.Any)
        {
            GiveStruck(runner, input, graph);
            _tools.Struck.End();
        }

        _tools.Meetings.Write(input);

        scratch.Release(mark);

        AnyBounce = AnyBounce || _tools.FastPairs.AnyBounce;
        _touching += _tools.FastPairs.Given;
        _touchingNow += _tools.FastPairs.Given;
        bool now = _touchingNow > 0 && _touchingNow * 2 >= _touching;
        ColdStart = now || _startedCold;
        _startedCold = now;
        _tools = null!;
    }

    /// <summary>Takes a pair out of the graph and forgets it.</summary>
    public static void Drop(ContactStore contacts, ConstraintGraph graph, int index)
    {
        contacts.Map.Remove(PairKey(contacts.Records[index]));
        Forget(contacts, graph, index);
    }

    /// <summary>Forgets a pair but for its place in the map.</summary>
    private static void Forget(ContactStore contacts, ConstraintGraph graph, int index)
    {
        ref ContactRecord record = ref contacts.Records[index];
        if (record.Color >= 0)
        {
            graph.Remove(ref record, contacts.Records);
            contacts.AddIdle(index);
        }

        contacts.Forget(index);
    }

    public static ulong PairKey(in ContactRecord record) => BroadPhase.PairBuffer.Pack(record.PieceA, record.PieceB);

    /// <summary>Makes room ahead for what is kept where many pairs of hulls have no rows.</summary>
    public void ReserveForGaps(WorldStores stores, ContactStore contacts)
    {
        _sides.Reserve(stores.Shapes);
        contacts.Steps.Reserve(stores.Bodies.State.Capacity);
    }

    /// <summary>Writes the sides of a body that has just fallen asleep: until it wakes they stay as they are.</summary>
    public void WriteSides(WorldStores stores, byte* moves, int piece) =>
        _sides.LayDown(stores.Shapes, stores.Bodies, stores.Proxies.Info.Pointer, moves, piece);

    /// <summary>Pairs of one side asleep are about to get a row: that wakes it, but for those that nothing has moved.</summary>
    private void WakeGained(SleepStage sleep, ContactStore contacts)
    {
        int kept = 0;
        for (int i = 0; i < _gained.Count; i++)
        {
            int index = _gained[i];
            if (sleep.WakeByContact(contacts.Records[index]))
            {
                _gained[kept++] = index;
            }
        }

        _gained.SetCount(kept);
    }

    private void UpdateGraph(StageRunner runner, in ContactUpdateInput input, ConstraintGraph graph)
    {
        Count(_tools.ContactUpdate.UpdateRows(runner, input, graph));
        ColorRanges ranges = _tools.ContactUpdate.Ranges;
        for (int place = 0; place < ranges.Places; place++)
        {
            BundleRuns runs = ranges.At(place, out int first, out int end);
            for (int i = _tools.ContactUpdate.Notes.Next(first, end); i < end; i = _tools.ContactUpdate.Notes.Next(i + 1, end))
            {
                while (i >= first + runs.Count)
                {
                    first += runs.Count;
                    runs.Next();
                }

                SeeTo(input, ContactBundle.At(runs.Bundles, i - first), _tools.ContactUpdate.Outcomes + i);
            }
        }
    }

    /// <summary>Notes what follows for the pairs of a bundle that have rows.</summary>
    private void SeeTo(in ContactUpdateInput input, ContactBundle* bundle, BundleOutcome* outcome)
    {
        ref ContactFates fates = ref outcome->Fates;
        _tools.Struck.Note(input, outcome, bundle->Contact);
        DeferAll(input.Contacts, bundle->Contact, fates.Deferred);
        OfferAll(bundle->Contact, fates.Racing);
        NoteAll(input.Contacts, bundle->Contact, fates.Ahead);
        int leaving = fates.Idle | fates.Dropped;
        for (int lane = 0; leaving != 0; lane++, leaving >>= 1)
        {
            if ((leaving & 1) == 0)
            {
                continue;
            }

            if ((fates.Dropped & (1 << lane)) != 0)
            {
                _dropped.Add(bundle->Contact[lane]);
            }
            else
            {
                _lost.Add(bundle->Contact[lane]);
            }
        }
    }

    private void UpdateIdle(StageRunner runner, in ContactUpdateInput input)
    {
        ContactStore contacts = input.Contacts;
        Count(_tools.Idle.Update(runner, input));
        _looked = _tools.Idle.LookedCount;
        int* pairs = stackalloc int[ContactBundle.Lanes];
        int next = 0;
        int bundles = (_tools.Idle.LookedCount + ContactBundle.Lanes - 1) / ContactBundle.Lanes;
        for (int i = _tools.Idle.Notes.Next(0, bundles); i < bundles; i = _tools.Idle.Notes.Next(i + 1, bundles))
        {
            int first = i * ContactBundle.Lanes;
            ref ContactFates fates = ref _tools.Idle.Outcomes[i].Fates;
            int leaving = fates.Solid | fates.Dropped;
            int lanes = leaving | fates.Deferred | fates.Racing;
            for (int lane = 0; lanes != 0; lane++, lanes >>= 1)
            {
                pairs[lane] = (lanes & 1) != 0 ? contacts.Idle(_tools.Idle.Place(first + lane)) : 0;
            }

            _tools.Struck.Note(input, _tools.Idle.Outcomes + i, pairs);
            DeferAll(contacts, pairs, fates.Deferred);
            OfferAll(pairs, fates.Racing);
            NoteAll(contacts, pairs, fates.Ahead);
            for (int lane = 0; leaving != 0; lane++, leaving >>= 1)
            {
                if ((fates.Dropped & (1 << lane)) != 0)
                {
                    next = DropParted(contacts, next, _tools.Idle.Place(first + lane));
                    _dropped.Add(pairs[lane]);
                }
                else if ((fates.Solid & (1 << lane)) != 0)
                {
                    _gained.Add(pairs[lane]);
                }
            }
        }

        DropParted(contacts, next, contacts.IdleCount);
    }

    /// <summary>
    /// Notes the pairs of a stretch of the idle list that are forgotten without a look: pairs go in the order of the list, looked at or
    /// not.
    /// </summary>
    private int DropParted(ContactStore contacts, int from, int to)
    {
        while (from < to && contacts.KeepsGaps)
        {
            int bundle = _tools.Idle.NextParted(from / ContactBundle.Lanes, (to + ContactBundle.Lanes - 1) / ContactBundle.Lanes);
            int first = bundle * ContactBundle.Lanes;
            from = Math.Max(from, first);
            int end = Math.Min(to, first + ContactBundle.Lanes);
            int parted = from < end ? _tools.Idle.Parted(bundle) >> (from - first) : 0;
            for (; parted != 0 && from < end; from++, parted >>= 1)
            {
                if ((parted & 1) != 0)
                {
                    _dropped.Add(contacts.Idle(from));
                }
            }

            from = end;
        }

        return to;
    }

    private void DeferAll(ContactStore contacts, int* pairs, int lanes)
    {
        for (int lane = 0; lanes != 0; lane++, lanes >>= 1)
        {
            if ((lanes & 1) != 0)
            {
                _tools.FastPairs.Defer(contacts, pairs[lane]);
            }
        }
    }

    private void OfferAll(int* pairs, int lanes)
    {
        for (int lane = 0; lanes != 0; lane++, lanes >>= 1)
        {
            if ((lanes & 1) != 0)
            {
                Lone.Offer(pairs[lane]);
            }
        }
    }

    private void NoteAll(ContactStore contacts, int* pairs, int lanes)
    {
        for (int lane = 0; lanes != 0; lane++, lanes >>= 1)
        {
            if ((lanes & 1) != 0)
            {
                _tools.Meetings.Note(contacts, pairs[lane]);
            }
        }
    }

    private void Count(in BundleSums sums)
    {
        _touching += sums.Touching;
        _touchingNow += sums.TouchingNow;
        _hulls += sums.Hulls;
        AnyHeard |= sums.AnyHeard;
        AnyBounce |= sums.AnyBounce;
    }

    /// <summary>
    /// Takes the rows of lost pairs, and forgets those that are over. What knows pairs by their pieces and what knows them by their numbers
    /// have nothing in common but the pairs, so two workers can clear them at the same time.
    /// </summary>
    private void Take(StageRunner runner, ContactStore contacts, ConstraintGraph graph)
    {
        _contacts = contacts;
        _graph = graph;
        _droppedKeys.SetCount(_dropped.Count);
        for (int i = 0; i < _dropped.Count; i++)
        {
            AskFor(contacts, _dropped, i);
            _droppedKeys[i] = PairKey(contacts.Records[_dropped[i]]);
        }

        runner.Run(this, Sides, _dropped.Count < ManyDropped ? Sides : 1);
    }

    void IStageWork.Run(int worker, int from, int to)
    {
        if (from == 0)
        {
            TakeRows();
        }

        if (to == Sides)
        {
            ForgetKeys();
        }
    }

    private void TakeRows()
    {
        ContactStore contacts = _contacts;
        ConstraintGraph graph = _graph;
        for (int i = 0; i < _lost.Count; i++)
        {
            if (Prefetch.IsUseful)
            {
                AskFor(contacts, _lost, i);
                ContactBundle.AskFor(graph.BundleOf(contacts.Records[_lost[Math.Min(i + RowsAhead, _lost.Count - 1)]].Row));
            }

            graph.Remove(ref contacts.Records[_lost[i]], contacts.Records);
            contacts.AddIdle(_lost[i]);
        }

        for (int i = 0; i < _dropped.Count; i++)
        {
            AskFor(contacts, _dropped, i);
            Forget(contacts, graph, _dropped[i]);
        }
    }

    private void ForgetKeys()
    {
        PairMap map = _contacts.Map;
        for (int i = 0; i < _droppedKeys.Count; i++)
        {
            map.AskForValue(_droppedKeys[Math.Min(i + KeysAhead, _droppedKeys.Count - 1)]);
            map.Remove(_droppedKeys[i]);
        }
    }

    /// <summary>Asks for the record of a pair that comes or goes some places on.</summary>
    private static void AskFor(ContactStore contacts, in ScratchList<int> pairs, int place) =>
        contacts.AskFor(pairs[Math.Min(place + RecordsAhead, pairs.Count - 1)]);

    /// <summary>
    /// New rows are coloured in a shuffled order: in creation order a stack gets all left supports in one colour and all right
    /// ones in another, and drifts sideways. Their constraints are written afterwards.
    /// </summary>
    private void Give(StageRunner runner, in ContactUpdateInput input, ConstraintGraph graph)
    {
        if (_gained.Count == 0)
        {
            return;
        }

        ContactStore contacts = input.Contacts;
        _gainKeys.SetCount(_gained.Count);
        for (int i = 0; i < _gained.Count; i++)
        {
            AskFor(contacts, _gained, i);
            _gainKeys[i] = Shuffle(PairKey(contacts.Records[_gained[i]]));
        }

        RadixSort.Sort(input.Scratch, _gainKeys.Pointer, _gained.Pointer, _gained.Count);
        for (int i = 0; i < _gained.Count; i++)
        {
            int index = _gained[i];
            AskFor(contacts, _gained, i);
            ref ContactRecord record = ref contacts.Records[index];
            contacts.RemoveIdle(index);
            graph.Add(index, ref record, input.Moves[record.BodyA] != 0, input.Moves[record.BodyB] != 0);
        }

        BundleSums sums = _tools.ContactUpdate.FillRows(runner, input, graph, _gained.Pointer, _gained.Count);
        AnyBounce |= sums.AnyBounce;
    }

    /// <summary>Gives rows to pairs beside a blow.</summary>
    private void GiveStruck(StageRunner runner, ContactUpdateInput input, ConstraintGraph graph)
    {
        _tools.Struck.Find(runner, input);
        ReadOnlySpan<int> found = _tools.Struck.Found;
        _gained.SetCount(found.Length);
        for (int i = 0; i < found.Length; i++)
        {
            _gained[i] = found[i];
        }

        input.Throws = _tools.Struck.Throws;
        Give(runner, input, graph);
        _tools.Struck.Widen(runner, input, graph);
    }

    // A fixed mixing of the bits (the finaliser of MurmurHash3); distinct keys stay distinct.
    internal static ulong Shuffle(ulong key)
    {
        key ^= key >> 33;
        key *= 0xFF51AFD7ED558CCDUL;
        key ^= key >> 33;
        key *= 0xC4CEB9FE1A85EC53UL;
        key ^= key >> 33;
        return key;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Value(ref _looked);
        s.Value(ref _startedCold);
        _sides.Visit(s);
        s.Value(ref _touching);
        s.Value(ref _touchingNow);
        s.Value(ref _hulls);
        Lone.Visit(s);
        AnyBounce = s.Value(AnyBounce);
        ColdStart = s.Value(ColdStart);
        AnyHeard = s.Value(AnyHeard);
    }
}
