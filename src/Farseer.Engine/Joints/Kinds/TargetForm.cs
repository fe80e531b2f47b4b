namespace Farseer.Engine.Joints.Kinds;

/// <summary>
/// Draws anchor B towards anchor A (the target, usually a point of the world) by a damped spring with a largest force: one
/// spring row along the way to the target and one across, whose forces are bounded together. Reads AnchorA, AnchorB, Frequency,
/// DampingRatio, MotorLimit (force), Ratio (the mass that the frequency counts by; 0: that at the anchor).
/// </summary>
internal sealed class TargetForm : JointForm
{
    public override void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows)
    {
        double length = Direction(f, out double nx, out double ny);
        rows.SpringMass = s.Ratio;
        for (int i = 0; i < 2; i++)
        {
            int row = i == 0
                ? rows.AddDistance(RowType.Spring, f, nx, ny, 1, length)
                : rows.AddDistance(RowType.Spring, f, -ny, nx, 1, 0);
            rows.SetSpring(row, AngularFrequency(s), s.DampingRatio);
            if (i == 1)
            {
                // The bound of both together, which is applied when the second is solved.
                rows.SetMotor(row, 0, s.MotorLimit * f.H);
            }
        }

        rows.JointError = length;
    }
}
