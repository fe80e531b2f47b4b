namespace Farseer.Engine.Joints.Kinds;

/// <summary>
/// Turns towards θB - θA = Target: a servo whose speed takes away the share β of the error in a step. Reads Target, BiasFactor,
/// Softness (the share of each impulse that is left out) and MaxImpulse.
/// </summary>
internal sealed class AngleForm : JointForm
{
    public override void Write(in JointFrame f, in JointSettings s, JointFlags flags, ref JointRows rows) =>
        AddServo(f, s, ref rows, -1, 1, f.BAngle - f.AAngle - s.Target);
}
