using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>What <see cref="TreeTension"/> does, for trees side by side; the records of their bodies get it too.</summary>
internal static unsafe class LaneTension
{
    private const int Y = LaneMatrix.Step;

    /// <returns>True if the inertia of any body changes.</returns>
    public static bool Stiffen(in LaneBundle bundle, LaneTrees* trees, JointForest forest, BodyStore bodies, double substep)
    {
        bool any = false;
        for (int lane = 0; lane < trees->Count; lane++)
        {
            if ((trees->Live & (1 << lane)) == 0)
            {
                continue;
            }

            TreeNode* records = forest.Nodes + forest.Trees[trees->Tree[lane]].First;
            Pull(bundle, lane, records);
            for (int i = 0; i < bundle.Count; i++)
            {
                LaneNode* node = DoubleLanes.Shift(bundle.Nodes + i, lane);
                any |= TreeTension.Stiffen(bodies, records + i, substep, ref node->Velocity[2 * Y]);
                node->InverseInertia[0] = records[i].InverseInertia;
            }
        }

        return any;
    }

    private static void Pull(in LaneBundle bundle, int lane, TreeNode* records)
    {
        for (int i = 0; i < bundle.Count; i++)
        {
            records[i].Tension = 0;
        }

        for (int i = 1; i < bundle.Count; i++)
        {
            LanePlace* place = bundle.Places + i;
            Pull(&DoubleLanes.Shift(bundle.Nodes + i, lane)->Joint, place, records + i, records + place->Parent);
        }

        for (int i = 0; i < bundle.AnchorCount; i++)
        {
            LanePlace* place = bundle.AnchorPlaces + i;
            Pull(&DoubleLanes.Shift(bundle.Anchors + i, lane)->Joint, place, records + place->Parent, null);
        }
    }

    private static void Pull(LaneJoint* joint, LanePlace* place, TreeNode* child, TreeNode* other)
    {
        double x = joint->Given[0] - joint->GivenBefore[0];
        double y = joint->Given[Y] - joint->GivenBefore[Y];
        joint->GivenBefore[0] = joint->Given[0];
        joint->GivenBefore[Y] = joint->Given[Y];
        if (place->Form <= LaneForm.Weld)
        {
            Pull(place->IsA ? child : other, (-joint->ArmA[0] * x) - (joint->ArmA[Y] * y));
            Pull(place->IsA ? other : child, (joint->ArmB[0] * x) - (-joint->ArmB[Y] * y));
        }
    }

    private static void Pull(TreeNode* node, double tension)
    {
        if (node != null)
        {
            node->Tension += tension;
        }
    }
}
