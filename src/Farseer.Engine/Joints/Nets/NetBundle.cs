using System.Runtime.InteropServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Nets;

/// <summary>
/// Eight pivots of a net, a lane each, of one colour. φ = anchor B - anchor A, dφ/dt = vB + ωB×rB - vA - ωA×rA and, with the sum m of
/// both inverse masses and jA, jB the inverse inertias over m, the response is m·Q with
/// <code>
/// Q = 1 + jA·pA pAᵀ + jB·pB pBᵀ,  p = (-r.y, r.x),  det Q = 1 + jA·rA² + jB·rB² + jA·jB·(rA×rB)²
/// </code>
/// which is at least 1 and loses nothing by cancellation. Impulses are kept as m times themselves, speeds: so all that the passes
/// compute with is of the order of speeds and lengths, however light or heavy the bodies. Arms and error are those at the start of
/// the substep, turned from the foreseen middle of the step; the error counts what changed since, so it keeps all its digits.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct NetBundle
{
    public const int Lanes = WideLanes.BundleLanes;

    public fixed int BodyA[Lanes];
    public fixed int BodyB[Lanes];

    /// <summary>Shares of an impulse's speed that the bodies take, inverse mass over m, and jA, jB.</summary>
    public fixed float ShareA[Lanes];
    public fixed float ShareB[Lanes];
    public fixed float TurnA[Lanes];
    public fixed float TurnB[Lanes];

    /// <summary>m times the impulse of the present substep.</summary>
    public fixed float ImpulseX[Lanes];
    public fixed float ImpulseY[Lanes];

    /// <summary>Arms and error in the present substep.</summary>
    public fixed float ArmAX[Lanes];
    public fixed float ArmAY[Lanes];
    public fixed float ArmBX[Lanes];
    public fixed float ArmBY[Lanes];
    public fixed float ErrorX[Lanes];
    public fixed float ErrorY[Lanes];

    /// <summary>Arms where the bodies are foreseen to be in the middle of the step, and the error if both had only turned there.</summary>
    public fixed float MiddleAX[Lanes];
    public fixed float MiddleAY[Lanes];
    public fixed float MiddleBX[Lanes];
    public fixed float MiddleBY[Lanes];
    public fixed float BaseX[Lanes];
    public fixed float BaseY[Lanes];

    /// <summary>Sum of the impulses of the substeps that have ended.</summary>
    public fixed float SumX[Lanes];
    public fixed float SumY[Lanes];

    /// <summary>Error at the start of the step.</summary>
    public fixed float StartX[Lanes];
    public fixed float StartY[Lanes];

    /// <summary>m; 0 where neither body can be moved.</summary>
    public fixed float Response[Lanes];

    /// <summary>Index of the joint; -1 in an empty lane.</summary>
    public fixed int Joint[Lanes];
}

/// <summary>The anchors of a pivot in the frames of its bodies.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct NetAnchors
{
    public double AX;
    public double AY;
    public double BX;
    public double BY;
}
