using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>
/// Which limits hold: the active set of <see cref="JointSolver"/>, of each tree its own. A lane of which the set is found is solved on with
/// the others; nothing about it changes, and it comes to the same bits again.
/// </summary>
[NotState(Why.Fixed)]
internal sealed unsafe class LaneActiveSet : LanePart
{
    private readonly LaneSoftRows _softRows;
    private readonly LaneContacts _contacts;

    public LaneActiveSet(LaneWork work, LaneSoftRows softRows, LaneContacts contacts)
        : base(work)
    {
        _softRows = softRows;
        _contacts = contacts;
    }

    /// <summary>Solves trees with limits that are held here; the goals are written, and the velocities put aside.</summary>
    /// <param name="trees">The bundle.</param>
    /// <param name="relaxed">The relax pass.</param>
    /// <param name="lanes">The trees that are to be solved; the others come to what they are.</param>
    /// <returns>The lanes in which other limits hold than before.</returns>
    public int SolveLimits(LaneTrees* trees, bool relaxed, int lanes)
    {
        LaneBundle bundle = _work.BundleOf(trees);
        int pressed = PressedLanes(trees);
        int changed = 0;
        for (int round = 0; ; round++)
        {
            LaneSolve.Run(bundle);
            lanes = round == TreeLimits.LimitRounds - 1 ? 0 : Revise(bundle, relaxed, round < TreeLimits.ReleaseRounds, lanes, pressed);
            if (lanes == 0)
            {
                if ((changed & pressed) != 0)
                {
                    ForgetLetGo(bundle);
                }

                return changed;
            }

            changed |= lanes;
            TakeBack(bundle);
            LaneFactor.Run(bundle, !_work.HasMoved);
            WriteGoals(trees, relaxed);
        }
    }

    /// <summary>After rows have pushed: solves the trees again of which a limit that holds would pull, or another is passed.</summary>
    /// <returns>The lanes in which other limits hold than before.</returns>
    public int SolveTurned(LaneTrees* trees, bool relaxed)
    {
        LaneBundle bundle = _work.BundleOf(trees);
        int turned = LaneLimits.Turned(bundle, _work.Step.Pace, relaxed) & trees->Live;
        if (turned == 0)
        {
            return 0;
        }

        LaneBodies.PutAside(bundle.Nodes, bundle.Count);
        WriteGoals(trees, relaxed);
        int changed = SolveLimits(trees, relaxed, turned);
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
        {
            if ((turned & (1 << lane)) == 0)
            {
                LeaveAsWas(bundle, lane);
            }
        }

        LaneSolve.Give(bundle);
        PrepareTurned(trees, changed);
        return changed;
    }

    /// <summary>The masses of trees of which the limits changed, for what is swept over them.</summary>
    public void PrepareTurned(LaneTrees* trees, int changed)
    {
        if (changed == 0)
        {
            return;
        }

        _softRows.PrepareSofts(trees);
        if (trees->Touched)
        {
            _contacts.ShareMasses(trees, changed);
            for (int lane = 0; lane < trees->Count; lane++)
            {
                _work.Forest.Trees[trees->Tree[lane]].Refactored |= (changed & (1 << lane)) != 0;
            }
        }
    }

    /// <summary>A lane takes no part in a solution: its velocities are those put aside, and its joints gave nothing.</summary>
    private static void LeaveAsWas(in LaneBundle bundle, int lane)
    {
        for (int i = 0; i < bundle.Count; i++)
        {
            LaneNode* node = DoubleLanes.Shift(bundle.Nodes + i, lane);
            for (int k = 0; k <= W; k += Y)
            {
                node->Velocity[k] = node->Saved[k];
                node->Joint.Lambda[k] = 0;
            }
        }

        for (int i = 0; i < bundle.AnchorCount; i++)
        {
            LaneAnchor* anchor = DoubleLanes.Shift(bundle.Anchors + i, lane);
            for (int k = 0; k <= W; k += Y)
            {
                anchor->Joint.Lambda[k] = 0;
            }
        }
    }

    /// <returns>Lanes with an error that was put there from outside.</returns>
    public int WriteGoals(LaneTrees* trees, bool relaxed)
    {
        if (!relaxed)
        {
            return LaneGoals.Biased(_work.BundleOf(trees), _work.WalksOrNone(trees), _work.Step.Pace);
        }

        LaneGoals.Relaxed(_work.BundleOf(trees), _work.Step.Pace);
        return 0;
    }

    /// <summary>Trees that contacts push at: see <see cref="TreeLimits.IsJustLetGo"/>.</summary>
    private int PressedLanes(LaneTrees* trees)
    {
        int pressed = 0;
        for (int lane = 0; lane < trees->Count && trees->Touched; lane++)
        {
            pressed |= _work.Forest.Trees[trees->Tree[lane]].Pressed ? 1 << lane : 0;
        }

        return pressed;
    }

    /// <summary>Lets go of limits that pull, and holds those that are passed.</summary>
    /// <returns>The lanes in which anything changed.</returns>
    private int Revise(in LaneBundle bundle, bool relaxed, bool release, int lanes, int pressed)
    {
        int changed = 0;
        for (int i = 1; i < bundle.Count; i++)
        {
            LanePlace* place = bundle.Places + i;
            if (place->HasLimits)
            {
                LaneNode* node = bundle.Nodes + i;
                LaneNode* parent = bundle.Nodes + place->Parent;
                LaneLimits.Verdict verdict =
                    LaneLimits.Judge(&node->Joint, place, node->Velocity, parent->Velocity, _work.Step.Pace, relaxed);
                changed |= Revise(&node->Joint, node->ParentS, place, node, parent, verdict.In(place, lanes, release), pressed);
            }
        }

        for (int i = 0; i < bundle.AnchorCount; i++)
        {
            LanePlace* place = bundle.AnchorPlaces + i;
            if (place->HasLimits)
            {
                LaneAnchor* anchor = bundle.Anchors + i;
                LaneNode* node = bundle.Nodes + place->Parent;
                LaneLimits.Verdict verdict =
                    LaneLimits.Judge(&anchor->Joint, place, node->Velocity, anchor->Still, _work.Step.Pace, relaxed);
                changed |= Revise(&anchor->Joint, anchor->OtherS, place, node, null, verdict.In(place, lanes, release), pressed);
            }
        }

        return changed;
    }

    private static int Revise(
        LaneJoint* joint, double* otherS, LanePlace* place, LaneNode* node, LaneNode* other, in LaneLimits.Verdict verdict, int pressed)
    {
        int passed = verdict.Lower | verdict.Upper;
        for (int lane = 0; (verdict.Pulls | passed) >> lane != 0; lane++)
        {
            int bit = 1 << lane;
            if ((verdict.Pulls & bit) != 0)
            {
                if (joint->HeldAbove[lane] != 0)
                {
                    place->LetGoAbove |= (byte)(bit & pressed);
                }
                else
                {
                    place->LetGoBelow |= (byte)(bit & pressed);
                }

                LetGo(joint, otherS, place, node, other, lane);
            }
            else if ((passed & bit) != 0)
            {
                Hold(joint, place, lane, (verdict.Upper & bit) != 0);
            }
        }

        if (verdict.Pulls != 0)
        {
            place->BlockRows = (byte)(place->Held != 0 ? place->HardRows + 1 : place->HardRows);
        }

        return verdict.Pulls | passed;
    }

    private static void ForgetLetGo(in LaneBundle bundle)
    {
        for (int i = 0; i < bundle.Count; i++)
        {
            bundle.Places[i].LetGoBelow = 0;
            bundle.Places[i].LetGoAbove = 0;
        }

        for (int i = 0; i < bundle.AnchorCount; i++)
        {
            bundle.AnchorPlaces[i].LetGoBelow = 0;
            bundle.AnchorPlaces[i].LetGoAbove = 0;
        }
    }

    private static void Hold(LaneJoint* joint, LanePlace* place, int lane, bool above)
    {
        joint->Held[lane] = -1;
        joint->HeldAbove[lane] = above ? -1 : 0;
        joint->Push[lane] = 0;
        joint->PlainPush[lane] = 0;
        place->Held |= (byte)(1 << lane);
        place->BlockRows = (byte)(place->HardRows + 1);
    }

    /// <summary>What the limit gave in the substep is taken from the velocities that the next round starts from.</summary>
    private static void LetGo(LaneJoint* joint, double* otherS, LanePlace* place, LaneNode* node, LaneNode* other, int lane)
    {
        double push = joint->Push[lane];
        if (push != 0)
        {
            int row = (place->HardRows * LaneMatrix.Row) + lane;
            TakeBack(node, joint->S + row, push, lane);
            if (other != null)
            {
                TakeBack(other, otherS + row, push, lane);
            }

            double* b = (place->LimitIsA ? otherS : joint->S) + row;
            if (place->Second == LaneForm.Range)
            {
                joint->Given[LaneMatrix.Row + lane] -= b[W] * push;
            }

            for (int at = 0; at < LaneMatrix.Row && place->Second != LaneForm.Range; at += LaneMatrix.Step)
            {
                joint->Given[at + lane] -= b[at] * push;
            }
        }

        joint->Push[lane] = 0;
        joint->Held[lane] = 0;
        place->Held &= (byte)~(1 << lane);
    }

    private static void TakeBack(LaneNode* node, double* j, double push, int lane)
    {
        node->Saved[lane] -= node->InverseMass[lane] * j[0] * push;
        node->Saved[Y + lane] -= node->InverseMass[lane] * j[Y] * push;
        node->Saved[W + lane] -= node->InverseInertia[lane] * j[W] * push;
    }

    private static void TakeBack(in LaneBundle bundle)
    {
        for (int i = 0; i < bundle.Count; i++)
        {
            Copy(bundle.Nodes[i].Saved, bundle.Nodes[i].Velocity, 3);
        }
    }

    /// <summary>The range of a joint, and nothing given by its limits.</summary>
    public void LoadLimits(LaneJoint* joint, LanePlace* place, int active)
    {
        ref JointSettings settings = ref _work.Active[active].Settings;
        joint->Lower[0] = place->LowerRow < 0 ? double.NegativeInfinity : settings.Lower;
        joint->Upper[0] = settings.Upper;
        joint->Slop[0] = _work.Rows[active].Share[place->UpperRow];

        // What limits gave in the step before is no start.
        for (int row = place->LowerRow < 0 ? place->UpperRow : place->LowerRow; row <= place->UpperRow; row++)
        {
            _work.Active[active].Lambda[row] = 0;
            _work.Active[active].PlainLambda[row] = 0;
        }
    }

    /// <summary>The limits of an edge or anchor that hold as the step begins.</summary>
    /// <param name="joint">The joint, moved on to its lane.</param>
    /// <param name="place">What it is.</param>
    /// <param name="lane">The lane.</param>
    /// <param name="from">The lane of which it is a copy.</param>
    /// <param name="rows">Rows of the block.</param>
    /// <param name="row">Which row of its joint the last of them is, if it is a limit.</param>
    public void LoadHeld(LaneJoint* joint, LanePlace* place, int lane, int from, int rows, int row)
    {
        bool held = rows > place->HardRows;
        joint->Held[0] = held ? -1 : 0;
        joint->HeldAbove[0] = held && row == place->UpperRow ? -1 : 0;
        joint->Push[0] = 0;
        joint->PlainPush[0] = 0;
        if (held)
        {
            place->BlockRows = (byte)rows;
            place->Held |= (byte)(lane == from ? 1 << lane : 0);
        }
    }

    /// <summary>The limits of a tree's joints that hold, to its records.</summary>
    public void PutHeldBack(LaneTrees* trees, int lane)
    {
        JointTree* tree = _work.Forest.Trees + trees->Tree[lane];
        for (int i = 1; i < trees->Nodes && trees->HasLimits; i++)
        {
            LanePlace* place = _places.Pointer + trees->First + i;
            TreeNode* node = _work.Forest.Nodes + tree->First + i;
            int row = PutHeldBack(&DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane)->Joint, place, lane);
            node->Rows = node->HardRows;
            if (row >= 0)
            {
                node->RowJoint[node->Rows] = place->Limited(lane);
                node->RowIndex[node->Rows++] = row;
            }
        }

        for (int i = 0; i < trees->Anchors && trees->HasLimits; i++)
        {
            LanePlace* place = _anchorPlaces.Pointer + trees->AnchorFirst + i;
            TreeAnchor* anchor = _work.Forest.Anchors + tree->AnchorFirst + i;
            int row = PutHeldBack(&DoubleLanes.Shift(_anchors.Pointer + trees->AnchorFirst + i, lane)->Joint, place, lane);
            anchor->Rows = place->HardRows;
            if (row >= 0)
            {
                anchor->RowIndex[anchor->Rows++] = row;
            }
        }
    }

    /// <returns>The row of the joint that holds; -1: none.</returns>
    private int PutHeldBack(LaneJoint* joint, LanePlace* place, int lane)
    {
        if (!place->HasLimits)
        {
            return -1;
        }

        ActiveJoint* active = _work.Active + place->Limited(lane);
        bool holds = joint->Held[0] != 0;
        int row = joint->HeldAbove[0] != 0 ? place->UpperRow : place->LowerRow;
        for (int k = place->LowerRow < 0 ? place->UpperRow : place->LowerRow; k <= place->UpperRow; k++)
        {
            active->Lambda[k] = holds && k == row ? joint->Push[0] : 0;
            active->PlainLambda[k] = holds && k == row ? joint->PlainPush[0] : 0;
        }

        return holds ? row : -1;
    }

    /// <summary>Where the limits of a tree's joints are.</summary>
    public void PutGapsBack(LaneTrees* trees, int lane)
    {
        for (int i = 1; i < trees->Nodes && trees->HasLimits; i++)
        {
            PutGapsBack(&DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane)->Joint, _places.Pointer + trees->First + i, lane);
        }

        for (int i = 0; i < trees->Anchors && trees->HasLimits; i++)
        {
            int at = trees->AnchorFirst + i;
            PutGapsBack(&DoubleLanes.Shift(_anchors.Pointer + at, lane)->Joint, _anchorPlaces.Pointer + at, lane);
        }
    }

    private void PutGapsBack(LaneJoint* joint, LanePlace* place, int lane)
    {
        if (!place->HasLimits)
        {
            return;
        }

        double* gaps = _work.Active[place->Limited(lane)].Stood;
        gaps[place->UpperRow] = joint->Gap[Y];
        if (place->LowerRow >= 0)
        {
            gaps[place->LowerRow] = joint->Gap[0];
        }
    }

    public void LetGoOfOpenLimits(LaneTrees* trees)
    {
        for (int i = 1; i < trees->Nodes && trees->HasLimits; i++)
        {
            LaneLimits.LetGoOfOpen(&_nodes.Pointer[trees->First + i].Joint, _places.Pointer + trees->First + i);
        }

        for (int i = 0; i < trees->Anchors && trees->HasLimits; i++)
        {
            LaneLimits.LetGoOfOpen(&_anchors.Pointer[trees->AnchorFirst + i].Joint, _anchorPlaces.Pointer + trees->AnchorFirst + i);
        }
    }

    /// <summary>What limits give is a sum over a substep.</summary>
    public void ForgetPushes(LaneTrees* trees)
    {
        for (int i = 1; i < trees->Nodes; i++)
        {
            ForgetPush(&_nodes.Pointer[trees->First + i].Joint, _places.Pointer + trees->First + i);
        }

        for (int i = 0; i < trees->Anchors; i++)
        {
            ForgetPush(&_anchors.Pointer[trees->AnchorFirst + i].Joint, _anchorPlaces.Pointer + trees->AnchorFirst + i);
        }
    }

    private static void ForgetPush(LaneJoint* joint, LanePlace* place)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes && place->Held != 0; lane++)
        {
            joint->Push[lane] = 0;
        }
    }
}
