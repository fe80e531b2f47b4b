using Farseer.Engine.Joints;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>How softly a joint holds: as a damped spring, or rigidly where the frequency is 0.</summary>
internal struct JointSpring
{
    public float Frequency;
    public float DampingRatio;

    public readonly void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        settings.Frequency = Frequency;
        settings.DampingRatio = DampingRatio;
        flags |= Frequency > 0 ? JointFlags.Spring : JointFlags.None;
    }
}
