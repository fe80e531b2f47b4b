namespace Farseer.Engine.Joints.Kinds;

/// <summary>
/// Ties two motions, each a turn or a slide against something that does not move: φ = cA + Ratio·cB - Target. The motion c of a side
/// is its body's angle or, where an axis u is given in world coordinates, u·anchor, with dc/dt = u·v + (r×u)·ω. Reads Ratio, Target,
/// AnchorA, AnchorB, GroundA and GroundB (the axes; zero: the angle counts).
/// </summary>
internal sealed class TransmissionForm : JointForm
{
    public override void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows)
    {
        bool turnsA = s.GroundAX == 0 && s.GroundAY == 0;
        bool turnsB = s.GroundBX == 0 && s.GroundBY == 0;
        double a = turnsA ? f.AAngle : (s.GroundAX * (f.AX + f.RAX)) + (s.GroundAY * (f.AY + f.RAY));
        double b = turnsB ? f.BAngle : (s.GroundBX * (f.BX + f.RBX)) + (s.GroundBY * (f.BY + f.RBY));
        double error = a + (s.Ratio * b) - s.Target;
        rows.Add(
            RowType.Hard,
            s.GroundAX,
            s.GroundAY,
            turnsA ? 1 : (f.RAX * s.GroundAY) - (f.RAY * s.GroundAX),
            s.Ratio * s.GroundBX,
            s.Ratio * s.GroundBY,
            s.Ratio * (turnsB ? 1 : (f.RBX * s.GroundBY) - (f.RBY * s.GroundBX)),
            error);
        rows.JointError = error;
    }
}
