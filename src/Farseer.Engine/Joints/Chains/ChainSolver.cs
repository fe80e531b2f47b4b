using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Chains;

/// <summary>
/// Chains of hinges that nothing touches, each by itself: what can be done for all bodies or joints of a chain side by side is, and what
/// goes along the chain is left to <see cref="ChainFactor"/> and <see cref="ChainSolve"/>. The passes are those of
/// <see cref="JointSolver"/>, with other roundings, and what these prepare for a step (nodes, rows) is not needed. A chain that is put out
/// of joint from outside, or whose correction goes astray, is given back and solved there for the rest of the step.
/// </summary>
internal sealed unsafe partial class ChainSolver : TreesAside
{
    private readonly Column<double> _numbers = new Column<double>();
    private readonly Column<Chain> _chains = new Column<Chain>();
    private readonly Column<ChainPlace> _places = new Column<ChainPlace>();
    private readonly Column<int> _given = new Column<int>();
    [NotState(Why.Elsewhere)]
    private JointForest _forest = null!;
    private readonly JointStore _store;
    private ActiveJoint* _active;
    private JointStep _step;
    private int _count;

    public ChainSolver(JointStore store)
    {
        _store = store;
    }

    /// <summary>Chains are solved here in the present passes.</summary>
    public bool Any { get; private set; }

    /// <summary>None has been given back in the step.</summary>
    public bool AllStay { get; private set; }

    /// <summary>Bodies of the chains that are solved here in the present passes.</summary>
    public int LiveBodies { get; private set; }

    /// <summary>Joints of quiet chains in this step.</summary>
    public int QuietJoints { get; private set; }

    public override int Given(int index) => _given[index];

    public override int GivenSoft(int tree, int index) => -1;

    /// <summary>See <see cref="JointSolver.Enter"/>.</summary>
    public void Enter()
    {
        for (int i = 0; i < _count; i++)
        {
            Chain* chain = _chains.Pointer + i;
            if (!chain->IsLive)
            {
                continue;
            }

            bool free = _forest.Trees[chain->Tree].Free;
            if (_step.Watched)
            {
                EnterWatched(chain, free);
            }
            else
            {
                ChainPoses.Drive(ViewOf(chain), free ? -0.5 : 0);
            }
        }
    }

    /// <summary>The biased pass or the relax pass; a chain that is given back is as it was before it.</summary>
    public void Solve(bool relaxed)
    {
        GivenCount = 0;
        for (int i = 0; i < _count; i++)
        {
            Chain* chain = _chains.Pointer + i;
            if (!chain->IsLive)
            {
                continue;
            }

            if (_step.Watched)
            {
                Refresh(chain);
            }

            ChainView view = ViewOf(chain);
            if (relaxed)
            {
                ChainSolve.LackRelaxed(view);
            }
            else if (ChainSolve.LackBiased(view, 1 / _step.Substep))
            {
                Leave(chain, true);
                continue;
            }

            MeetStill(chain, view);
            ChainSolve.Run(view);
            ChainSolve.Give(view);
            if (_step.Watched)
            {
                StoreVelocities(chain);
            }
        }
    }

    /// <summary>
    /// See <see cref="TreePositions.CorrectPositions"/>; the chains that are given back went astray, and are to be projected.
    /// </summary>
    public void CorrectPositions()
    {
        GivenCount = 0;
        HasMoved = true;
        for (int i = 0; i < _count; i++)
        {
            Chain* chain = _chains.Pointer + i;
            if (!chain->IsLive)
            {
                continue;
            }

            if (_step.Watched)
            {
                Refresh(chain);
            }

            LoadStill(chain);
            ChainView view = ViewOf(chain);
            ChainPoses.Move(view, _step.Substep);
            Correct(chain, view);
            chain->Swapped = !chain->Swapped;
            if (chain->Astray)
            {
                Leave(chain, false);
                continue;
            }

            view = ViewOf(chain);
            ChainFactor.Run(view);
            if (_forest.Trees[chain->Tree].Free)
            {
                ChainPoses.Kick(view, 0.5);
            }

            if (_step.Watched)
            {
                StoreMoves(chain);
                StoreVelocities(chain);
            }
        }
    }

    private void Correct(Chain* chain, in ChainView view)
    {
        double h = _step.Substep;
        chain->Astray = false;
        chain->Before = double.PositiveInfinity;
        ChainPoses.Turn(view);
        chain->Worst = ChainPoses.Place(view);
        for (int round = 0; !chain->Astray && chain->Worst > TreePositions.ToleranceAt(round, pressed: false, rows: false); round++)
        {
            if (round == 0)
            {
                NotePlain(view);
            }

            ChainSolve.LackErrors(view, 1 / h);
            ChainSolve.Run(view);
            double bent = ChainSolve.Correct(view, h);
            ChainPoses.Turn(view);
            chain->Worst = ChainPoses.Place(view);
            chain->Astray = TreesOnLanes.IsAstray(chain->Worst, chain->Before, bent, round);
            chain->Before = chain->Worst;
        }
    }

    /// <summary>Velocities, displacements and impulses before corrections.</summary>
    private static void NotePlain(in ChainView view)
    {
        Copy(view[ChainColumn.Velocity], view[ChainColumn.PlainVelocity], 3 * view.Stride);
        Copy(view[ChainColumn.Move], view[ChainColumn.PlainMove], 3 * view.Stride);
        Copy(view[ChainColumn.Given], view[ChainColumn.PlainGiven], 4 * view.Stride);
        double* bent = view[ChainColumn.Bent];
        for (int i = 0; i < view.Stride; i += WideDouble.Count)
        {
            WideDouble.Zero.Store(bent + i);
        }
    }

    private static void Copy(double* from, double* to, int count)
    {
        for (int i = 0; i < count; i += WideDouble.Count)
        {
            WideDouble.Load(from + i).Store(to + i);
        }
    }

    /// <summary>What cannot be moved may yet be moving.</summary>
    private void MeetStill(Chain* chain, in ChainView view)
    {
        if (view.Joints < view.Bodies)
        {
            return;
        }

        int last = view.Bodies - 1;
        int s = view.Stride;
        BodyState* still = _step.Bodies.State.Pointer + _places[chain->PlaceFirst + view.Bodies].Body;
        double* arm = view[view.Arms] + (2 * s) + last;
        double* residual = view[ChainColumn.Residual] + last;
        double w = still->AngularVelocity;
        if (w != 0 || still->LinearVelocity.X != 0 || still->LinearVelocity.Y != 0)
        {
            residual[0] -= still->LinearVelocity.X - (w * arm[s]);
            residual[s] -= still->LinearVelocity.Y + (w * arm[0]);
        }
    }

    private ChainView ViewOf(Chain* chain) => new ChainView
    {
        First = _numbers.Pointer + chain->First,
        Stride = StrideOf(chain->Bodies),
        Bodies = chain->Bodies,
        Joints = chain->Joints,
        Middle = chain->IsPressed ? chain->Middle : chain->Joints / 2,
        IsPressed = chain->IsPressed,
        Low = chain->Low,
        High = chain->High,
        Arms = chain->Swapped ? ChainColumn.OtherArms : ChainColumn.Arms,
        NewArms = chain->Swapped ? ChainColumn.Arms : ChainColumn.OtherArms,
    };

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Local(_numbers);
        s.Column(_chains);
        s.Column(_places);
        s.Column(_given);
        s.Value(ref _count);
        Any = s.Value(Any);
        AllStay = s.Value(AllStay);
        LiveBodies = s.Value(LiveBodies);
        QuietJoints = s.Value(QuietJoints);
        AnyPressed = s.Value(AnyPressed);
    }
}
