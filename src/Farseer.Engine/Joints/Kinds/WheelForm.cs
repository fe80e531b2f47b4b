using System;

namespace Farseer.Engine.Joints.Kinds;

/// <summary>
/// A wheel B on a car A: anchor B keeps to the line through anchor A along the axis a of A (p·d = 0, hard, as in the prismatic
/// kind), sprung along it towards a·d = 0, free to turn or driven by a motor. Reads AnchorA, AnchorB, Axis, Frequency,
/// DampingRatio, Lower, Upper, MotorSpeed, MotorLimit.
/// </summary>
internal sealed class WheelForm : JointForm
{
    public override void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows)
    {
        double ax = (f.ACos * s.AxisX) - (f.ASin * s.AxisY);
        double ay = (f.ASin * s.AxisX) + (f.ACos * s.AxisY);
        double across = (f.DY * ax) - (f.DX * ay);
        rows.AddAxis(RowType.Hard, f, -ay, ax, 1, across);
        double travel = (f.DX * ax) + (f.DY * ay);
        if ((flags & JointFlags.Spring) != 0)
        {
            int row = rows.AddAxis(RowType.Spring, f, ax, ay, 1, travel);
            rows.SetSpring(row, AngularFrequency(s), s.DampingRatio);
        }

        if ((flags & JointFlags.Limit) != 0)
        {
            rows.AddAxis(RowType.Limit, f, ax, ay, 1, travel - s.Lower);
            rows.AddAxis(RowType.Limit, f, ax, ay, -1, s.Upper - travel);
        }

        if ((flags & JointFlags.Motor) != 0)
        {
            int row = rows.AddAngle(RowType.Motor, 1, 0);
            rows.SetMotor(row, s.MotorSpeed, s.MotorLimit * f.H);
        }

        rows.JointError = Math.Abs(across);
    }
}
