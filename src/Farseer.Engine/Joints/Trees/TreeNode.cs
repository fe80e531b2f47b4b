using System.Runtime.InteropServices;

namespace Farseer.Engine.Joints.Trees;

/// <summary>
/// A body in the joint solver. Matrices are row by row; those of the edge to the parent have up to three rows. Symbols: S the
/// Jacobians of the edge at child and parent, Y the inverse mass of the body with its subtree, A that within the whole tree.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct TreeNode
{
    public int Body;

    /// <summary>Index of the parent's node; -1 for a root.</summary>
    public int Parent;
    public int Tree;
    public int Depth;

    /// <summary>Joints of the edge to the parent: a range of the list of edge joints.</summary>
    public int EdgeFirst;
    public int EdgeCount;

    /// <summary>Rows of the edge: those that always hold, then the limits that hold now. Of each its joint and its place there.</summary>
    public int Rows;
    public int HardRows;
    public fixed int RowJoint[3];
    public fixed int RowIndex[3];

    /// <summary>A joint of the edge has limits that belong to the block when they hold.</summary>
    public bool HasLimits;

    /// <summary>It has anchors: what it gets is noted for their multipliers.</summary>
    public bool Anchored;

    /// <summary>Iterated rows push at it or at a body of its subtree, or are not known yet: walks come by.</summary>
    public bool Bears;

    /// <summary>0: what lies between fields is not always the same, and this is state.</summary>
    public byte Spare;

    /// <summary>Next node on the way down of a walk.</summary>
    public int Towards;

    /// <summary>Angle by which corrections turned the body in the substep.</summary>
    public double Bent;

    public double X;
    public double Y;
    public double Angle;
    public double Cos;
    public double Sin;

    /// <summary>Of the angle in the middle of the step as foreseen, from which turns count.</summary>
    public double MiddleCos;
    public double MiddleSin;

    /// <summary>Sine and cosine of the turn since then, by which the contacts' arms turn.</summary>
    public double TurnSin;
    public double TurnCos;
    public double InverseMass;
    public double InverseInertia;

    /// <summary>See <see cref="Solving.TreeTension"/>.</summary>
    public double Tension;

    /// <summary>Displacement since the start of the step and turn since its middle; the store's floats are their rounding.</summary>
    public fixed double Move[3];

    /// <summary>
    /// The same at the substep's start, and where h·v took the body, before corrections; then where it stood before a push.
    /// </summary>
    public fixed double StartMove[3];
    public fixed double PlainMove[3];

    /// <summary>The velocity before corrections.</summary>
    public fixed double PlainVelocity[3];

    public fixed double ChildS[9];
    public fixed double ParentS[9];

    /// <summary>E = (S Y Sᵀ)⁻¹ at the child and G = Y Sᵀ E.</summary>
    public fixed double E[9];
    public fixed double G[9];

    /// <summary>W = H S Y of the parent, with H the inverse of both ends' response.</summary>
    public fixed double W[9];

    /// <summary>T = -G S of the parent: a velocity change of the parent moves the child by T times it.</summary>
    public fixed double T[9];
    public fixed double SubtreeMass[9];
    public fixed double FullMass[9];
    public fixed double Target[3];
    public fixed double Velocity[3];

    /// <summary>The velocity put aside while a set of limits is tried, or while the position correction is found.</summary>
    public fixed double Saved[3];

    /// <summary>Impulse that the body got in the pass, for the multipliers of its anchors.</summary>
    public fixed double Got[3];

    /// <summary>Multipliers of the edge in the pass.</summary>
    public fixed double Edge[3];

    /// <summary>In a walk: what was applied to the body and passed up to it, and its velocity at the start.</summary>
    public fixed double Through[3];
    public fixed double Start[3];

    /// <summary>Impulse from the subtree that has not been passed up, and the parent's velocity at the last crossing.</summary>
    public fixed double Pending[3];
    public fixed double Seen[3];
}

/// <summary>A joint of a tree's body with something that cannot move.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct TreeAnchor
{
    public int Active;
    public int Node;

    /// <summary>Rows: those that always hold, then the limits that hold now; their places in the joint.</summary>
    public int Rows;
    public fixed int RowIndex[3];
    public fixed double S[9];

    /// <summary>H S Y, and H.</summary>
    public fixed double Gain[9];
    public fixed double H[9];

    /// <summary>Residual before the anchor was solved, and its multipliers in the pass.</summary>
    public fixed double Residual[3];
    public fixed double Lambda[3];
    public fixed double Target[3];
}
