using System;

namespace Farseer.Engine.Joints.Kinds;

/// <summary>
/// A rope over two fixed points: φ = Target - lA - Ratio·lB ≥ 0 with the lengths lA, lB from the fixed points to the anchors. A
/// rope pulls and never pushes, so it is a limit: dφ/dt = -nA·(vA + ωA×rA) - Ratio·nB·(vB + ωB×rB). Reads GroundA, GroundB,
/// AnchorA, AnchorB, Ratio, Target. With the limit flag neither side grows beyond its length: φ = Upper - lA and Lower - lB.
/// </summary>
internal sealed class PulleyForm : JointForm
{
    public override void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows)
    {
        double lengthA = Unit(f.AX + f.RAX - s.GroundAX, f.AY + f.RAY - s.GroundAY, out double ax, out double ay);
        double lengthB = Unit(f.BX + f.RBX - s.GroundBX, f.BY + f.RBY - s.GroundBY, out double bx, out double by);
        double slack = s.Target - lengthA - (s.Ratio * lengthB);
        rows.Add(
            RowType.Limit,
            -ax,
            -ay,
            -((f.RAX * ay) - (f.RAY * ax)),
            -s.Ratio * bx,
            -s.Ratio * by,
            -s.Ratio * ((f.RBX * by) - (f.RBY * bx)),
            slack);
        if ((flags & JointFlags.Limit) != 0)
        {
            rows.Add(RowType.Limit, -ax, -ay, -((f.RAX * ay) - (f.RAY * ax)), 0, 0, 0, s.Upper - lengthA);
            rows.Add(RowType.Limit, 0, 0, 0, -bx, -by, -((f.RBX * by) - (f.RBY * bx)), s.Lower - lengthB);
        }

        rows.JointError = Math.Max(0, -slack);
    }

    private static double Unit(double x, double y, out double nx, out double ny)
    {
        double length = Math.Sqrt((x * x) + (y * y));
        nx = length > 0 ? x / length : 0;
        ny = length > 0 ? y / length : 0;
        return length;
    }
}
