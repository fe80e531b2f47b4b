using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <summary>
/// The passes over the contact rows, colour by colour: the rows of one colour share no body that moves, so they are cut into ranges for
/// the workers. Rows of a heavy body and of the overflow may share bodies and are done by one.
/// </summary>
internal sealed unsafe class ContactPasses : IStageWork, ISequenceWork
{
    /// <summary>Records that are worth another worker's while, some 0.5 µs of a pass: a phase of two blocks takes 0.3 µs to share.</summary>
    private const int LeastRecords = 8;

    /// <summary>Bundles of a colour of a world whose rows are no longer near, some 8 MB in all colours.</summary>
    private const int MostNear = 384;

    /// <summary>Runs of each colour that there is room for from the start: most have one to three, and a world that settles is not to allocate.</summary>
    private const int FirstRuns = 8;

    /// <summary>Bundles of a colour that nobody is asked to share.</summary>
    private const int MostShort = 8;

    /// <summary>
    /// Where the rows of all colours are, looked up once for all passes: in a small world the way to the rows took as long as some of the passes over them,
    /// in large ones a hundredth of a step.
    /// </summary>
    private KnownRun[] _runs = new KnownRun[FirstRuns * ConstraintGraph.ColorCount];
    private int[] _firstRun = new int[ConstraintGraph.ColorCount + 1];

    /// <summary>
    /// The phases of a pass: a colour that is shared, or some in a row that are not worth it, which one worker does. For each phase the first
    /// colour that is behind it, and whether it is one of these.
    /// </summary>
    private readonly StageList _stages = new StageList();

    /// <summary>Parts of the runs: what <see cref="RelaxChosen"/> walks over.</summary>
    private readonly Column<RunPart> _chosen = new Column<RunPart>();
    private int _chosenCount;
    private StageColors[] _stageColors = new StageColors[ConstraintGraph.ColorCount];
    private StageRunner _runner = null!;
    private ContactPass _pass;
    private int _color;

    /// <param name="runner">Who shares the passes.</param>
    /// <param name="bodies">The store.</param>
    /// <param name="coefficients">Constants of the substeps.</param>
    /// <param name="colors">The rows of all passes that follow, whose points are known by now.</param>
    public void Begin(StageRunner runner, BodyStore bodies, in ContactCoefficients coefficients, ReadOnlySpan<GraphColor> colors)
    {
        _runner = runner;
        _pass.States = bodies.State.Pointer;
        _pass.Coefficients = coefficients;
        FindRuns(colors);
        FindStages(colors);
    }

    public void WarmStart(ReadOnlySpan<GraphColor> colors) => Run(colors, ContactPassKind.WarmStart, false);

    public void SolveBiased(ReadOnlySpan<GraphColor> colors, bool anyDeep) => Run(colors, ContactPassKind.Biased, anyDeep);

    /// <param name="colors">The rows.</param>
    /// <param name="rub">With friction.</param>
    /// <param name="first">The only sweep, or the first, of the substep.</param>
    public void Relax(ReadOnlySpan<GraphColor> colors, bool rub, bool first)
    {
        _pass.First = first;
        Run(colors, ContactPassKind.Relax, rub);
    }

    /// <summary>Makes room for what <see cref="Choose"/> may find in a world of so many bodies: a part for four, where each has five contacts or less.</summary>
    public void Reserve(int bodies) => _chosen.EnsureCapacity(bodies / 4);

    /// <summary>Chooses the records with rows of some islands.</summary>
    /// <param name="colors">The rows of all passes.</param>
    /// <param name="islands">1 for an island that is wanted.</param>
    /// <param name="islandOfSlot">The island of each slot.</param>
    /// <returns>False if these are more than half of all, which workers had better share as they are.</returns>
    public bool Choose(ReadOnlySpan<GraphColor> colors, byte* islands, int* islandOfSlot)
    {
        _chosenCount = 0;
        int all = 0;
        int wanted = 0;
        for (int i = 0; i < _firstRun[colors.Length]; i++)
        {
            ref readonly BundleRun rows = ref _runs[i].Rows;
            int first = 0;
            for (int at = 0; at < rows.Count; at += ContactBundle.Beside)
            {
                int end = Math.Min(at + ContactBundle.Beside, rows.Count);
                if (HasRowOf(ContactBundle.At(rows.Bundles, at), end - at, islands, islandOfSlot))
                {
                    wanted += end - at;
                    continue;
                }

                AddChosen(i, first, at);
                first = end;
            }

            AddChosen(i, first, rows.Count);
            all += rows.Count;
        }

        return 2 * wanted <= all;
    }

    /// <summary>The relax pass with friction over what was chosen, not the first of its substep.</summary>
    public void RelaxChosen()
    {
        _pass.Kind = ContactPassKind.Relax;
        _pass.Flag = true;
        _pass.First = false;
        for (int i = 0; i < _chosenCount; i++)
        {
            KnownRun run = _runs[_chosen[i].Run];
            run.Rows = run.Rows.Part(_chosen[i].First, _chosen[i].Count);
            Run(run);
        }
    }

    public void PushOut(ReadOnlySpan<GraphColor> colors, float rate)
    {
        _pass.Rate = rate;
        Run(colors, ContactPassKind.PushOut, false);
    }

    void IStageWork.Run(int worker, int from, int to) => Run(_color, from, to);

    void ISequenceWork.Run(int worker, int stage, int from, int to)
    {
        StageColors colors = _stageColors[stage];
        if (colors.AreShared)
        {
            Run(colors.End - 1, from, to);
            return;
        }

        for (int i = stage == 0 ? 0 : _stageColors[stage - 1].End; i < colors.End; i++)
        {
            RunWhole(i);
        }
    }

    /// <summary>Runs the pass over a colour.</summary>
    private void RunWhole(int color)
    {
        for (int i = _firstRun[color]; i < _firstRun[color + 1]; i++)
        {
            Run(_runs[i]);
        }
    }

    private void Run(in KnownRun run)
    {
        if (run.IsShared)
        {
            SharedKernel.Run(_pass, run.Rows);
        }
        else
        {
            Run(run.Rows, run.IsGrounded, run.HasOnePoint);
        }
    }

    private void AddChosen(int run, int first, int end)
    {
        if (first >= end)
        {
            return;
        }

        _chosen.EnsureCapacity(_chosenCount + 1);
        _chosen[_chosenCount++] = new RunPart { Run = run, First = first, Count = end - first };
    }

    private static bool HasRowOf(ContactBundle* row, int bundles, byte* islands, int* islandOfSlot)
    {
        ContactBundle.AskAhead(row->Slot);
        int any = 0;
        for (; bundles > 0; bundles--, row = ContactBundle.Next(row))
        {
            for (int lane = 0; lane < ContactBundle.Lanes; lane++)
            {
                any |= islands[islandOfSlot[row->Slot[lane]]];
            }
        }

        return any != 0;
    }

    /// <summary>Runs the pass over some records of a colour.</summary>
    private void Run(int color, int from, int to)
    {
        int first = from * ContactBundle.Beside;
        int end = to * ContactBundle.Beside;
        for (int i = _firstRun[color]; i < _firstRun[color + 1] && end > 0; i++)
        {
            ref readonly KnownRun run = ref _runs[i];
            int count = run.Rows.Count;
            if (first < count)
            {
                int skipped = Math.Max(0, first);
                Run(run.Rows.Part(skipped, Math.Min(end, count) - skipped), run.IsGrounded, run.HasOnePoint);
            }

            first -= count;
            end -= count;
        }
    }

    /// <summary>Records of a colour: what is shared, since bundles of one have cache lines in common and may be solved together.</summary>
    private static int RecordsOf(GraphColor color) => (color.BundleCount + ContactBundle.Beside - 1) / ContactBundle.Beside;

    private void Run(in BundleRun rows, bool grounded, bool onePoint)
    {
#if NET8_0_OR_GREATER
        if (Numerics.Sixteen.WideLanes.AreThere && rows.Count > 1 && rows.Stride > 1)
        {
            var records = new Contacts.Sixteen.BundleRun(
                (Contacts.Sixteen.ContactBundle*)rows.Bundles,
                (rows.Count + ContactBundle.Beside - 1) / ContactBundle.Beside,
                (Contacts.Sixteen.ContactBundle*)rows.Following,
                rows.IsFar);
            Contacts.Sixteen.PassChoice.Run(_pass, records, grounded, onePoint);
            return;
        }
#endif
        PassChoice.Run(_pass, rows, grounded, onePoint);
    }

    private void Run(ReadOnlySpan<GraphColor> colors, ContactPassKind kind, bool flag)
    {
        _pass.Kind = kind;
        _pass.Flag = flag;
        if (colors.Length > 0 && _runner.RunAll(this, _stages))
        {
            return;
        }

        for (int i = 0; i < colors.Length; i++)
        {
            GraphColor color = colors[i];
            if (color.HasOrder || color.BundleCount <= MostShort)
            {
                RunWhole(i);
                continue;
            }

            _color = i;
            _runner.Run(this, RecordsOf(color), LeastRecords);
        }
    }

    private void FindRuns(ReadOnlySpan<GraphColor> colors)
    {
        if (_firstRun.Length <= colors.Length)
        {
            _firstRun = new int[(2 * colors.Length) + 1];
        }

        int count = 0;
        for (int i = 0; i < colors.Length; i++)
        {
            GraphColor color = colors[i];
            bool far = color.BundleCount > MostNear;
            _firstRun[i] = count;
            BundleRuns runs = color.Runs;
            while (runs.Next())
            {
                if (count == _runs.Length)
                {
                    Array.Resize(ref _runs, 2 * count);
                }

                _runs[count++] = new KnownRun
                {
                    Rows = new BundleRun(runs.Bundles, runs.Count, runs.Following, far, color.IsSequential),
                    IsGrounded = color.IsGrounded,
                    HasOnePoint = OnePoint.Are(runs.Bundles, runs.Count),
                    IsShared = color.IsShared,
                };
            }
        }

        _firstRun[colors.Length] = count;
    }

    private void FindStages(ReadOnlySpan<GraphColor> colors)
    {
        if (!_runner.IsShared(2, 1))
        {
            return;
        }

        if (_stageColors.Length < colors.Length)
        {
            _stageColors = new StageColors[2 * colors.Length];
        }

        _runner.Clear(_stages);
        bool any = false;
        bool alone = false;
        for (int i = 0; i < colors.Length; i++)
        {
            GraphColor color = colors[i];
            int blocks = color.HasOrder ? 1 : _runner.BlocksOf(RecordsOf(color), LeastRecords);
            any |= blocks > 1;
            if (blocks > 1 || !alone)
            {
                alone = blocks == 1;
                _stages.Add(alone ? 1 : RecordsOf(color), blocks);
            }

            _stageColors[_stages.Count - 1] = new StageColors { End = i + 1, AreShared = !alone };
        }

        if (!any)
        {
            _runner.Clear(_stages);
        }
    }

    private struct StageColors
    {
        public int End;
        public bool AreShared;
    }

    /// <summary>Some bundles of a run.</summary>
    private struct RunPart
    {
        public int Run;
        public int First;
        public int Count;
    }

    private struct KnownRun
    {
        public BundleRun Rows;
        public bool IsGrounded;
        public bool HasOnePoint;
        public bool IsShared;
    }
}
