using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Contacts;
using Farseer.Engine.Continuous;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>The sweep of fast bodies along the way that they took.</summary>
internal sealed partial class SweepStage : WorldPhase, IImpactListener
{
    private readonly BoxStage _boxes;
    private readonly PairFinder _pairs;
    private readonly ContactStage _contactStage;
    private readonly ContactEvents _events;
    private readonly PushReport _pushes;
    private readonly AccuracyStage _accuracy;
    /// <summary>What a fast body may meet, for which there is room before there is one.</summary>
    private const int FewCandidates = 16;

    // By body, and the pairs by place, in scratch memory until the step ends.
    private unsafe int* _sweepPlace;
    private unsafe SweepRoles* _sweepRoles;
    private ScratchList<ulong> _sweepKeys;

    // Where the pairs of each place begin, and how many one has at most.
    private unsafe int* _sweepFirst;
    private int _mostSwept;

    [NotState(Why.OfOneStep)]
    private int _sweepNext;

    [NotState(Why.OfOneStep)]
    private bool _sweepGathered;

    public SweepStage(
        WorldStores stores,
        BoxStage boxes,
        PairFinder pairs,
        ContactStage contactStage,
        ContactEvents events,
        PushReport pushes,
        AccuracyStage accuracy)
        : base(stores)
    {
        _boxes = boxes;
        _pairs = pairs;
        _contactStage = contactStage;
        _events = events;
        _pushes = pushes;
        _accuracy = accuracy;
    }

    bool IImpactListener.OnImpact(int contact, in Manifold manifold) =>
        _events.RaiseImpact(_contacts, contact, manifold);

    public void FlyLonePairs(float dt, float substep)
    {
        SweepInput input = BeginSweep(dt, substep);
        LonePairs pairs = _contactStage.Lone;
        for (int i = 0; i < pairs.Count; i++)
        {
            LonePair pair = pairs[i];
            FillSweep(_stores.Tools.Sweep, 2 * i, pair.Contact);
            FillSweep(_stores.Tools.SecondSweep, (2 * i) + 1, pair.Contact);
            bool a = IsThere(pair.A.Body);
            bool b = IsThere(pair.B.Body);
            if (a && b && _contacts.Records[pair.Contact].PieceA >= 0)
            {
                _accuracy.Audit?.BeginImpacts(pair.A.Body);
                _accuracy.Audit?.BeginImpacts(pair.B.Body);
                PairImpulse given = _stores.Tools.PairFlight.Run(input, pair);
                pairs.Write(i, _contacts, _graph, given);
            }
            else if (a || b)
            {
                (a ? _stores.Tools.Sweep : _stores.Tools.SecondSweep).Run(input, a ? pair.A : pair.B);
            }
        }
    }

    /// <summary>Whether fast bodies can meet anything that they are looked after against.</summary>
    private bool CanMeetAny()
    {
        ListImmovable();
        bool any = _immovable.Count > 0;
        for (int i = 0; i < _lists.Fast.Count && !any; i++)
        {
            any = _bodies.IsBullet(_lists.Fast[i].Body);
        }

        return any;
    }

    public unsafe void Sweep(float dt, float substep)
    {
        if (!CanMeetAny())
        {
            return;
        }

        SweepInput input = BeginSweep(dt, substep);
        FastList fast = _lists.Fast;
        int first = 2 * _contactStage.Lone.Count;
        byte* clear = _stores.Tools.Sweeps.FindClear(_stores.Runner, this, fast.Count, _mostSwept, dt, substep, _stores.Scratch);
        int heard = _events.ImpactsHeard;
        for (int i = 0; i < fast.Count; i++)
        {
            // What a handler did may have changed the answers.
            if (clear != null && clear[i] != 0 && _events.ImpactsHeard == heard)
            {
                continue;
            }

            FillSweep(_stores.Tools.Sweep, first + i, -1);
            FastMotion motion = fast[i];
            if (IsThere(motion.Body) && (_sweepRoles[motion.Body] & SweepRoles.Paired) == 0)
            {
                BeginSweptImpacts(motion);
                _stores.Tools.Sweep.Run(input, motion);
            }
        }
    }

    /// <summary>One that flew free may bounce on its way.</summary>
    private void BeginSweptImpacts(in FastMotion motion)
    {
        if (motion.Free != 0)
        {
            _accuracy.Audit?.BeginImpacts(motion.Body);
        }
    }

    /// <summary>
    /// Whether the sweep would leave a fast body as it is. What cannot move is where it is whatever happens to others, and pairs with it
    /// are found for one body and not for another, so the answer stands; of a body that is looked after against others that move it is no.
    /// </summary>
    public unsafe bool MeetsNothing(FastBodySweep sweep, int position, float dt, float substep)
    {
        int place = (2 * _contactStage.Lone.Count) + position;
        sweep.Begin();
        for (int i = _sweepFirst[place]; i < _sweepFirst[place + 1]; i++)
        {
            int contact = (int)(uint)_sweepKeys[i];
            ref ContactRecord record = ref _contacts.Records[contact];
            if (_bodies.IsMovable(_sweepPlace[record.BodyA] == place ? record.BodyB : record.BodyA))
            {
                return false;
            }

            sweep.Add(contact, false);
        }

        return sweep.MeetsNothing(SweepOf(dt, substep), _lists.Fast[position]);
    }

    /// <summary>
    /// Puts the pairs in the order of their places, and finds where those of each begin. They were listed in their own order, which those
    /// of a place keep.
    /// </summary>
    private unsafe void SortSweepPairs(int places)
    {
        int count = _sweepKeys.Count;
        _sweepFirst = _stores.Scratch.Take<int>(places + 2);
        int mark = _stores.Scratch.Mark;
        ulong* sorted = _stores.Scratch.Take<ulong>(count);
        Unsafe.InitBlock(_sweepFirst, 0, (uint)(places + 2) * sizeof(int));
        for (int i = 0; i < count; i++)
        {
            _sweepFirst[(int)(_sweepKeys[i] >> 32) + 2]++;
        }

        _mostSwept = 0;
        for (int place = 2; place < places + 2; place++)
        {
            _mostSwept = Math.Max(_mostSwept, _sweepFirst[place]);
            _sweepFirst[place] += _sweepFirst[place - 1];
        }

        // Filling moves the beginning of each place, which stands one further on till then, to where the next begins.
        for (int i = 0; i < count; i++)
        {
            sorted[_sweepFirst[(int)(_sweepKeys[i] >> 32) + 1]++] = _sweepKeys[i];
        }

        Unsafe.CopyBlock(_sweepKeys.Pointer, sorted, (uint)count * sizeof(ulong));
        _stores.Scratch.Release(mark);
    }

    private bool IsThere(int body)
    {
        const BodyFlags Both = BodyFlags.Alive | BodyFlags.Enabled;
        return (_bodies.Flags[body] & Both) == Both;
    }

    private SweepInput BeginSweep(float dt, float substep)
    {
        if (!_sweepGathered)
        {
            _sweepGathered = true;
            GatherSweepPairs();
            _sweepNext = 0;
        }

        return SweepOf(dt, substep);
    }

    private SweepInput SweepOf(float dt, float substep)
    {
        SweepInput input;
        input.Driven = _stores.DrivenBoundOf(dt);
        input.Bodies = _bodies;
        input.Shapes = _shapes;
        input.Contacts = _contacts;
        input.Joints = _joints;
        input.Settings = _settings;
        input.Listener = this;
        input.Impulses = _pushes.Impulses;
        input.Dt = dt;
        input.Substep = substep;
        return input;
    }

    /// <summary>Has a sweep look at the pairs of a place but for one; places are asked for in their order.</summary>
    private unsafe void FillSweep(FastBodySweep sweep, int place, int without)
    {
        sweep.Begin();
        while (_sweepNext < _sweepKeys.Count && (int)(_sweepKeys[_sweepNext] >> 32) < place)
        {
            _sweepNext++;
        }

        for (; _sweepNext < _sweepKeys.Count && (int)(_sweepKeys[_sweepNext] >> 32) == place; _sweepNext++)
        {
            int contact = (int)(uint)_sweepKeys[_sweepNext];
            ref ContactRecord record = ref _contacts.Records[contact];
            if (contact != without)
            {
                sweep.Add(contact, _bodies.IsMovable(_sweepPlace[record.BodyA] == place ? record.BodyB : record.BodyA));
            }
        }
    }

    /// <summary>
    /// The pairs of fast bodies with what they are looked after against, by place: first the bodies of the pairs that fly alone, then
    /// the fast ones.
    /// </summary>
    private unsafe void GatherSweepPairs()
    {
        FastList fast = _lists.Fast;
        LonePairs pairs = _contactStage.Lone;
        int end = _bodies.Ids.End;
        _sweepPlace = _stores.Scratch.Take<int>(end);
        _sweepRoles = _stores.Scratch.Take<SweepRoles>(end);
        _sweepKeys = new ScratchList<ulong>(_stores.Scratch);
        SweepRoles* roles = _sweepRoles;
        for (int i = 0; i < end; i++)
        {
            roles[i] = _bodies.IsMovable(i) ? SweepRoles.None : SweepRoles.Wall;
            _sweepPlace[i] = -1;
        }

        for (int i = 0; i < fast.Count; i++)
        {
            SetPlace(fast[i].Body, (2 * pairs.Count) + i, SweepRoles.Fast);
        }

        for (int i = 0; i < pairs.Count; i++)
        {
            SetPlace(pairs[i].A.Body, 2 * i, SweepRoles.Fast | SweepRoles.Paired);
            SetPlace(pairs[i].B.Body, (2 * i) + 1, SweepRoles.Fast | SweepRoles.Paired);
        }

        ContactRecord* records = _contacts.Records.Pointer;
        ulong* marks = _stores.Tools.Sweeps.MarkPairs(_stores.Runner, this, _contacts.End, _stores.Scratch);
        for (int word = 0; word * BitSet.WordBits < _contacts.End; word++)
        {
            for (ulong left = marks[word]; left != 0; left &= left - 1)
            {
                int contact = (word * BitSet.WordBits) + BitSet.LowestBit(left);
                ContactRecord* record = records + contact;
                if (IsLookedAfter(roles[record->BodyA], roles[record->BodyB]))
                {
                    _sweepKeys.Add(((ulong)(uint)_sweepPlace[record->BodyA] << 32) | (uint)contact);
                }

                if (IsLookedAfter(roles[record->BodyB], roles[record->BodyA]))
                {
                    _sweepKeys.Add(((ulong)(uint)_sweepPlace[record->BodyB] << 32) | (uint)contact);
                }
            }
        }

        SortSweepPairs((2 * pairs.Count) + fast.Count);
    }

    /// <summary>
    /// Marks those of some pairs in which one body is looked after against the other; the first is the first of a word of marks.
    /// </summary>
    public unsafe void MarkSwept(ulong* marks, int from, int to)
    {
        const SweepRoles FastAtWall = SweepRoles.Fast | SweepRoles.Wall;
        ContactRecord* records = _contacts.Records.Pointer;
        SweepRoles* roles = _sweepRoles;
        for (int first = from; first < to; first += BitSet.WordBits)
        {
            ulong marked = 0;
            int end = Math.Min(first + BitSet.WordBits, to);
            for (int i = first; i < end; i++)
            {
                ContactRecord* record = records + i;
                SweepRoles a = roles[record->BodyA];
                SweepRoles b = roles[record->BodyB];

                // Few of all pairs are of this kind, so one question that nearly all answer alike comes first.
                SweepRoles both = a | b;
                if (((both & SweepRoles.Bullet) == 0 && (both & FastAtWall) != FastAtWall) || record->PieceA < 0)
                {
                    continue;
                }

                if ((IsLookedAfter(a, b) || IsLookedAfter(b, a)) && Responds(*record))
                {
                    marked |= 1UL << (i % BitSet.WordBits);
                }
            }

            marks[first / BitSet.WordBits] = marked;
        }
    }

    private static bool IsLookedAfter(SweepRoles body, SweepRoles other) =>
        (body & SweepRoles.Bullet) != 0 || ((body & SweepRoles.Fast) != 0 && (other & SweepRoles.Wall) != 0);

    private unsafe void SetPlace(int body, int place, SweepRoles role)
    {
        _sweepPlace[body] = place;
        _sweepRoles[body] |= _bodies.IsBullet(body) ? role | SweepRoles.Bullet : role;
    }

    private bool Responds(in ContactRecord record)
    {
        ColliderFlags both = _shapes.ColliderAt(record.PieceA).Flags & _shapes.ColliderAt(record.PieceB).Flags;
        return (both & (ColliderFlags.Alive | ColliderFlags.ResponseEnabled)) == (ColliderFlags.Alive | ColliderFlags.ResponseEnabled);
    }

    /// <summary>What a body is in the sweep.</summary>
    [Flags]
    private enum SweepRoles : byte
    {
        None = 0,

        /// <summary>Must not be passed.</summary>
        Wall = 1,
        Fast = 2,

        /// <summary>Fast, and must pass nothing.</summary>
        Bullet = 4,

        /// <summary>One of a pair that flies alone.</summary>
        Paired = 8,
    }

    /// <summary>Makes room for what a fast body may meet, before there is one.</summary>
    public void ReserveFew()
    {
        _stores.Tools.Sweep.Reserve(Math.Min(_contacts.Records.Capacity, FewCandidates));
        _stores.Tools.SecondSweep.Reserve(Math.Min(_contacts.Records.Capacity, FewCandidates));
    }

    /// <summary>Makes room for what cannot move.</summary>
    public void Reserve(int immovable) => _immovable.Reserve(Math.Min(immovable, MostInARow + 1));

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Of(nameof(SweepStage)).Value(ref _mostSwept);
        if (s.IsReading)
        {
            _immovableListed = false;
            _queriesSeeStep = false;
        }
    }
}
