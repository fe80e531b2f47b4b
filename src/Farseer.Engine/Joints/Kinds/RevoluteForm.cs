using System;
using Farseer.Engine.Joints.Nets;

namespace Farseer.Engine.Joints.Kinds;

/// <summary>
/// Two anchors in one place: φ = xB + rB - (xA + rA), so dφ/dt = vB + ωB×rB - vA - ωA×rA, two hard rows. With a softness σ the
/// two rows are compliant. The angle θ = θB - θA - Target may have limits, φ = θ - Lower and Upper - θ, and a motor.
/// Reads AnchorA, AnchorB, Target (angle), Lower, Upper, MotorSpeed, MotorLimit, Softness, BiasFactor, MaxImpulse.
/// </summary>
internal sealed class RevoluteForm : JointForm
{
    public override void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows)
    {
        if (IsRigid(s))
        {
            rows.AddPoint(RowType.Hard, f);
        }
        else
        {
            // A soft or bounded pivot is a pair of motors that take the error away at the rate of the bias factor.
            rows.AddPoint(RowType.Motor, f);
            Soften(ref rows, 0, f, s);
            Soften(ref rows, 1, f, s);
        }

        double angle = f.BAngle - f.AAngle - s.Target;
        if ((flags & JointFlags.Limit) != 0)
        {
            rows.AddAngle(RowType.Limit, 1, angle - s.Lower);
            rows.AddAngle(RowType.Limit, -1, s.Upper - angle);
        }

        if ((flags & JointFlags.Motor) != 0)
        {
            int row = rows.AddAngle(RowType.Motor, 1, 0);
            rows.SetMotor(row, s.MotorSpeed, s.MotorLimit * f.H);
        }

        rows.JointError = Math.Sqrt((f.DX * f.DX) + (f.DY * f.DY));
    }

    public override NetForm NetFormOf(in JointSettings s, JointFlags flags) =>
        IsRigid(s) && (flags & (JointFlags.Limit | JointFlags.Motor)) == 0 ? NetForm.Pivot : NetForm.None;

    public override PivotKind PivotOf(in JointSettings s, JointFlags flags) =>
        !IsRigid(s) || (flags & JointFlags.Motor) != 0 ? PivotKind.None
        : (flags & JointFlags.Limit) != 0 ? PivotKind.Limited : PivotKind.Point;

    private static bool IsRigid(in JointSettings s) => s.Softness == 0 && double.IsInfinity(s.MaxImpulse);
}
