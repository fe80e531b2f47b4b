using System.Runtime.CompilerServices;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>The bodies of trees on lanes, and those that anchors hold on to: from the store, and to it.</summary>
[NotState(Why.Fixed)]
internal sealed unsafe class LaneBodies : LanePart
{
    public LaneBodies(LaneWork work)
        : base(work)
    {
    }

    public void LoadNode(LaneNode* node, TreeNode* from)
    {
        ref BodyPose pose = ref _work.Step.Bodies.Pose[from->Body];
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
        node->Lead[0] = _work.Step.Bodies.Drive[from->Body].Lead;
    }

    /// <summary>Pose and velocity of what anchors hold on to.</summary>
    public void LoadStill(LaneTrees* trees)
    {
        for (int i = 0; i < trees->Anchors; i++)
        {
            LanePlace* place = _anchorPlaces.Pointer + trees->AnchorFirst + i;
            for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
            {
                LaneAnchor* anchor = DoubleLanes.Shift(_anchors.Pointer + trees->AnchorFirst + i, lane);
                int body = place->Body[lane < trees->Count ? lane : 0];
                ref BodyState state = ref _work.Step.Bodies.State[body];
                double angle = TreesOnLanes.ReadStill(_work.Step.Bodies, body, out anchor->X[0], out anchor->Y[0]);
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

    /// <summary>The velocities in double stand as long as the store has their rounding.</summary>
    public void Refresh()
    {
        BodyState* states = _work.Step.Bodies.State.Pointer;
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            for (int i = 0; i < trees->Nodes; i++)
            {
                Refresh(states, trees, i);
            }
        }
    }

    private void Refresh(BodyState* states, LaneTrees* trees, int i)
    {
        LaneNode* node = _nodes.Pointer + trees->First + i;
        LanePlace* place = _places.Pointer + trees->First + i;
        for (int lane = 0; lane < trees->Count; lane++)
        {
            BodyState* state = states + place->Body[lane];
            Refresh(node->Velocity + lane, state->LinearVelocity.X);
            Refresh(node->Velocity + 4 + lane, state->LinearVelocity.Y);
            Refresh(node->Velocity + 8 + lane, state->AngularVelocity);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Refresh(double* held, float stored)
    {
        if ((float)*held != stored)
        {
            *held = stored;
        }
    }

    /// <summary>Gravity and forces: see <see cref="JointSolver.Enter"/>.</summary>
    public void Enter(LaneTrees* trees, int lane)
    {
        BodyState* states = _work.Step.Bodies.State.Pointer;
        BodyMotion* motions = _work.Step.Bodies.Motion.Pointer;
        BodyDrive* drives = _work.Step.Bodies.Drive.Pointer;
        bool free = _work.Forest.Trees[trees->Tree[lane]].Free;
        for (int i = 0; i < trees->Nodes; i++)
        {
            LaneNode* node = DoubleLanes.Shift(_nodes.Pointer + trees->First + i, lane);
            int body = _places[trees->First + i].Body[lane];
            BodyState* state = states + body;
            BodyMotion* motion = motions + body;
            BodyDrive* drive = drives + body;
            motion->ChangeX = 0;
            motion->ChangeY = 0;
            motion->ChangeW = 0;
            node->StartMove[0] = node->Move[0];
            node->StartMove[4] = node->Move[4];
            node->StartMove[8] = node->Move[8];
            HeldVelocity.Drive(ref node->Velocity[0], ref state->LinearVelocity.X, motion->StartX, drive->LinearKeep, drive->X);
            HeldVelocity.Drive(ref node->Velocity[4], ref state->LinearVelocity.Y, motion->StartY, drive->LinearKeep, drive->Y);
            HeldVelocity.Drive(ref node->Velocity[8], ref state->AngularVelocity, motion->StartW, drive->AngularKeep, drive->W);
            Kick(node, state, drive, free ? -0.5f : 0);
        }
    }

    /// <summary>A share of gravity and forces; see <see cref="JointSolver"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Kick(LaneNode* node, BodyState* state, BodyDrive* drive, float share)
    {
        if (share != 0)
        {
            HeldVelocity.Kick(ref node->Velocity[0], ref state->LinearVelocity.X, share * (double)drive->X);
            HeldVelocity.Kick(ref node->Velocity[4], ref state->LinearVelocity.Y, share * (double)drive->Y);
            HeldVelocity.Kick(ref node->Velocity[8], ref state->AngularVelocity, share * (double)drive->W);
            return;
        }

        Refresh(node->Velocity, state->LinearVelocity.X);
        Refresh(node->Velocity + 4, state->LinearVelocity.Y);
        Refresh(node->Velocity + 8, state->AngularVelocity);
    }

    public static void PutAside(LaneNode* nodes, int count)
    {
        for (int i = 0; i < count; i++)
        {
            Copy(nodes[i].Velocity, nodes[i].Saved, 3);
        }
    }

    public static void ClearVelocities(LaneNode* nodes, int count)
    {
        for (int i = 0; i < count; i++)
        {
            for (int k = 0; k < 3 * DoubleLanes.BundleLanes; k += WideDouble.Count)
            {
                WideDouble.Zero.Store(nodes[i].Velocity + k);
            }
        }
    }

    public void StoreVelocities(LaneTrees* trees)
    {
        BodyState* states = _work.Step.Bodies.State.Pointer;
        for (int i = 0; i < trees->Nodes; i++)
        {
            LaneNode* node = _nodes.Pointer + trees->First + i;
            LanePlace* place = _places.Pointer + trees->First + i;
            for (int lane = 0; lane < trees->Count; lane++)
            {
                if (LaneWork.IsLive(trees, lane))
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
    public void EndSubstep(LaneTrees* trees)
    {
        BodyState* states = _work.Step.Bodies.State.Pointer;
        BodyMotion* motions = _work.Step.Bodies.Motion.Pointer;
        BodyDrive* drives = _work.Step.Bodies.Drive.Pointer;
        for (int lane = 0; lane < trees->Count; lane++)
        {
            if (!LaneWork.IsLive(trees, lane))
            {
                continue;
            }

            bool free = _work.Forest.Trees[trees->Tree[lane]].Free;
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
}
