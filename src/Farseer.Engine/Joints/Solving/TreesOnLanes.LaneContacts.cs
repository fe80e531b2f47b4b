using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <content>
/// Contacts of trees that are solved side by side: swept one by one, with the motors and springs of these trees, between their passes.
/// </content>
internal sealed unsafe partial class TreesOnLanes
{
    /// <summary>Trees with contacts that are on lanes, and their rows, in the order of the agenda.</summary>
    private readonly Column<int> _laneTrees = new Column<int>();
    private readonly Column<int> _laneAgenda = new Column<int>();
    private int _laneTreeCount;
    private int _laneAgendaCount;

    private void ClearOnLanes()
    {
        _laneTrees.EnsureCapacity(_trees.Capacity);
        _laneAgenda.EnsureCapacity(_agenda.Capacity);
        _laneTreeCount = 0;
        _laneAgendaCount = 0;
    }

    /// <summary>It does not tie its tree to another, nothing bounces, and no overlap is pushed apart.</summary>
    private bool IsOrdinary(TreeContact* contact)
    {
        ref RowEnds ends = ref contact->Ends;
        return !contact->Deep && contact->Restitution <= 0 && (ends.NodeA < 0 || ends.NodeB < 0 || ends.Coupled);
    }

    /// <summary>The impulses that the rows of trees with contacts on lanes start from.</summary>
    public void WarmStartOnLanes()
    {
        if (_laneTreeCount == 0)
        {
            return;
        }

        _lanes.Contacts.ShareVelocities();
        _solver.Contacts.WarmStart(_laneTrees, _laneTreeCount, _laneAgenda, _laneAgendaCount);

        _lanes.Contacts.TakeVelocities();
    }

    /// <summary>Separations and responses of the rows of trees with contacts on lanes.</summary>
    /// <param name="refactored">Only of trees whose limits changed.</param>
    public void PrepareOnLanes(bool refactored)
    {
        for (int i = 0; i < _laneAgendaCount; i++)
        {
            int item = _laneAgenda[i];
            if (!refactored || _forest.Trees[_forest.TreeOf(_solver.Sweeps.EndsOf(item))].Refactored)
            {
                _solver.Sweeps.Prepare(item);
            }
        }

        for (int at = 0; refactored && at < _laneTreeCount; at++)
        {
            _forest.Trees[_laneTrees[at]].Refactored = false;
        }
    }

    /// <summary>As <see cref="TreeSweeps.RunPass"/> goes on after the trees are solved.</summary>
    private void SweepOnLanes(SweepKind pass, int sweeps)
    {
        if (_laneTreeCount == 0)
        {
            return;
        }

        PrepareOnLanes(true);
        _lanes.Contacts.ShareVelocities();
        WalkOnLanes(pass, sweeps);
        _lanes.Contacts.TakeSwept();
        if (pass != SweepKind.Settle && _lanes.SolveTouched(pass != SweepKind.Biased))
        {
            PrepareOnLanes(true);
            WalkOnLanes(pass, 1);
            _lanes.Contacts.TakeSwept();
        }

        _lanes.Contacts.StoreTouched();
    }

    private void WalkOnLanes(SweepKind pass, int sweeps)
    {
        JointForestView view = _forest.View;
        _solver.Sweeps.Walk(_laneTrees, _laneTreeCount, _laneAgenda, _laneAgendaCount, pass, sweeps, true);
        for (int at = 0; at < _laneTreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _laneTrees[at];
            if (tree->GroupActs)
            {
                TreeWalk.End(view, tree);
            }
        }
    }

    /// <summary>The rounds of the correction, as <see cref="TreePositions.Correct"/> makes them.</summary>
    private void CorrectOnLanes()
    {
        for (int round = 0; _laneTreeCount > 0 && _lanes.BeginRound(round); round++)
        {
            WalkOnLanes(SweepKind.Correction, TreePositions.CorrectionSweeps);
            _lanes.EndRound(round);
        }

        _lanes.EndRounds();
    }

    /// <summary>The contacts of a tree that leaves the lanes are swept with the others.</summary>
    private void TakeContactsFromLanes(JointTree* tree, int index)
    {
        if (!tree->Touched)
        {
            return;
        }

        int kept = 0;
        for (int i = 0; i < _laneAgendaCount; i++)
        {
            int item = _laneAgenda[i];
            if (_forest.TreeOf(_solver.Sweeps.EndsOf(item)) == index)
            {
                _agenda[_work.AgendaCount++] = item;
            }
            else
            {
                _laneAgenda[kept++] = item;
            }
        }

        _laneAgendaCount = kept;
        kept = 0;
        for (int at = 0; at < _laneTreeCount; at++)
        {
            if (_laneTrees[at] != index)
            {
                _laneTrees[kept++] = _laneTrees[at];
            }
        }

        _laneTreeCount = kept;
    }
}
