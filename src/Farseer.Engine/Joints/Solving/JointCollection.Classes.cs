using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints.Solving;

/// <content>
/// Which trees take part in the present passes. Islands that need more substeps than the others make a class of their own and are
/// solved after them.
/// </content>
internal sealed unsafe partial class JointCollection
{
    private const int All = -1;

    /// <summary>Turns to the trees of a class.</summary>
    /// <param name="index">The class.</param>
    /// <param name="substep">Its substep, seconds.</param>
    /// <param name="fineness">How many of its substeps make one of the step's.</param>
    public void Select(int index, double substep, int fineness)
    {
        _work.Fineness = fineness;
        _work.Class = index;
        _work.Step.Substep = substep;
        Choose(index);
        _nets.Select(index);
        if (fineness > 1)
        {
            _solver.Rows.WriteRows(true);
        }
    }

    /// <summary>The trees of a class, but for quiet chains.</summary>
    private void Choose(int index)
    {
        _trees.EnsureCapacity(_forest.TreeRoom);
        _nodes.EnsureCapacity(_forest.NodeRoom);
        _joints.EnsureCapacity(_active.Capacity);
        _work.TreeCount = 0;
        _work.NodeCount = 0;
        _work.JointCount = 0;
        for (int i = 0; i < _forest.TreeCount; i++)
        {
            JointTree* tree = _forest.Trees + i;
            if (!tree->IsQuiet && (index == All || tree->Class == index))
            {
                ChooseTree(i);
            }
        }

        for (int i = 0; i < _work.Count && _chains.QuietJoints < _work.Count; i++)
        {
            JointTree* tree = _forest.Trees + _forest.TreeOf(_active[i].Ends);
            if (!tree->IsQuiet && (index == All || tree->Class == index))
            {
                _joints[_work.JointCount++] = i;
            }
        }
    }

    public void ChooseTree(int index)
    {
        JointTree* tree = _forest.Trees + index;
        _trees[_work.TreeCount++] = index;
        for (int i = tree->First; i < tree->End; i++)
        {
            _nodes[_work.NodeCount++] = i;
        }
    }
}
