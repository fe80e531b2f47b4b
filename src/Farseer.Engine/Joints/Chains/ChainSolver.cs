using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Chains;

/// <summary>
/// Chains of hinges that nothing touches, each by itself: what can be done for all bodies or joints of a chain side by side is, and what
/// goes along the chain is left to <see cref="ChainFactor"/> and <see cref="ChainSolve"/>. The passes are those of
/// <see cref="JointSolver"/>, with other roundings, and what these prepare for a step (nodes, rows) is not needed. A chain that is put out
/// of joint from outside, or whose correction goes astray, is given back and solved there for the rest of the step.
/// </summary>
internal sealed unsafe class ChainSolver
{
    private readonly ChainWork _work;
    private readonly Column<Chain> _chains;
    private readonly Column<ChainPlace> _places;
    private readonly ChainExchange _exchange;

    public ChainSolver(ChainWork work)
    {
        _work = work;
        _chains = work.Chains;
        _places = work.Places;
        _exchange = new ChainExchange(work);
        Choice = new ChainChoice(work, _exchange);
        Pressed = new PressedChains(work, Choice, _exchange);
    }

    /// <summary>Which trees are chains, and are solved here.</summary>
    public ChainChoice Choice { get; }

    /// <summary>Chains that contacts press on.</summary>
    public PressedChains Pressed { get; }

    /// <summary>The chains that are given back.</summary>
    public TreesAside Aside => _work;

    /// <summary>Some tree is a chain.</summary>
    public bool AnyChains => _work.Count > 0;

    /// <inheritdoc cref="ChainWork.Any"/>
    public bool Any => _work.Any;

    /// <inheritdoc cref="ChainWork.AnyPressed"/>
    public bool AnyPressed => _work.AnyPressed;

    /// <inheritdoc cref="ChainWork.AllStay"/>
    public bool AllStay => _work.AllStay;

    /// <inheritdoc cref="ChainWork.LiveBodies"/>
    public int LiveBodies => _work.LiveBodies;

    /// <inheritdoc cref="ChainWork.QuietJoints"/>
    public int QuietJoints => _work.QuietJoints;

    /// <summary>Starts the substeps.</summary>
    public void Start()
    {
        for (int i = 0; i < _work.Count; i++)
        {
            Chain* chain = _chains.Pointer + i;
            if (!chain->IsLive)
            {
                continue;
            }

            JointTree* tree = _work.Forest.Trees + chain->Tree;
            tree->Free = true;
            tree->Tied = false;
            tree->Touched = false;
            tree->HasRows = false;
            tree->Group = chain->Tree;
            if (tree->Class > 0)
            {
                // Kinematic bodies have been taken back to where the step began.
                _exchange.LoadStill(chain);
                ChainPoses.Place(_work.ViewOf(chain));
                chain->Swapped = !chain->Swapped;
            }

            ChainView view = _work.ViewOf(chain);
            ChainPlace* places = _places.Pointer + chain->PlaceFirst;
            for (int k = 0; k < chain->Bodies; k++)
            {
                _exchange.LoadMotion(view, k, places + k, chain->HasVelocities);
            }

            chain->HasVelocities = true;
            ChainWork.Clear(view[ChainColumn.Given], 4 * view.Stride);
            ChainFactor.Run(view);
        }
    }

    /// <summary>See <see cref="JointSolver.Enter"/>.</summary>
    public void Enter()
    {
        for (int i = 0; i < _work.Count; i++)
        {
            Chain* chain = _chains.Pointer + i;
            if (!chain->IsLive)
            {
                continue;
            }

            bool free = _work.Forest.Trees[chain->Tree].Free;
            if (_work.Step.Watched)
            {
                _exchange.EnterWatched(chain, free);
            }
            else
            {
                ChainPoses.Drive(_work.ViewOf(chain), free ? -0.5 : 0);
            }
        }
    }

    /// <summary>The biased pass or the relax pass; a chain that is given back is as it was before it.</summary>
    public void Solve(bool relaxed)
    {
        _work.GivenCount = 0;
        for (int i = 0; i < _work.Count; i++)
        {
            Chain* chain = _chains.Pointer + i;
            if (!chain->IsLive)
            {
                continue;
            }

            if (_work.Step.Watched)
            {
                _exchange.Refresh(chain);
            }

            ChainView view = _work.ViewOf(chain);
            if (relaxed)
            {
                ChainSolve.LackRelaxed(view);
            }
            else if (ChainSolve.LackBiased(view, 1 / _work.Step.Substep))
            {
                _exchange.Leave(chain, true);
                continue;
            }

            MeetStill(chain, view);
            ChainSolve.Run(view);
            ChainSolve.Give(view);
            if (_work.Step.Watched)
            {
                _exchange.StoreVelocities(chain);
            }
        }
    }

    /// <summary>
    /// See <see cref="TreePositions.CorrectPositions"/>; the chains that are given back went astray, and are to be projected.
    /// </summary>
    public void CorrectPositions()
    {
        _work.GivenCount = 0;
        _work.HasMoved = true;
        for (int i = 0; i < _work.Count; i++)
        {
            Chain* chain = _chains.Pointer + i;
            if (!chain->IsLive)
            {
                continue;
            }

            if (_work.Step.Watched)
            {
                _exchange.Refresh(chain);
            }

            _exchange.LoadStill(chain);
            ChainView view = _work.ViewOf(chain);
            ChainPoses.Move(view, _work.Step.Substep);
            Correct(chain, view);
            chain->Swapped = !chain->Swapped;
            if (chain->Astray)
            {
                _exchange.Leave(chain, false);
                continue;
            }

            view = _work.ViewOf(chain);
            ChainFactor.Run(view);
            if (_work.Forest.Trees[chain->Tree].Free)
            {
                ChainPoses.Kick(view, 0.5);
            }

            if (_work.Step.Watched)
            {
                _exchange.StoreMoves(chain);
                _exchange.StoreVelocities(chain);
            }
        }
    }

    /// <summary>Gives all back that a step leaves: velocities, displacements and impulses.</summary>
    public void Finish()
    {
        for (int i = 0; i < _work.Count; i++)
        {
            Chain* chain = _chains.Pointer + i;
            if (chain->IsLive)
            {
                _exchange.KeepAll(chain);
                chain->IsLive = false;
            }
        }

        _work.Any = false;
        Pressed.Finish();
    }

    private void Correct(Chain* chain, in ChainView view)
    {
        double h = _work.Step.Substep;
        chain->Astray = false;
        chain->Before = double.PositiveInfinity;
        ChainPoses.Turn(view);
        chain->Worst = ChainPoses.Place(view);
        for (int round = 0; !chain->Astray && chain->Worst > TreePositions.ToleranceAt(round, pressed: false, rows: false); round++)
        {
            if (round == 0)
            {
                ChainSolve.NotePlain(view);
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

    /// <summary>What cannot be moved may yet be moving.</summary>
    private void MeetStill(Chain* chain, in ChainView view)
    {
        if (view.Joints < view.Bodies)
        {
            return;
        }

        int last = view.Bodies - 1;
        int s = view.Stride;
        BodyState* still = _work.Step.Bodies.State.Pointer + _places[chain->PlaceFirst + view.Bodies].Body;
        double* arm = view[view.Arms] + (2 * s) + last;
        double* residual = view[ChainColumn.Residual] + last;
        double w = still->AngularVelocity;
        if (w != 0 || still->LinearVelocity.X != 0 || still->LinearVelocity.Y != 0)
        {
            residual[0] -= still->LinearVelocity.X - (w * arm[s]);
            residual[s] -= still->LinearVelocity.Y + (w * arm[0]);
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s) => _work.Visit(s);
}
