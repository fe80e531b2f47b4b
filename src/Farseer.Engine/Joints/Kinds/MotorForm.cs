namespace Farseer.Engine.Joints.Kinds;

/// <summary>
/// Drives body B to an offset o (Axis, in the frame of A) and an angle (Target) relative to A with a largest force and torque, as
/// for a character that is moved by speed and yet pushes no harder than it can. With d = xB - xA and the turn R of A the error is
/// φ = R·(Rᵗ·d - o), what A sees of it: dφ/dt = vB - vA - ωA×d while A sees it change. So the force on A acts where B is, and
/// no pair of forces has a lever. Three motor rows whose speeds take away the share β of the error in a step. Reads Axis (offset),
/// Target, BiasFactor, MotorLimit (force), TorqueLimit.
/// </summary>
internal sealed class MotorForm : JointForm
{
    public override void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows)
    {
        double offsetX = (f.ACos * s.AxisX) - (f.ASin * s.AxisY);
        double offsetY = (f.ASin * s.AxisX) + (f.ACos * s.AxisY);
        double errorX = f.DX - offsetX;
        double errorY = f.DY - offsetY;
        double angle = f.BAngle - f.AAngle - s.Target;
        int x = rows.Add(RowType.Motor, -1, 0, f.DY, 1, 0, 0, errorX);
        int y = rows.Add(RowType.Motor, 0, -1, -f.DX, 0, 1, 0, errorY);
        int turn = rows.AddAngle(RowType.Motor, 1, angle);
        rows.SetMotor(x, -s.BiasFactor * errorX / f.PullTime, s.MotorLimit * f.H);
        rows.SetMotor(y, -s.BiasFactor * errorY / f.PullTime, s.MotorLimit * f.H);
        rows.SetMotor(turn, -s.BiasFactor * angle / f.PullTime, s.TorqueLimit * f.H);
        rows.JointError = System.Math.Sqrt((errorX * errorX) + (errorY * errorY));
    }
}
