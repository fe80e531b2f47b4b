using System;

namespace Farseer.Engine.Joints.Kinds;

/// <summary>A rope: |d| ≤ Upper between two anchors, one limit. Reads AnchorA, AnchorB, Upper.</summary>
internal sealed class RopeForm : JointForm
{
    public override void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows)
    {
        double length = Direction(f, out double nx, out double ny);
        rows.AddDistance(RowType.Limit, f, nx, ny, -1, s.Upper - length);
        rows.Size += s.Upper;
        rows.JointError = Math.Max(0, length - s.Upper);
    }
}
