using System.Runtime.InteropServices;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints;

/// <summary>How the hard rows of a joint are solved.</summary>
internal enum JointRole : byte
{
    /// <summary>As a block, by iteration: the joint ties different trees together, or has no hard rows.</summary>
    Iterated,

    /// <summary>Between two bodies of a tree, eliminated.</summary>
    Edge,

    /// <summary>Between a body of a tree and something that cannot move, eliminated.</summary>
    Anchor,

    /// <summary>Between two bodies of a tree that its edges tie already: solved with the tree.</summary>
    Loop,
}

/// <summary>A joint that acts in this step, with what its iterated rows need.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal unsafe struct ActiveJoint
{
    public int Joint;
    public RowEnds Ends;
    public JointRole Role;

    /// <summary>Its hard rows are an edge or an anchor of a tree.</summary>
    public readonly bool IsEliminated => Role == JointRole.Edge || Role == JointRole.Anchor;

    /// <summary>The first of the joints that close the loops of its tree.</summary>
    public bool LeadsLoops;

    public JointKind Kind;
    public JointFlags Flags;
    public JointSettings Settings;

    /// <summary>Its rows are those of a rigid pivot, and no others.</summary>
    public PivotKind Pivot;

    /// <summary>Of a pivot, the arms from the bodies' centres at the poses of its errors.</summary>
    public fixed double ArmA[2];
    public fixed double ArmB[2];

    /// <summary>The iteration has rows of this joint to solve.</summary>
    public bool HasRows;

    /// <summary>Hard rows when the trees were built; -1: not known yet.</summary>
    public int BuiltHard;
    public int BuiltCount;

    /// <summary>It has limits that a tree's block can hold: rigid ones.</summary>
    public bool Limited;

    /// <summary>The block that it belongs to takes its limits when they hold; else they are iterated.</summary>
    public bool BlockLimits;

    /// <summary>A limit alone that makes an edge of a tree, where nothing else ties its bodies together.</summary>
    public bool Ties;

    /// <summary>A limit of it stands aside, see <see cref="Outside"/>.</summary>
    public bool Overrun;
    public int Class;

    /// <summary>While a tree that others push at is solved: 1 + the row of the limit that was let go.</summary>
    public int LetGo;

    /// <summary>Where a limit that holds in the block is to be by the substep's end.</summary>
    public fixed double Goal[JointRows.Most];

    /// <summary>
    /// What of the overrun of a limit came from outside, negative: so far from its place the limit stands meanwhile, and from there its
    /// error counts. And its error before bodies were displaced; then that where the substep left them, before impacts.
    /// </summary>
    public fixed double Outside[JointRows.Most];
    public fixed double Stood[JointRows.Most];

    /// <summary>Inverse of the block's response.</summary>
    public fixed double Block[9];
    public fixed double Lambda[JointRows.Most];

    /// <summary>
    /// What an iterated motor or limit started the substep from; a free tree starts the other half of its forces from it again.
    /// </summary>
    public fixed double Start[JointRows.Most];

    /// <summary>Impulse on body B in the step: linear and about its centre.</summary>
    public fixed double Given[3];

    /// <summary>Its linear part when the substep before began.</summary>
    public fixed double GivenBefore[2];

    /// <summary>The multipliers and that impulse before the position correction.</summary>
    public fixed double PlainLambda[JointRows.Most];
    public fixed double PlainGiven[3];

    /// <summary>
    /// What h·v left of each hard row in the last substep although its target was met, over h²: the bend of the ways that its bodies took.
    /// And that foreseen for the next one.
    /// </summary>
    public fixed double Bend[3];
    public fixed double Foreseen[3];

    /// <summary>Response k of a row.</summary>
    public fixed double Response[JointRows.Most];

    /// <summary>Of a soft point: what one of its rows answers to the other.</summary>
    public double PointCoupling;

    /// <summary>
    /// Spring: Δλ = -(q·v + κ·(φ + c·u) + k·λ)/(k·(1 + q)), the sum of the substep's λ starting from 0; u is the speed before all loads.
    /// </summary>
    public fixed double SpringQ[JointRows.Most];
    public fixed double SpringKappa[JointRows.Most];
    public fixed double SpringLead[JointRows.Most];

    /// <summary>c·u.</summary>
    public fixed double SpringAhead[JointRows.Most];
}
