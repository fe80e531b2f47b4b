using System;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>Motors and springs at the joints of trees on lanes: to the records of the joints and back, and their sweeps.</summary>
[NotState(Why.Fixed)]
internal sealed unsafe class LaneSoftRows : LanePart
{
    public LaneSoftRows(LaneWork work)
        : base(work)
    {
    }

    /// <summary>Sweeps may follow each other without a look at limits.</summary>
    public bool SweepsByItself()
    {
        bool alone = true;
        for (int b = 0; b < _work.Count; b++)
        {
            LaneTrees* trees = _bundles.Pointer + b;
            alone &= !(trees->HasLimits && trees->HasRows);
        }

        return alone;
    }

    private void ExchangeBends(LaneTrees* trees, int lane, bool load)
    {
        int from = lane < trees->Count ? lane : 0;
        for (int i = 1; i < trees->Nodes; i++)
        {
            LaneBends* bends = &DoubleLanes.Shift(_walks.Pointer + trees->First + i, lane)->Bends;
            ExchangeBends(bends, _work.Active + _places[trees->First + i].Active[from], load);
        }

        for (int i = 0; i < trees->Anchors; i++)
        {
            LaneBends* bends = &DoubleLanes.Shift(_anchors.Pointer + trees->AnchorFirst + i, lane)->Bends;
            ExchangeBends(bends, _work.Active + _anchorPlaces[trees->AnchorFirst + i].Active[from], load);
        }
    }

    private static void ExchangeBends(LaneBends* bends, ActiveJoint* joint, bool load)
    {
        for (int row = 0; row < TreeFactor.MostRows; row++)
        {
            if (load)
            {
                bends->Bend[row * Y] = joint->Bend[row];
                bends->Foreseen[row * Y] = joint->Foreseen[row];
            }
            else
            {
                joint->Bend[row] = bends->Bend[row * Y];
                joint->Foreseen[row] = bends->Foreseen[row * Y];
            }
        }
    }

    public void LoadSofts(LaneTrees* trees)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes && trees->HasRows; lane++)
        {
            ExchangeBends(trees, lane, true);
        }

        for (int i = trees->SoftFirst; i < trees->SoftFirst + trees->Softs; i++)
        {
            for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
            {
                LaneSoft* soft = DoubleLanes.Shift(_softs.Pointer + i, lane);
                int active = _work.ActiveOf(trees, _softPlaces.Pointer + i, lane < trees->Count ? lane : 0);
                soft->SpringMass[0] = _work.Rows[active].SpringMass;
                soft->Hold[0] = JointPass.HoldOf(_work.Forest.Trees, _work.Forest.Nodes, _work.Active + active);
                soft->Early[0] = JointPass.EarlyOf(_work.Forest.Trees + trees->Tree[lane < trees->Count ? lane : 0]);
                LoadRow(&soft->Row0, _work.Active + active, _work.Rows + active, _softPlaces[i].Kind0.Index);
                LoadRow(&soft->Row1, _work.Active + active, _work.Rows + active, _softPlaces[i].Kind1.Index);
            }
        }
    }

    /// <summary>What a row of a joint starts a step with.</summary>
    public static void LoadRow(LaneSoftRow* row, ActiveJoint* joint, JointRows* rows, int k)
    {
        row->Lambda[0] = joint->Lambda[k];
        row->Speed[0] = rows->Speed[k];
        row->Low[0] = rows->Low[k];
        row->High[0] = rows->High[k];
        row->Share[0] = rows->Share[k];
        row->Stiffness[0] = rows->Stiffness[k];
        row->Damping[0] = rows->Damping[k];
        row->Ahead[0] = 0;
        row->Start[0] = 0;
    }

    public void PrepareSofts(LaneTrees* trees)
    {
        trees->Stalled = 0;
        for (int lane = 0; lane < DoubleLanes.BundleLanes && trees->SweepsSofts; lane += WideDouble.Count)
        {
            LaneSoftPlace* places = _softPlaces.Pointer + trees->SoftFirst;
            LaneSoft* softs = _softs.Pointer + trees->SoftFirst;
            trees->Stalled |= LaneSweep.Prepare(_work.WalksOf(trees, lane), softs, places, trees->Softs, _work.Step.Substep, lane);
        }
    }

    public void WarmStart(LaneTrees* trees)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            LaneSoftPlace* places = _softPlaces.Pointer + trees->SoftFirst;
            LaneSweep.WarmStart(_work.WalksOf(trees, lane), _softs.Pointer + trees->SoftFirst, places, trees->Softs, lane);
        }
    }

    public void Resume(LaneTrees* trees)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            LaneSoftPlace* places = _softPlaces.Pointer + trees->SoftFirst;
            LaneSweep.Resume(_work.WalksOf(trees, lane), _softs.Pointer + trees->SoftFirst, places, trees->Softs, lane);
        }
    }

    /// <summary>Sweeps over the motors and springs of some lanes.</summary>
    public void SweepIn(LaneTrees* trees, int lanes, bool relaxed, int sweeps)
    {
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
        {
            trees->Sweeps[lane] = (lanes & (1 << lane)) != 0 ? -1 : 0;
        }

        bool any = false;
        for (int lane = 0; lane < DoubleLanes.BundleLanes; lane += WideDouble.Count)
        {
            LaneSoftPlace* places = _softPlaces.Pointer + trees->SoftFirst;
            any |= LaneSweep.Run(
                _work.WalksOf(trees, lane), _softs.Pointer + trees->SoftFirst, places, trees->Softs, !relaxed, sweeps, lane, trees->Sweeps);
        }

        if (any)
        {
            LaneSolve.Give(_work.BundleOf(trees));
        }
    }

    /// <summary>
    /// See <see cref="JointPass.Foresee"/>. Of a tree with contacts the joints themselves are told: they are swept there.
    /// </summary>
    public void Foresee(LaneTrees* trees, int lane)
    {
        for (int i = trees->SoftFirst; i < trees->SoftFirst + trees->Softs; i++)
        {
            LaneSoft* soft = DoubleLanes.Shift(_softs.Pointer + i, lane);
            LaneSoftPlace* place = _softPlaces.Pointer + i;
            int active = _work.ActiveOf(trees, place, lane);
            for (int k = 0; k < place->Rows; k++)
            {
                LaneSoftKind kind = k == 0 ? place->Kind0 : place->Kind1;
                LaneSoftRow* row = k == 0 ? &soft->Row0 : &soft->Row1;
                if (kind.IsSpring && trees->Touched)
                {
                    JointRows* rows = _work.Rows + active;
                    double speed = StartSpeed(trees, lane, place->NodeA, _work.Active[active].Ends.BodyA, rows->A + (kind.Index * 3), 1)
                        + StartSpeed(trees, lane, place->NodeB, _work.Active[active].Ends.BodyB, rows->B + (kind.Index * 3), 1);
                    _work.Active[active].SpringAhead[kind.Index] = _work.Active[active].SpringLead[kind.Index] * speed;
                }
                else if (kind.IsSpring)
                {
                    double speed = StartSpeed(trees, lane, place->NodeA, _work.Active[active].Ends.BodyA, row->A, Y)
                        + StartSpeed(trees, lane, place->NodeB, _work.Active[active].Ends.BodyB, row->B, Y);
                    row->Ahead[0] = row->Lead[0] * speed;
                }
            }
        }
    }

    private double StartSpeed(LaneTrees* trees, int lane, int node, int body, double* j, int stride)
    {
        double* held = DoubleLanes.Shift(_nodes.Pointer + trees->First + Math.Max(0, node), lane)->Velocity;
        return HeldVelocity.StartSpeed(_work.Step.Bodies, body, node >= 0, held, Y, j, stride);
    }

    /// <summary>The impulses of a tree's motors and springs to its joints.</summary>
    /// <param name="trees">The bundle.</param>
    /// <param name="lane">The tree.</param>
    /// <param name="before">Those from before the pass.</param>
    public void PutSoftsBack(LaneTrees* trees, int lane, bool before)
    {
        if (trees->HasRows)
        {
            ExchangeBends(trees, lane, false);
        }

        for (int i = trees->SoftFirst; i < trees->SoftFirst + trees->Softs; i++)
        {
            LaneSoft* soft = DoubleLanes.Shift(_softs.Pointer + i, lane);
            LaneSoftPlace* place = _softPlaces.Pointer + i;
            ActiveJoint* joint = _work.Active + _work.ActiveOf(trees, place, lane);
            if (trees->Touched)
            {
                joint->PlainLambda[place->Kind0.Index] = joint->Lambda[place->Kind0.Index];
                joint->PlainLambda[place->Kind1.Index] = joint->Lambda[place->Kind1.Index];
                continue;
            }

            PutRowBack(joint, place->Kind0.Index, &soft->Row0, before);
            if (place->Rows > 1)
            {
                PutRowBack(joint, place->Kind1.Index, &soft->Row1, before);
            }
        }
    }

    private static void PutRowBack(ActiveJoint* joint, int index, LaneSoftRow* row, bool before)
    {
        double lambda = before ? row->Before[0] : row->Lambda[0];
        joint->Lambda[index] = lambda;
        joint->PlainLambda[index] = lambda;
        joint->Start[index] = row->Start[0];
        joint->SpringAhead[index] = row->Ahead[0];
    }

    /// <summary>Notes what the joints have given before a pass: a tree that is given back starts the pass anew elsewhere.</summary>
    public void PutGivenAside(LaneTrees* trees)
    {
        for (int i = 1; i < trees->Nodes; i++)
        {
            LaneJoint* joint = &_nodes.Pointer[trees->First + i].Joint;
            Copy(joint->Given, joint->PlainGiven, 4);
        }

        for (int i = 0; i < trees->Anchors; i++)
        {
            LaneJoint* joint = &_anchors.Pointer[trees->AnchorFirst + i].Joint;
            Copy(joint->Given, joint->PlainGiven, 4);
        }

        for (int i = trees->SoftFirst; i < trees->SoftFirst + trees->Softs; i++)
        {
            LaneSoft* soft = _softs.Pointer + i;
            Copy(soft->Row0.Lambda, soft->Row0.Before, 1);
            Copy(soft->Row1.Lambda, soft->Row1.Before, 1);
        }
    }
}
