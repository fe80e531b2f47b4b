using Farseer.Engine.Joints.Loose;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints;

/// <content>Joints without hard rows between single bodies, which go side by side: out of the lists for a step, and back.</content>
internal sealed unsafe partial class JointSolver
{
    private readonly LooseSolver _loose = new LooseSolver();

    /// <summary>Takes the groups of bodies that nothing but loose joints holds; their trees are marked.</summary>
    private void TakeLoose()
    {
        _loose.Begin(_forest, _active.Pointer, _rows.Pointer, _step);
        for (int at = 0; at < _treeCount; at++)
        {
            _forest.Trees[_trees[at]].Loose = UsesLanes && !_step.Drifts && !_step.Audited;
            _forest.Trees[_trees[at]].Wishes = true;
            _forest.Trees[_trees[at]].Wished = false;
        }

        for (int at = 0; at < _treeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            bool single = tree->HasRows && !tree->Eliminates && !tree->Guest && !_nets.Search.IsNet(_forest.Nodes[tree->First].Body);
            if (!single || tree->Pulled || tree->Disturbed)
            {
                _forest.Trees[tree->Group].Loose = false;
            }

            _forest.Trees[tree->Group].Wishes &= single;
        }

        for (int i = 0; i < _agendaCount; i++)
        {
            int item = _agenda[i];
            int group = GroupOf(EndsOf(item));
            if (item < 0 || !LooseSolver.Knows(_active.Pointer + item, _rows.Pointer + item))
            {
                _forest.Trees[group].Loose = false;
            }

            if (item < 0 || _rows[item].Hard > 0)
            {
                _forest.Trees[group].Wishes = false;
            }

            if (IsWish(item))
            {
                MarkWished(EndsOf(item).NodeA);
                MarkWished(EndsOf(item).NodeB);
            }
        }

        _anyWishes = false;

        for (int at = 0; at < _treeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            tree->Loose = _forest.Trees[tree->Group].Loose;
            _anyWishes |= !tree->Loose && _forest.Trees[tree->Group].Wishes;
            if (tree->Loose)
            {
                _loose.TakeBody(tree->First);
            }
        }

        for (int i = 0; i < _agendaCount && _loose.BodyCount > 1; i++)
        {
            int item = _agenda[i];
            if (_forest.Trees[GroupOf(EndsOf(item))].Loose)
            {
                _loose.TakeJoint(item);
            }
        }

        if (_loose.Any)
        {
            _loose.Load();
        }
    }

    private int GroupOf(in RowEnds ends) => _forest.Trees[TreeOf(ends)].Group;

    /// <summary>They are in the lists again.</summary>
    private void FinishLoose()
    {
        if (!_loose.Any)
        {
            return;
        }

        _loose.Finish();
        for (int i = 0; i < _loose.BodyCount; i++)
        {
            int node = _loose.NodeAt(i);
            if (node >= 0)
            {
                ChooseTree(_forest.Nodes[node].Tree);
            }
        }

        for (int i = 0; i < _loose.JointCount; i++)
        {
            int index = _loose.JointAt(i);
            _joints[_jointCount++] = index;
            if (!double.IsInfinity(_active[index].Settings.Breakpoint))
            {
                LoadPoseOf(_active[index].Ends.NodeA);
                LoadPoseOf(_active[index].Ends.NodeB);
                WriteJoint(index);
            }
        }
    }

    private void LoadPoseOf(int node)
    {
        if (node >= 0)
        {
            LoadPose(_forest.Nodes + node);
        }
    }
}
