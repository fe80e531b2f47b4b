using Farseer.Engine.Bodies;
using Farseer.Engine.Joints.Trees;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints;

/// <content>Masses, poses and velocities: from the store and back.</content>
internal sealed unsafe partial class JointSolver
{
    private void LoadMasses()
    {
        for (int i = 0; i < _forest.Count; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            ref BodyMass mass = ref _step.Bodies.Mass[node->Body];
            node->InverseMass = mass.InverseMass;
            node->InverseInertia = mass.InverseInertia;
        }
    }

    /// <summary>Trees that touch nothing are free.</summary>
    private void MarkFree()
    {
        for (int i = 0; i < _forest.Count; i++)
        {
            _forest.Nodes[i].Free = 1;
        }

        for (int i = 0; i < _forest.Count; i++)
        {
            if (_step.Touches[_forest.Nodes[i].Body] > 0)
            {
                _forest.Nodes[_forest.Nodes[i].Root].Free = 0;
            }
        }

        for (int i = 0; i < _count; i++)
        {
            if (_active[i].HasRows && Acts(_active.Pointer + i, _rows.Pointer + i))
            {
                Bind(_active[i].NodeA);
                Bind(_active[i].NodeB);
            }
        }
    }

    private void Bind(int node)
    {
        if (node >= 0)
        {
            _forest.Nodes[_forest.Nodes[node].Root].Free = 0;
        }
    }

    /// <summary>A motor, a spring or a limit that holds gives its whole impulse before the move: half a weight would be overcome.</summary>
    private static bool Acts(ActiveJoint* joint, JointRows* rows)
    {
        for (int k = rows->Hard; k < rows->Count; k++)
        {
            if (rows->Type[k] != (byte)RowType.Limit || joint->Lambda[k] > 0)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>
    /// A free tree takes half of its gravity and forces before it moves and half after, which is exact to the second order: the
    /// solver has given all of it before. With contacts that would load them with half the weight in turn.
    /// </summary>
    private void Kick(float share)
    {
        BodyState* states = _step.Bodies.State.Pointer;
        BodyDrive* drives = _step.Bodies.Drive.Pointer;
        for (int i = 0; i < _forest.Count; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            if (_forest.Nodes[node->Root].Free != 0)
            {
                BodyState* state = states + node->Body;
                BodyDrive* drive = drives + node->Body;
                state->LinearVelocity.X += share * drive->X;
                state->LinearVelocity.Y += share * drive->Y;
                state->AngularVelocity += share * drive->W;
            }
        }
    }

    private void LoadPoses()
    {
        for (int i = 0; i < _forest.Count; i++)
        {
            LoadPose(_forest.Nodes + i);
        }
    }

    /// <summary>Angle turned since the start of the step.</summary>
    private double Turn(int body) => (double)_step.Bodies.Motion[body].Turned + _step.Bodies.Drive[body].Lead;

    private void LoadPose(TreeNode* node)
    {
        ref BodyPose pose = ref _step.Bodies.Pose[node->Body];
        ref BodyState state = ref _step.Bodies.State[node->Body];
        node->X = pose.X + state.DeltaPosition.X;
        node->Y = pose.Y + state.DeltaPosition.Y;
        double angle = pose.Angle + Turn(node->Body);
        if (angle != node->Angle || node->Cos == 0)
        {
            node->Angle = angle;
            StableMath.SinCos(angle, out node->Sin, out node->Cos);
        }
    }

    private void LoadVelocities()
    {
        BodyState* states = _step.Bodies.State.Pointer;
        for (int i = 0; i < _forest.Count; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            BodyState* state = states + node->Body;
            node->Velocity[0] = Refresh(node->Velocity[0], state->LinearVelocity.X);
            node->Velocity[1] = Refresh(node->Velocity[1], state->LinearVelocity.Y);
            node->Velocity[2] = Refresh(node->Velocity[2], state->AngularVelocity);
        }
    }

    // The double stands as long as the store still holds its rounding.
    private static double Refresh(double held, float stored) => (float)held == stored ? held : stored;

    private void StoreVelocities()
    {
        BodyState* states = _step.Bodies.State.Pointer;
        for (int i = 0; i < _forest.Count; i++)
        {
            TreeNode* node = _forest.Nodes + i;
            BodyState* state = states + node->Body;
            state->LinearVelocity.X = (float)node->Velocity[0];
            state->LinearVelocity.Y = (float)node->Velocity[1];
            state->AngularVelocity = (float)node->Velocity[2];
        }
    }
}
