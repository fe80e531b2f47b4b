using System;

namespace Farseer.Engine.Joints.Kinds;

/// <summary>
/// Lower ≤ |d| ≤ Upper with d from anchor A to anchor B: two limits along d. An overrun of up to Slop is not pushed back. Reads
/// AnchorA, AnchorB, Lower, Upper, Slop, BiasFactor, Softness.
/// </summary>
internal sealed class SliderForm : JointForm
{
    public override void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows)
    {
        double length = Direction(f, out double nx, out double ny);
        int lower = rows.AddDistance(RowType.Limit, f, nx, ny, 1, length - s.Lower);
        int upper = rows.AddDistance(RowType.Limit, f, nx, ny, -1, s.Upper - length);
        rows.SetShare(lower, s.Slop);
        rows.SetShare(upper, s.Slop);
        if (s.Softness > 0)
        {
            rows.SetSpring(lower, 0, s.Softness * f.PullTime / f.H);
            rows.SetSpring(upper, 0, s.Softness * f.PullTime / f.H);
        }

        double beyond = length > s.Upper ? length - s.Upper : length < s.Lower ? length - s.Lower : 0;
        rows.Size += s.Upper;
        rows.JointError = Math.Abs(beyond) < s.Slop ? 0 : beyond;
    }
}
