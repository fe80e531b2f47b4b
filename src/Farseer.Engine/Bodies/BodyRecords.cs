using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Farseer.Engine.Bodies;

/// <summary>
/// What the solver reads and writes in every pass: exactly 32 bytes, two 16-byte halves, gathered and scattered by lanes.
/// </summary>
[StructLayout(LayoutKind.Sequential, Size = 32)]
internal struct BodyState
{
    /// <summary>Velocity of the centre of mass, length/s.</summary>
    public Vector2 LinearVelocity;

    /// <summary>rad/s, positive turns the x axis towards the y axis.</summary>
    public float AngularVelocity;

    public float Spare;

    /// <summary>Displacement since the start of the step.</summary>
    public Vector2 DeltaPosition;

    /// <summary>Sine and cosine of the turn since the middle of the step as foreseen at its start (0 and 1 between steps).</summary>
    public float DeltaSin;

    public float DeltaCos;

    /// <summary>Velocity and what is spare beside it, which is read and written as one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Vector4* VelocityOf(BodyState* state) => (Vector4*)state;
}

/// <summary>Pose in double precision: the solver works on differences, so 10^7 m behaves as the origin. 32 bytes.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct BodyPose
{
    public double X;
    public double Y;

    /// <summary>Unwrapped angle, radians.</summary>
    public double Angle;

    public float Cos;
    public float Sin;
}

/// <summary>Mass properties as the user set them, and the inverses in effect (0 for static and kinematic bodies).</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct BodyMass
{
    public float Mass;
    public float Inertia;
    public float InverseMass;
    public float InverseInertia;
}

/// <summary>Accumulated force and torque, cleared at the end of each step.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct BodyForce
{
    public Vector2 Force;
    public float Torque;
}

/// <summary>
/// Drag coefficients, forces: -Linear·v - Quadratic·|v|·v, and as a torque -Angular·ω or, where that is 0, -Rotational·ω·|ω|.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal struct BodyDrag
{
    public float Linear;
    public float Quadratic;
    public float Rotational;
    public float Angular;
}

[Flags]
internal enum BodyFlags : uint
{
    None = 0,
    Alive = 1,

    /// <summary>Takes part in collision and motion; the original's <c>Body.Enabled</c>.</summary>
    Enabled = 2,

    /// <summary>Never moves by itself; infinite mass.</summary>
    Static = 4,

    /// <summary>Moves with the velocity that the user gives; infinite mass.</summary>
    Kinematic = 8,

    IgnoreGravity = 16,

    /// <summary>Adds <see cref="BodyDrag.Quadratic"/>.</summary>
    QuadraticDrag = 32,

    /// <summary>The pose or a collider was changed from outside since the last step: its boxes must be found anew.</summary>
    Moved = 64,

    /// <summary>The state left its range; disabled until the user enables the body again.</summary>
    Quarantined = 128,

    /// <summary>Looked after against everything, not only against what cannot move, when it is fast.</summary>
    Bullet = 256,

    /// <summary>Not looked after when it is fast: it is where it is at the end of each step, and may pass through things.</summary>
    Discrete = 512,

    /// <summary>Foreseen at the start of the step to move by more than its own size in it.</summary>
    Fast = 1024,

    /// <summary>Rests, and costs nothing until something wakes it: see <c>World.WakeUp</c>.</summary>
    Asleep = 2048,

    /// <summary>Never falls asleep, nor does what it is in touch with.</summary>
    NeverSleeps = 4096,

    /// <summary>Asleep, and somebody got hold of its velocity: the next step looks whether it was set.</summary>
    Handled = 8192,

    /// <summary>How many times the step's substeps its island takes, chosen by the user: see <see cref="ChosenSubsteps"/>.</summary>
    Substeps = 7 * 16384,

    /// <summary>A limb: has joints that give no way, so it does not go where its velocity leads.</summary>
    Tied = 131072,
}

/// <summary>What a step's motion of a body is measured by. 8 bytes; a body without colliders is never fast.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct BodySize
{
    /// <summary>A body that moves by more than this in a step is fast; it comes from half the shorter side of its smallest piece.</summary>
    public float Extent;

    /// <summary>Greatest distance of a point of it from its centre.</summary>
    public float Reach;
}

/// <summary>A body that moved by more than its size in a step, and where and how fast it was when the step began.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 4)]
internal struct FastMotion
{
    public double X;
    public double Y;
    public double Angle;
    public float VelocityX;
    public float VelocityY;
    public float AngularVelocity;
    public int Body;

    /// <summary>1: it flew without contacts, springs and joints, by the law of free flight. 0: the solver moved it.</summary>
    public int Free;
}

/// <summary>What a body is made from.</summary>
internal struct BodyDef
{
    public double X;
    public double Y;
    public double Angle;
    public Vector2 LinearVelocity;
    public float AngularVelocity;
    public float Mass;
    public float Inertia;
    public BodyDrag Drag;
    public BodyFlags Flags;
    public int UserIndex;
}
