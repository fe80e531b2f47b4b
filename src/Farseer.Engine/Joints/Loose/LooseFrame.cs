using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Joints.Loose;

/// <summary>The two poses of a bundle's joints, arms and distances: <see cref="JointFrame"/> for lanes.</summary>
internal unsafe struct LooseFrame
{
    public WideDouble AX;
    public WideDouble AY;
    public WideDouble AAngle;
    public WideDouble BX;
    public WideDouble BY;
    public WideDouble BAngle;
    public WideDouble RAX;
    public WideDouble RAY;
    public WideDouble RBX;
    public WideDouble RBY;
    public WideDouble DX;
    public WideDouble DY;

    /// <summary>Collects the poses of the lanes' bodies.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set(LooseBundle* bundle, LooseBody* bodies, int* a, int* b)
    {
        AX = LooseKernel.Gather(bodies, LooseBody.PoseAt, a);
        AY = LooseKernel.Gather(bodies, LooseBody.PoseAt + 1, a);
        AAngle = LooseKernel.Gather(bodies, LooseBody.PoseAt + 2, a);
        BX = LooseKernel.Gather(bodies, LooseBody.PoseAt, b);
        BY = LooseKernel.Gather(bodies, LooseBody.PoseAt + 1, b);
        BAngle = LooseKernel.Gather(bodies, LooseBody.PoseAt + 2, b);
        WideDouble cos = LooseKernel.Gather(bodies, LooseBody.PoseAt + 3, a);
        WideDouble sin = LooseKernel.Gather(bodies, LooseBody.PoseAt + 4, a);
        Turn(bundle->AnchorA, cos, sin, out RAX, out RAY);
        cos = LooseKernel.Gather(bodies, LooseBody.PoseAt + 3, b);
        sin = LooseKernel.Gather(bodies, LooseBody.PoseAt + 4, b);
        Turn(bundle->AnchorB, cos, sin, out RBX, out RBY);
        DX = (BX - AX) + (RBX - RAX);
        DY = (BY - AY) + (RBY - RAY);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Turn(double* anchor, WideDouble cos, WideDouble sin, out WideDouble x, out WideDouble y)
    {
        WideDouble ax = WideDouble.Load(anchor);
        WideDouble ay = WideDouble.Load(anchor + 4);
        x = (cos * ax) - (sin * ay);
        y = (sin * ax) + (cos * ay);
    }
}
