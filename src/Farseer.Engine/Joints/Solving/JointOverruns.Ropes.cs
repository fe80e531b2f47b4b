using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints.Solving;

/// <content>What limits do that are edges of a tree.</content>
internal sealed unsafe partial class JointOverruns
{
    /// <summary>
    /// An overrun of a tree with edges of limits that was put there from outside goes by displacements, as errors of other joints do: as a
    /// speed it would strike what lies in the way, and where the limit turns meanwhile something of it stays.
    /// </summary>
    public bool HoldsOverrun(ActiveJoint* joint, double share)
    {
        JointTree* tree = TreeOfLimits(joint);
        if (tree == null)
        {
            return false;
        }

        tree->Disturbed |= tree->IsOutside(share);
        return tree->Disturbed;
    }

    /// <summary>The tree of a joint if it has edges of limits, or null.</summary>
    public JointTree* TreeOfLimits(ActiveJoint* joint)
    {
        JointTree* tree = _forest.Trees + _forest.TreeOf(joint->Ends);
        return tree->LimitEdges ? tree : null;
    }
}
