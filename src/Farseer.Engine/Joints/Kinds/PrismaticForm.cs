using System;

namespace Farseer.Engine.Joints.Kinds;

/// <summary>
/// Slides along an axis a of body A without turning: with p = a turned by a right angle and d from anchor A to anchor B,
/// φ = p·d and φ = θB - θA - Target are hard. dφ/dt of the first is p·(vB + ωB×rB) - p·vA - ωA·((rA + d)×p), since p turns with
/// A. The travel a·d may have limits and a motor. Reads AnchorA, AnchorB, Axis, Target (angle), Lower, Upper, MotorSpeed,
/// MotorLimit.
/// </summary>
internal sealed class PrismaticForm : JointForm
{
    public override void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows)
    {
        double ax = (f.ACos * s.AxisX) - (f.ASin * s.AxisY);
        double ay = (f.ASin * s.AxisX) + (f.ACos * s.AxisY);
        double across = (f.DY * ax) - (f.DX * ay);
        rows.AddAxis(RowType.Hard, f, -ay, ax, 1, across);
        rows.AddAngle(RowType.Hard, 1, f.BAngle - f.AAngle - s.Target);
        double travel = (f.DX * ax) + (f.DY * ay);
        if ((flags & JointFlags.Limit) != 0)
        {
            rows.AddAxis(RowType.Limit, f, ax, ay, 1, travel - s.Lower);
            rows.AddAxis(RowType.Limit, f, ax, ay, -1, s.Upper - travel);
        }

        if ((flags & JointFlags.Motor) != 0)
        {
            int row = rows.AddAxis(RowType.Motor, f, ax, ay, 1, 0);
            rows.SetMotor(row, s.MotorSpeed, s.MotorLimit * f.H);
        }

        rows.JointError = Math.Abs(across);
    }
}
