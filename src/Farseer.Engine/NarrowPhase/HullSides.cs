using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.NarrowPhase;

/// <summary>What the kernels of hulls and circles read of the sides of their pairs, for as many lanes as these have.</summary>
internal static unsafe class HullSides
{
    /// <summary>As <see cref="HullLanes.Name"/>.</summary>
    /// <param name="hulls">The lanes to name.</param>
    /// <param name="lanes">Those that have a hull, a bit each.</param>
    /// <param name="pieces">The piece of each lane.</param>
    /// <param name="packed">By piece, what <see cref="HullLanes.Pack"/> told.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Name(HullLanes* hulls, int lanes, int* pieces, int* packed)
    {
        for (int lane = 0; lane < WideLanes.BundleLanes; lane += HullLanes.Lanes)
        {
            HullLanes.Name(HullLanes.At(hulls, lane), lanes >> lane, pieces + lane, packed);
        }
    }

    /// <summary>Reads the corners of all lanes from the pools and returns how many the largest hull has.</summary>
    public static int Gather(HullLanes* hulls, Vector2* vertices, Vector2* normals)
    {
        int most = 0;
        for (int lane = 0; lane < WideLanes.BundleLanes; lane++)
        {
            most = hulls->Last[lane] > most ? hulls->Last[lane] : most;
        }

        for (int lane = 0; lane < WideLanes.BundleLanes; lane += HullLanes.Lanes)
        {
            HullLanes.Gather(HullLanes.At(hulls, lane), most, vertices, normals);
        }

        return most + 1;
    }

    /// <summary>Rounding radii: a box has none, and its half sides where others have theirs.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Radius(SideLanes* side, int lane)
    {
        WideMask box = WideLanes.Has(Wide.Load((float*)side->Flags + lane), (int)SideFlags.Box);
        return Wide.Select(box, Wide.Zero, Wide.Load(side->HalfX + lane));
    }
}
