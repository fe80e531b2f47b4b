using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Lanes;

/// <content>To the records of the bodies, joints and trees, and from them.</content>
internal sealed unsafe partial class TreeLanes
{
    private const int Y = DoubleLanes.BundleLanes;
    private const int W = 2 * DoubleLanes.BundleLanes;

    /// <summary>Loads the trees that were taken, at the start of a step.</summary>
    public void Load()
    {
        for (int b = 0; b < _count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
            {
                // Empty lanes are copies of the first.
                int from = lane < trees->Count ? lane : 0;
                JointTree* tree = _forest.Trees + trees->Tree[from];
                for (int i = 0; i < trees->Nodes; i++)
                {
                    LaneNode* node = DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane);
                    LoadNode(node, _forest.Nodes + tree->First + i);
                    if (i > 0)
                    {
                        LanePlace* place = _places.Pointer + trees->First + i;
                        TreeNode* own = _forest.Nodes + tree->First + i;
                        LoadJoint(&node->Joint, place, from);
                        LoadSecond(node, place, from);
                        LoadHeld(&node->Joint, place, lane, from, own->Rows, own->RowIndex[own->Rows - 1]);
                    }
                }

                for (int i = 0; i < trees->Anchors; i++)
                {
                    LaneAnchor* anchor = DoubleLanes.Shift(_anchors.Pointer + trees->AnchorFirst + i, lane);
                    LanePlace* place = _anchorPlaces.Pointer + trees->AnchorFirst + i;
                    TreeAnchor* own = _forest.Anchors + tree->AnchorFirst + i;
                    LoadJoint(&anchor->Joint, place, from);
                    LoadHeld(&anchor->Joint, place, lane, from, own->Rows, own->Rows > 0 ? own->RowIndex[own->Rows - 1] : -1);
                    anchor->Angle[0] = double.NaN;
                }
            }

            LoadStill(trees);
            Place(trees);
            LoadAnchorRows(trees);
            LoadSofts(trees);
            Factor(trees, true);
        }
    }

    /// <summary>The rows of the first substep are of the step's start: since then kinematic bodies have moved, by the whole step.</summary>
    private void LoadAnchorRows(LaneTrees* trees)
    {
        for (int i = 0; i < trees->Anchors; i++)
        {
            for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
            {
                LaneAnchor* anchor = DoubleLanes.Shift(_anchors.Pointer + trees->AnchorFirst + i, lane);
                LanePlace* place = _anchorPlaces.Pointer + trees->AnchorFirst + i;
                JointRows* rows = _rows + place->Active[lane < trees->Count ? lane : 0];
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

    private void LoadNode(LaneNode* node, TreeNode* from)
    {
        ref BodyPose pose = ref _step.Bodies.Pose[from->Body];
        node->Velocity[0] = from->Velocity[0];
        node->Velocity[Y] = from->Velocity[1];
        node->Velocity[W] = from->Velocity[2];
        node->Move[0] = from->Move[0];
        node->Move[Y] = from->Move[1];
        node->Move[W] = from->Move[2];
        node->MiddleSin[0] = from->MiddleSin;
        node->MiddleCos[0] = from->MiddleCos;
        node->TurnSin[0] = from->TurnSin;
        node->TurnCos[0] = from->TurnCos;
        node->InverseMass[0] = from->InverseMass;
        node->InverseInertia[0] = from->InverseInertia;
        node->StartX[0] = pose.X;
        node->StartY[0] = pose.Y;
        node->StartAngle[0] = pose.Angle;
        node->Lead[0] = _step.Bodies.Drive[from->Body].Lead;
    }

    private void LoadJoint(LaneJoint* joint, LanePlace* place, int lane)
    {
        int active = place->Active[lane];
        ref JointSettings settings = ref _active[active].Settings;
        joint->AnchorA[0] = settings.AnchorAX;
        joint->AnchorA[Y] = settings.AnchorAY;
        joint->AnchorB[0] = settings.AnchorBX;
        joint->AnchorB[Y] = settings.AnchorBY;
        joint->Target[0] = settings.Target;
        joint->Axis[0] = place->Form switch
        {
            LaneForm.Servo => _rows[active].Speed[0],
            LaneForm.Gear or LaneForm.Turning or LaneForm.Sliding => settings.Ratio,
            _ => settings.AxisX,
        };
        joint->Axis[Y] = settings.AxisY;
        joint->LineA[0] = settings.GroundAX;
        joint->LineA[Y] = settings.GroundAY;
        joint->LineB[0] = settings.GroundBX;
        joint->LineB[Y] = settings.GroundBY;
        joint->Error[0] = 0;
        joint->GivenBefore[0] = _active[active].GivenBefore[0];
        joint->GivenBefore[Y] = _active[active].GivenBefore[1];
        for (int k = 0; k <= LaneMatrix.Row; k += Y)
        {
            joint->Given[k] = 0;
            joint->PlainGiven[k] = 0;
        }

        if (place->HasLimits)
        {
            LoadLimits(joint, place, place->Limited(lane));
        }
    }

    /// <summary>A second joint that is a servo: its row is the same at all poses.</summary>
    private void LoadSecond(LaneNode* node, LanePlace* place, int lane)
    {
        if (place->Second != LaneForm.Servo)
        {
            return;
        }

        node->Joint.SecondSpeed[0] = _rows[place->ActiveSecond[lane]].Speed[0];
        for (int k = 0; k < 3; k++)
        {
            int at = (place->Rows * LaneMatrix.Row) + (k * Y);
            double turn = k < 2 ? 0 : 1;
            node->Joint.S[at] = place->SecondIsA && k == 2 ? -1 : turn;
            node->ParentS[at] = !place->SecondIsA && k == 2 ? -1 : turn;
        }
    }

    /// <summary>Pose and velocity of what anchors hold on to.</summary>
    private void LoadStill(LaneTrees* trees)
    {
        for (int i = 0; i < trees->Anchors; i++)
        {
            LanePlace* place = _anchorPlaces.Pointer + trees->AnchorFirst + i;
            for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
            {
                LaneAnchor* anchor = DoubleLanes.Shift(_anchors.Pointer + trees->AnchorFirst + i, lane);
                int body = place->Body[lane < trees->Count ? lane : 0];
                ref BodyState state = ref _step.Bodies.State[body];
                double angle = TreesOnLanes.ReadStill(_step.Bodies, body, out anchor->X[0], out anchor->Y[0]);
                if (angle != anchor->Angle[0])
                {
                    anchor->Angle[0] = angle;
                    StableMath.SinCos(angle, out anchor->Sin[0], out anchor->Cos[0]);
                }

                anchor->Still[0] = state.LinearVelocity.X;
                anchor->Still[Y] = state.LinearVelocity.Y;
                anchor->Still[W] = state.AngularVelocity;
            }
        }
    }

    private static void PutAside(LaneNode* nodes, int count)
    {
        for (int i = 0; i < count; i++)
        {
            Copy(nodes[i].Velocity, nodes[i].Saved, 3);
        }
    }

    private static void ClearVelocities(LaneNode* nodes, int count)
    {
        for (int i = 0; i < count; i++)
        {
            for (int k = 0; k < 3 * DoubleLanes.BundleLanes; k += WideDouble.Count)
            {
                WideDouble.Zero.Store(nodes[i].Velocity + k);
            }
        }
    }

    /// <summary>What the joints gave before corrections, and what their limits had left at the start of the substep.</summary>
    private void NoteGiven(LaneTrees* trees)
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

    private static void Copy(double* from, double* to, int count)
    {
        for (int k = 0; k < count * DoubleLanes.BundleLanes; k += WideDouble.Count)
        {
            WideDouble.Load(from + k).Store(to + k);
        }
    }

    private void StoreVelocities(LaneTrees* trees)
    {
        BodyState* states = _step.Bodies.State.Pointer;
        for (int i = 0; i < trees->Nodes; i++)
        {
            LaneNode* node = _nodes.Pointer + trees->First + i;
            LanePlace* place = _places.Pointer + trees->First + i;
            for (int lane = 0; lane < trees->Count; lane++)
            {
                if (IsLive(trees, lane))
                {
                    BodyState* state = states + place->Body[lane];
                    state->LinearVelocity.X = (float)node->Velocity[lane];
                    state->LinearVelocity.Y = (float)node->Velocity[Y + lane];
                    state->AngularVelocity = (float)node->Velocity[W + lane];
                }
            }
        }
    }

    /// <summary>Displacements to the store; the other half of gravity and forces.</summary>
    private void EndSubstep(LaneTrees* trees)
    {
        BodyState* states = _step.Bodies.State.Pointer;
        BodyMotion* motions = _step.Bodies.Motion.Pointer;
        BodyDrive* drives = _step.Bodies.Drive.Pointer;
        for (int lane = 0; lane < trees->Count; lane++)
        {
            if (!IsLive(trees, lane))
            {
                continue;
            }

            bool free = _forest.Trees[trees->Tree[lane]].Free;
            for (int i = 0; i < trees->Nodes; i++)
            {
                LaneNode* node = DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane);
                int body = _places[trees->First + i].Body[lane];
                BodyState* state = states + body;
                state->DeltaPosition.X = (float)node->Move[0];
                state->DeltaPosition.Y = (float)node->Move[Y];
                motions[body].Turned = (float)node->Move[W];
                Integrator.Show(state, node->Move[W], node->TurnSin[0], node->TurnCos[0]);
                if (free)
                {
                    BodyDrive* drive = drives + body;
                    node->Velocity[0] += 0.5f * (double)drive->X;
                    node->Velocity[Y] += 0.5f * (double)drive->Y;
                    node->Velocity[W] += 0.5f * (double)drive->W;
                }

                state->LinearVelocity.X = (float)node->Velocity[0];
                state->LinearVelocity.Y = (float)node->Velocity[Y];
                state->AngularVelocity = (float)node->Velocity[W];
            }
        }
    }

    /// <summary>Gives back trees as they were before a pass.</summary>
    private void LeaveBefore(LaneTrees* trees, int leaves)
    {
        for (int lane = 0; leaves >> lane != 0; lane++)
        {
            if ((leaves & (1 << lane)) != 0)
            {
                Leave(trees, lane, true);
            }
        }
    }

    private void LeaveAstray(LaneTrees* trees)
    {
        for (int lane = 0; lane < trees->Count; lane++)
        {
            if (IsLive(trees, lane) && trees->Astray[lane])
            {
                Leave(trees, lane, false);
            }
        }
    }

    private void Leave(LaneTrees* trees, int lane, bool before)
    {
        trees->Live &= ~(1 << lane);
        JointTree* tree = _forest.Trees + trees->Tree[lane];
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
            TreeNode* node = _forest.Nodes + tree->First + i;
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
        PutHeldBack(trees, lane);
        PutSoftsBack(trees, lane, before);
        PutGapsBack(trees, lane);
        if (before && trees->HasRows)
        {
            TakeGivenBack(trees, lane);
        }

        _givenFrom[GivenCount] = (int)(trees - _bundles.Pointer);
        _given[GivenCount++] = trees->Tree[lane];
    }

    private void TakeGivenBack(LaneTrees* trees, int lane)
    {
        for (int i = 1; i < trees->Nodes; i++)
        {
            LanePlace* place = _places.Pointer + trees->First + i;
            LaneJoint* from = &DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane)->Joint;
            PutBack(from->PlainGiven, _active[place->Active[lane]].Given);
            if (place->Second != LaneForm.None)
            {
                _active[place->ActiveSecond[lane]].Given[2] = from->PlainGiven[LaneMatrix.Row];
            }
        }

        for (int i = 0; i < trees->Anchors; i++)
        {
            ActiveJoint* joint = _active + _anchorPlaces[trees->AnchorFirst + i].Active[lane];
            PutBack(DoubleLanes.Shift(_anchors.Pointer + trees->AnchorFirst + i, lane)->Joint.PlainGiven, joint->Given);
        }
    }

    private void PutJointsBack(LaneTrees* trees, int lane)
    {
        for (int i = 1; i < trees->Nodes; i++)
        {
            PutBack(&DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane)->Joint, _places.Pointer + trees->First + i, lane);
        }

        for (int i = 0; i < trees->Anchors; i++)
        {
            int at = trees->AnchorFirst + i;
            PutBack(&DoubleLanes.Shift(_anchors.Pointer + at, lane)->Joint, _anchorPlaces.Pointer + at, lane);
        }
    }

    private void PutBack(LaneJoint* joint, LanePlace* place, int lane)
    {
        int active = place->Active[lane];
        PutBack(joint->Given, _active[active].Given);
        _active[active].GivenBefore[0] = joint->GivenBefore[0];
        _active[active].GivenBefore[1] = joint->GivenBefore[Y];
        PutBack(joint->PlainGiven, _active[active].PlainGiven);
        _rows[active].ArmX = joint->ArmB[0];
        _rows[active].ArmY = joint->ArmB[Y];
        if (place->Second != LaneForm.None)
        {
            _active[place->ActiveSecond[lane]].Given[2] = joint->Given[LaneMatrix.Row];
            _active[place->ActiveSecond[lane]].PlainGiven[2] = joint->PlainGiven[LaneMatrix.Row];
        }

        if (place->HasLimits && HasMoved)
        {
            // The goals of a projection follow from what the limits were off by at the start of the substep.
            JointRows* limited = _rows + place->Limited(lane);
            limited->Error[place->UpperRow] = joint->StartGap[Y];
            if (place->LowerRow >= 0)
            {
                limited->Error[place->LowerRow] = joint->StartGap[0];
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void PutBack(double* from, double* to)
    {
        to[0] = from[0];
        to[1] = from[Y];
        to[2] = from[W];
    }

    /// <summary>Gives all back that a step leaves: velocities, displacements and impulses.</summary>
    public void Finish()
    {
        GivenCount = 0;
        for (int b = 0; b < _count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            for (int lane = 0; lane < trees->Count; lane++)
            {
                if (IsLive(trees, lane))
                {
                    JointTree* tree = _forest.Trees + trees->Tree[lane];
                    for (int i = 0; i < trees->Nodes; i++)
                    {
                        LaneNode* from = DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane);
                        TreeNode* node = _forest.Nodes + tree->First + i;
                        PutBack(from->Velocity, node->Velocity);
                        PutBack(from->Move, node->Move);
                        node->TurnSin = from->TurnSin[0];
                        node->TurnCos = from->TurnCos[0];
                    }

                    PutJointsBack(trees, lane);
                    PutHeldBack(trees, lane);
                    PutSoftsBack(trees, lane, false);
                    PutGapsBack(trees, lane);
                    _given[GivenCount++] = trees->Tree[lane];
                }
            }
        }

        _count = 0;
    }
}
