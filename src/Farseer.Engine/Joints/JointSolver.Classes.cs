using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints;

/// <content>
/// Which trees take part in the present passes. Islands that need more substeps than the others make a class of their own and are
/// solved after them.
/// </content>
internal sealed unsafe partial class JointSolver
{
    private const int All = -1;

    private readonly Column<int> _trees = new Column<int>();
    private readonly Column<int> _nodes = new Column<int>();
    private readonly Column<int> _joints = new Column<int>();
    private int _treeCount;
    private int _nodeCount;
    private int _jointCount;
    private double _fineness = 1;
    private int _class;

    /// <summary>Turns to the trees of a class.</summary>
    /// <param name="index">The class.</param>
    /// <param name="substep">Its substep, seconds.</param>
    /// <param name="fineness">How many of its substeps make one of the step's.</param>
    public void Select(int index, double substep, int fineness)
    {
        _fineness = fineness;
        _class = index;
        _step.Substep = substep;
        Choose(index);
        _nets.Select(index);
        if (fineness > 1)
        {
            WriteRows(true);
        }
    }

    /// <summary>The trees of a class, but for quiet chains.</summary>
    private void Choose(int index)
    {
        _trees.EnsureCapacity(_forest.TreeRoom);
        _nodes.EnsureCapacity(_forest.NodeRoom);
        _joints.EnsureCapacity(_active.Capacity);
        _treeCount = 0;
        _nodeCount = 0;
        _jointCount = 0;
        for (int i = 0; i < _forest.TreeCount; i++)
        {
            JointTree* tree = _forest.Trees + i;
            if (!tree->IsQuiet && (index == All || tree->Class == index))
            {
                ChooseTree(i);
            }
        }

        for (int i = 0; i < _count && _chains.QuietJoints < _count; i++)
        {
            JointTree* tree = _forest.Trees + TreeOf(_active[i].Ends);
            if (!tree->IsQuiet && (index == All || tree->Class == index))
            {
                _joints[_jointCount++] = i;
            }
        }
    }

    private void ChooseTree(int index)
    {
        JointTree* tree = _forest.Trees + index;
        _trees[_treeCount++] = index;
        for (int i = tree->First; i < tree->End; i++)
        {
            _nodes[_nodeCount++] = i;
        }
    }
}
