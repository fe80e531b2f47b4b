using System.Runtime.InteropServices;

namespace Farseer.Engine.Joints.Lanes;

/// <summary>
/// The body at one place of four trees of equal shape, and the edge to its parent, as in <see cref="Trees.TreeNode"/>: each number four
/// times, one a tree; of vectors and matrices one element after the other. A pointer to it moved on by lanes is one to the later lanes. It
/// must not be 4,096 bytes long, or all want the same places of the cache: the passes took half as long again.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct LaneNode
{
    public fixed double Velocity[12];

    /// <summary>The velocity before the pass, and the one before corrections.</summary>
    public fixed double Saved[12];
    public fixed double PlainVelocity[12];

    public fixed double Move[12];
    public fixed double StartMove[12];
    public fixed double PlainMove[12];
    public fixed double Bent[4];

    public fixed double InverseMass[4];
    public fixed double InverseInertia[4];

    /// <summary>
    /// The pose at the start of the step, its angle with the lead, and sine and cosine of the angle in the step's middle.
    /// </summary>
    public fixed double StartX[4];
    public fixed double StartY[4];
    public fixed double StartAngle[4];
    public fixed double Lead[4];
    public fixed double MiddleSin[4];
    public fixed double MiddleCos[4];
    public fixed double TurnSin[4];
    public fixed double TurnCos[4];

    public fixed double X[4];
    public fixed double Y[4];
    public fixed double Angle[4];
    public fixed double Cos[4];
    public fixed double Sin[4];
    public fixed double SubtreeMass[36];

    /// <summary>Impulse that the body got in the pass, if it has anchors.</summary>
    public fixed double Got[12];

    public LaneJoint Joint;
    public fixed double ParentS[36];
    public fixed double G[36];
    public fixed double W[36];
}

/// <summary>A joint of a bundle: the edge of a node, or an anchor.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct LaneJoint
{
    /// <summary>Anchors in the frames of bodies A and B.</summary>
    public fixed double AnchorA[8];
    public fixed double AnchorB[8];

    /// <summary>The angle or length that the kind has for its origin, and the limits.</summary>
    public fixed double Target[4];
    public fixed double Lower[4];
    public fixed double Upper[4];

    /// <summary>The axis in the frame of A; of gears and transmissions first the ratio; of a servo first its speed.</summary>
    public fixed double Axis[8];

    /// <summary>Arms at the present poses, how far the anchors are apart, and the unit vector of the row that has one.</summary>
    public fixed double ArmA[8];
    public fixed double ArmB[8];
    public fixed double Apart[8];
    public fixed double Way[8];
    public fixed double Error[12];

    /// <summary>The turn or the way along the line, which limits bound and springs pull at.</summary>
    public fixed double Travel[4];

    /// <summary>
    /// By how much a limit may be overrun, and what is left to the lower limit and to the upper, now and at the start of the substep.
    /// </summary>
    public fixed double Slop[4];
    public fixed double Gap[8];
    public fixed double StartGap[8];

    /// <summary>The rows' own: a length against which errors are small, at the poses of the rows.</summary>
    public fixed double Size[4];

    /// <summary>
    /// Jacobian at the child of an edge, or at the body of an anchor: the rows that always hold, then that of a limit that holds.
    /// </summary>
    public fixed double S[36];

    /// <summary>Of a joint with a line: the Jacobian along it, at bodies A and B. Of a transmission first the lines of the world.</summary>
    public fixed double LineA[12];
    public fixed double LineB[12];

    /// <summary>All bits set for the lanes in which a limit holds, and for those in which it is the upper one.</summary>
    public fixed long Held[4];
    public fixed long HeldAbove[4];

    /// <summary>
    /// What the limit that holds gave in the substep, in all and before corrections; and where it is to be by the substep's end.
    /// </summary>
    public fixed double Push[4];
    public fixed double PlainPush[4];
    public fixed double Stop[4];

    /// <summary>E of an edge, H of an anchor.</summary>
    public fixed double E[36];
    public fixed double Goal[12];
    public fixed double Lambda[12];

    /// <summary>
    /// What it gave to its body B; then what a second joint between the same bodies did, which only turns. And the same before corrections.
    /// </summary>
    public fixed double Given[16];
    public fixed double PlainGiven[16];

    /// <summary>The same along x and y when the substep before began.</summary>
    public fixed double GivenBefore[8];

    /// <summary>The speed of a second joint that is a servo.</summary>
    public fixed double SecondSpeed[4];
}

/// <summary>A joint between the bodies at one place and something that cannot move, as in <see cref="Trees.TreeAnchor"/>.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct LaneAnchor
{
    public LaneJoint Joint;

    /// <summary>The pose and velocity of what cannot move, and the Jacobian there.</summary>
    public fixed double X[4];
    public fixed double Y[4];
    public fixed double Angle[4];
    public fixed double Cos[4];
    public fixed double Sin[4];
    public fixed double Still[12];
    public fixed double OtherS[36];
    public fixed double Gain[36];
    public fixed double Residual[12];
    public LaneBends Bends;
}

/// <summary>What is the same for all four: a node's place in the tree, or an anchor's; and which bodies and joints they are.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal unsafe struct LanePlace
{
    /// <summary>Place of the parent in the tree, -1: the root; of an anchor that of its body.</summary>
    public int Parent;

    /// <summary>The child, or the anchored body, is body A of the joint.</summary>
    public bool IsA;

    /// <summary>What the joint is, and how many of its rows always hold.</summary>
    public LaneForm Form;
    public byte Rows;

    /// <summary>Of an edge: a second joint between the same bodies, a servo or a range of turns; the child is its body A.</summary>
    public LaneForm Second;
    public bool SecondIsA;

    /// <summary>Rows that always hold, of both joints, and how many the block has with a limit that holds in any lane.</summary>
    public byte HardRows;
    public byte BlockRows;

    /// <summary>A bit for each lane in which a limit holds.</summary>
    public byte Held;

    /// <summary>While trees that contacts push at are solved: a bit for each lane in which the end of the range was let go.</summary>
    public byte LetGoBelow;
    public byte LetGoAbove;

    /// <summary>A bit for each row of angles, which a radian is the measure of; the others are of lengths.</summary>
    public byte Turning;

    /// <summary>
    /// There are limits, of the first joint or of a second one: they bound a turn, and the child is body A of their joint.
    /// </summary>
    public bool HasLimits;
    public bool LimitTurns;
    public bool LimitIsA;

    /// <summary>The joint has limits, motors or springs.</summary>
    public bool HasMore;

    /// <summary>
    /// Among the rows of their joint the lower limit and the upper one, and of the first joint's the first along its line; -1: none.
    /// </summary>
    public sbyte LowerRow;
    public sbyte UpperRow;
    public sbyte LineRow;

    /// <summary>The body has anchors.</summary>
    public bool Anchored;

    /// <summary>Of each lane: the body, or what cannot move, and the active joint.</summary>
    public fixed int Body[4];
    public fixed int Active[4];

    /// <summary>The second joint.</summary>
    public fixed int ActiveSecond[4];

    /// <summary>The joint that has the limits.</summary>
    public readonly int Limited(int lane) => Second == LaneForm.Range ? ActiveSecond[lane] : Active[lane];
}

/// <summary>Up to four trees of equal shape side by side.</summary>
[StructLayout(LayoutKind.Sequential, Pack = 1)]
internal unsafe struct LaneTrees
{
    public ulong Shape;
    public int Count;
    public fixed int Tree[4];

    /// <summary>The lanes that are still solved here; a tree that needs more is given back.</summary>
    public int Live;

    /// <summary>Ranges of nodes and of anchors.</summary>
    public int First;
    public int Nodes;
    public int AnchorFirst;
    public int Anchors;
    public bool HasLimits;

    /// <summary>They have contacts, which are swept one by one; and a bit for each lane in which they are swept next.</summary>
    public bool Touched;
    public int Acting;

    /// <summary>Range of the joints with motors and springs; and the lanes with a spring that its tree leaves no freedom.</summary>
    public int SoftFirst;
    public int Softs;
    public int Stalled;

    /// <summary>All bits set for the lanes that take part in a round of the correction, and for those in which a sweep is made.</summary>
    public fixed long Corrects[4];
    public fixed long Sweeps[4];
    public fixed double Worst[4];
    public fixed double Before[4];
    public fixed double Bent[4];
    public fixed bool Astray[4];

    /// <summary>Something besides the joints' own rows and the limits that they hold is swept over.</summary>
    public readonly bool HasRows => Softs > 0 || Touched;

    /// <summary>Motors and springs are swept here, and not with contacts.</summary>
    public readonly bool SweepsSofts => Softs > 0 && !Touched;
}
