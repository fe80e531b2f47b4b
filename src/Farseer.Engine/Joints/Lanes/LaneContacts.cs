using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>
/// Trees with contacts. Each has its own at other places, so that these are swept one by one, with the motors and springs of the tree, over
/// the records of the bodies and joints: masses, lines and velocities are taken there before, and velocities and what went through each
/// body back. All else is side by side.
/// </summary>
[NotState(Why.Fixed)]
internal sealed unsafe class LaneContacts : LanePart
{
    private readonly LaneBodies _bodies;

    public LaneContacts(LaneWork work, LaneBodies bodies)
        : base(work)
    {
        _bodies = bodies;
    }

    /// <summary>The velocities of all trees with contacts to the records of their bodies: a sweep or a start of impulses follows.</summary>
    public void ShareVelocities()
    {
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            if (LaneWork.IsTouched(trees))
            {
                ShareVelocities(trees, trees->Live);
            }
        }
    }

    /// <summary>The velocities of some trees to the records of their bodies; of the others nothing is swept.</summary>
    public void ShareVelocities(LaneTrees* trees, int lanes)
    {
        trees->Acting = lanes;
        for (int lane = 0; lane < trees->Count; lane++)
        {
            JointTree* tree = _work.Forest.Trees + trees->Tree[lane];
            bool acts = (lanes & (1 << lane)) != 0;
            if (LaneWork.IsLive(trees, lane))
            {
                tree->GroupActs = acts;
            }

            for (int i = 0; i < trees->Nodes && acts; i++)
            {
                PutBack(DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane)->Velocity, _work.Forest.Nodes[tree->First + i].Velocity);
            }

            for (int i = 0; i < trees->Softs && acts; i++)
            {
                LaneSoftPlace* place = _softPlaces.Pointer + trees->SoftFirst + i;
                PutBack(JointOf(trees, place, lane)->Given, _work.Active[_work.ActiveOf(trees, place, lane)].Given);
            }
        }
    }

    private LaneJoint* JointOf(LaneTrees* trees, LaneSoftPlace* place, int lane) => place->Joint >= 0
        ? &DoubleLanes.Shift(_nodes.Pointer + trees->First + place->Joint, lane)->Joint
        : &DoubleLanes.Shift(_anchors.Pointer + trees->AnchorFirst + ~place->Joint, lane)->Joint;

    /// <summary>What motors and springs gave in a sweep.</summary>
    private void TakeGiven(LaneTrees* trees, int lane)
    {
        for (int i = 0; i < trees->Softs; i++)
        {
            LaneSoftPlace* place = _softPlaces.Pointer + trees->SoftFirst + i;
            TakeOver(_work.Active[_work.ActiveOf(trees, place, lane)].Given, JointOf(trees, place, lane)->Given);
        }
    }

    /// <summary>The velocities of the records, after a start of impulses.</summary>
    public void TakeVelocities()
    {
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            if (!LaneWork.IsTouched(trees))
            {
                continue;
            }

            for (int lane = 0; lane < trees->Count; lane++)
            {
                TreeNode* nodes = _work.Forest.Nodes + _work.Forest.Trees[trees->Tree[lane]].First;
                for (int i = 0; i < trees->Nodes && LaneWork.IsLive(trees, lane); i++)
                {
                    TakeOver(nodes[i].Velocity, DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane)->Velocity);
                }

                if (LaneWork.IsLive(trees, lane))
                {
                    TakeGiven(trees, lane);
                }
            }

            _bodies.StoreVelocities(trees);
        }
    }

    /// <summary>After a sweep: the velocities of the trees that took part, and what their joints answered.</summary>
    public void TakeSwept()
    {
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            if (LaneWork.IsTouched(trees))
            {
                TakeSwept(trees);
            }
        }
    }

    public void TakeSwept(LaneTrees* trees)
    {
        bool any = false;
        for (int lane = 0; lane < trees->Count; lane++)
        {
            any |= Carries(trees, lane);
        }

        if (!any)
        {
            return;
        }

        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
        {
            bool carries = lane < trees->Count && Carries(trees, lane);
            if (carries)
            {
                TakeGiven(trees, lane);
            }

            TreeNode* nodes = _work.Forest.Nodes + _work.Forest.Trees[trees->Tree[carries ? lane : 0]].First;
            for (int i = 0; i < trees->Nodes; i++)
            {
                LaneNode* node = DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane);
                LaneWalk* walk = DoubleLanes.Shift(_walks.Pointer + trees->First + i, lane);
                for (int k = 0; k < 3; k++)
                {
                    // Where nothing was brought, nothing is answered.
                    walk->Start[k * Y] = node->Velocity[k * Y];
                    node->Velocity[k * Y] = carries ? nodes[i].Velocity[k] : node->Velocity[k * Y];
                    walk->Through[k * Y] = carries ? nodes[i].Through[k] : 0;
                    node->Got[k * Y] = carries ? nodes[i].Got[k] : 0;
                }
            }
        }

        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            _work.WalksOf(trees, lane).Answer();
        }

        LaneSolve.Give(_work.BundleOf(trees));
    }

    private bool Carries(LaneTrees* trees, int lane) => (trees->Acting & (1 << lane)) != 0 && _work.Forest.Trees[trees->Tree[lane]].Carries;

    /// <summary>At the end of a pass; of trees without contacts the velocities are in the store then.</summary>
    public void StoreTouched()
    {
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            if (LaneWork.IsTouched(trees))
            {
                _bodies.StoreVelocities(trees);
            }
        }
    }

    /// <summary>Masses within the tree, ways and turns, and the lines along which springs and motors push.</summary>
    public void ShareMasses(LaneTrees* trees, int lanes)
    {
        double* space = stackalloc double[3 * LaneMatrix.Row];
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            _work.WalksOf(trees, lane).Complete(space);
        }

        for (int lane = 0; lane < trees->Count; lane++)
        {
            TreeNode* nodes = _work.Forest.Nodes + _work.Forest.Trees[trees->Tree[lane]].First;
            for (int i = 0; i < trees->Nodes && (lanes & (1 << lane)) != 0; i++)
            {
                LaneNode* from = DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane);
                LaneWalk* walk = DoubleLanes.Shift(_walks.Pointer + trees->First + i, lane);
                PutBack(from->Move, nodes[i].Move);
                nodes[i].TurnSin = from->TurnSin[0];
                nodes[i].TurnCos = from->TurnCos[0];
                for (int k = 0; k < 9; k++)
                {
                    nodes[i].FullMass[k] = walk->FullMass[k * Y];
                    nodes[i].T[k] = walk->T[k * Y];
                }
            }

            for (int i = 0; i < trees->Softs && (lanes & (1 << lane)) != 0; i++)
            {
                LaneSoftPlace* place = _softPlaces.Pointer + trees->SoftFirst + i;
                LaneJoint* joint = JointOf(trees, place, lane);
                JointRows* rows = _work.Rows + _work.ActiveOf(trees, place, lane);
                ShareRow(joint, rows, place->Kind0);
                if (place->Rows > 1)
                {
                    ShareRow(joint, rows, place->Kind1);
                }
            }
        }
    }

    /// <summary>Rows of angles are the same at all poses.</summary>
    private static void ShareRow(LaneJoint* joint, JointRows* rows, in LaneSoftKind kind)
    {
        if (kind.Along)
        {
            PutBack(joint->LineA, rows->A + (kind.Index * 3));
            PutBack(joint->LineB, rows->B + (kind.Index * 3));
        }

        if (kind.IsSpring)
        {
            rows->Error[kind.Index] = joint->Travel[0];
        }
    }
}
