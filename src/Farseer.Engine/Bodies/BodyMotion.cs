using System.Runtime.InteropServices;

namespace Farseer.Engine.Bodies;

/// <summary>
/// What the solver remembers of a body from substep to substep, 32 bytes: the velocity at the substep's start, the velocity
/// change of the substep before, and the angle turned in this step.
/// </summary>
[StructLayout(LayoutKind.Sequential, Size = 32)]
internal struct BodyMotion
{
    public float StartX;
    public float StartY;
    public float StartW;

    /// <summary>
    /// Angle turned since the middle of the step as foreseen at its start (-<see cref="BodyDrive.Lead"/> there), radians.
    /// </summary>
    public float Turned;

    public float ChangeX;
    public float ChangeY;
    public float ChangeW;

    /// <summary>Goes along in the fourth lane and means nothing.</summary>
    public float Spare;
}

/// <summary>
/// What acts on a body from outside in every substep of a step, 32 bytes: the first half is added to the velocity, when that has been
/// multiplied by the second, lane by lane (<see cref="Integrator.IntegrateVelocities"/>).
/// </summary>
[StructLayout(LayoutKind.Sequential, Size = 32)]
internal struct BodyDrive
{
    /// <summary>Velocity change of a substep by gravity, force and torque.</summary>
    public float X;
    public float Y;
    public float W;

    /// <summary>0, as the spare lane of the velocity.</summary>
    public float Spare;

    /// <summary>
    /// Factors by which drag leaves linear and angular velocity after a substep; that of the y axis is that of the x axis.
    /// </summary>
    public float LinearKeep;
    public float LinearKeepY;
    public float AngularKeep;

    /// <summary>Angle that the body is foreseen to turn until the middle of the step, radians.</summary>
    public float Lead;

    public void Keep(float linear, float angular)
    {
        LinearKeep = linear;
        LinearKeepY = linear;
        AngularKeep = angular;
    }
}

/// <summary>
/// Low-order part of the velocity, so that free flight is exact for minutes: a float velocity of 100 m/s loses 4e-6 m/s
/// with every rounding. It counts only as long as the velocity is still the float that it belongs to.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal struct BodyResidual
{
    public float X;
    public float Y;
    public float W;
    public float OfX;
    public float OfY;
    public float OfW;
}
