namespace Farseer.Engine.Joints.Kinds;

/// <summary>
/// Drives body B to an offset (Axis, in the frame of A) and an angle (Target) relative to A with a largest force and torque, as
/// for a character that is moved by speed and yet pushes no harder than it can. Three motor rows whose speeds take away the share
/// β of the error in a step. Reads Axis (offset), Target, BiasFactor, MotorLimit (force), TorqueLimit.
/// </summary>
internal sealed class MotorForm : JointForm
{
    public override void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows)
    {
        // Anchors are the centres of mass, so the offset is the only arm.
        double offsetX = (f.ACos * s.AxisX) - (f.ASin * s.AxisY);
        double offsetY = (f.ASin * s.AxisX) + (f.ACos * s.AxisY);
        double dx = f.BX - f.AX - offsetX;
        double dy = f.BY - f.AY - offsetY;
        double angle = f.BAngle - f.AAngle - s.Target;
        int x = rows.Add(RowType.Motor, -1, 0, offsetY, 1, 0, 0, dx);
        int y = rows.Add(RowType.Motor, 0, -1, -offsetX, 0, 1, 0, dy);
        int turn = rows.AddAngle(RowType.Motor, 1, angle);
        rows.SetMotor(x, -s.BiasFactor * dx / f.Dt, s.MotorLimit * f.H);
        rows.SetMotor(y, -s.BiasFactor * dy / f.Dt, s.MotorLimit * f.H);
        rows.SetMotor(turn, -s.BiasFactor * angle / f.Dt, s.TorqueLimit * f.H);
        rows.JointError = System.Math.Sqrt((dx * dx) + (dy * dy));
    }
}
