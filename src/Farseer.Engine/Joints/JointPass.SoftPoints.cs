using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints;

/// <content>
/// Soft points: two motors that hold two points together. They are solved as one, bounds permitting. In turn they hardly get anywhere where both go by the same turn of a light body, as of an anchor
/// metres off it: in terms of their own responses the two have 1 - ρ of each other, with ρ the share of its mass in that of its inertia there, a thousandth, and a sweep leaves all but so much of what is across. A body of
/// 0.1 kg swung about such a pivot at 10⁴ to 10¹² m/s.
/// </content>
internal sealed unsafe partial class JointPass
{
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
