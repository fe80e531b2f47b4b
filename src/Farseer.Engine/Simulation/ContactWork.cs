using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>What the update of a bundle found.</summary>
internal unsafe struct BundleOutcome
{
    public ContactFates Fates;

    /// <summary>How deep those that are struck would sink in.</summary>
    public fixed float Sinking[ContactBundle.Lanes];
}

/// <summary>
/// The parts of the narrow phase that workers share: the sides of the pieces, then bundles of pairs. A bundle writes its rows, the flags
/// and manifolds of its pairs, and its outcome; what follows from the outcomes is done afterwards, by one thread, in the order of
/// the bundles.
/// </summary>
internal sealed unsafe class ContactWork : IStageWork
{
    /// <summary>Pieces that are worth another worker's while, some 2 µs, and bundles, some 0.5 µs.</summary>
    private const int LeastPieces = 256;
    private const int LeastBundles = 8;

    /// <summary>Sides of more pieces than that are no longer all near: a third of a megabyte.</summary>
    private const int MostNear = 5000;

    private readonly Column<PairLanes> _pairs = new Column<PairLanes>();
    private readonly Column<ContactBundle> _bundles = new Column<ContactBundle>();
    private BundleOutcome* _outcomes;
    private readonly ColorRanges _ranges = new ColorRanges();
    private readonly BundleNotes _notes = new BundleNotes();
    private ContactUpdateInput _input;
    private ContactSides _sides = null!;
    private ConstraintGraph _graph = null!;
    private int* _gained;
    private int _gainedCount;
    private Part _part;

    private enum Part
    {
        Sides,
        Rows,
        Given,
    }

    /// <summary>Where pairs pass through that the calling thread works on alone.</summary>
    public PairLanes* Pairs => _pairs.Pointer;

    /// <summary>Outcomes of the last update, by the numbers of its bundles.</summary>
    public BundleOutcome* Outcomes => _outcomes;

    /// <summary>The numbers of the bundles of rows.</summary>
    public ColorRanges Ranges => _ranges;

    /// <summary>Those of them that something follows from.</summary>
    public BundleNotes Notes => _notes;

    /// <summary>Writes the sides of all pieces.</summary>
    public void WriteSides(StageRunner runner, in ContactUpdateInput input, ContactSides sides)
    {
        _pairs.EnsureCapacity(runner.Workers);
        _bundles.EnsureCapacity(runner.Workers);
        sides.Begin(input.Shapes, input.Contacts.KeepsGaps ? input.Contacts.Steps : null, input.Settings.AllowSleep, input.Scratch);
        _input = input;
        _sides = sides;
        _part = Part.Sides;
        int words = (input.Shapes.PieceIds.End + BitSet.WordBits - 1) / BitSet.WordBits;
        runner.Run(this, words, LeastPieces / BitSet.WordBits);
    }

    /// <summary>Updates the pairs that have rows, colour by colour.</summary>
    public BundleSums UpdateRows(StageRunner runner, in ContactUpdateInput input, ConstraintGraph graph)
    {
        _ranges.Find(graph.Used, runner.Workers);
        return Run(runner, input, Part.Rows, _ranges.Count);
    }

    /// <summary>Writes the constraints of pairs that have just been given rows, eight at a time, and moves them to their places.</summary>
    /// <returns>True if one of them can bounce.</returns>
    public bool FillRows(StageRunner runner, in ContactUpdateInput input, ConstraintGraph graph, int* gained, int count)
    {
        _graph = graph;
        _gained = gained;
        _gainedCount = count;
        int bundles = (count + ContactBundle.Lanes - 1) / ContactBundle.Lanes;
        return Run(runner, input, Part.Given, bundles).AnyBounce;
    }

    /// <summary>What the sides and boxes of one piece of a pair are read from is asked for.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void AskFor(in ContactUpdateInput input, int piece, int body)
    {
        Prefetch.Line(input.Sides + piece);
        Prefetch.Line(input.Bodies.Pose.Pointer + body);
        Prefetch.Line(input.Fat + piece);
    }

    /// <summary>Keeps how deep those of a bundle that are struck would sink in.</summary>
    public static void NoteSinking(PairLanes* pairs, BundleOutcome* outcome)
    {
        for (int lane = 0, blows = outcome->Fates.Blows; blows != 0; lane++, blows >>= 1)
        {
            outcome->Sinking[lane] = pairs->Sinking[lane];
        }
    }

    void IStageWork.Run(int worker, int from, int to)
    {
        ContactUpdateInput input = _input;
        input.Pairs = _pairs.Pointer + worker;
        switch (_part)
        {
            case Part.Sides:
                int end = Math.Min(to * BitSet.WordBits, input.Shapes.PieceIds.End);
                _sides.Write(input.Shapes, input.Bodies, input.Proxies, input.Moves, from * BitSet.WordBits, end);
                break;
            case Part.Rows:
                UpdateRows(input, worker, from, to);
                break;
            case Part.Given:
                FillRows(input, worker, from, to);
                break;
        }
    }

    private BundleSums Run(StageRunner runner, in ContactUpdateInput input, Part part, int count)
    {
        _input = input;
        _part = part;
        _outcomes = input.Scratch.Take<BundleOutcome>(count);
        _notes.Begin(runner, input.Scratch, count);
        runner.Run(this, count, LeastBundles);
        return _notes.Total(runner);
    }

    private void UpdateRows(in ContactUpdateInput input, int worker, int from, int to)
    {
        BundleOutcome* outcomes = _outcomes;
        BundleSums sums = default;
        bool far = Prefetch.IsUseful && input.Shapes.PieceIds.End > MostNear;
        while (from < to)
        {
            BundleOutcome* outcome = outcomes + from;
            BundleRuns runs = _ranges.From(from, to, out from);
            while (runs.Next())
            {
                ContactBundle* bundle = runs.Bundles;
                for (int left = runs.Count; left > 0; left--, bundle = ContactBundle.Next(bundle), outcome++)
                {
                    if (Prefetch.IsUseful && (ContactBundle.IsFirst(bundle) || bundle == runs.Bundles))
                    {
                        ContactBundle* behind = left > 2 ? bundle + 1 : runs.Following;
                        if (behind != runs.Bundles)
                        {
                            ContactBundle.AskFor(behind);
                        }
                    }

                    if (far)
                    {
                        AskForSides(input, left > 1 ? ContactBundle.Next(bundle) : runs.Following);
                    }

                    outcome->Fates = ContactUpdate.UpdateRows(input, bundle);
                    NoteSinking(input.Pairs, outcome);
                    ref ContactFates fates = ref outcome->Fates;
                    sums.Add(fates);
                    sums.AnyBounce |= BounceKernel.Bounces(bundle);
                    _notes.Note((int)(outcome - outcomes), fates.Idle | fates.Dropped | fates.Deferred | fates.Racing | fates.Blows);
                }
            }
        }

        _notes.Add(worker, sums);
    }

    /// <summary>
    /// The sides of a bundle's pieces are asked for. Poses and boxes are read a little later, by instructions that can wait for them: to ask for these too
    /// took longer than it saved.
    /// </summary>
    private static void AskForSides(in ContactUpdateInput input, ContactBundle* bundle)
    {
        for (int lane = 0; lane < ContactBundle.Lanes; lane++)
        {
            Prefetch.Line(input.Sides + bundle->PieceA[lane]);
            Prefetch.Line(input.Sides + bundle->PieceB[lane]);
        }
    }

    // Two bundles of new rows may write different lanes of the same bundle of a colour: those are different places of memory.
    private void FillRows(in ContactUpdateInput input, int worker, int from, int to)
    {
        ContactBundle* bundle = _bundles.Pointer + worker;
        BundleSums sums = default;
        Column<ContactRecord> records = input.Contacts.Records;
        for (int i = from; i < to; i++)
        {
            int* gained = _gained + (i * ContactBundle.Lanes);
            int count = Math.Min(ContactBundle.Lanes, _gainedCount - (i * ContactBundle.Lanes));
            ContactRowWriter.ClearForWrite(bundle);
            for (int lane = 0; lane < count; lane++)
            {
                ContactRowWriter.Name(bundle, lane, gained[lane], records[gained[lane]]);
            }

            ContactUpdate.FillRows(input, bundle);
            sums.AnyBounce |= BounceKernel.Bounces(bundle);
            for (int lane = 0; lane < count; lane++)
            {
                ref ContactRecord record = ref records[gained[lane]];
                ContactRowWriter.MoveLane(bundle, lane, _graph.BundleOf(record.Row), RowArena.LaneOf(record.Row));
            }
        }

        _notes.Add(worker, sums);
    }
}
