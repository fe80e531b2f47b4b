using Farseer.Engine.Joints.Nets;

namespace Farseer.Engine.Joints.Kinds;

/// <summary>
/// A rod: φ = |d| - Target with d from anchor A to anchor B and n = d/|d|, so dφ/dt = n·(vB + ωB×rB - vA - ωA×rA), one hard row.
/// A rod of length 0 has no direction: it is a pivot, two hard rows. Reads AnchorA, AnchorB, Target, Softness, BiasFactor.
/// </summary>
internal sealed class PinForm : JointForm
{
    public override void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows)
    {
        RowType type = s.Softness > 0 ? RowType.Motor : RowType.Hard;
        double length = Direction(f, out double nx, out double ny);
        if (s.Target > 0)
        {
            rows.AddDistance(type, f, nx, ny, 1, length - s.Target);
        }
        else
        {
            rows.AddPoint(type, f);
        }

        for (int i = 0; type == RowType.Motor && i < rows.Count; i++)
        {
            Soften(ref rows, i, f, s);
        }

        rows.Size += s.Target;
        rows.JointError = length - s.Target;
    }

    public override NetForm NetFormOf(in JointSettings s, JointFlags flags) =>
        s.Softness > 0 ? NetForm.None : s.Target > 0 ? NetForm.Rod : NetForm.Pivot;

    public override PivotKind PivotOf(in JointSettings s, JointFlags flags) =>
        s.Softness > 0 || s.Target > 0 ? PivotKind.None : PivotKind.Point;
}
