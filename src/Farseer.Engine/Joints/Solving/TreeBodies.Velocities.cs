using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints.Solving;

/// <content>Poses and velocities, read from the store and written back.</content>
internal sealed unsafe partial class TreeBodies
{
    public void LoadPoses()
    {
        TreeNode* nodes = _forest.Nodes;
        int* list = _nodes.Pointer;
        BodyPose* poses = _work.Step.Bodies.Pose.Pointer;
        BodyDrive* drives = _work.Step.Bodies.Drive.Pointer;
        for (int at = 0; at < _work.NodeCount; at++)
        {
            TreeNode* node = nodes + list[at];
            LoadPose(node, poses + node->Body, drives[node->Body].Lead);
        }

        _work.Posed = true;
        _work.Armed = 0;
    }

    public void LoadPose(TreeNode* node) =>
        LoadPose(node, _work.Step.Bodies.Pose.Pointer + node->Body, _work.Step.Bodies.Drive[node->Body].Lead);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void LoadPose(TreeNode* node, BodyPose* pose, double lead)
    {
        node->X = pose->X + node->Move[0];
        node->Y = pose->Y + node->Move[1];
        node->Angle = pose->Angle + (node->Move[2] + lead);
        node->Cos = (node->MiddleCos * node->TurnCos) - (node->MiddleSin * node->TurnSin);
        node->Sin = (node->MiddleSin * node->TurnCos) + (node->MiddleCos * node->TurnSin);
    }

    public void LoadVelocities()
    {
        BodyState* states = _work.Step.Bodies.State.Pointer;
        TreeNode* nodes = _forest.Nodes;
        int* list = _nodes.Pointer;
        for (int at = 0; at < _work.NodeCount; at++)
        {
            TreeNode* node = nodes + list[at];
            BodyState* state = states + node->Body;
            node->Velocity[0] = HeldVelocity.Refresh(node->Velocity[0], state->LinearVelocity.X);
            node->Velocity[1] = HeldVelocity.Refresh(node->Velocity[1], state->LinearVelocity.Y);
            node->Velocity[2] = HeldVelocity.Refresh(node->Velocity[2], state->AngularVelocity);
        }
    }

    /// <summary>Springs note how fast their bodies go before they are driven.</summary>
    public void ForeseeRows()
    {
        for (int i = 0; i < _work.AgendaCount; i++)
        {
            int item = _agenda[i];
            if (item >= 0)
            {
                _pass.Foresee(_active.Pointer + item, _rows.Pointer + item, _work.Step.Bodies);
            }
        }
    }

    public void DriveDoubles()
    {
        BodyState* states = _work.Step.Bodies.State.Pointer;
        BodyMotion* motions = _work.Step.Bodies.Motion.Pointer;
        BodyDrive* drives = _work.Step.Bodies.Drive.Pointer;
        TreeNode* nodes = _forest.Nodes;
        int* list = _nodes.Pointer;
        for (int at = 0; at < _work.NodeCount; at++)
        {
            TreeNode* node = nodes + list[at];
            BodyState* state = states + node->Body;
            BodyMotion* motion = motions + node->Body;
            BodyDrive* drive = drives + node->Body;
            HeldVelocity.Drive(ref node->Velocity[0], ref state->LinearVelocity.X, motion->StartX, drive->LinearKeep, drive->X);
            HeldVelocity.Drive(ref node->Velocity[1], ref state->LinearVelocity.Y, motion->StartY, drive->LinearKeep, drive->Y);
            HeldVelocity.Drive(ref node->Velocity[2], ref state->AngularVelocity, motion->StartW, drive->AngularKeep, drive->W);
        }
    }

    public void StoreVelocities()
    {
        BodyState* states = _work.Step.Bodies.State.Pointer;
        TreeNode* nodes = _forest.Nodes;
        int* list = _nodes.Pointer;
        for (int at = 0; at < _work.NodeCount; at++)
        {
            TreeNode* node = nodes + list[at];
            StoreVelocity(node->Velocity, states + node->Body);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void StoreVelocity(double* velocity, BodyState* state)
    {
        state->LinearVelocity.X = (float)velocity[0];
        state->LinearVelocity.Y = (float)velocity[1];
        state->AngularVelocity = (float)velocity[2];
    }
}
