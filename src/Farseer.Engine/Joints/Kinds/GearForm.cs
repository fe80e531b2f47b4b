namespace Farseer.Engine.Joints.Kinds;

/// <summary>
/// Meshing gears: φ = θB + Ratio·θA - Target, one row on the two angles. Without a bound and softness it is hard; with them it
/// slips. Reads Ratio, Target, MaxImpulse, Softness, BiasFactor.
/// </summary>
internal sealed class GearForm : JointForm
{
    public override void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows)
    {
        double error = f.BAngle + (s.Ratio * f.AAngle) - s.Target;
        if (double.IsInfinity(s.MaxImpulse) && s.Softness == 0)
        {
            rows.Add(RowType.Hard, 0, 0, s.Ratio, 0, 0, 1, error);
            rows.JointError = error;
            return;
        }

        AddServo(f, s, ref rows, s.Ratio, 1, error);
    }
}
