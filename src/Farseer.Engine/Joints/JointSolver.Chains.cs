using Farseer.Engine.Joints.Chains;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints;

/// <content>Quiet chains, which are in none of the lists: they see to themselves until something happens to them.</content>
internal sealed unsafe partial class JointSolver
{
    private readonly ChainSolver _chains;
    private readonly Column<int> _movers = new Column<int>();

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
        if (!_chains.Any || !_chains.AllStay || _step.Watched)
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

        _movers.EnsureCapacity(padded + WideLanes.BundleLanes);
        for (int i = 0; i < padded; i++)
        {
            int node = list[i] == 0 ? -1 : _forest.NodeOf(list[i]);
            _movers[count] = list[i];
            count += list[i] == 0 || (node >= 0 && _forest.Trees[_forest.Nodes[node].Tree].IsQuiet) ? 0 : 1;
        }

        while (count % WideLanes.BundleLanes != 0)
        {
            _movers[count++] = 0;
        }

        return _movers.Pointer;
    }

    private void LookAtChains() => _chains.Look(_step, UsesChains && !_step.Drifts);

    /// <summary>A joint of a chain that sees to itself.</summary>
    private bool IsQuiet(int index) => _forest.Trees[TreeOf(_active[index].Ends)].IsQuiet;

    /// <summary>Chains that something touches or a spring pulls at after all are put into the lists.</summary>
    private void AdmitTouched()
    {
        if (!_chains.Any)
        {
            return;
        }

        for (int i = 0; i < _contactCount; i++)
        {
            Admit(_step.Moves[_contacts[i].Ends.BodyA] != 0 ? _forest.NodeOf(_contacts[i].Ends.BodyA) : -1);
            Admit(_step.Moves[_contacts[i].Ends.BodyB] != 0 ? _forest.NodeOf(_contacts[i].Ends.BodyB) : -1);
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

        int first = _nodeCount;
        int firstJoint = _jointCount;
        int index = _forest.Nodes[node].Tree;
        _chains.Refuse(index);
        TakeFromLanes(index);
        for (int at = first; at < _nodeCount; at++)
        {
            LoadMass(_forest.Nodes + _nodes[at]);
        }

        LoadMoves(first);
        for (int at = first; at < _nodeCount; at++)
        {
            LoadPose(_forest.Nodes + _nodes[at]);
        }

        for (int at = firstJoint; at < _jointCount; at++)
        {
            CopySettings(_joints[at]);
            WriteJoint(_joints[at]);
        }
    }

    private void SolveChains(bool relaxed)
    {
        if (_chains.Any)
        {
            _chains.Solve(relaxed);
            LoadJointsGiven();
            TakeLeft(_chains);
        }
    }

    private void CorrectChains()
    {
        if (_chains.Any)
        {
            _chains.CorrectPositions();
            LoadJointsGiven();
            TakeAstray(_chains);
        }
    }

    /// <summary>What the step has not prepared for the joints of chains that are given back.</summary>
    private void LoadJointsGiven()
    {
        for (int k = 0; k < _chains.GivenCount; k++)
        {
            JointTree* tree = _forest.Trees + _chains.Given(k);
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
        CopySettings(index);
        ForgetBends(_active.Pointer + index);
        for (int row = 0; row < JointRows.Most; row++)
        {
            _active[index].Lambda[row] = 0;
            _active[index].PlainLambda[row] = 0;
        }
    }
}
