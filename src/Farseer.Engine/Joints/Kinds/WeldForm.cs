using Farseer.Engine.Joints.Nets;

namespace Farseer.Engine.Joints.Kinds;

/// <summary>
/// Two bodies as one: φ = anchor B - anchor A and φ = θB - θA - Target, three hard rows; with the spring flag the angle is a damped
/// spring. Reads AnchorA, AnchorB, Target (angle), Frequency, DampingRatio.
/// </summary>
internal sealed class WeldForm : JointForm
{
    public override void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows)
    {
        rows.AddPoint(RowType.Hard, f);
        bool springy = (flags & JointFlags.Spring) != 0;
        int row = rows.AddAngle(springy ? RowType.Spring : RowType.Hard, 1, f.BAngle - f.AAngle - s.Target);
        rows.SetSpring(row, AngularFrequency(s), s.DampingRatio);
        rows.JointError = Distance(f);
    }

    public override NetForm NetFormOf(in JointSettings s, JointFlags flags) =>
        (flags & JointFlags.Spring) == 0 ? NetForm.Weld : NetForm.None;
}
