using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Stepping;

namespace Farseer.Engine.Solver;

/// <summary>
/// The passes over the contact rows, colour by colour: the rows of one colour share no body that moves, so they are cut into ranges for
/// the workers. Rows of the overflow may share bodies and are done by one.
/// </summary>
internal sealed unsafe class ContactPasses : IStageWork, ISequenceWork
{
    /// <summary>Records that are worth another worker's while, some 0.5 µs of a pass: a phase of two blocks takes 0.3 µs to share.</summary>
    private const int LeastRecords = 8;

    /// <summary>Bundles of a colour of a world whose rows are no longer near, some 8 MB in all colours.</summary>
    private const int MostNear = 384;

    /// <summary>
    /// Colours of up to so many bundles, all behind each other, are looked up once for all passes: in a small world the way to the rows took as
    /// long as some of the passes over them. Far below what is shared.
    /// </summary>
    private const int MostShort = 8;

    private ShortColor[] _short = new ShortColor[ConstraintGraph.ColorCount];

    /// <summary>
    /// The phases of a pass: a colour that is shared, or some in a row that are not worth it, which one worker does. For each phase the first
    /// colour that is behind it, and whether it is one of these.
    /// </summary>
    private readonly StageList _stages = new StageList();
    private GraphColor[] _colors = new GraphColor[ConstraintGraph.ColorCount];
    private StageColors[] _stageColors = new StageColors[ConstraintGraph.ColorCount];
    private StageRunner _runner = null!;
    private ContactPass _pass;
    private GraphColor _color = null!;

    /// <param name="runner">Who shares the passes.</param>
    /// <param name="bodies">The store.</param>
    /// <param name="coefficients">Constants of the substeps.</param>
    /// <param name="colors">The rows of all passes that follow, whose points are known by now.</param>
    public void Begin(StageRunner runner, BodyStore bodies, in ContactCoefficients coefficients, ReadOnlySpan<GraphColor> colors)
    {
        _runner = runner;
        _pass.States = bodies.State.Pointer;
        _pass.Coefficients = coefficients;
        if (_short.Length < colors.Length)
        {
            _short = new ShortColor[2 * colors.Length];
        }

        for (int i = 0; i < colors.Length; i++)
        {
            _short[i] = new ShortColor(colors[i]);
        }

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
            Run(_colors[colors.End - 1], from, to);
            return;
        }

        for (int i = stage == 0 ? 0 : _stageColors[stage - 1].End; i < colors.End; i++)
        {
            ref readonly ShortColor found = ref _short[i];
            if (found.Rows.Count > 0)
            {
                Run(found.Rows, found.IsGrounded, found.HasOnePoint);
            }
            else
            {
                Run(_colors[i], 0, RecordsOf(_colors[i]));
            }
        }
    }

    /// <summary>Runs the pass over some records of a colour.</summary>
    private void Run(GraphColor color, int from, int to)
    {
        int first = from * ContactBundle.Beside;
        BundleRuns runs = color.Part(first, Math.Min(to * ContactBundle.Beside, color.BundleCount));
        bool far = color.BundleCount > MostNear;
        while (runs.Next())
        {
            var rows = new BundleRun(runs.Bundles, runs.Count, runs.Following, far, color.IsSequential);
            Run(rows, color.IsGrounded, OnePoint.Are(rows.Bundles, rows.Count));
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
            ref readonly ShortColor found = ref _short[i];
            if (found.Rows.Count > 0)
            {
                Run(found.Rows, found.IsGrounded, found.HasOnePoint);
                continue;
            }

            _color = colors[i];
            _runner.Run(this, RecordsOf(_color), _color.IsSequential ? int.MaxValue : LeastRecords);
        }
    }

    private void FindStages(ReadOnlySpan<GraphColor> colors)
    {
        if (!_runner.IsShared(2, 1))
        {
            return;
        }

        if (_colors.Length < colors.Length)
        {
            _colors = new GraphColor[2 * colors.Length];
            _stageColors = new StageColors[2 * colors.Length];
        }

        _runner.Clear(_stages);
        bool any = false;
        bool alone = false;
        for (int i = 0; i < colors.Length; i++)
        {
            GraphColor color = colors[i];
            _colors[i] = color;
            int blocks = color.IsSequential ? 1 : _runner.BlocksOf(RecordsOf(color), LeastRecords);
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

    /// <summary>Where the rows of a colour of few bundles are; no rows: it is not one, or they lie apart.</summary>
    private readonly struct ShortColor
    {
        public readonly BundleRun Rows;
        public readonly bool IsGrounded;
        public readonly bool HasOnePoint;

        public ShortColor(GraphColor color)
        {
            Rows = default;
            IsGrounded = color.IsGrounded;
            HasOnePoint = false;
            if (color.BundleCount > MostShort)
            {
                return;
            }

            BundleRuns runs = color.Runs;
            if (runs.Next() && runs.Count == color.BundleCount)
            {
                Rows = new BundleRun(runs.Bundles, runs.Count, runs.Following, isFar: false, color.IsSequential);
                HasOnePoint = OnePoint.Are(runs.Bundles, runs.Count);
            }
        }
    }
}
