using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>Quiet chains, which are in none of the lists: they see to themselves until something happens to them.</summary>
internal sealed unsafe class TreesAsChains : JointPart
{
    private readonly Column<int> _movers = new Column<int>();

    public TreesAsChains(JointSolver solver, JointWork work)
        : base(solver, work)
    {
    }

    /// <summary>Trees that are chains of hinges are solved as such while nothing touches them.</summary>
    public bool UsesChains { get; set; } = true;

    /// <summary>Bodies that <see cref="Movers"/> left out are to be moved again.</summary>
    public bool GivesBodiesBack => !_chains.AllStay;

    /// <summary>Of the bodies of a list those that the passes move; chains are moved by nobody else, unless somebody watches.</summary>
    /// <param name="list">Bodies, padded to whole bundles.</param>
    /// <param name="padded">How many.</param>
    /// <param name="count">How many of them remain.</param>
    /// <returns>The list, if all remain.</returns>
    public int* Movers(int* list, int padded, out int count)
    {
        count = padded;
        if (!(_chains.Any || _chains.AnyPressed) || !_chains.AllStay || _work.Step.Watched)
        {
            return list;
        }

        int all = padded;
        while (all > 0 && list[all - 1] == 0)
        {
            all--;
        }

        count = 0;
        if (all == _chains.LiveBodies)
        {
            return list;
        }

        _movers.EnsureCapacity(_work.Step.Bodies.State.Capacity + WideLanes.BundleLanes);
        for (int i = 0; i < padded; i++)
        {
            int node = list[i] == 0 ? -1 : _forest.NodeOf(list[i]);
            _movers[count] = list[i];
            count += list[i] == 0 || (node >= 0 && IsChained(_forest.Trees + _forest.Nodes[node].Tree)) ? 0 : 1;
        }

        while (count % WideLanes.BundleLanes != 0)
        {
            _movers[count++] = 0;
        }

        return _movers.Pointer;
    }

    private static bool IsChained(JointTree* tree) => tree->IsQuiet || tree->OnChain;

    public void LookAtChains() => _chains.Choice.Look(_work.Step, UsesChains && !_work.Step.Drifts);

    /// <summary>A joint of a chain that sees to itself.</summary>
    public bool IsQuiet(int index) => _forest.Trees[_forest.TreeOf(_active[index].Ends)].IsQuiet;

    /// <summary>Chains that something touches or a spring pulls at after all are put into the lists.</summary>
    public void AdmitTouched()
    {
        if (!_chains.Any)
        {
            return;
        }

        for (int i = 0; i < _work.ContactCount; i++)
        {
            Admit(_work.Step.Moves[_contacts[i].Ends.BodyA] != 0 ? _forest.NodeOf(_contacts[i].Ends.BodyA) : -1);
            Admit(_work.Step.Moves[_contacts[i].Ends.BodyB] != 0 ? _forest.NodeOf(_contacts[i].Ends.BodyB) : -1);
        }

        for (int i = 0; i < _forest.TreeCount; i++)
        {
            if (_forest.Trees[i].Pulled)
            {
                Admit(_forest.Trees[i].First);
            }
        }
    }

    private void Admit(int node)
    {
        if (node < 0 || !_forest.Trees[_forest.Nodes[node].Tree].IsQuiet)
        {
            return;
        }

        int first = _work.NodeCount;
        int firstJoint = _work.JointCount;
        int index = _forest.Nodes[node].Tree;
        _chains.Choice.Refuse(index);
        _solver.Lanes.TakeFromLanes(index);
        for (int at = first; at < _work.NodeCount; at++)
        {
            _solver.Bodies.LoadMass(_forest.Nodes + _nodes[at]);
        }

        _solver.Bodies.LoadMoves(first);
        for (int at = first; at < _work.NodeCount; at++)
        {
            _solver.Bodies.LoadPose(_forest.Nodes + _nodes[at]);
        }

        for (int at = firstJoint; at < _work.JointCount; at++)
        {
            _solver.Collection.CopySettings(_joints[at]);
            _solver.Rows.WriteJoint(_joints[at]);
        }
    }

    public void SolveChains(bool relaxed)
    {
        if (_chains.Any)
        {
            _chains.Solve(relaxed);
            LoadJointsGiven();
            _solver.Lanes.TakeLeft(_chains.Aside);
        }
    }

    public void CorrectChains()
    {
        if (_chains.Any)
        {
            _chains.CorrectPositions();
            LoadJointsGiven();
            _solver.Lanes.TakeAstray(_chains.Aside);
        }
    }

    /// <summary>What the step has not prepared for the joints of chains that are given back.</summary>
    private void LoadJointsGiven()
    {
        for (int k = 0; k < _chains.Aside.GivenCount; k++)
        {
            JointTree* tree = _forest.Trees + _chains.Aside.Given(k);
            for (int i = tree->First + 1; i < tree->End; i++)
            {
                LoadJoint(_forest.Nodes[i].RowJoint[0]);
            }

            for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
            {
                LoadJoint(_forest.Anchors[i].Active);
            }
        }
    }

    private void LoadJoint(int index)
    {
        _solver.Collection.CopySettings(index);
        TreePositions.ForgetBends(_active.Pointer + index);
        for (int row = 0; row < JointRows.Most; row++)
        {
            _active[index].Lambda[row] = 0;
            _active[index].PlainLambda[row] = 0;
        }
    }

    /// <summary>
    /// Chains that contacts press on, if what they press on are bodies without joints or what cannot move, and nothing bounces or is pushed
    /// out of a deep overlap: moves them out of the lists, but for their contacts.
    /// </summary>
    public void TakeToChains()
    {
        _chains.Pressed.ClearTouches(_work.Step);
        if (!UsesChains || !_chains.AnyChains || _work.AgendaCount == 0 || _work.Step.Drifts || _work.AnyWheels || !FindPressed())
        {
            return;
        }

        int kept = 0;
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            tree->OnChain = tree->MayPress && _chains.Pressed.Press(_trees[at]);
            if (!tree->OnChain)
            {
                _trees[kept++] = _trees[at];
            }
        }

        if (kept < _work.TreeCount)
        {
            _work.TreeCount = kept;
            _solver.Lanes.DropAside();
        }
    }

    /// <returns>True if there may be any.</returns>
    private bool FindPressed()
    {
        bool any = false;
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            tree->MayPress = tree->IsChain && tree->HasRows && !tree->Disturbed && !tree->Pulled && HoldsAlone(_trees[at]);
            any |= tree->MayPress;
        }

        for (int i = 0; any && i < _work.AgendaCount; i++)
        {
            int item = _agenda[i];
            ref RowEnds ends = ref _solver.Sweeps.EndsOf(item);
            bool plain = item < 0 && !_contacts[~item].Deep && _contacts[~item].Restitution <= 0;
            PressChain(ends.NodeA, plain);
            PressChain(ends.NodeB, plain);
        }

        return any;
    }

    /// <summary>Joints hold no other tree of its group.</summary>
    private bool HoldsAlone(int index)
    {
        bool alone = true;
        for (int at = 0; alone && at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            alone = _trees[at] == index || !tree->Eliminates || tree->Group != _forest.Trees[index].Group;
        }

        return alone;
    }

    /// <summary>A contact presses at a node, of a chain perhaps.</summary>
    private void PressChain(int node, bool plain)
    {
        if (node >= 0)
        {
            int index = _forest.Nodes[node].Tree;
            JointTree* tree = _forest.Trees + index;
            tree->MayPress &= plain && !_nets.Search.IsNet(_forest.Nodes[node].Body);
            if (tree->MayPress)
            {
                _chains.Pressed.Touch(index, node);
            }
        }
    }

    public void SolvePressed(bool relaxed, bool again)
    {
        if (_chains.AnyPressed)
        {
            _chains.Pressed.Solve(relaxed, again);
            _solver.Lanes.TakeLeft(_chains.Aside);
        }
    }

    public void LeaveAstray(int round)
    {
        if (_chains.AnyPressed)
        {
            _chains.Pressed.FindAstray(round);
            _chains.Pressed.LeaveAstray();
            _solver.Lanes.TakeAstray(_chains.Aside);
        }
    }

    public void LeavePressed()
    {
        if (_chains.AnyPressed)
        {
            _chains.Pressed.LeaveAll();
            _solver.Lanes.TakeLeft(_chains.Aside);
        }
    }

    public void EndPressed()
    {
        if (!_chains.AnyPressed)
        {
            return;
        }

        _chains.Pressed.EndSubstep();
        for (int k = 0; k < _chains.Aside.GivenCount; k++)
        {
            _solver.Lanes.TakeFromLanes(_chains.Aside.Given(k));
            _work.Posed = false;
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_movers);
        UsesChains = s.Value(UsesChains);
    }
}
