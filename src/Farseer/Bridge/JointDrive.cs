using System.Runtime.InteropServices;
using Farseer.Engine.Joints;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>The limits and the motor of a joint.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal struct JointDrive
{
    public bool IsLimited;
    public float Lower;
    public float Upper;
    public bool IsDriven;
    public float Speed;

    /// <summary>Largest torque or force of the motor; the largest float stands for no bound.</summary>
    public float MaxEffort;

    public readonly void Fill(ref JointSettings settings, ref JointFlags flags)
    {
        settings.Lower = Lower;
        settings.Upper = Upper;
        flags |= IsLimited ? JointFlags.Limit : JointFlags.None;
        settings.MotorSpeed = Speed;
        settings.MotorLimit = Dynamics.Joints.Joint.Bound(MaxEffort);
        flags |= IsDriven ? JointFlags.Motor : JointFlags.None;
    }
}
