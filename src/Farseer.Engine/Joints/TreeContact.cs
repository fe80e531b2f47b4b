using System.Runtime.InteropServices;
using Farseer.Engine.Contacts;
using Farseer.Engine.Joints.Trees;

namespace Farseer.Engine.Joints;

/// <summary>One point of a contact with a tree; the symbols are those of <see cref="ContactBundle"/>.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct TreeContactPoint
{
    public double NormalArmA;
    public double TangentArmA;
    public double NormalArmB;
    public double TangentArmB;
    public double Base;

    /// <summary>The depth at which the surfaces rest.</summary>
    public double Rest;
    public double Normal;
    public double Tangent;
    public double PreviousNormal;
    public double PreviousTangent;
    public double Feed;

    /// <summary>Speed at which the surfaces are to part after an impact; negative: none.</summary>
    public double Bounce;

    /// <summary>How fast the surfaces part before the impact.</summary>
    public double Parted;

    /// <summary>Overlap at the start of the substep, as a gap of at most 0.</summary>
    public double Level;

    /// <summary>The normal impulse before the position correction.</summary>
    public double Plain;

    /// <summary>The normal impulse that the last sweep began with, and the conjugate direction in which sweeps go on.</summary>
    public double SweptFrom;
    public double Direction;

    /// <summary>At the present poses: separation, arms of the normal and of the tangent row, response of the tangent row.</summary>
    public double Separation;
    public double NormalA;
    public double NormalB;
    public double RubA;
    public double RubB;
    public double RubResponse;

    /// <summary>1; less, down to 0, where no turn within reach undoes the overlap.</summary>
    public double Reach;
}

/// <summary>
/// A contact that touches a tree, taken out of its lane for the step: it is solved against the tree's inverse mass. With the
/// body's own mass a contact sees a light link, hands over too little, and the solution of the tree takes it back.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct TreeContact
{
    public RowEnds Ends;
    public ContactBundle* Bundle;
    public int Lane;
    public int Class;

    /// <summary>0, 1 or 2.</summary>
    public int Points;
    public bool Deep;

    /// <summary>About to bounce, and out of the passes of the substep; its impact is being solved; it had one in this substep.</summary>
    public bool Held;
    public bool Hit;
    public bool Impact;

    /// <summary>
    /// How long ago the surfaces met, before the end of the substep; their acceleration; approach slower than this is rest.
    /// </summary>
    public double Since;
    public double Acceleration;
    public double Slow;

    /// <summary>Impulse of the last bounce in the step, both points together; 0: none.</summary>
    public double Struck;
    public double NormalX;
    public double NormalY;
    public double Friction;
    public double RadiusA;
    public double RadiusB;
    public double FeedRate;
    public double FeedShare;
    public double Restitution;

    public TreeContactPoint Point0;
    public TreeContactPoint Point1;

    /// <summary>
    /// Normal responses and their coupling; 1/(k11·k22 - k12²), or 0: solve row by row. The coupling of the tangent rows.
    /// </summary>
    public double K11;
    public double K22;
    public double K12;
    public double InverseDeterminant;
    public double RubCoupling;
}
