using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <summary>
/// Groups of islands solved one after the other, all substeps of one before the next: its rows and bodies stay near meanwhile, and a worker
/// that has one waits for nobody. Each row meets the same rows in the same order as when all groups are solved together.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class SolverUnits : IStageWork
{
    /// <summary>Fewer units for each worker would leave some of them without work at the end.</summary>
    private const int LeastUnitsAWorker = 4;

    // Made once there are groups.
    private int[] _unitOf = Array.Empty<int>();
    private int[] _firstColor = Array.Empty<int>();
    private int[] _firstBody = Array.Empty<int>();
    private int[] _next = Array.Empty<int>();
    private readonly Column<int> _list = new Column<int>();
    private StageRunner _alone = null!;
    private GraphColor[] _colors = Array.Empty<GraphColor>();
    private SubstepSolver[] _solvers = Array.Empty<SubstepSolver>();
    private int _count;
    private BodyStore _bodies = null!;
    private Vector4* _saved;
    private CarriedPush* _pushes;
    private int _rowCount;
    private int _bundleRoom;
    private int _substeps;
    private float _substep;
    private ContactCoefficients _coefficients;
    private float _recovery;
    private bool _anyDeep;
    private bool _coldStart;
    private bool _anySmall;
    private int* _degrees;
    private IslandStore _islands = null!;
    private Vector2 _gravity;
    private ContactImpulses? _impulses;
    private PairSurfaces? _surfaces;

    /// <summary>Places that so many bodies may take, each group filled up to whole bundles.</summary>
    public static int MostListed(int bodies, int groups) => bodies + (groups * WideLanes.BundleLanes);

    /// <summary>Parts the rows and the bodies by unit.</summary>
    /// <param name="runner">Who shares the units out.</param>
    /// <param name="graph">The rows.</param>
    /// <param name="moves">1 for a body that can move.</param>
    /// <param name="list">Bodies with constraints.</param>
    /// <param name="count">How many.</param>
    /// <returns>False: all is to be solved together.</returns>
    public bool Find(StageRunner runner, ConstraintGraph graph, byte* moves, int* list, int count)
    {
        if (graph.Groups.Count == 1)
        {
            return false;
        }

        MakeRoom(runner, graph);
        CountColors(graph);
        return _count >= LeastUnitsAWorker * runner.Workers && ListBodies(graph, moves, list, count);
    }

    /// <summary>Solves all units.</summary>
    /// <param name="input">Contacts that do not bounce, and nothing else that holds bodies.</param>
    /// <param name="first">The solver of the calling thread.</param>
    public void Solve(in SolverInput input, SubstepSolver first)
    {
        _solvers[0] = first;
        _bodies = input.Bodies;
        _rowCount = input.RowCount;
        _bundleRoom = input.BundleRoom;
        _saved = input.Saved;
        _pushes = input.Pushes;
        _substeps = input.Substeps;
        _substep = input.Substep;
        _coefficients = input.Coefficients;
        _recovery = input.Recovery;
        _anyDeep = input.AnyDeep;
        _coldStart = input.ColdStart;
        _anySmall = input.AnySmall;
        _degrees = input.Degrees;
        _islands = input.Islands;
        _gravity = input.GravityVector;
        _impulses = input.Impulses;
        _surfaces = input.Surfaces;
        input.Runner.RunEach(this, _count);
    }

    /// <summary>
    /// All that units need, once there are groups: how many of these are units, and how many colours those have, differs from step to step.
    /// </summary>
    private void MakeRoom(StageRunner runner, ConstraintGraph graph)
    {
        if (_unitOf.Length == 0)
        {
            _unitOf = new int[RowGroups.Most];
            _firstColor = new int[RowGroups.Most + 1];
            _firstBody = new int[RowGroups.Most + 1];
            _next = new int[RowGroups.Most];
            _alone = new StageRunner(1, null);
        }

        if (_colors.Length < graph.ColorRoom)
        {
            _colors = new GraphColor[graph.ColorRoom];
        }

        if (_solvers.Length != runner.Workers)
        {
            _solvers = new SubstepSolver[runner.Workers];
            for (int i = 1; i < _solvers.Length; i++)
            {
                _solvers[i] = new SubstepSolver();
            }
        }
    }

    /// <summary>Lets go of the world.</summary>
    public void Forget()
    {
        if (_bodies == null)
        {
            return;
        }

        _bodies = null!;
        _islands = null!;
        _impulses = null;
        _surfaces = null;
        Array.Clear(_colors, 0, _colors.Length);
        for (int i = 1; i < _solvers.Length; i++)
        {
            _solvers[i].Forget();
        }
    }

    void IStageWork.Run(int worker, int from, int to)
    {
        for (int unit = from; unit < to; unit++)
        {
            if (_firstBody[unit] == _firstBody[unit + 1])
            {
                continue;
            }

            SolverInput input = default;
            input.Runner = _alone;
            input.Bodies = _bodies;
            input.Colors = new ReadOnlySpan<GraphColor>(_colors, _firstColor[unit], _firstColor[unit + 1] - _firstColor[unit]);
            input.RowCount = _rowCount;
            input.BundleRoom = _bundleRoom;
            input.List = _list.Pointer + _firstBody[unit];
            input.PaddedCount = _firstBody[unit + 1] - _firstBody[unit];
            input.Saved = _saved + _firstBody[unit];
            input.Pushes = _pushes;
            input.Substeps = _substeps;
            input.Substep = _substep;
            input.Coefficients = _coefficients;
            input.Recovery = _recovery;
            input.AnyDeep = _anyDeep;
            input.ColdStart = _coldStart;
            input.AnySmall = _anySmall;
            input.Degrees = _degrees;
            input.Islands = _islands;
            input.GravityVector = _gravity;
            input.Impulses = _impulses;
            input.Surfaces = _surfaces;
            _solvers[worker].Solve(input);
        }
    }

    /// <summary>The colours of each unit, in the order of solving. Tied groups are unit 0.</summary>
    private void CountColors(ConstraintGraph graph)
    {
        ReadOnlySpan<GraphColor> solved = graph.Solved;
        _count = 1;
        for (int group = 0; group < graph.Groups.Count; group++)
        {
            _unitOf[group] = graph.Groups.IsTied(group) ? 0 : _count++;
        }

        for (int i = 0; i <= _count; i++)
        {
            _firstColor[i] = 0;
        }

        foreach (GraphColor color in solved)
        {
            _firstColor[_unitOf[color.Group] + 1]++;
        }

        for (int i = 0; i < _count; i++)
        {
            _firstColor[i + 1] += _firstColor[i];
            _next[i] = _firstColor[i];
        }

        foreach (GraphColor color in solved)
        {
            _colors[_next[_unitOf[color.Group]]++] = color;
        }
    }

    /// <summary>The bodies of each unit, filled up to whole bundles with body 0.</summary>
    /// <returns>False if a body is led on its way, which rows of several units may read.</returns>
    private bool ListBodies(ConstraintGraph graph, byte* moves, int* list, int count)
    {
        for (int i = 0; i < _count; i++)
        {
            _next[i] = 0;
        }

        for (int i = 0; i < count; i++)
        {
            if (moves[list[i]] == 0)
            {
                return false;
            }

            _next[_unitOf[graph.Groups.Of(list[i])]]++;
        }

        int total = 0;
        for (int i = 0; i < _count; i++)
        {
            _firstBody[i] = total;
            total += (_next[i] + WideLanes.BundleLanes - 1) / WideLanes.BundleLanes * WideLanes.BundleLanes;
            _next[i] = _firstBody[i];
        }

        _firstBody[_count] = total;
        _list.EnsureCapacity(total);
        for (int i = 0; i < count; i++)
        {
            _list[_next[_unitOf[graph.Groups.Of(list[i])]]++] = list[i];
        }

        for (int i = 0; i < _count; i++)
        {
            while (_next[i] < _firstBody[i + 1])
            {
                _list[_next[i]++] = 0;
            }
        }

        return true;
    }
}
