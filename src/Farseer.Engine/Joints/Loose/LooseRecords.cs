using System.Runtime.InteropServices;
using Farseer.Engine.Joints.Lanes;

namespace Farseer.Engine.Joints.Loose;

/// <summary>A body of loose joints, or what they hang on: what <see cref="Trees.TreeNode"/> has of a tree of one body.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal unsafe struct LooseBody
{
    /// <summary>Where the pose begins, in doubles.</summary>
    public const int PoseAt = 4;

    public fixed double Velocity[4];

    /// <summary>x, y, angle, and its cosine and sine.</summary>
    public fixed double Pose[5];
    public double InverseMass;
    public double InverseInertia;

    /// <summary>Displacement since the start of the step and turn since its middle.</summary>
    public fixed double Move[3];
    public double StartX;
    public double StartY;
    public double StartAngle;
    public double Lead;
    public double MiddleSin;
    public double MiddleCos;
    public double TurnSin;
    public double TurnCos;

    public int Body;

    /// <summary>Its node; -1: it cannot move.</summary>
    public int Node;

    /// <summary>See <see cref="Trees.JointTree"/>: half of the forces come after the move; only the joints move it.</summary>
    public bool Free;
    public bool Exact;

    /// <summary>A joint that is not of limits alone holds it.</summary>
    public bool Held;
}

/// <summary>A row of four joints side by side.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct LooseRow
{
    public LaneSoftRow Soft;
    public fixed double Error[4];

    /// <summary>Of a spring: the share by which its frequency was taken last.</summary>
    public fixed double SpringShare[4];
}

/// <summary>Four joints of one kind and of the same rows, between bodies of which no two joints share one that moves.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct LooseBundle
{
    public fixed double AnchorA[8];
    public fixed double AnchorB[8];
    public fixed double Target[4];
    public fixed double Lower[4];
    public fixed double Upper[4];
    public fixed double Ratio[4];
    public fixed double GroundA[8];
    public fixed double GroundB[8];
    public fixed double MassA[4];
    public fixed double InertiaA[4];
    public fixed double MassB[4];
    public fixed double InertiaB[4];
    public fixed double SpringMass[4];

    /// <summary>See <see cref="JointPass.HoldOf"/> and <see cref="JointPass.EarlyOf"/>.</summary>
    public fixed double Hold[4];
    public fixed double Early[4];

    /// <summary>Of soft points: what one of the two rows answers to the other.</summary>
    public fixed double PointCoupling[4];
    public fixed double ArmB[8];
    public fixed double Given[12];
}

/// <summary>What the four joints are, and whose.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal unsafe struct LoosePlace
{
    public JointKind Kind;
    public int FirstRow;
    public int Rows;
    public int Count;
    public fixed byte Type[JointRows.Most];

    /// <summary>All rows are limits.</summary>
    public bool OnlyLimits;

    /// <summary>The first two rows are motors that hold two points together.</summary>
    public bool SoftPoint;

    public fixed int Active[4];

    /// <summary>
    /// Bodies that are read, and those that are written: what cannot move, and what an empty lane moves, goes to a place that nobody reads.
    /// </summary>
    public fixed int BodyA[4];
    public fixed int BodyB[4];
    public fixed int IntoA[4];
    public fixed int IntoB[4];
}
