using System;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <content>
/// What rows give through limits that they open. A row in a sweep takes the limits that hold for joints that always do: where one leaves
/// its tree next to no freedom (a slider between two rods, at its stop) a servo of an angle finds an impulse a hundred times as large as
/// what turns its body alone. The limit would pull, is let go, and the impulse is there: a linkage of two bodies of 0.2 kg had 3 J before
/// the sweep and 3 kJ after it, was past all its other stops within the substep, and its servo went on from there.
/// </content>
internal sealed unsafe partial class TreeLimits
{
    private const int KeptOfJoint = JointRows.Most + 3;
    private const int KeptOfContact = 6;
    private readonly KeptState _before = new KeptState();
    private readonly KeptState _first = new KeptState();

    /// <summary>Before the rows are swept: keeps velocities and impulses of what joints push at while limits hold.</summary>
    /// <returns>True if there is any.</returns>
    public bool KeepBeforeRows()
    {
        if (!_work.AnyLimits || _work.AgendaCount == 0 || _chains.AnyPressed)
        {
            return false;
        }

        bool any = false;
        for (int at = 0; at < _work.TreeCount; at++)
        {
            _forest.Trees[_trees[at]].Kept = false;
        }

        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            bool holds = (tree->Joined || tree->Pressed) && tree->HasRows && HoldsLimit(tree, !tree->Joined);
            _forest.Trees[tree->Group].Kept |= holds;
            any |= holds;
        }

        if (any)
        {
            Keep(_before);
        }

        return any;
    }

    /// <param name="tree">The tree.</param>
    /// <param name="open">Only limits that hold at the speed which closes their gap: contacts that open one find it a drive.</param>
    private bool HoldsLimit(JointTree* tree, bool open)
    {
        if (!tree->HasLimits || !tree->Eliminates)
        {
            return false;
        }

        for (int i = tree->First + 1; i < tree->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            for (int r = node->HardRows; r < node->Rows; r++)
            {
                if (!open || IsOpen(_rows.Pointer + node->RowJoint[r], node->RowIndex[r]))
                {
                    return true;
                }
            }
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            TreeAnchor* anchor = _forest.Anchors + i;
            JointRows* rows = _rows.Pointer + anchor->Active;
            for (int r = rows->Hard; r < anchor->Rows && _active[anchor->Active].BlockLimits; r++)
            {
                if (!open || IsOpen(rows, anchor->RowIndex[r]))
                {
                    return true;
                }
            }
        }

        return _solver.LoopLimits.AnyHolds(tree, open);
    }

    /// <summary>Makes room for what is kept, before the first push at a limit.</summary>
    public void ReserveKept()
    {
        Reserve(_before);
        Reserve(_first);
    }

    private void Reserve(KeptState state)
    {
        state.Speeds.EnsureCapacity(3 * _forest.NodeRoom);
        state.OfJoints.EnsureCapacity(KeptOfJoint * _active.Capacity);
        state.OfContacts.EnsureCapacity(KeptOfContact * _contacts.Capacity);
    }

    private void Keep(KeptState state)
    {
        Reserve(state);
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (_forest.GroupOf(tree)->Kept)
            {
                for (int i = tree->First; i < tree->End; i++)
                {
                    TreePositions.Copy(_forest.Nodes[i].Velocity, state.Speeds.Pointer + (3 * i), 3);
                }
            }
        }

        for (int at = 0; at < _work.JointCount; at++)
        {
            ActiveJoint* joint = _active.Pointer + _joints[at];
            TreePositions.Copy(joint->Lambda, state.OfJoints.Pointer + (KeptOfJoint * at), JointRows.Most);
            TreePositions.Copy(joint->Given, state.OfJoints.Pointer + (KeptOfJoint * at) + JointRows.Most, 3);
        }

        for (int i = 0; i < _work.ContactCount; i++)
        {
            double* kept = state.OfContacts.Pointer + (KeptOfContact * i);
            KeepPoint(_contacts[i].Point0, kept);
            KeepPoint(_contacts[i].Point1, kept + (KeptOfContact / 2));
        }
    }

    private static void KeepPoint(in TreeContactPoint point, double* kept)
    {
        kept[0] = point.Normal;
        kept[1] = point.Tangent;
        kept[2] = point.Feed;
    }

    private static void ReturnPoint(ref TreeContactPoint point, double* kept)
    {
        point.Normal = kept[0];
        point.Tangent = kept[1];
        point.Feed = kept[2];
    }

    /// <summary>
    /// After the rows: where they left more energy than there was, all that they gave is taken back, and they are asked again with no limit
    /// held. What they pass then holds, and of both ways that with less energy stays. What drives give without opening a limit never comes
    /// here.
    /// </summary>
    public void AskAgainWithoutLimits(TargetKind kind, SweepKind pass, int sweeps)
    {
        // What turned somewhere else says nothing of a group, and other trees are asked elsewhere when they go side by side.
        for (int at = 0; at < _work.TreeCount; at++)
        {
            _forest.Trees[_trees[at]].Kept &= _forest.Trees[_trees[at]].GroupActs;
        }

        if (!FindGains(_before))
        {
            return;
        }

        Keep(_first);
        Return(_before);
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (_forest.GroupOf(tree)->GroupActs && tree->HasLimits && tree->Eliminates)
            {
                LetGoOfLimits(tree);
                _solver.Responses.Factor(tree);
                tree->Refactored = true;
            }
        }

        PrepareAgain();
        _solver.Sweeps.Sweep(pass, sweeps, true);
        HoldAgain(kind, false);
        if (FindGains(_first))
        {
            Return(_first);
            HoldAgain(kind, true);
        }
    }

    /// <summary>Before an impact: keeps velocities and impulses of what hangs together with limits that hold.</summary>
    /// <returns>True if there are any.</returns>
    public bool KeepBeforeImpact()
    {
        bool any = false;
        for (int at = 0; at < _work.TreeCount && _work.AnyLimits; at++)
        {
            _forest.Trees[_trees[at]].Kept = false;
        }

        for (int at = 0; at < _work.TreeCount && _work.AnyLimits; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            bool holds = HoldsLimit(tree, false);
            _forest.GroupOf(tree)->Kept |= holds;
            any |= holds;
        }

        if (any)
        {
            Keep(_before);
        }

        return any;
    }

    /// <summary>
    /// Takes back what the groups that act have got since <see cref="KeepBeforeImpact"/>; limits of refactored trees were let go meanwhile.
    /// </summary>
    public void TakeBackImpact()
    {
        Return(_before);
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (tree->Refactored)
            {
                _solver.Responses.Factor(tree);
            }
        }

        PrepareAgain();
    }

    /// <summary>Limits that are passed hold.</summary>
    /// <param name="kind">What the rows are to reach.</param>
    /// <param name="all">Also in trees that meet theirs: other limits are held in them than their velocities are of.</param>
    private void HoldAgain(TargetKind kind, bool all)
    {
        bool refactored = false;
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (_forest.GroupOf(tree)->GroupActs && tree->HasLimits && tree->Eliminates && (all || LimitsTurn(tree, kind)))
            {
                SolveTree(tree, kind);
                refactored |= tree->Refactored;
            }
        }

        if (refactored)
        {
            PrepareAgain();
        }
    }

    /// <summary>Marks the groups that have more energy than in that state.</summary>
    private bool FindGains(KeptState state)
    {
        _solver.Sweeps.ClearGroups();
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            JointTree* group = _forest.GroupOf(tree);
            for (int i = tree->First; i < tree->End && group->Kept; i++)
            {
                TreeNode* node = _forest.Nodes + i;
                double* kept = state.Speeds.Pointer + (3 * i);
                for (int k = 0; k < 3; k++)
                {
                    double inverse = k < 2 ? node->InverseMass : node->InverseInertia;
                    double gain = (node->Velocity[k] * node->Velocity[k]) - (kept[k] * kept[k]);
                    group->Gained += inverse > 0 ? gain / inverse : 0;
                }
            }
        }

        bool any = false;
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            tree->GroupActs = tree->Kept && tree->Gained > 0;
            tree->Kept = tree->GroupActs;
            tree->Gained = 0;
            any |= tree->GroupActs;
        }

        return any;
    }

    private void Return(KeptState state)
    {
        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            if (_forest.GroupOf(tree)->GroupActs)
            {
                for (int i = tree->First; i < tree->End; i++)
                {
                    TreePositions.Copy(state.Speeds.Pointer + (3 * i), _forest.Nodes[i].Velocity, 3);
                }
            }
        }

        for (int at = 0; at < _work.JointCount; at++)
        {
            ActiveJoint* joint = _active.Pointer + _joints[at];
            if (_forest.GroupOf(_forest.Trees + _forest.TreeOf(joint->Ends))->GroupActs)
            {
                TreePositions.Copy(state.OfJoints.Pointer + (KeptOfJoint * at), joint->Lambda, JointRows.Most);
                TreePositions.Copy(state.OfJoints.Pointer + (KeptOfJoint * at) + JointRows.Most, joint->Given, 3);
            }
        }

        for (int i = 0; i < _work.ContactCount; i++)
        {
            if (_forest.GroupOf(_forest.Trees + _forest.TreeOf(_contacts[i].Ends))->GroupActs)
            {
                double* kept = state.OfContacts.Pointer + (KeptOfContact * i);
                ReturnPoint(ref _contacts[i].Point0, kept);
                ReturnPoint(ref _contacts[i].Point1, kept + (KeptOfContact / 2));
            }
        }
    }

    /// <summary>
    /// No limit holds. What they have pushed stays: of a tree that its joints hold twice, it is a million times what it moves.
    /// </summary>
    private void LetGoOfLimits(JointTree* tree)
    {
        for (int i = tree->First + 1; i < tree->End; i++)
        {
            _forest.Nodes[i].Rows = _forest.Nodes[i].HardRows;
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            TreeAnchor* anchor = _forest.Anchors + i;
            if (_active[anchor->Active].BlockLimits)
            {
                anchor->Rows = _rows[anchor->Active].Hard;
            }
        }

        _loops.ReleaseAll(tree);
    }

    /// <summary>Velocities and impulses at some moment of a pass.</summary>
    [NotState(Why.OfOneStep)]
    private sealed class KeptState
    {
        public readonly Column<double> Speeds = new Column<double>();
        public readonly Column<double> OfJoints = new Column<double>();
        public readonly Column<double> OfContacts = new Column<double>();
    }
}
