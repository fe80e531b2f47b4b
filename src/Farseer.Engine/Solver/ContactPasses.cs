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
    /// <summary>
    /// Records that are worth another worker's while, some 0.5 µs of a pass: a phase of two blocks takes 0.3 µs to share.
    /// </summary>
    private const int LeastRecords = 8;

    /// <summary>Bundles of a colour of a world whose rows are no longer near, some 8 MB in all colours.</summary>
    private const int MostNear = 384;

    /// <summary>Bundles of a colour that nobody is asked to share.</summary>
    private const int MostShort = 8;

    /// <summary>
    /// An odd number of bundles up to this is solved bundle by bundle, on eight lanes: with 3, 5 and 7 bundles a step of boxes at rest
    /// takes 0.91, 0.95 and 0.975 of its time on a core that halves 512 bits, with 2 and 4 it would take 1.02 and 1.06.
    /// </summary>
    private const int MostOdd = 7;

    /// <summary>
    /// Where the bundles of all colours are, or their records where these are solved as one: looked up once for all passes, and
    /// <see cref="BundleList.PlacesBehind"/> more.
    /// </summary>
    private readonly Column<nint> _list = new Column<nint>();

    /// <summary>For each of them which lanes did not push before: see <see cref="BundleList.Fresh"/>.</summary>
    private readonly Column<ushort> _fresh = new Column<ushort>();
    private readonly Column<ListedColor> _colors = new Column<ListedColor>();
    private int _colorCount;

    /// <summary>
    /// The phases of a pass: a colour that is shared, or some in a row that are not worth it, which one worker does. For each phase the
    /// first colour that is behind it, and whether it is one of these.
    /// </summary>
    private readonly StageList _stages = new StageList();

    /// <summary>Parts of the list, and of which colour they are: what <see cref="RelaxChosen"/> walks over.</summary>
    private readonly Column<ChosenPart> _chosen = new Column<ChosenPart>();
    private int _chosenCount;
    private readonly Column<StageColors> _stageColors = new Column<StageColors>();
    private StageRunner _runner = null!;
    private ContactPass _pass;
    private int _color;

    /// <param name="runner">Who shares the passes.</param>
    /// <param name="bodies">The store.</param>
    /// <param name="coefficients">Constants of the substeps.</param>
    /// <param name="colors">The rows of all passes that follow, whose points are known by now.</param>
    /// <param name="bundleRoom">Bundles that the rows of the world have memory for: as long as that does not grow, nothing here
    /// does.</param>
    /// <param name="areHalves">The rows are halved: see <see cref="RowHalves"/>.</param>
    public void Begin(
        StageRunner runner,
        BodyStore bodies,
        in ContactCoefficients coefficients,
        ReadOnlySpan<GraphColor> colors,
        int bundleRoom,
        bool areHalves)
    {
        ReserveBundles(bundleRoom);
        ReserveColors(runner, Math.Max(colors.Length, Math.Min(bundleRoom, ConstraintGraph.ColorCount)));
        _runner = runner;
        _pass.States = bodies.State.Pointer;
        _pass.Coefficients = coefficients;
        ListColors(colors, areHalves);
        FindStages();
    }

    /// <summary>Lets go of the world.</summary>
    public void Forget() => _runner = null!;

    /// <summary>Makes room for the bundles of all rows.</summary>
    public void ReserveBundles(int bundles)
    {
        _list.EnsureCapacity(bundles + BundleList.PlacesBehind);
        _fresh.EnsureCapacity(bundles);
    }

    /// <summary>Makes room for so many colours: each has a bundle at least.</summary>
    private void ReserveColors(StageRunner runner, int colors)
    {
        _colors.EnsureCapacity(colors);
        if (runner.Workers > 1)
        {
            _stageColors.EnsureCapacity(colors);
            _stages.Reserve(colors);
        }
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

    /// <summary>
    /// Makes room for what <see cref="Choose"/> may find in a world of so many bodies: a part for four, where each has five contacts or
    /// less.
    /// </summary>
    public void ReserveChosen(int bodies) => _chosen.EnsureCapacity(bodies / 4);

    /// <summary>Chooses the records with rows of some islands.</summary>
    /// <param name="islands">1 for an island that is wanted.</param>
    /// <param name="islandOfSlot">The island of each slot.</param>
    /// <returns>False if these are more than half of all, which workers had better share as they are.</returns>
    public bool Choose(byte* islands, int* islandOfSlot)
    {
        _chosenCount = 0;
        int all = 0;
        int wanted = 0;
        for (int i = 0; i < _colorCount; i++)
        {
            ref readonly ListedColor color = ref _colors[i];
            int first = color.First;
            int behind = color.First + color.Count;
            for (int at = color.First; at < behind;)
            {
                int next = color.AreRecords || at + 1 == behind || ContactBundle.IsFirst((ContactBundle*)_list[at + 1]) ? at + 1 : at + 2;
                if (HasRowOf((ContactBundle*)_list[at], islands, islandOfSlot, out int bundles))
                {
                    wanted += bundles;
                }
                else
                {
                    AddChosen(i, first, at);
                    first = next;
                }

                at = next;
            }

            AddChosen(i, first, behind);
            all += color.BundleCount;
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
            Run(_colors[_chosen[i].Color], _chosen[i].First, _chosen[i].Count);
        }
    }

    public void PushOut(ReadOnlySpan<GraphColor> colors, float rate)
    {
        _pass.Rate = rate;
        Run(colors, ContactPassKind.PushOut, false);
    }

    void IStageWork.Run(int worker, int from, int to) => RunPart(_color, from, to);

    void ISequenceWork.Run(int worker, int stage, int from, int to)
    {
        StageColors colors = _stageColors[stage];
        if (colors.AreShared)
        {
            RunPart(colors.End - 1, from, to);
            return;
        }

        for (int i = stage == 0 ? 0 : _stageColors[stage - 1].End; i < colors.End; i++)
        {
            RunWhole(i);
        }
    }

    /// <summary>Runs the pass over a colour.</summary>
    private void RunWhole(int color) => Run(_colors[color], _colors[color].First, _colors[color].Count);

    /// <summary>Runs the pass over some records of a colour.</summary>
    private void RunPart(int color, int from, int to)
    {
        ref readonly ListedColor rows = ref _colors[color];
        int beside = rows.AreRecords ? 1 : ContactBundle.Beside;
        int first = from * beside;
        Run(rows, rows.First + first, Math.Min(to * beside, rows.Count) - first);
    }

    /// <summary>Runs the pass over some places of the list, which are of one colour.</summary>
    private void Run(in ListedColor color, int first, int count)
    {
        nint* bundles = _list.Pointer + first;
        ushort* fresh = _fresh.Pointer + first;
#if NET8_0_OR_GREATER
        if (color.AreRecords)
        {
            var records = new Contacts.Sixteen.BundleList((Contacts.Sixteen.ContactBundle**)bundles, fresh, count, color.IsFar);
            Contacts.Sixteen.PassChoice.Run(_pass, records, color.IsGrounded, color.HasOnePoint);
            return;
        }
#endif
        var rows = new BundleList((ContactBundle**)bundles, fresh, count, color.IsFar, color.IsSequential);
        if (color.IsShared)
        {
            SharedKernel.Run(_pass, rows);
        }
        else
        {
            PassChoice.Run(_pass, rows, color.IsGrounded, color.HasOnePoint);
        }
    }

    private void AddChosen(int color, int first, int behind)
    {
        if (first >= behind)
        {
            return;
        }

        _chosen.EnsureCapacity(_chosenCount + 1);
        _chosen[_chosenCount++] = new ChosenPart { Color = color, First = first, Count = behind - first };
    }

    /// <summary>Whether some row of a record is of an island that is wanted, and how many of its bundles have rows.</summary>
    private static bool HasRowOf(ContactBundle* row, byte* islands, int* islandOfSlot, out int bundles)
    {
        ContactBundle.AskAhead(row->Slot);
        int any = 0;
        bundles = 0;
        do
        {
            bundles++;
            for (int lane = 0; lane < ContactBundle.Lanes; lane++)
            {
                any |= islands[islandOfSlot[row->Slot[lane]]];
            }

            row = ContactBundle.Next(row);
        }
        while (!ContactBundle.IsFirst(row) && row->Contact[0] >= 0);

        return any != 0;
    }

    private void Run(ReadOnlySpan<GraphColor> colors, ContactPassKind kind, bool flag)
    {
        _pass.Kind = kind;
        _pass.Flag = flag;
        if (colors.Length == 0 || _runner.RunAll(this, _stages))
        {
            return;
        }

        for (int i = 0; i < _colorCount; i++)
        {
            if (_colors[i].HasOrder || _colors[i].BundleCount <= MostShort)
            {
                RunWhole(i);
                continue;
            }

            _color = i;
            _runner.Run(this, _colors[i].RecordCount, _colors[i].RecordsOf(_colors[i].Middle), LeastRecords);
        }
    }

    /// <summary>
    /// Lists the colours. Those of several groups that are solved together have the same place and no body in common, and are one.
    /// </summary>
    private void ListColors(ReadOnlySpan<GraphColor> colors, bool areHalves)
    {
        _colorCount = 0;
        int end = 0;
        for (int i = 0; i < colors.Length;)
        {
            GraphColor color = colors[i];
            int bundles = color.BundleCount;
            int next = i + 1;
            for (; next < colors.Length && colors[next].Place == color.Place && color.Place >= 0 && !color.HasOrder; next++)
            {
                bundles += colors[next].BundleCount;
            }

            bool areRecords = AreRecords(bundles, color.HasOrder);
            int first = end;
            int middle = -1;
            for (; i < next; i++)
            {
                middle = middle < 0 && colors[i].Group > 0 && areHalves ? end - first : middle;
                BundleRuns runs = colors[i].Runs;
                while (runs.Next())
                {
                    end = List(runs, areRecords, end);
                }

                // Workers divide the list by whole records: the last of a group is listed with the empty bundle in it.
                if (i + 1 < next && !areRecords && (end - first) % ContactBundle.Beside != 0)
                {
                    _list[end] = (nint)ContactBundle.Next((ContactBundle*)_list[end - 1]);
                    end++;
                }
            }

            _colors[_colorCount++] = new ListedColor
            {
                First = first,
                Count = end - first,
                Middle = middle < 0 ? (end - first) / 2 : middle,
                BundleCount = bundles,
                AreRecords = areRecords,
                IsFar = bundles > MostNear,
                IsGrounded = color.IsGrounded,
                IsShared = color.IsShared,
                IsSequential = color.IsSequential,
                HasOnePoint = HaveOnePoint(first, end, areRecords),
            };
        }

        for (int i = 0; i < BundleList.PlacesBehind && end > 0; i++)
        {
            _list[end + i] = _list[end - 1];
        }
    }

    /// <summary>
    /// A colour's rows are solved a record at a time. Of a few bundles, not if half of the last record would be worked for nothing.
    /// </summary>
    private static bool AreRecords(int bundles, bool hasOrder)
    {
#if NET8_0_OR_GREATER
        bool areHalf = bundles % ContactBundle.Beside != 0 && bundles <= MostOdd;
        return Numerics.Sixteen.WideLanes.AreThere && !areHalf && !hasOrder;
#else
        return false;
#endif
    }

    /// <returns>The end of the list.</returns>
    private int List(in BundleRuns run, bool areRecords, int end)
    {
        ContactBundle* row = run.Bundles;
        if (areRecords)
        {
            for (int left = run.Count; left > 0; left -= ContactBundle.Beside)
            {
                _list[end++] = (nint)row++;
            }

            return end;
        }

        for (int left = run.Count; left > 0; left--, row = ContactBundle.Next(row))
        {
            _list[end++] = (nint)row;
        }

        return end;
    }

    private bool HaveOnePoint(int first, int end, bool areRecords)
    {
        for (int i = first; i < end; i++)
        {
            if (!OnePoint.Are((ContactBundle*)_list[i], areRecords ? ContactBundle.Beside : 1))
            {
                return false;
            }
        }

        return true;
    }

    private void FindStages()
    {
        if (!_runner.IsShared(2, 1))
        {
            return;
        }

        _runner.Clear(_stages);
        bool any = false;
        bool alone = false;
        for (int i = 0; i < _colorCount; i++)
        {
            int records = _colors[i].RecordCount;
            int blocks = _colors[i].HasOrder ? 1 : _runner.BlocksOf(records, LeastRecords);
            any |= blocks > 1;
            if (blocks > 1 || !alone)
            {
                alone = blocks == 1;
                _stages.Add(alone ? 1 : records, blocks, alone ? 0 : _colors[i].RecordsOf(_colors[i].Middle));
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

    /// <summary>Places of the list that are of one colour.</summary>
    private struct ChosenPart
    {
        public int Color;
        public int First;
        public int Count;
    }

    private struct ListedColor
    {
        public int First;
        public int Count;

        /// <summary>Places of the first half of the rows.</summary>
        public int Middle;
        public int BundleCount;
        public bool AreRecords;
        public bool IsFar;
        public bool IsGrounded;
        public bool HasOnePoint;
        public bool IsShared;
        public bool IsSequential;

        /// <summary>See <see cref="GraphColor.HasOrder"/>.</summary>
        public readonly bool HasOrder => IsShared || IsSequential;

        /// <summary>What is shared, since bundles of one record have cache lines in common and may be solved together.</summary>
        public readonly int RecordCount => RecordsOf(Count);

        /// <summary>Records that so many places are.</summary>
        public readonly int RecordsOf(int places) => AreRecords ? places : (places + ContactBundle.Beside - 1) / ContactBundle.Beside;
    }
}
