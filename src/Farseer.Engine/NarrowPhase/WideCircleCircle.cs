using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.NarrowPhase;

/// <summary><see cref="CirclePairs.CircleCircle"/> on lanes, with the same bits.</summary>
internal static unsafe class WideCircleCircle
{
    /// <summary>Writes the manifolds of the lanes whose sides are both circles and leaves the others alone.</summary>
    [MethodImpl(KernelMethod.Optimized)]
    public static void Collide(PairLanes* pairs)
    {
        for (int lane = 0; lane < WideLanes.BundleLanes; lane += Wide.Count)
        {
            WideMask circles = WideLanes.Has(
                Wide.Load((float*)pairs->A.Flags + lane) & Wide.Load((float*)pairs->B.Flags + lane), (int)SideFlags.Circle);
            Wide ax = Wide.Load(pairs->A.X + lane);
            Wide ay = Wide.Load(pairs->A.Y + lane);
            Wide x = (Wide.Load(pairs->B.X + lane) + Wide.Load(pairs->OffsetX + lane)) - ax;
            Wide y = (Wide.Load(pairs->B.Y + lane) + Wide.Load(pairs->OffsetY + lane)) - ay;
            Wide radius = Wide.Load(pairs->A.HalfX + lane);
            Wide sum = radius + Wide.Load(pairs->B.HalfX + lane);
            Wide distance = Wide.Sqrt((x * x) + (y * y));
            Wide separation = distance - sum;
            WideMask near = separation <= Wide.Load(pairs->Margin + lane);
            WideMask apart = distance > Wide.Splat(CirclePairs.ShortestArm) * sum;
            Wide nx = Wide.Select(apart, x / distance, Wide.Zero);
            Wide ny = Wide.Select(apart, y / distance, Wide.One);
            Wide reach = radius + (Wide.Splat(0.5f) * separation);
            WideLanes.Replace(circles, Wide.Keep(near, Wide.One), pairs->Count + lane);
            WideLanes.Replace(circles, nx, pairs->NormalX + lane);
            WideLanes.Replace(circles, ny, pairs->NormalY + lane);
            WideLanes.Replace(circles, ax + (nx * reach), pairs->Point0.X + lane);
            WideLanes.Replace(circles, ay + (ny * reach), pairs->Point0.Y + lane);
            WideLanes.Replace(circles, separation, pairs->Point0.Separation + lane);
            WideLanes.Replace(circles, separation, pairs->Gap + lane);
            WideLanes.Replace(circles, Wide.Zero, pairs->GapOwner + lane);
            WideLanes.Replace(circles, Wide.FromBits((int)CirclePairs.Id), (float*)pairs->Point0.Id + lane);
        }
    }
}
