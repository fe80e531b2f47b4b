using System;
using System.Runtime.InteropServices;

namespace Farseer.Engine.Joints;

/// <summary>Kinds of joints. The numbers are stable: snapshots carry them.</summary>
internal enum JointKind : byte
{
    Revolute = 0,
    Angle = 1,
    AngleLimit = 2,
    Pin = 3,
    Slider = 4,
    Gear = 5,
    Prismatic = 6,
    Pulley = 7,
    Distance = 8,
    Weld = 9,
    Wheel = 10,
    Target = 11,
    Rope = 12,
    Motor = 13,
    Transmission = 14,
}

[Flags]
internal enum JointFlags : uint
{
    None = 0,
    Alive = 1,
    Enabled = 2,

    /// <summary>The two bodies collide with each other all the same.</summary>
    CollideConnected = 4,

    /// <summary>Lower and upper limit hold.</summary>
    Limit = 8,

    Motor = 16,

    /// <summary>Frequency and damping ratio make the joint a spring where its kind has one.</summary>
    Spring = 32,
}

/// <summary>
/// What a joint is made of, one record for all kinds; each kind says which fields it reads. Anchors are in the frames of the
/// bodies; the frame of body 0 is the world.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal struct JointSettings
{
    public double AnchorAX;
    public double AnchorAY;
    public double AnchorBX;
    public double AnchorBY;

    /// <summary>World points over which a pulley's rope runs, or the axes of a transmission.</summary>
    public double GroundAX;
    public double GroundAY;
    public double GroundBX;
    public double GroundBY;

    /// <summary>Unit axis in the frame of body A.</summary>
    public double AxisX;
    public double AxisY;

    /// <summary>Wanted angle, distance, length or offset, as the kind says.</summary>
    public double Target;

    /// <summary>Limits of angle, distance or travel, as the kind says.</summary>
    public double Lower;
    public double Upper;

    public double Ratio;

    /// <summary>Slack past a limit that is not pushed back.</summary>
    public double Slop;

    /// <summary>Share of an error that is taken away in a step.</summary>
    public double BiasFactor;

    /// <summary>0 rigid; above, a stiffness of β/(σ·dt²) and a damping of 1/(σ·dt), or the share of an impulse that is left out.</summary>
    public double Softness;

    /// <summary>Largest impulse of a row in a substep; infinite: unbounded.</summary>
    public double MaxImpulse;

    public double MotorSpeed;

    /// <summary>Largest force or torque of the motor.</summary>
    public double MotorLimit;

    /// <summary>Largest torque of a joint that has a force as well.</summary>
    public double TorqueLimit;

    /// <summary>Hertz.</summary>
    public double Frequency;
    public double DampingRatio;

    /// <summary>Error at which the joint breaks; infinite: never.</summary>
    public double Breakpoint;

    /// <summary>Force at which the joint breaks; infinite: never.</summary>
    public double BreakForce;
}

/// <summary>What connects a joint with its bodies.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal struct JointLink
{
    public int BodyA;
    public int BodyB;

    /// <summary>Next joint at the same body, times two plus the side (0 A, 1 B); -1 ends the list.</summary>
    public int NextA;
    public int NextB;

    /// <summary>The one before it in the same way; -1 begins the list.</summary>
    public int PreviousA;
    public int PreviousB;
    public int Order;
    public JointKind Kind;

    /// <summary>It counts as a tie of its bodies.</summary>
    public bool Ties;
}

/// <summary>What a joint did in the last step.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct JointState
{
    /// <summary>Impulses of the last substep, the start of the next.</summary>
    public fixed double Impulse[JointRows.Most];

    /// <summary>Error at the start of the step, as the kind defines it.</summary>
    public double Error;

    /// <summary>What the error of a joint with a breaking point would be if each step were taken straight on; see the solver.</summary>
    public double Drift;

    /// <summary>Mean force and torque on body B in the step.</summary>
    public double ForceX;
    public double ForceY;
    public double Torque;
}

/// <summary>Where a step left the limits of a joint, the lower one first.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal unsafe struct JointRange
{
    /// <summary>Limits that a joint may have: a pulley has three.</summary>
    public const int MostLimits = 3;

    /// <summary>Distance to the limit, negative: past it.</summary>
    public fixed double Gap[MostLimits];

    /// <summary>What of an overrun came from outside and is still to be taken out, negative.</summary>
    public fixed double Outside[MostLimits];

    /// <summary>The joint has acted in a step.</summary>
    public bool Known;
}
