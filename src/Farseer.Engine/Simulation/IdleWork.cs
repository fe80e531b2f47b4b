using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Contacts;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// The narrow phase of the pairs without a row, which workers share. Where there are many, most are passed over by what is known of their
/// gaps, and the others packed into bundles of eight.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class IdleWork : IStageWork
{
    /// <summary>Bundles that are worth another worker's while, some 0.5 µs, those that are only passed over, and words of bodies.</summary>
    private const int LeastBundles = 8;
    private const int LeastPasses = 64;
    private const int LeastWords = 4;

    /// <summary>Idle pairs for each so many bodies from which on their gaps are kept, and down to which they go on being kept.</summary>
    private const int BodiesToBegin = 2;
    private const int BodiesToEnd = 4;

    /// <summary>Fewer pairs are looked at as they come: what is left of bundles of each kind would outweigh what is gained.</summary>
    private const int LeastSorted = 8 * ContactBundle.Lanes;

    private WorkerLanes* _lanes;
    private readonly BundleNotes _notes = new BundleNotes();

    // In scratch memory, until the end of the narrow phase.
    private BundleOutcome* _outcomes;
    private byte* _looks;
    private byte* _parted;

    // Places in the idle list of the pairs to look at; null: of all.
    private int* _looked;
    private ContactUpdateInput _input;
    private Part _part;

    private enum Part
    {
        Steps,
        Gaps,
        Idle,
    }

    /// <summary>Pairs that were looked at.</summary>
    public int LookedCount { get; private set; }

    /// <summary>Outcomes of the pairs looked at, in bundles of eight.</summary>
    public BundleOutcome* Outcomes => _outcomes;

    /// <summary>Those of these bundles that something follows from.</summary>
    public BundleNotes Notes => _notes;

    /// <summary>Place in the idle list of a pair that was looked at.</summary>
    public int Place(int looked) => _looked != null ? _looked[looked] : looked;

    /// <summary>
    /// Of the pairs of a bundle of the idle list those, a bit each, that are forgotten without a look, as their boxes have parted.
    /// </summary>
    public int Parted(int bundle) => _parted[bundle];

    /// <summary>The first bundle of a range of which a pair is, or <paramref name="to"/>.</summary>
    public int NextParted(int from, int to) => ByteMarks.Next(_parted, from, to);

    /// <summary>
    /// Decides whether gaps are kept, before the sides are written: where there are many such pairs and most are of hulls. To know the gaps
    /// of boxes and circles takes as long as to look at them.
    /// </summary>
    /// <param name="input">Columns and numbers of this step.</param>
    /// <param name="hulls">Pairs of hulls looked at in the last step.</param>
    /// <param name="looked">All pairs that were, those that have rows among them.</param>
    public void Begin(in ContactUpdateInput input, int hulls, int looked)
    {
        ContactStore contacts = input.Contacts;
        int end = input.Bodies.Ids.End;
        bool keeps = contacts.IdleCount * (contacts.KeepsGaps ? BodiesToEnd : BodiesToBegin) > end && hulls * 2 > looked;
        if (keeps)
        {
            contacts.Steps.Begin(end, afresh: !contacts.KeepsGaps);
        }

        if (keeps != contacts.KeepsGaps)
        {
            contacts.KeepGaps(keeps);
        }
    }

    /// <summary>Finds what the gaps are measured by, once the sides are written.</summary>
    public void FindSteps(StageRunner runner, in ContactUpdateInput input)
    {
        if (input.Contacts.KeepsGaps)
        {
            _input = input;
            _part = Part.Steps;
            runner.Run(this, (input.Bodies.Ids.End + BitSet.WordBits - 1) / BitSet.WordBits, LeastWords);
        }
    }

    /// <summary>Looks at the pairs, eight at a time in a bundle of the worker's own, which has never held an impulse.</summary>
    /// <param name="runner">Who shares the work out.</param>
    /// <param name="input">Columns and numbers of this step; the pairs of the first worker.</param>
    /// <returns>What they add up to.</returns>
    public BundleSums Update(StageRunner runner, in ContactUpdateInput input)
    {
        ContactStore contacts = input.Contacts;
        LookedCount = contacts.IdleCount;
        if (LookedCount == 0)
        {
            return default;
        }

        _input = input;
        _lanes = input.Scratch.Lasting<WorkerLanes>(runner.Workers);
        _looked = null;
        if (contacts.KeepsGaps)
        {
            int bundles = Bundles(contacts.IdleCount);
            _looks = input.Scratch.Take<byte>(bundles);
            _parted = input.Scratch.Take<byte>(bundles);
            _looked = input.Scratch.Take<int>(contacts.IdleCount);
            _part = Part.Gaps;
            runner.Run(this, bundles, LeastPasses);
            CollectLooked(bundles);
        }
        else
        {
            SortByKind(input);
        }

        _outcomes = input.Scratch.Take<BundleOutcome>(Bundles(LookedCount));
        _notes.Begin(runner, input.Scratch, Bundles(LookedCount));
        _part = Part.Idle;
        runner.Run(this, Bundles(LookedCount), LeastBundles);
        return _notes.Total(runner);
    }

    void IStageWork.Run(int worker, int from, int to)
    {
        ContactUpdateInput input = _input;
        input.Pairs = &(_lanes + worker)->Pairs;
        switch (_part)
        {
            case Part.Steps:
                input.Contacts.Steps.Find(input.Bodies, input.Dt, from, to);
                break;
            case Part.Gaps:
                PassOver(input, from, to);
                break;
            case Part.Idle:
                Look(input, worker, from, to);
                break;
        }
    }

    private static int Bundles(int pairs) => (pairs + ContactBundle.Lanes - 1) / ContactBundle.Lanes;

    /// <summary>
    /// Finds the pairs of some bundles that must be looked at, and of the others those whose boxes are new and have parted.
    /// </summary>
    private void PassOver(in ContactUpdateInput input, int from, int to)
    {
        ContactStore contacts = input.Contacts;
        BodyStep* steps = contacts.Steps.Pointer;
        float pull = (Math.Abs(input.Settings.Gravity.X) + Math.Abs(input.Settings.Gravity.Y)) * input.Dt * input.Dt;
        for (int i = from; i < to; i++)
        {
            IdleBundle* idle = contacts.Gaps + i;
            int first = i * ContactBundle.Lanes;
            int exist = (1 << Math.Min(ContactBundle.Lanes, contacts.IdleCount - first)) - 1;
            int look = IdleGap.Pass(idle, contacts.IdleBodyA + first, contacts.IdleBodyB + first, steps, pull, out int newBoxes) & exist;
            int parted = 0;
            newBoxes &= exist & ~look;
            for (int lane = 0; newBoxes != 0; lane++, newBoxes >>= 1)
            {
                if ((newBoxes & 1) != 0 && !Box.Overlap(input.Fat[idle->PieceA[lane]], input.Fat[idle->PieceB[lane]]))
                {
                    parted |= 1 << lane;
                }
            }

            _looks[i] = (byte)look;
            _parted[i] = (byte)parted;
        }
    }

    /// <summary>
    /// Puts pairs of one kind next to each other, where there are several: each kernel works on whole bundles, and of a heap of boxes,
    /// circles and capsules a bundle as they come takes three of the four.
    /// </summary>
    private void SortByKind(in ContactUpdateInput input)
    {
        ContactStore contacts = input.Contacts;
        int count = contacts.IdleCount;
        int* next = stackalloc int[ContactRecord.Kinds + 1];
        Unsafe.InitBlock(next, 0, (ContactRecord.Kinds + 1) * sizeof(int));
        for (int i = 0; i < count; i++)
        {
            next[(int)contacts.IdleKind(i) + 1]++;
        }

        if (count < LeastSorted || next[(int)contacts.IdleKind(0) + 1] == count)
        {
            return;
        }

        for (int kind = 1; kind < ContactRecord.Kinds; kind++)
        {
            next[kind] += next[kind - 1];
        }

        _looked = input.Scratch.Take<int>(count);
        for (int i = 0; i < count; i++)
        {
            _looked[next[(int)contacts.IdleKind(i)]++] = i;
        }
    }

    private void CollectLooked(int bundles)
    {
        int* next = _looked;
        for (int i = 0; i < bundles; i++)
        {
            int place = i * ContactBundle.Lanes;
            for (uint look = _looks[i]; look != 0; look &= look - 1)
            {
                *next++ = place + BitSet.LowestBit(look);
            }
        }

        LookedCount = (int)(next - _looked);
    }

    private void Look(in ContactUpdateInput input, int worker, int from, int to)
    {
        ContactBundle* bundle = &(_lanes + worker)->Looked;
        BundleSums sums = default;
        ContactStore contacts = input.Contacts;
        int* places = stackalloc int[ContactBundle.Lanes];
        for (int i = from; i < to; i++)
        {
            int first = i * ContactBundle.Lanes;
            int count = Math.Min(ContactBundle.Lanes, LookedCount - first);
            AskForRecords(contacts, first + (2 * ContactBundle.Lanes));
            for (int lane = 0; lane < ContactBundle.Lanes; lane++)
            {
                if (lane < count)
                {
                    places[lane] = Place(first + lane);
                    int index = contacts.Idle(places[lane]);
                    ContactLanes.Name(bundle, lane, index, contacts.Records[index]);
                }
                else
                {
                    ContactLanes.Unname(bundle, lane);
                }
            }

            ContactUpdate.UpdateIdle(input, bundle, out ContactFates fates);
            int follows = fates.Solid | fates.Dropped | fates.Deferred | fates.Racing | fates.Blows;
            sums.Add(fates);
            _notes.Note(i, follows);
            if (follows != 0)
            {
                ContactUpdateWork.Keep(input.Pairs, _outcomes + i, fates);
            }

            if (contacts.KeepsGaps)
            {
                IdleGap.Note(input.Pairs, contacts.Gaps, places, count);
            }
        }

        _notes.Add(worker, sums);
    }

    /// <summary>
    /// The records of the bundle after next are asked for: without, a step takes 1.03 of its time. What the next one reads of their sides,
    /// poses and boxes is not: processors that reach for the next bundle while they compute with this one took 0.99 of their time without
    /// being asked, others as long.
    /// </summary>
    private void AskForRecords(ContactStore contacts, int first)
    {
        if (!Prefetch.IsUseful)
        {
            return;
        }

        ContactRecord* records = contacts.Records.Pointer;
        int end = Math.Min(first + ContactBundle.Lanes, LookedCount);
        for (int i = first; i < end; i++)
        {
            Prefetch.Line(records + contacts.Idle(Place(i)));
        }
    }

    /// <summary>Lets go of the world.</summary>
    public void Forget() => _input.Forget();
}
