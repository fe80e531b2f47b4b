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
[NotState(Why.OfOneStep)]
internal sealed unsafe class ContactUpdateWork : IStageWork
{
    /// <summary>Pieces that are worth another worker's while, some 2 µs, and bundles, some 0.5 µs.</summary>
    private const int LeastPieces = 256;
    private const int LeastBundles = 8;

    /// <summary>Sides of more pieces than that are no longer all near: a third of a megabyte.</summary>
    private const int MostNear = 5000;

    private WorkerLanes* _lanes;
    private BundleOutcome* _outcomes;
    private ColorRanges _ranges = null!;
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
    public PairLanes* Pairs => &_lanes->Pairs;

    /// <summary>Outcomes of the last update, by the numbers of its bundles.</summary>
    public BundleOutcome* Outcomes => _outcomes;

    /// <summary>The numbers of the bundles of rows.</summary>
    public ColorRanges Ranges => _ranges;

    /// <summary>Those of them that something follows from.</summary>
    public BundleNotes Notes => _notes;

    /// <summary>Takes the lanes of all workers.</summary>
    public void Begin(WorkerLanes* lanes) => _lanes = lanes;

    /// <summary>Writes the sides of all pieces.</summary>
    public void WriteSides(StageRunner runner, in ContactUpdateInput input, ContactSides sides)
    {
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
        _ranges = graph.NumberBundles(runner.Workers);
        return Run(runner, input, Part.Rows, _ranges.Count, ContactBundle.Beside);
    }

    /// <summary>Writes the constraints of pairs that have just been given rows, eight at a time, and moves them to their places.</summary>
    /// <returns>Whether they can have impacts.</returns>
    public BundleSums FillRows(StageRunner runner, in ContactUpdateInput input, ConstraintGraph graph, int* gained, int count)
    {
        _graph = graph;
        _gained = gained;
        _gainedCount = count;
        int bundles = (count + ContactBundle.Lanes - 1) / ContactBundle.Lanes;
        return Run(runner, input, Part.Given, bundles, 1);
    }

    /// <summary>
    /// Keeps what is to become of the pairs of a bundle of which something follows, and how deep those that are struck would sink in.
    /// </summary>
    public static void Keep(PairLanes* pairs, BundleOutcome* outcome, in ContactFates fates)
    {
        outcome->Fates = fates;
        for (int lane = 0, blows = fates.Blows; blows != 0; lane++, blows >>= 1)
        {
            outcome->Sinking[lane] = pairs->Sinking[lane];
        }
    }

    /// <summary>Lets go of the world.</summary>
    public void Forget()
    {
        _input.Forget();
        _ranges = null!;
        _sides = null!;
        _graph = null!;
    }

    void IStageWork.Run(int worker, int from, int to)
    {
        ContactUpdateInput input = _input;
        input.Pairs = &(_lanes + worker)->Pairs;
        switch (_part)
        {
            case Part.Sides:
                int end = Math.Min(to * BitSet.WordBits, input.Shapes.PieceIds.End);
                _sides.Write(input.Shapes, input.Bodies, input.Proxies, input.Moves, from * BitSet.WordBits, end);
                break;
            case Part.Rows:
                UpdateRows(input, worker, from * ContactBundle.Beside, to * ContactBundle.Beside);
                break;
            case Part.Given:
                FillRows(input, worker, from, to);
                break;
        }
    }

    /// <param name="runner">Who shares the work out.</param>
    /// <param name="input">Columns and numbers of this step.</param>
    /// <param name="part">What is to be done.</param>
    /// <param name="count">Bundles.</param>
    /// <param name="together">How many of them no two workers may share.</param>
    private BundleSums Run(StageRunner runner, in ContactUpdateInput input, Part part, int count, int together)
    {
        _input = input;
        _part = part;
        _outcomes = input.Scratch.Take<BundleOutcome>(count);
        _notes.Begin(runner, input.Scratch, count);
        runner.Run(this, count / together, LeastBundles / together);
        return _notes.Total(runner);
    }

    private void UpdateRows(in ContactUpdateInput input, int worker, int from, int to)
    {
        BundleSums sums = default;
        while (from < to)
        {
            int number = from;
            BundleRuns runs = _ranges.From(from, to, out from);
            while (runs.Next())
            {
#if NET8_0_OR_GREATER
                if (Numerics.Sixteen.WideLanes.AreThere && runs.Count > 1)
                {
                    UpdateRecords(input, runs, number, ref sums);
                }
                else
#endif
                {
                    UpdateBundles(input, runs, number, ref sums);
                }

                number += runs.Count;
            }
        }

        _notes.Add(worker, sums);
    }

    /// <summary>Updates the pairs of bundles that lie behind each other.</summary>
    private void UpdateBundles(in ContactUpdateInput input, in BundleRuns runs, int number, ref BundleSums sums)
    {
        bool far = AreSidesFar(input);
        ContactBundle* bundle = runs.Bundles;
        for (int left = runs.Count; left > 0; left--, bundle = ContactBundle.Next(bundle), number++)
        {
            if (Prefetch.IsUseful && ContactBundle.IsFirst(bundle))
            {
                ContactBundle* behind = left > ContactBundle.Beside ? bundle + 1 : runs.Following;
                if (behind != runs.Bundles)
                {
                    ContactBundle.AskFor(behind);
                }
            }

            if (far)
            {
                AskForSides(input, left > 1 ? ContactBundle.Next(bundle) : runs.Following, ContactBundle.Lanes);
            }

            ContactUpdate.UpdateRows(input, bundle, out ContactFates fates);
            sums.Add(fates);
            sums.NoteBounces(bundle);
            int follows = fates.Follows;
            _notes.Note(number, follows);
            if (follows != 0)
            {
                Keep(input.Pairs, _outcomes + number, fates);
            }
        }
    }

#if NET8_0_OR_GREATER
    /// <summary>
    /// The same with both bundles of a record at a time. Beside the last one of a colour there may be none: the pairs of empty lanes do not
    /// exist.
    /// </summary>
    private void UpdateRecords(in ContactUpdateInput input, in BundleRuns runs, int number, ref BundleSums sums)
    {
        bool far = AreSidesFar(input);
        ContactBundle* bundle = runs.Bundles;
        for (int left = runs.Count; left > 0; left -= ContactBundle.Beside, bundle++, number += ContactBundle.Beside)
        {
            // What the next record names is asked for while this one is looked at, so the record itself one earlier.
            ContactBundle* next = left > ContactBundle.Beside ? bundle + 1 : runs.Following;
            if (next != runs.Bundles)
            {
                ContactBundle* nextButOne = left > ContactBundle.Beside && left <= 2 * ContactBundle.Beside ? runs.Following : next + 1;
                ContactBundle.AskFor(far ? nextButOne : next);
            }

            if (far)
            {
                AskForSides(input, next, ContactBundle.LineLanes);
            }

            ContactUpdate.UpdateRecord(input, bundle, out ContactFates fates);
            sums.Add(fates);
            sums.NoteBounces(bundle);
            sums.NoteBounces(ContactBundle.Next(bundle));
            int follows = fates.Follows;
            _notes.Note(number, PairBits.Of(follows, 0));
            _notes.Note(number + 1, PairBits.Of(follows, 1));
            if (follows != 0)
            {
                Keep(input.Pairs, _outcomes + number, fates.OfBundle(0));
                Keep(PairLanes.Beside(input.Pairs), _outcomes + number + 1, fates.OfBundle(1));
            }
        }
    }
#endif

    /// <summary>The sides are to be asked for.</summary>
    private static bool AreSidesFar(in ContactUpdateInput input) => Prefetch.IsUseful && input.Shapes.PieceIds.End > MostNear;

    /// <summary>
    /// The sides of the pieces of a bundle, or of two side by side, are asked for. Poses and boxes are read a little later, by instructions
    /// that can wait for them: to ask for these too took longer than it saved.
    /// </summary>
    private static void AskForSides(in ContactUpdateInput input, ContactBundle* bundle, int lanes)
    {
        for (int lane = 0; lane < lanes; lane++)
        {
            Prefetch.Line(input.Sides + bundle->PieceA[lane]);
            Prefetch.Line(input.Sides + bundle->PieceB[lane]);
        }
    }

    // Two bundles of new rows may write different lanes of the same bundle of a colour: those are different places of memory.
    private void FillRows(in ContactUpdateInput input, int worker, int from, int to)
    {
        ContactBundle* bundle = &(_lanes + worker)->Filled;
        BundleSums sums = default;
        Column<ContactRecord> records = input.Contacts.Records;
        for (int i = from; i < to; i++)
        {
            int* gained = _gained + (i * ContactBundle.Lanes);
            int count = Math.Min(ContactBundle.Lanes, _gainedCount - (i * ContactBundle.Lanes));
            ContactLanes.ClearForWrite(bundle);
            for (int lane = 0; lane < count; lane++)
            {
                ContactLanes.Name(bundle, lane, gained[lane], records[gained[lane]]);
            }

            ContactUpdate.FillRows(input, bundle, beside: input.Throws != null);
            sums.NoteBounces(bundle);
            for (int lane = 0; lane < count; lane++)
            {
                ref ContactRecord record = ref records[gained[lane]];
                ContactLanes.MoveLane(bundle, lane, _graph.BundleOf(record.Row), RowArena.LaneOf(record.Row));
            }
        }

        _notes.Add(worker, sums);
    }
}
