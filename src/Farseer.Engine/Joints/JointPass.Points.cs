using System;
using Farseer.Engine.Joints.Solving;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints;

/// <content>Points of joints that yield, or that are pulled together.</content>
internal sealed unsafe partial class JointPass
{
    /// <summary>While bodies are displaced: limits that stand aside are pulled to their places; by nothing else, and no further.</summary>
    public void Pull(ActiveJoint* joint, JointRows* r, in JointStep step)
    {
        if (!joint->Overrun || joint->BlockLimits)
        {
            return;
        }

        RowEnds.Visit(_view, &joint->Ends);
        double* a = stackalloc double[3];
        double* b = stackalloc double[3];
        for (int k = r->Hard; k < r->Count; k++)
        {
            if (r->Type[k] != (byte)RowType.Limit || !(joint->Outside[k] < 0) || !(joint->Response[k] > 0))
            {
                continue;
            }

            double v = Displacing(joint->Ends.NodeA, r->A + (k * 3)) + Displacing(joint->Ends.NodeB, r->B + (k * 3));
            double old = joint->PlainLambda[k];
            double pull = TreeRows.PullSpeed(joint->Outside[k], r, k, step);
            joint->PlainLambda[k] = Math.Max(0, old - ((v + pull) / joint->Response[k]));
            Scale(r->A + (k * 3), joint->PlainLambda[k] - old, a);
            Scale(r->B + (k * 3), joint->PlainLambda[k] - old, b);
            RowEnds.Apply(_view, &joint->Ends, a, b);
        }
    }

    /// <summary>What cannot be moved is not displaced, though it may be moving.</summary>
    private double Displacing(int node, double* j) => node >= 0 ? SmallMatrix.Dot(j, _view.Nodes[node].Velocity) : 0;

    /// <returns>False if the rows are to be solved in turn.</returns>
    private bool SolvePoint(ActiveJoint* joint, JointRows* r, double share)
    {
        double old0 = joint->Lambda[0];
        double old1 = joint->Lambda[1];
        double off0 = RowSpeed(joint, r, 0) - r->Speed[0] + (r->Damping[0] * old0);
        double off1 = RowSpeed(joint, r, 1) - r->Speed[1] + (r->Damping[1] * old1);
        if (!AnswerPoint(joint, r, off0, off1, out double change0, out double change1))
        {
            return false;
        }

        double now0 = old0 + change0;
        double now1 = old1 + change1;
        if (!(now0 >= share * r->Low[0] && now0 <= share * r->High[0] && now1 >= share * r->Low[1] && now1 <= share * r->High[1]))
        {
            return false;
        }

        joint->Lambda[0] = now0;
        Apply(joint, r, 0, now0 - old0);
        joint->Lambda[1] = now1;
        Apply(joint, r, 1, now1 - old1);
        return true;
    }

    /// <summary>
    /// In the position correction: a soft point goes with its bodies no further than it gives way to the impulse. What a limit or a contact
    /// turned a light body by swung its far anchor by decimetres in each substep, and the speed of that was for the pivot to stop.
    /// </summary>
    public void HoldPoint(ActiveJoint* joint, JointRows* r)
    {
        if (!r->SoftPoint)
        {
            return;
        }

        RowEnds.Visit(_view, &joint->Ends);
        if (AnswerPoint(joint, r, RowSpeed(joint, r, 0), RowSpeed(joint, r, 1), out double change0, out double change1))
        {
            joint->Lambda[0] += change0;
            Apply(joint, r, 0, change0);
            joint->Lambda[1] += change1;
            Apply(joint, r, 1, change1);
        }
    }

    /// <summary>The impulses that bring both rows to 0.</summary>
    private static bool AnswerPoint(ActiveJoint* joint, JointRows* r, double off0, double off1, out double change0, out double change1)
    {
        double k0 = joint->Response[0] + r->Damping[0];
        double k1 = joint->Response[1] + r->Damping[1];
        double k01 = joint->PointCoupling;
        double determinant = (k0 * k1) - (k01 * k01);
        change0 = ((k01 * off1) - (k1 * off0)) / determinant;
        change1 = ((k01 * off0) - (k0 * off1)) / determinant;
        return joint->Response[0] > 0 && joint->Response[1] > 0 && determinant > SmallMatrix.Lost * (k0 * k1);
    }
}
