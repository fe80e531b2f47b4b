using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>Trees on lanes: to the records of the bodies, joints and trees, and from them.</summary>
[NotState(Why.Fixed)]
internal sealed unsafe class LaneExchange : LanePart
{
    private readonly LaneBodies _bodies;
    private readonly LaneSoftRows _softRows;
    private readonly LaneActiveSet _activeSet;

    public LaneExchange(LaneWork work, LaneBodies bodies, LaneSoftRows softRows, LaneActiveSet activeSet)
        : base(work)
    {
        _bodies = bodies;
        _softRows = softRows;
        _activeSet = activeSet;
    }

    /// <summary>Loads the bodies and joints of trees that were taken, at the start of a step.</summary>
    public void Load(LaneTrees* trees)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
        {
            // Empty lanes are copies of the first.
            int from = lane < trees->Count ? lane : 0;
            JointTree* tree = _work.Forest.Trees + trees->Tree[from];
            for (int i = 0; i < trees->Nodes; i++)
            {
                LaneNode* node = DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane);
                _bodies.LoadNode(node, _work.Forest.Nodes + tree->First + i);
                if (i > 0)
                {
                    LanePlace* place = _places.Pointer + trees->First + i;
                    TreeNode* own = _work.Forest.Nodes + tree->First + i;
                    LoadJoint(&node->Joint, place, from);
                    LoadSecond(node, place, from);
                    _activeSet.LoadHeld(&node->Joint, place, lane, from, own->Rows, own->RowIndex[own->Rows - 1]);
                }
            }

            for (int i = 0; i < trees->Anchors; i++)
            {
                LaneAnchor* anchor = DoubleLanes.Shift(_anchors.Pointer + trees->AnchorFirst + i, lane);
                LanePlace* place = _anchorPlaces.Pointer + trees->AnchorFirst + i;
                TreeAnchor* own = _work.Forest.Anchors + tree->AnchorFirst + i;
                LoadJoint(&anchor->Joint, place, from);
                _activeSet.LoadHeld(&anchor->Joint, place, lane, from, own->Rows, own->Rows > 0 ? own->RowIndex[own->Rows - 1] : -1);
                anchor->Angle[0] = double.NaN;
            }
        }
    }

    /// <summary>The rows of the first substep are of the step's start: since then kinematic bodies have moved, by the whole step.</summary>
    public void LoadAnchorRows(LaneTrees* trees)
    {
        for (int i = 0; i < trees->Anchors; i++)
        {
            for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
            {
                LaneAnchor* anchor = DoubleLanes.Shift(_anchors.Pointer + trees->AnchorFirst + i, lane);
                LanePlace* place = _anchorPlaces.Pointer + trees->AnchorFirst + i;
                JointRows* rows = _work.Rows + place->Active[lane < trees->Count ? lane : 0];
                LaneJoint* joint = &anchor->Joint;
                LoadRows(place->IsA ? rows->A : rows->B, joint->S, place);
                LoadRows(place->IsA ? rows->B : rows->A, anchor->OtherS, place);
                LoadLine(rows->A, joint->LineA, place);
                LoadLine(rows->B, joint->LineB, place);

                // A servo has no error: what it is off by is in its speed.
                for (int row = 0; row < place->Rows && place->Form != LaneForm.Servo; row++)
                {
                    joint->Error[row * Y] = rows->Error[row];
                }

                if (place->HasLimits)
                {
                    joint->Gap[0] = place->LowerRow < 0 ? double.PositiveInfinity : rows->Error[place->LowerRow];
                    joint->Gap[Y] = rows->Error[place->UpperRow];
                }

                if (place->HasMore)
                {
                    // Where the first row is no spring, there is none.
                    joint->Travel[0] = rows->Error[place->LineRow];
                }

                joint->Size[0] = rows->Size;
                joint->ArmB[0] = rows->ArmX;
                joint->ArmB[Y] = rows->ArmY;
            }
        }
    }

    private static void LoadRows(double* from, double* to, LanePlace* place)
    {
        for (int k = 0; k < place->Rows * 3; k++)
        {
            to[k * Y] = from[k];
        }
    }

    /// <summary>The line goes the way of lower limits.</summary>
    private static void LoadLine(double* from, double* to, LanePlace* place)
    {
        for (int k = 0; k < 3 && place->HasMore; k++)
        {
            double along = from[(place->LineRow * 3) + k];
            to[k * Y] = place->LineRow == place->UpperRow ? -along : along;
        }
    }

    private void LoadJoint(LaneJoint* joint, LanePlace* place, int lane)
    {
        int active = place->Active[lane];
        ref JointSettings settings = ref _work.Active[active].Settings;
        joint->AnchorA[0] = settings.AnchorAX;
        joint->AnchorA[Y] = settings.AnchorAY;
        joint->AnchorB[0] = settings.AnchorBX;
        joint->AnchorB[Y] = settings.AnchorBY;
        joint->Target[0] = settings.Target;
        joint->Axis[0] = place->Form switch
        {
            LaneForm.Servo => _work.Rows[active].Speed[0],
            LaneForm.Gear or LaneForm.Turning or LaneForm.Sliding => settings.Ratio,
            _ => settings.AxisX,
        };
        joint->Axis[Y] = settings.AxisY;
        joint->LineA[0] = settings.GroundAX;
        joint->LineA[Y] = settings.GroundAY;
        joint->LineB[0] = settings.GroundBX;
        joint->LineB[Y] = settings.GroundBY;
        joint->Error[0] = 0;
        joint->GivenBefore[0] = _work.Active[active].GivenBefore[0];
        joint->GivenBefore[Y] = _work.Active[active].GivenBefore[1];
        for (int k = 0; k <= LaneMatrix.Row; k += Y)
        {
            joint->Given[k] = 0;
            joint->PlainGiven[k] = 0;
        }

        if (place->HasLimits)
        {
            _activeSet.LoadLimits(joint, place, place->Limited(lane));
        }
    }

    /// <summary>A second joint that is a servo: its row is the same at all poses.</summary>
    private void LoadSecond(LaneNode* node, LanePlace* place, int lane)
    {
        if (place->Second != LaneForm.Servo)
        {
            return;
        }

        node->Joint.SecondSpeed[0] = _work.Rows[place->ActiveSecond[lane]].Speed[0];
        for (int k = 0; k < 3; k++)
        {
            int at = (place->Rows * LaneMatrix.Row) + (k * Y);
            double turn = k < 2 ? 0 : 1;
            node->Joint.S[at] = place->SecondIsA && k == 2 ? -1 : turn;
            node->ParentS[at] = !place->SecondIsA && k == 2 ? -1 : turn;
        }
    }

    /// <summary>What the joints gave before corrections, and what their limits had left at the start of the substep.</summary>
    public void NoteGiven(LaneTrees* trees)
    {
        for (int i = 1; i < trees->Nodes; i++)
        {
            NoteGiven(&_nodes.Pointer[trees->First + i].Joint, _places[trees->First + i].HasLimits);
        }

        for (int i = 0; i < trees->Anchors; i++)
        {
            NoteGiven(&_anchors.Pointer[trees->AnchorFirst + i].Joint, _anchorPlaces[trees->AnchorFirst + i].HasLimits);
        }
    }

    private static void NoteGiven(LaneJoint* joint, bool hasLimits)
    {
        Copy(joint->Given, joint->PlainGiven, 4);
        if (hasLimits)
        {
            Copy(joint->Gap, joint->StartGap, 2);
            Copy(joint->Push, joint->PlainPush, 1);
        }
    }

    /// <summary>Gives back trees as they were before a pass.</summary>
    public void LeaveBefore(LaneTrees* trees, int leaves)
    {
        for (int lane = 0; leaves >> lane != 0; lane++)
        {
            if ((leaves & (1 << lane)) != 0)
            {
                Leave(trees, lane, true);
            }
        }
    }

    public void LeaveAstray(LaneTrees* trees)
    {
        for (int lane = 0; lane < trees->Count; lane++)
        {
            if (LaneWork.IsLive(trees, lane) && trees->Astray[lane])
            {
                Leave(trees, lane, false);
            }
        }
    }

    private void Leave(LaneTrees* trees, int lane, bool before)
    {
        trees->Live &= ~(1 << lane);
        JointTree* tree = _work.Forest.Trees + trees->Tree[lane];
        tree->Exact = true;
        tree->Disturbed = false;
        tree->Corrects = false;
        tree->Refactored = false;
        tree->Astray = !before;
        tree->Worst = trees->Worst[lane];
        tree->Before = trees->Before[lane];
        for (int i = 0; i < trees->Nodes; i++)
        {
            LaneNode* from = DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane);
            TreeNode* node = _work.Forest.Nodes + tree->First + i;
            PutBack(before ? from->Saved : from->Velocity, node->Velocity);
            PutBack(from->Move, node->Move);
            PutBack(from->StartMove, node->StartMove);
            PutBack(from->PlainMove, node->PlainMove);
            PutBack(from->PlainVelocity, node->PlainVelocity);
            node->Bent = from->Bent[0];
            node->MiddleSin = from->MiddleSin[0];
            node->MiddleCos = from->MiddleCos[0];
            node->TurnSin = from->TurnSin[0];
            node->TurnCos = from->TurnCos[0];
        }

        PutJointsBack(trees, lane);
        _activeSet.PutHeldBack(trees, lane);
        _softRows.PutSoftsBack(trees, lane, before);
        _activeSet.PutGapsBack(trees, lane);
        if (before && trees->HasRows)
        {
            TakeGivenBack(trees, lane);
        }

        _work.GivenFrom[_work.GivenCount] = (int)(trees - _bundles.Pointer);
        _work.GivenTrees[_work.GivenCount++] = trees->Tree[lane];
    }

    private void TakeGivenBack(LaneTrees* trees, int lane)
    {
        for (int i = 1; i < trees->Nodes; i++)
        {
            LanePlace* place = _places.Pointer + trees->First + i;
            LaneJoint* from = &DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane)->Joint;
            PutBack(from->PlainGiven, _work.Active[place->Active[lane]].Given);
            if (place->Second != LaneForm.None)
            {
                _work.Active[place->ActiveSecond[lane]].Given[2] = from->PlainGiven[LaneMatrix.Row];
            }
        }

        for (int i = 0; i < trees->Anchors; i++)
        {
            ActiveJoint* joint = _work.Active + _anchorPlaces[trees->AnchorFirst + i].Active[lane];
            PutBack(DoubleLanes.Shift(_anchors.Pointer + trees->AnchorFirst + i, lane)->Joint.PlainGiven, joint->Given);
        }
    }

    private void PutJointsBack(LaneTrees* trees, int lane)
    {
        for (int i = 1; i < trees->Nodes; i++)
        {
            PutJointBack(&DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane)->Joint, _places.Pointer + trees->First + i, lane);
        }

        for (int i = 0; i < trees->Anchors; i++)
        {
            int at = trees->AnchorFirst + i;
            PutJointBack(&DoubleLanes.Shift(_anchors.Pointer + at, lane)->Joint, _anchorPlaces.Pointer + at, lane);
        }
    }

    private void PutJointBack(LaneJoint* joint, LanePlace* place, int lane)
    {
        int active = place->Active[lane];
        PutBack(joint->Given, _work.Active[active].Given);
        _work.Active[active].GivenBefore[0] = joint->GivenBefore[0];
        _work.Active[active].GivenBefore[1] = joint->GivenBefore[Y];
        PutBack(joint->PlainGiven, _work.Active[active].PlainGiven);
        _work.Rows[active].ArmX = joint->ArmB[0];
        _work.Rows[active].ArmY = joint->ArmB[Y];
        if (place->Second != LaneForm.None)
        {
            _work.Active[place->ActiveSecond[lane]].Given[2] = joint->Given[LaneMatrix.Row];
            _work.Active[place->ActiveSecond[lane]].PlainGiven[2] = joint->PlainGiven[LaneMatrix.Row];
        }

        if (place->HasLimits && _work.HasMoved)
        {
            // The goals of a projection follow from what the limits were off by at the start of the substep.
            JointRows* limited = _work.Rows + place->Limited(lane);
            limited->Error[place->UpperRow] = joint->StartGap[Y];
            if (place->LowerRow >= 0)
            {
                limited->Error[place->LowerRow] = joint->StartGap[0];
            }
        }
    }

    /// <summary>Gives all of a tree back that a step leaves: velocities, displacements and impulses.</summary>
    public void Finish(LaneTrees* trees, int lane)
    {
        JointTree* tree = _work.Forest.Trees + trees->Tree[lane];
        for (int i = 0; i < trees->Nodes; i++)
        {
            LaneNode* from = DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane);
            TreeNode* node = _work.Forest.Nodes + tree->First + i;
            PutBack(from->Velocity, node->Velocity);
            PutBack(from->Move, node->Move);
            node->TurnSin = from->TurnSin[0];
            node->TurnCos = from->TurnCos[0];
        }

        PutJointsBack(trees, lane);
        _activeSet.PutHeldBack(trees, lane);
        _softRows.PutSoftsBack(trees, lane, false);
        _activeSet.PutGapsBack(trees, lane);
        _work.GivenTrees[_work.GivenCount++] = trees->Tree[lane];
    }
}
