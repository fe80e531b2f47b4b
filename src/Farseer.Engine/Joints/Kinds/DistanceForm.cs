using Farseer.Engine.Joints.Nets;

namespace Farseer.Engine.Joints.Kinds;

/// <summary>
/// A distance |d| = Target between two anchors, rigid as a rod or, with the spring flag, a damped spring; limits Lower ≤ |d| ≤ Upper
/// may bound the spring. Reads AnchorA, AnchorB, Target, Lower, Upper, Frequency, DampingRatio.
/// </summary>
internal sealed class DistanceForm : JointForm
{
    public override void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows)
    {
        double length = Direction(f, out double nx, out double ny);
        bool springy = (flags & JointFlags.Spring) != 0;
        int row = rows.AddDistance(springy ? RowType.Spring : RowType.Hard, f, nx, ny, 1, length - s.Target);
        rows.SetSpring(row, AngularFrequency(s), s.DampingRatio);
        if (springy && (flags & JointFlags.Limit) != 0)
        {
            rows.AddDistance(RowType.Limit, f, nx, ny, 1, length - s.Lower);
            rows.AddDistance(RowType.Limit, f, nx, ny, -1, s.Upper - length);
        }

        rows.Size += s.Target;
        rows.JointError = length - s.Target;
    }

    public override NetForm NetFormOf(in JointSettings s, JointFlags flags) =>
        (flags & JointFlags.Spring) == 0 && s.Target > 0 ? NetForm.Rod : NetForm.None;
}
