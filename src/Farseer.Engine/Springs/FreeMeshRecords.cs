using System.Runtime.InteropServices;

namespace Farseer.Engine.Springs;

/// <summary>
/// A body of a free mesh while a substep is gone through in parts; an end that springs do not move has no inverses. What springs read and
/// write is in front, 64 bytes.
/// </summary>
[StructLayout(LayoutKind.Sequential, Size = 192)]
internal struct FreeBody
{
    /// <summary>Displacement since the step's start, and turn since its foreseen middle.</summary>
    public double X;
    public double Y;
    public double Turned;
    public double Sin;
    public double Cos;

    /// <summary>Sum of what the springs pull.</summary>
    public double ForceX;
    public double ForceY;
    public double Torque;
    public double VX;
    public double VY;
    public double W;

    /// <summary>Acceleration by gravity, forces and torques.</summary>
    public double LoadX;
    public double LoadY;
    public double LoadW;
    public double InverseMass;
    public double InverseInertia;

    /// <summary>The term of the series of a damped kick that was added last.</summary>
    public double TermX;
    public double TermY;
    public double TermW;
    public int Body;
    public int Moves;
    public int Acts;

    /// <summary>1 if a spring pulls beside the centre: the sine and cosine are needed.</summary>
    public int Turns;
}

/// <summary>A spring of a free mesh; see <see cref="SpringRow"/>.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct FreeSpring
{
    /// <summary>Places of the ends among the bodies of all free meshes.</summary>
    public int A;
    public int B;
    public SpringKind Kind;

    /// <summary>1 if an end is beside the centre of its body.</summary>
    public int HasArms;
    public double OffsetX;
    public double OffsetY;
    public double ArmAX;
    public double ArmAY;
    public double ArmBX;
    public double ArmBY;
    public double Rest;
    public double Stiffness;
    public double Damping;
    public double MaxTorque;

    /// <summary>The Jacobian at the last place looked at; of angular springs 0 for an end at its largest torque.</summary>
    public double NormalX;
    public double NormalY;
    public double TurnA;
    public double TurnB;
}

/// <summary>How a free mesh goes through a substep.</summary>
internal enum FreeScheme
{
    /// <summary>One kick in the middle, second order.</summary>
    Leap,

    /// <summary>Four kicks, fourth order.</summary>
    Four,

    /// <summary>Six kicks, fourth order.</summary>
    Six,
}

/// <summary>The scheme, and the number of parts that a substep is cut into; 0: none.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct FreePace
{
    public FreeScheme Scheme;
    public int Parts;

    /// <summary>Bound of c·h/m in a part.</summary>
    public double Drag;
}

/// <summary>A free mesh: its bodies, its springs, and the parts that a substep is cut into.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct FreeMesh
{
    public int FirstBody;
    public int BodyCount;
    public int FirstSpring;
    public int SpringCount;
    public FreePace Pace;

    /// <summary>A spring pulls beside a centre.</summary>
    public bool Turns;

    /// <summary>An end is driven, which gives energy.</summary>
    public bool Driven;

    /// <summary>Terms of the series of a kick.</summary>
    public int Terms;
}
