using Farseer.Engine.Joints.Loose;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Solving;

/// <summary>How a tree as a whole answers to forces: for springs, which pull at its bodies before the joints act.</summary>
[NotState(Why.Fixed)]
internal sealed unsafe class TreeResponses : JointPart
{
    public TreeResponses(JointSolver solver, JointWork work)
        : base(solver, work)
    {
    }

    /// <summary>Number of trees that joints make of the bodies, single ones included.</summary>
    public int TreeCount => _forest.TreeCount;

    /// <summary>Number of bodies in them.</summary>
    public int TreeBodies => _forest.Count;

    /// <summary>The tree in which eliminated joints hold a body; -1: none.</summary>
    public int TreeOfBody(int body) => _solver.Contacts.IsInTree(body) ? _forest.Nodes[_forest.NodeOf(body)].Tree : -1;

    public int SizeOf(int tree) => _forest.Trees[tree].End - _forest.Trees[tree].First;

    /// <summary>Body of a tree by its place in it.</summary>
    public int BodyOf(int tree, int place) => _forest.Nodes[_forest.Trees[tree].First + place].Body;

    /// <summary>A force pulls at a tree in this step that is given before its bodies move.</summary>
    public void MarkPulled(int tree) => _forest.Trees[tree].Pulled = true;

    /// <summary>A spring that is no joint pulls at a body in this step.</summary>
    public void MarkStrung(int body)
    {
        int node = _forest.NodeOf(body);
        if (node >= 0)
        {
            _forest.Trees[_forest.Nodes[node].Tree].Strung = true;
        }
    }

    /// <summary>
    /// The velocity changes that impulses on a tree's bodies make, three numbers a body; its joints hold as they did last.
    /// </summary>
    public void Respond(int tree, double* impulses, double* changes)
    {
        JointTree* t = _forest.Trees + tree;
        _solver.Limits.Save(t);
        for (int i = t->First; i < t->End; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            double* p = impulses + (3 * (i - t->First));
            node->Velocity[0] = node->InverseMass * p[0];
            node->Velocity[1] = node->InverseMass * p[1];
            node->Velocity[2] = node->InverseInertia * p[2];
        }

        SolveChanges(t, changes);
    }

    /// <summary>What its joints leave of velocity changes of a tree's bodies.</summary>
    public void Project(int tree, double* changes)
    {
        JointTree* t = _forest.Trees + tree;
        _solver.Limits.Save(t);
        for (int i = t->First; i < t->End; i++)
        {
            TreePositions.Copy(changes + (3 * (i - t->First)), _forest.Nodes[i].Velocity, 3);
        }

        SolveChanges(t, changes);
    }

    private void SolveChanges(JointTree* tree, double* changes)
    {
        for (int i = tree->First; i < tree->End; i++)
        {
            ClearChanges(_forest.Nodes[i].Target);
        }

        for (int i = tree->AnchorFirst; i < tree->AnchorEnd; i++)
        {
            ClearChanges(_forest.Anchors[i].Target);
        }

        _loops.ClearTargets(tree);
        _loops.Solve(tree);
        for (int i = tree->First; i < tree->End; i++)
        {
            TreePositions.Copy(_forest.Nodes[i].Velocity, changes + (3 * (i - tree->First)), 3);
        }

        _solver.Limits.Restore(tree);
    }

    private static void ClearChanges(double* v)
    {
        v[0] = 0;
        v[1] = 0;
        v[2] = 0;
    }

    /// <summary>The elimination of a tree and, with it, its loops.</summary>
    public void Factor(JointTree* tree)
    {
        TreeFactor.Run(_forest, tree, _active.Pointer, _rows.Pointer);
        _loops.Factor(tree);
    }

    /// <summary>Adds what a solution gave to the joints of a tree.</summary>
    public void Give(JointTree* tree)
    {
        TreeReactions.Give(_forest, tree, _active.Pointer, _rows.Pointer);
        _loops.Give(tree);
    }
}
