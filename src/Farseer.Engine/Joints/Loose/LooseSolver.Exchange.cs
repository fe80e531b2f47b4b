using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Loose;

/// <content>To the records of the bodies and joints, and from them.</content>
internal sealed unsafe partial class LooseSolver
{
    private const int Y = DoubleLanes.BundleLanes;
    private const int W = 2 * DoubleLanes.BundleLanes;

    /// <summary>Loads the joints that were taken, at the start of a step, with the rows that were written for it.</summary>
    public void Load()
    {
        Bundle();
        for (int i = Nobody + 1; i < _bodyCount; i++)
        {
            if (_bodies[i].Node >= 0)
            {
                LoadBody(_bodies.Pointer + i);
            }
        }

        for (int i = 0; i < _bundleCount; i++)
        {
            LoosePlace* place = _places.Pointer + i;
            for (int lane = 0; lane < DoubleLanes.BundleLanes; lane++)
            {
                LoadJoint(DoubleLanes.Shift(_bundles.Pointer + i, lane), place, lane);
                for (int k = 0; k < place->Rows; k++)
                {
                    LoadRow(DoubleLanes.Shift(_looseRows.Pointer + place->FirstRow + k, lane), place->Active[lane], k);
                }
            }

            Prepare(i);
        }
    }

    private void LoadBody(LooseBody* body)
    {
        TreeNode* node = _forest.Nodes + body->Node;
        ref BodyPose pose = ref _step.Bodies.Pose[node->Body];
        body->Body = node->Body;
        body->Free = _forest.Trees[node->Tree].Free;
        body->InverseMass = node->InverseMass;
        body->InverseInertia = node->InverseInertia;
        for (int k = 0; k < 3; k++)
        {
            body->Velocity[k] = node->Velocity[k];
            body->Move[k] = node->Move[k];
        }

        body->StartX = pose.X;
        body->StartY = pose.Y;
        body->StartAngle = pose.Angle;
        body->Lead = _step.Bodies.Drive[node->Body].Lead;
        body->MiddleSin = node->MiddleSin;
        body->MiddleCos = node->MiddleCos;
        body->TurnSin = node->TurnSin;
        body->TurnCos = node->TurnCos;
    }

    private void LoadJoint(LooseBundle* bundle, LoosePlace* place, int lane)
    {
        int active = place->Active[lane];
        ref JointSettings settings = ref _active[active].Settings;
        LooseBody* a = _bodies.Pointer + place->BodyA[lane];
        LooseBody* b = _bodies.Pointer + place->BodyB[lane];
        bundle->AnchorA[0] = settings.AnchorAX;
        bundle->AnchorA[Y] = settings.AnchorAY;
        bundle->AnchorB[0] = settings.AnchorBX;
        bundle->AnchorB[Y] = settings.AnchorBY;
        bundle->Target[0] = settings.Target;
        bundle->Lower[0] = settings.Lower;
        bundle->Upper[0] = settings.Upper;
        bundle->Ratio[0] = settings.Ratio;
        bundle->GroundA[0] = settings.GroundAX;
        bundle->GroundA[Y] = settings.GroundAY;
        bundle->GroundB[0] = settings.GroundBX;
        bundle->GroundB[Y] = settings.GroundBY;
        bundle->MassA[0] = a->InverseMass;
        bundle->InertiaA[0] = a->InverseInertia;
        bundle->MassB[0] = b->InverseMass;
        bundle->InertiaB[0] = b->InverseInertia;
        bundle->SpringMass[0] = _rows[active].SpringMass;
        bundle->Hold[0] = JointPass.HoldOf(_forest.Trees, _forest.Nodes, _active + active);
        bundle->Early[0] = JointPass.EarlyOf(_forest.Trees + _forest.Nodes[System.Math.Max(a->Node, b->Node)].Tree);
        bundle->ArmB[0] = _rows[active].ArmX;
        bundle->ArmB[Y] = _rows[active].ArmY;
        bundle->Given[0] = 0;
        bundle->Given[Y] = 0;
        bundle->Given[W] = 0;
    }

    private void LoadRow(LooseRow* row, int active, int k)
    {
        JointRows* from = _rows + active;
        Lanes.LaneSoftRows.LoadRow(&row->Soft, _active + active, from, k);
        for (int i = 0; i < 3; i++)
        {
            row->Soft.A[i * Y] = from->A[(k * 3) + i];
            row->Soft.B[i * Y] = from->B[(k * 3) + i];
        }

        row->Error[0] = from->Error[k];
        row->SpringShare[0] = double.NaN;
    }

    /// <summary>Gives all back that a step leaves: velocities, displacements and impulses.</summary>
    public void Finish()
    {
        for (int i = Nobody + 1; i < _bodyCount; i++)
        {
            LooseBody* body = _bodies.Pointer + i;
            if (body->Node >= 0)
            {
                TreeNode* node = _forest.Nodes + body->Node;
                for (int k = 0; k < 3; k++)
                {
                    node->Velocity[k] = body->Velocity[k];
                    node->Move[k] = body->Move[k];
                }

                node->TurnSin = body->TurnSin;
                node->TurnCos = body->TurnCos;
            }
        }

        for (int i = 0; i < _bundleCount; i++)
        {
            LoosePlace* place = _places.Pointer + i;
            for (int lane = 0; lane < place->Count; lane++)
            {
                PutBack(DoubleLanes.Shift(_bundles.Pointer + i, lane), place, lane);
            }
        }
    }

    private void PutBack(LooseBundle* bundle, LoosePlace* place, int lane)
    {
        ActiveJoint* joint = _active + place->Active[lane];
        JointRows* rows = _rows + place->Active[lane];
        for (int k = 0; k < place->Rows; k++)
        {
            LooseRow* row = DoubleLanes.Shift(_looseRows.Pointer + place->FirstRow + k, lane);
            joint->Lambda[k] = row->Soft.Lambda[0];
            joint->Response[k] = row->Soft.Response[0];
            joint->Stood[k] = row->Error[0];
        }

        joint->Given[0] = bundle->Given[0];
        joint->Given[1] = bundle->Given[Y];
        joint->Given[2] = bundle->Given[W];
        rows->ArmX = bundle->ArmB[0];
        rows->ArmY = bundle->ArmB[Y];
    }
}
