using Farseer.Engine.Joints.Loose;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints.Solving;

/// <content>Joints without hard rows between single bodies, which go side by side: out of the lists for a step, and back.</content>
internal sealed unsafe partial class TreesOnLanes
{
    /// <summary>Takes the groups of bodies that nothing but loose joints holds; their trees are marked.</summary>
    private void TakeLoose()
    {
        _loose.Begin(_forest, _active.Pointer, _rows.Pointer, _work.Step);
        for (int at = 0; at < _work.TreeCount; at++)
        {
            _forest.Trees[_trees[at]].Loose = UsesLanes && !_work.Step.Drifts && !_work.Step.Audited;
            _forest.Trees[_trees[at]].Wishes = true;
            _forest.Trees[_trees[at]].Wished = false;
        }

        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            bool single = tree->HasRows && !tree->Eliminates && !tree->Guest && !_nets.Search.IsNet(_forest.Nodes[tree->First].Body);
            if (!single || tree->Pulled || tree->Disturbed)
            {
                _forest.Trees[tree->Group].Loose = false;
            }

            _forest.Trees[tree->Group].Wishes &= single;
        }

        for (int i = 0; i < _work.AgendaCount; i++)
        {
            int item = _agenda[i];
            int group = GroupOfEnds(_solver.Sweeps.EndsOf(item));
            if (item < 0 || !LooseSolver.Knows(_active.Pointer + item, _rows.Pointer + item))
            {
                _forest.Trees[group].Loose = false;
            }

            if (item < 0 || _rows[item].Hard > 0)
            {
                _forest.Trees[group].Wishes = false;
            }

            if (_solver.Wishes.IsWish(item))
            {
                _solver.Wishes.MarkWished(_solver.Sweeps.EndsOf(item).NodeA);
                _solver.Wishes.MarkWished(_solver.Sweeps.EndsOf(item).NodeB);
            }
        }

        _work.AnyWishes = false;

        for (int at = 0; at < _work.TreeCount; at++)
        {
            JointTree* tree = _forest.Trees + _trees[at];
            tree->Loose = _forest.Trees[tree->Group].Loose;
            _work.AnyWishes |= !tree->Loose && _forest.Trees[tree->Group].Wishes;
            if (tree->Loose)
            {
                _loose.TakeBody(tree->First);
            }
        }

        for (int i = 0; i < _work.AgendaCount && _loose.BodyCount > 1; i++)
        {
            int item = _agenda[i];
            if (_forest.Trees[GroupOfEnds(_solver.Sweeps.EndsOf(item))].Loose)
            {
                _loose.TakeJoint(item);
            }
        }

        if (_loose.Any)
        {
            _loose.Load();
        }
    }

    private int GroupOfEnds(in RowEnds ends) => _forest.Trees[_forest.TreeOf(ends)].Group;

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
                _solver.Collection.ChooseTree(_forest.Nodes[node].Tree);
            }
        }

        for (int i = 0; i < _loose.JointCount; i++)
        {
            int index = _loose.JointAt(i);
            _joints[_work.JointCount++] = index;
            if (!double.IsInfinity(_active[index].Settings.Breakpoint))
            {
                LoadPoseOf(_active[index].Ends.NodeA);
                LoadPoseOf(_active[index].Ends.NodeB);
                _solver.Rows.WriteJoint(index);
            }
        }
    }

    private void LoadPoseOf(int node)
    {
        if (node >= 0)
        {
            _solver.Bodies.LoadPose(_forest.Nodes + node);
        }
    }
}
