using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints;

/// <content>
/// The correction of positions. It goes along the directions of the substep's start, which makes the motion symplectic; where that
/// does not converge (the whip of a rope), the tree is projected along the directions at its present pose instead, which always
/// holds together but costs energy.
/// </content>
internal sealed unsafe partial class JointSolver
{
    private const int Corrections = 3;
    private const int Projections = 12;

    /// <summary>Errors in terms of the joint's size: none, good enough to stay with, and too large after all corrections.</summary>
    private const double Tolerance = 1e-7;
    private const double Loose = 2e-6;
    private const double Failed = 1e-4;

    /// <summary>A correction that does not shrink the error to this share goes astray; so does one that turns a body further.</summary>
    private const double Shrink = 0.7;
    private const double LargestBend = 0.3;

    /// <summary>After the positions moved: what is left of the errors is taken out of positions and velocities alike.</summary>
    public void CorrectPositions()
    {
        for (int i = 0; i < _forest.Count; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            ReadMove(node, node->PlainMove);
            node->Bent = 0;
            node->Before = double.PositiveInfinity;
            node->Astray = 0;
        }

        LoadPoses();
        WriteErrors();
        double worst = SetTargets(TargetKind.Correction);
        for (int round = 0; round < Corrections && worst > Tolerance; round++)
        {
            ClearCorrections();
            TreeSolve.Run(_forest, true);
            TreeReactions.AddSolve(_forest, _active.Pointer, _rows.Pointer);
            ApplyCorrections(false);
            LoadPoses();
            WriteErrors();
            worst = SetTargets(TargetKind.Correction);
            FindAstray(round == Corrections - 1);
        }

        Project();
        WriteRows(false);
        Factor();
        Kick(0.5f);
    }

    private void FindAstray(bool last)
    {
        for (int i = 0; i < _forest.Count; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            TreeNode* root = _forest.Nodes + node->Root;
            root->Astray |= node->Bent > LargestBend ? 1 : 0;
            if (node->Parent < 0)
            {
                bool stuck = node->Worst > Loose && node->Worst > Shrink * node->Before;
                node->Astray |= stuck || (last && node->Worst > Failed) || !FloatBits.IsFinite(node->Worst) ? 1 : 0;
                node->Before = node->Worst;
            }
        }
    }

    private void ClearCorrections()
    {
        for (int i = 0; i < _forest.Count; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            node->Correction[0] = 0;
            node->Correction[1] = 0;
            node->Correction[2] = 0;
        }
    }

    /// <summary>Takes the trees that went astray back to where h·v took them, and projects them onto their joints.</summary>
    private void Project()
    {
        bool any = false;
        for (int i = 0; i < _forest.Count; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            if (_forest.Nodes[node->Root].Astray != 0)
            {
                any = true;
                WriteMove(node, node->PlainMove[0], node->PlainMove[1], node->PlainMove[2]);
            }
        }

        for (int round = 0; any && round < Projections; round++)
        {
            LoadPoses();
            WriteRows(false);
            TreeFactor.Run(_forest, _active.Pointer, _rows.Pointer);
            if (SetTargets(TargetKind.Projection) <= Tolerance)
            {
                break;
            }

            ClearCorrections();
            TreeSolve.Run(_forest, true);
            ApplyCorrections(true);
        }

        double* moved = stackalloc double[3];
        for (int i = 0; any && i < _forest.Count; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            if (_forest.Nodes[node->Root].Astray != 0)
            {
                ReadMove(node, moved);
                for (int k = 0; k < 3; k++)
                {
                    node->Velocity[k] = (moved[k] - node->StartMove[k]) / _step.Substep;
                }
            }
        }

        if (any)
        {
            StoreVelocities();
            LoadPoses();
        }
    }

    private void ApplyCorrections(bool projecting)
    {
        double h = _step.Substep;
        double* moved = stackalloc double[3];
        for (int i = 0; i < _forest.Count; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            if (projecting && _forest.Nodes[node->Root].Astray == 0)
            {
                continue;
            }

            double turn = h * node->Correction[2];
            node->Bent += Math.Abs(turn);
            turn = projecting ? Math.Max(-1, Math.Min(1, turn)) : turn;
            ReadMove(node, moved);
            WriteMove(node, moved[0] + (h * node->Correction[0]), moved[1] + (h * node->Correction[1]), moved[2] + turn);
            for (int k = 0; !projecting && k < 3; k++)
            {
                node->Velocity[k] += node->Correction[k];
            }
        }

        if (!projecting)
        {
            StoreVelocities();
        }
    }

    private void ReadMove(TreeNode* node, double* move)
    {
        BodyState* state = _step.Bodies.State.Pointer + node->Body;
        move[0] = state->DeltaPosition.X;
        move[1] = state->DeltaPosition.Y;
        move[2] = _step.Bodies.Motion[node->Body].Turned;
    }

    private void WriteMove(TreeNode* node, double x, double y, double turned)
    {
        BodyState* state = _step.Bodies.State.Pointer + node->Body;
        state->DeltaPosition.X = (float)x;
        state->DeltaPosition.Y = (float)y;
        _step.Bodies.Motion[node->Body].Turned = (float)turned;
        StableMath.SinCos((double)(float)turned, out double sin, out double cos);
        state->DeltaSin = (float)sin;
        state->DeltaCos = (float)cos;
    }
}
