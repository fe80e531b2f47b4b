using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints;

/// <content>What motors and springs did in a substep, for those who keep accounts.</content>
internal sealed unsafe partial class JointSolver
{
    /// <summary>
    /// Work of the motors and springs of the joints in the substep that has just ended: impulse times mean speed of each row. What is no
    /// number was done to a body that is about to be taken out.
    /// </summary>
    /// <param name="before">Velocities at the substep's start, three numbers a body of the solver.</param>
    public double MotorWork(double* before)
    {
        double work = 0;
        for (int at = 0; at < _jointCount; at++)
        {
            int i = _joints[at];
            ActiveJoint* joint = _active.Pointer + i;
            JointRows* rows = _rows.Pointer + i;
            ref JointLink link = ref _store.Links[joint->Joint];
            for (int k = rows->Hard; k < rows->Count; k++)
            {
                RowType type = (RowType)rows->Type[k];
                if (type == RowType.Motor || type == RowType.Spring)
                {
                    double a = MeanSpeed(link.BodyA, rows->A + (k * 3), before);
                    double b = MeanSpeed(link.BodyB, rows->B + (k * 3), before);
                    double done = joint->Lambda[k] * (a + b);
                    work += FloatBits.IsFinite(done) ? done : 0;
                }
            }
        }

        return work;
    }

    /// <summary>A body that cannot be moved keeps its velocity through the substep; no energy of it is counted.</summary>
    private double MeanSpeed(int body, double* j, double* before)
    {
        if (_step.Moves[body] == 0)
        {
            return 0;
        }

        ref BodyState s = ref _step.Bodies.State[body];
        double* v = before + (body * 3);
        return 0.5 * ((j[0] * (v[0] + s.LinearVelocity.X)) + (j[1] * (v[1] + s.LinearVelocity.Y)) + (j[2] * (v[2] + s.AngularVelocity)));
    }
}
