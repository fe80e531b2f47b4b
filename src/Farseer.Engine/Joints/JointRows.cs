using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Farseer.Engine.Joints;

/// <summary>How a row is solved.</summary>
internal enum RowType : byte
{
    /// <summary>φ = 0, exactly.</summary>
    Hard,

    /// <summary>dφ/dt = a given speed, with an impulse as large as it takes.</summary>
    Servo,

    /// <summary>dφ/dt = a given speed, with a bounded impulse, or less by a compliance times the impulse.</summary>
    Motor,

    /// <summary>φ ≥ 0.</summary>
    Limit,

    /// <summary>A damped spring towards φ = 0, by frequency and damping ratio.</summary>
    Spring,
}

/// <summary>The two poses that a kind looks at, and the times of the step.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct JointFrame
{
    public double AX;
    public double AY;
    public double AAngle;
    public double ACos;
    public double ASin;
    public double BX;
    public double BY;
    public double BAngle;
    public double BCos;
    public double BSin;

    /// <summary>See <see cref="JointStep.PullTime"/>.</summary>
    public double PullTime;

    /// <summary>The substep, seconds.</summary>
    public double H;

    /// <summary>Arms from the centres of mass to the anchors, in world axes.</summary>
    public double RAX;
    public double RAY;
    public double RBX;
    public double RBY;

    /// <summary>Anchor B less anchor A.</summary>
    public double DX;
    public double DY;

    /// <summary>Works out arms and distance of the anchors.</summary>
    public void SetAnchors(in JointSettings s)
    {
        RAX = (ACos * s.AnchorAX) - (ASin * s.AnchorAY);
        RAY = (ASin * s.AnchorAX) + (ACos * s.AnchorAY);
        RBX = (BCos * s.AnchorBX) - (BSin * s.AnchorBY);
        RBY = (BSin * s.AnchorBX) + (BCos * s.AnchorBY);
        DX = (BX - AX) + (RBX - RAX);
        DY = (BY - AY) + (RBY - RAY);
    }
}

/// <summary>
/// The rows of a joint at a pose: for each the Jacobian, with which dφ/dt = JA·(vA, ωA) + JB·(vB, ωB), the value φ and what
/// its type needs. Hard and servo rows come first: they are solved as one block.
/// </summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal unsafe struct JointRows
{
    public const int Most = 6;

    /// <summary>Rows that hold two points together.</summary>
    public const int OfPoint = 2;

    public fixed double A[Most * 3];
    public fixed double B[Most * 3];
    public fixed double Error[Most];

    /// <summary>Wanted dφ/dt of a servo or motor.</summary>
    public fixed double Speed[Most];

    /// <summary>Bounds of the impulse in a substep.</summary>
    public fixed double Low[Most];
    public fixed double High[Most];

    /// <summary>Spring: ω and ζ. Motor and limit: nothing, and the compliance.</summary>
    public fixed double Stiffness[Most];
    public fixed double Damping[Most];

    /// <summary>Motor: the share of a correction that is applied. Limit: the slack.</summary>
    public fixed double Share[Most];

    public fixed byte Type[Most];
    public int Count;

    /// <summary>Only the errors are wanted.</summary>
    public bool ErrorsOnly;

    /// <summary>Mass by which springs are as stiff as their frequency says; 0: the mass that each row feels.</summary>
    public double SpringMass;

    /// <summary>The first two rows are motors that hold two points together.</summary>
    public bool SoftPoint;

    /// <summary>Rows of the block at the front.</summary>
    public int Hard;

    /// <summary>Of a spring along a line: how the turns of the bodies move its anchors across.</summary>
    public double AcrossA;
    public double AcrossB;

    /// <summary>What the facade shows as the error of the joint.</summary>
    public double JointError;

    /// <summary>A length of the joint that says which errors are small: the arms together.</summary>
    public double Size;

    /// <summary>Arm from body B to its anchor.</summary>
    public double ArmX;
    public double ArmY;

    /// <summary>Share of an error from outside that is taken away in a step.</summary>
    public double Bias;

    /// <summary>Appends a row.</summary>
    /// <returns>Its index.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Add(RowType type, double ax, double ay, double aw, double bx, double by, double bw, double error)
    {
        int i = Count++;
        Error[i] = error;
        if (ErrorsOnly)
        {
            return i;
        }

        A[i * 3] = ax;
        A[(i * 3) + 1] = ay;
        A[(i * 3) + 2] = aw;
        B[i * 3] = bx;
        B[(i * 3) + 1] = by;
        B[(i * 3) + 2] = bw;
        Type[i] = (byte)type;
        Speed[i] = 0;
        Low[i] = double.NegativeInfinity;
        High[i] = double.PositiveInfinity;
        Share[i] = type == RowType.Limit ? 0 : 1;
        Stiffness[i] = 0;
        Damping[i] = 0;
        if (type <= RowType.Servo)
        {
            Hard++;
        }

        return i;
    }

    /// <summary>φ = anchor B - anchor A, both coordinates.</summary>
    public void AddPoint(RowType type, in JointFrame f)
    {
        Add(type, -1, 0, f.RAY, 1, 0, -f.RBY, f.DX);
        Add(type, 0, -1, -f.RAX, 0, 1, f.RBX, f.DY);
        SoftPoint = type == RowType.Motor;
    }

    /// <summary>φ = sign·(angle of B - angle of A) - offset.</summary>
    public int AddAngle(RowType type, double sign, double error) => Add(type, 0, 0, -sign, 0, 0, sign, error);

    /// <summary>φ along a unit vector n that turns with body A: n·(anchor B - anchor A), times sign.</summary>
    public int AddAxis(RowType type, in JointFrame f, double nx, double ny, double sign, double error)
    {
        double ax = f.RAX + f.DX;
        double ay = f.RAY + f.DY;
        if (type == RowType.Spring)
        {
            AcrossA = -((ax * nx) + (ay * ny));
            AcrossB = (f.RBX * nx) + (f.RBY * ny);
        }

        return Add(
            type,
            -sign * nx,
            -sign * ny,
            -sign * ((ax * ny) - (ay * nx)),
            sign * nx,
            sign * ny,
            sign * ((f.RBX * ny) - (f.RBY * nx)),
            error);
    }

    /// <summary>φ = sign·|anchor B - anchor A| - offset, with n the unit vector from A to B.</summary>
    public int AddDistance(RowType type, in JointFrame f, double nx, double ny, double sign, double error)
    {
        if (type == RowType.Spring)
        {
            AcrossA = -((f.RAX * nx) + (f.RAY * ny));
            AcrossB = (f.RBX * nx) + (f.RBY * ny);
        }

        return Add(
            type,
            -sign * nx,
            -sign * ny,
            -sign * ((f.RAX * ny) - (f.RAY * nx)),
            sign * nx,
            sign * ny,
            sign * ((f.RBX * ny) - (f.RBY * nx)),
            error);
    }

    /// <summary>A motor on the row last added: its bounds in a substep and its speed.</summary>
    public void SetMotor(int row, double speed, double bound)
    {
        Speed[row] = speed;
        Low[row] = -bound;
        High[row] = bound;
    }

    /// <summary>Motor: the share of a correction that is applied. Limit: the slack.</summary>
    public void SetShare(int row, double share) => Share[row] = share;

    /// <summary>What the error of a row is small or large against: a radian, or the joint's length.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly double SizeOf(int row) => Turns(row) ? 1 : Size;

    /// <summary>A row of angles alone.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly bool Turns(int row) => A[row * 3] == 0 && A[(row * 3) + 1] == 0 && B[row * 3] == 0 && B[(row * 3) + 1] == 0;

    /// <summary>Two limits are one, or the two ends of one range.</summary>
    public readonly bool BoundSame(int one, int other)
    {
        bool opposed = true;
        for (int k = 0; k < 3; k++)
        {
            opposed &= A[(one * 3) + k] == -A[(other * 3) + k] && B[(one * 3) + k] == -B[(other * 3) + k];
        }

        return one == other || opposed;
    }

    /// <summary>As if hard rows had no error, and limits were not overrun.</summary>
    public static void ForgetErrors(JointRows* rows)
    {
        for (int k = 0; k < rows->Count; k++)
        {
            rows->Error[k] = rows->Type[k] switch
            {
                (byte)RowType.Hard => 0,
                (byte)RowType.Limit => System.Math.Max(0, rows->Error[k]),
                _ => rows->Error[k],
            };
        }
    }

    public readonly double ErrorOf(int row) => Error[row];

    public void SetSpring(int row, double stiffness, double damping)
    {
        Stiffness[row] = stiffness;
        Damping[row] = damping;
    }
}
