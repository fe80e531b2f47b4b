using System.Runtime.InteropServices;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>What the sweeps over bounded rows need of the body at one place: see <see cref="Trees.TreeWalk"/>.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct LaneWalk
{
    /// <summary>A velocity change of the parent moves the child by T times it; and the inverse mass within the whole tree.</summary>
    public fixed double T[36];
    public fixed double FullMass[36];
    public fixed double Through[12];
    public fixed double Start[12];
    public fixed double Pending[12];
    public fixed double Seen[12];

    /// <summary>Of the edge.</summary>
    public LaneBends Bends;
}

/// <summary>
/// How the ways of a joint's bodies bent in the last substep, and what is foreseen of it: see <see cref="ActiveJoint.Bend"/>.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct LaneBends
{
    public fixed double Bend[12];
    public fixed double Foreseen[12];
}

/// <summary>A row of a bounded impulse at a joint of a bundle: a motor or a spring.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct LaneSoftRow
{
    public fixed double A[12];
    public fixed double B[12];
    public fixed double Response[4];
    public fixed double Lambda[4];

    /// <summary>The impulse before the pass; and that from which the substep started.</summary>
    public fixed double Before[4];
    public fixed double Start[4];
    public fixed double Speed[4];
    public fixed double Low[4];
    public fixed double High[4];

    /// <summary>
    /// Of a motor; all bits set for the lanes in which its tree leaves it no freedom, and what its bodies alone would answer. Own of a
    /// spring: what its ends answer.
    /// </summary>
    public fixed double Share[4];
    public fixed long Stalled[4];
    public fixed double Own[4];

    /// <summary>Of a spring: frequency and damping ratio, and what follows for a substep.</summary>
    public fixed double Stiffness[4];
    public fixed double Damping[4];
    public fixed double Q[4];
    public fixed double Kappa[4];
    public fixed double Lead[4];
    public fixed double Ahead[4];
}

/// <summary>The rows of one joint, and how its two bodies answer each other.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct LaneSoft
{
    public LaneSoftRow Row0;
    public LaneSoftRow Row1;
    public fixed double Cross[36];

    /// <summary>The mass that springs go by; 0: the one that they feel.</summary>
    public fixed double SpringMass[4];

    /// <summary>See <see cref="JointPass.HoldOf"/> and <see cref="JointPass.EarlyOf"/>.</summary>
    public fixed double Hold[4];
    public fixed double Early[4];
}

/// <summary>What a row is, the same for all four.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal struct LaneSoftKind
{
    /// <summary>Its place among the rows of the joint.</summary>
    public int Index;

    /// <summary>It goes along the joint's line; else it is one of angles.</summary>
    public bool Along;
    public bool IsSpring;
}

/// <summary>Which joint of the tree has the rows, in the order in which they are solved.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct LaneSoftPlace
{
    /// <summary>The child of the edge; of an anchor, the complement of its index.</summary>
    public int Joint;

    /// <summary>Places of the two bodies in the tree; -1: cannot move.</summary>
    public int NodeA;
    public int NodeB;
    public int Rows;
    public LaneSoftKind Kind0;
    public LaneSoftKind Kind1;

    public readonly bool IsSame(in LaneSoftPlace other) => Joint == other.Joint
        && NodeA == other.NodeA
        && NodeB == other.NodeB
        && Rows == other.Rows
        && IsSame(Kind0, other.Kind0)
        && IsSame(Kind1, other.Kind1);

    private static bool IsSame(in LaneSoftKind a, in LaneSoftKind b) =>
        a.Index == b.Index && a.Along == b.Along && a.IsSpring == b.IsSpring;
}
