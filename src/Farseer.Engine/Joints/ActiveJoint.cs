using System.Runtime.InteropServices;

namespace Farseer.Engine.Joints;

/// <summary>How the hard rows of a joint are solved.</summary>
internal enum JointRole : byte
{
    /// <summary>As a block, by iteration: the joint closes a loop or has no hard rows.</summary>
    Iterated,

    /// <summary>Between two bodies of a tree, eliminated.</summary>
    Edge,

    /// <summary>Between a body of a tree and something that cannot move, eliminated.</summary>
    Anchor,
}

/// <summary>A joint that acts in this step, with what its iterated rows need.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct ActiveJoint
{
    public int Joint;
    public int BodyA;
    public int BodyB;

    /// <summary>-1: cannot move.</summary>
    public int NodeA;
    public int NodeB;
    public JointRole Role;

    public JointKind Kind;
    public JointFlags Flags;
    public JointSettings Settings;

    /// <summary>Both nodes are in one tree: moving one moves the other.</summary>
    public bool Coupled;

    /// <summary>The iteration has rows of this joint to solve.</summary>
    public bool HasRows;

    /// <summary>Hard rows when the trees were built.</summary>
    public int BuiltHard;

    /// <summary>Response of body A's velocity to an impulse on B, where coupled.</summary>
    public fixed double Cross[9];

    /// <summary>Inverse of the block's response.</summary>
    public fixed double Block[9];
    public fixed double Lambda[JointRows.Most];

    /// <summary>Impulse on body B in the step: linear and about its centre.</summary>
    public fixed double Given[3];

    /// <summary>Response k of a row.</summary>
    public fixed double Response[JointRows.Most];

    /// <summary>Spring: Δλ = -(q·v + κ·φ + k·λ)/(k·(1 + q)), the sum of the substep's λ starting from 0.</summary>
    public fixed double SpringQ[JointRows.Most];
    public fixed double SpringKappa[JointRows.Most];
}
