namespace Farseer.Engine.Joints.Chains;

/// <summary>
/// The numbers of a chain, each kind a column: of bodies along the chain, or of joints. Joint i is between body i, its low one, and body
/// i + 1, its high one; the last may hold on to something that cannot move, which then stands behind the last body, with no inverse mass.
/// Vectors and matrices are columns that follow each other.
/// </summary>
internal enum ChainColumn
{
    Velocity = 0,

    /// <summary>The velocity at the start of the substep, and before corrections.</summary>
    StartVelocity = 3,
    PlainVelocity = 6,

    /// <summary>
    /// Displacement since the start of the step and turn since its middle; at the substep's start; and before corrections.
    /// </summary>
    Move = 9,
    StartMove = 12,
    PlainMove = 15,

    /// <summary>Angle by which corrections turned the body in the substep.</summary>
    Bent = 18,

    InverseMass = 19,
    InverseInertia = 20,

    /// <summary>What drag leaves of linear and angular velocity in a substep, and what gravity, force and torque add.</summary>
    LinearKeep = 21,
    AngularKeep = 22,
    Drive = 23,

    /// <summary>The place at the start of the step, and sine and cosine of the angle in its middle and of the turn since.</summary>
    Place = 26,
    MiddleSin = 28,
    MiddleCos = 29,
    TurnSin = 30,
    TurnCos = 31,

    /// <summary>The present pose.</summary>
    X = 32,
    Y = 33,
    Sin = 34,
    Cos = 35,

    /// <summary>Anchors in the frames of the low and the high body.</summary>
    LowAnchor = 36,
    HighAnchor = 38,

    /// <summary>Arms to the anchors, low and high, by turns of the rows and of the poses since.</summary>
    Arms = 40,
    OtherArms = 44,

    /// <summary>High anchor less low anchor.</summary>
    Error = 48,

    /// <summary>The joint's length, against which errors are small, and one over it.</summary>
    Size = 50,
    PerSize = 51,

    /// <summary>What the rows lack, what is left of it half way through, and the impulses on the high bodies.</summary>
    Residual = 52,
    Half = 54,
    Lambda = 56,

    /// <summary>Their sums in the step, and those of their moments about the low and the high body; the same before corrections.</summary>
    Given = 58,
    PlainGiven = 62,

    /// <summary>The response of a joint to its own impulses, and to those of the joint before: see <see cref="ChainFactor"/>.</summary>
    Own = 66,
    Cross = 69,
    Inverse = 73,
    Gain = 76,

    /// <summary>All bits set where a joint is.</summary>
    Exists = 80,

    /// <summary>Of a chain that contacts press on: the impulses of these in the pass, and their moments.</summary>
    Push = 81,

    /// <summary>
    /// What h·v left of each row in the last substep, over h², and what is foreseen for the next: see <see cref="ActiveJoint.Bend"/>.
    /// </summary>
    Bend = 84,
    Foreseen = 86,
    Count = 88,
}

/// <summary>
/// One chain as the kernels see it. Columns begin 32 bytes apart from each other's ends, so that what is before the first and behind the
/// last of each is there, and 0.
/// </summary>
internal unsafe struct ChainView
{
    /// <summary>Room before and between columns.</summary>
    public const int Margin = 4;

    public double* First;
    public int Stride;

    /// <summary>Number of bodies, without what cannot move.</summary>
    public int Bodies;
    public int Joints;

    /// <summary>The joint at which the eliminations from both ends meet.</summary>
    public int Middle;

    /// <summary>Contacts press on it, between its bodies <see cref="Low"/> and <see cref="High"/>.</summary>
    public bool IsPressed;
    public int Low;
    public int High;

    /// <summary>The arms by which impulses act: those of the poses at which the chain was factored; and those of the poses since.</summary>
    public ChainColumn Arms;
    public ChainColumn NewArms;

    /// <summary>The joints at the bodies between <see cref="Low"/> and <see cref="High"/>, first and last.</summary>
    public readonly int FirstWithin => Low > 0 ? Low - 1 : 0;
    public readonly int LastWithin => High < Joints ? High : Joints - 1;

    /// <summary>A column.</summary>
    public readonly double* this[ChainColumn column] => First + ((int)column * Stride);
}
