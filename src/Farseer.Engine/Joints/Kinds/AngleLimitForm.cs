using System;

namespace Farseer.Engine.Joints.Kinds;

/// <summary>
/// Lower ≤ θB - θA ≤ Upper: φ = θ - Lower and φ = Upper - θ, two limits. An overrun of up to Slop is not pushed back. Reads
/// Lower, Upper, Slop, BiasFactor, Softness.
/// </summary>
internal sealed class AngleLimitForm : JointForm
{
    public override void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows)
    {
        double angle = f.BAngle - f.AAngle;
        int lower = rows.AddAngle(RowType.Limit, 1, angle - s.Lower);
        int upper = rows.AddAngle(RowType.Limit, -1, s.Upper - angle);
        rows.SetShare(lower, s.Slop);
        rows.SetShare(upper, s.Slop);
        if (s.Softness > 0)
        {
            rows.SetSpring(lower, 0, s.Softness * f.PullTime / f.H);
            rows.SetSpring(upper, 0, s.Softness * f.PullTime / f.H);
        }

        double beyond = angle > s.Upper ? angle - s.Upper : angle < s.Lower ? angle - s.Lower : 0;
        rows.JointError = Math.Abs(beyond) < s.Slop ? 0 : beyond;
    }
}
