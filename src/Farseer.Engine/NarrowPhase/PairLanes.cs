using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Farseer.Engine.Numerics;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif

namespace Farseer.Engine.NarrowPhase;

/// <summary>What a side of a pair is and may do.</summary>
[System.Flags]
internal enum SideFlags : int
{
    None = 0,

    /// <summary>Not set in the side that empty lanes point at.</summary>
    Exists = 1,

    /// <summary>The collider takes part in the response.</summary>
    Responds = 2,

    /// <summary>The solver may move the body.</summary>
    Moves = 4,

    /// <summary>Gravity acts on the body.</summary>
    Pulled = 8,

    /// <summary>A listener wants to hear of the collider.</summary>
    Heard = 16,

    /// <summary>A box that the box kernel can do.</summary>
    Box = 32,

    /// <summary>A circle.</summary>
    Circle = 64,

    /// <summary>The fat box is new in this step.</summary>
    NewBox = 128,

    /// <summary>The body turns with its spin; a static one with a spin only drags along what it touches.</summary>
    Turns = 256,

    /// <summary>The body is foreseen to move by more than its own size in this step.</summary>
    Fast = 512,

    /// <summary>A hull without seams, of two to <see cref="HullLanes.MostCorners"/> corners: the kernels of hulls can do it.</summary>
    Hull = 1024,

    /// <summary>A box whose own axes are not those of its body.</summary>
    Tilted = 2048,
}

/// <summary>One side of each pair of a bundle: shape, motion and material, as the record it was gathered from has them.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct SideLanes
{
    public const int Lanes = WideLanes.BundleLanes;

    /// <summary>Centre of a box or circle from its body's, in world axes.</summary>
    public fixed float X[Lanes];
    public fixed float Y[Lanes];

    /// <summary>Direction of a box's own x axis in world axes; of other pieces that of their body.</summary>
    public fixed float Cos[Lanes];
    public fixed float Sin[Lanes];

    /// <summary>Half sides of a box; of other pieces the first is the rounding radius (of a circle all there is).</summary>
    public fixed float HalfX[Lanes];
    public fixed float HalfY[Lanes];
    public fixed float Extent[Lanes];
    public fixed float Reach[Lanes];

    public fixed float VelocityX[Lanes];
    public fixed float VelocityY[Lanes];
    public fixed float AngularVelocity[Lanes];

    /// <summary><see cref="SideFlags"/>.</summary>
    public fixed int Flags[Lanes];

    public fixed float InverseMass[Lanes];
    public fixed float InverseInertia[Lanes];
    public fixed float Friction[Lanes];
    public fixed float Restitution[Lanes];

    /// <summary>Rounding radii: a box has none, and its half sides where others have theirs.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Wide Radius(SideLanes* side, int lane)
    {
        WideMask box = WideLanes.Has(Wide.Load((float*)side->Flags + lane), (int)SideFlags.Box);
        return Wide.Select(box, Wide.Zero, Wide.Load(side->HalfX + lane));
    }
}

/// <summary>One point of each pair's manifold, as <see cref="ManifoldPoint"/>, and its arms in the contact frame.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct PointLanes
{
    public const int Lanes = WideLanes.BundleLanes;

    public fixed float X[Lanes];
    public fixed float Y[Lanes];
    public fixed float Separation[Lanes];
    public fixed uint Id[Lanes];

    /// <summary>-1: a corner of A, which goes along with A while B passes by; 1: a corner of B; 0: not known.</summary>
    public fixed float Owner[Lanes];

    /// <summary>Arms an = r·n and at = r×n from the centres of both bodies.</summary>
    public fixed float NormalArmA[Lanes];
    public fixed float TangentArmA[Lanes];
    public fixed float NormalArmB[Lanes];
    public fixed float TangentArmB[Lanes];
}

/// <summary>
/// Eight pairs side by side on their way through the narrow phase: each stage reads what it needs at the point of use and
/// writes its result, so no stage holds more than a few vectors. It stays in the first-level cache.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct PairLanes
{
    public const int Lanes = WideLanes.BundleLanes;

    /// <summary>The gap of a pair of which none was found.</summary>
    public const float UnknownGap = float.MinValue;

    public SideLanes A;
    public SideLanes B;

    /// <summary>Centre of body B minus centre of body A.</summary>
    public fixed float OffsetX[Lanes];
    public fixed float OffsetY[Lanes];

    /// <summary>Points farther apart than this are left out.</summary>
    public fixed float Margin[Lanes];

    public fixed float NormalX[Lanes];
    public fixed float NormalY[Lanes];

    /// <summary>-1: the normal is that of a face of A and turns with it; 1: that of a face of B; 0: not known.</summary>
    public fixed float NormalOwner[Lanes];

    /// <summary>0, 1 or 2 points.</summary>
    public fixed float Count[Lanes];

    /// <summary>Separation along the axis that separates the pieces, or a number that says nothing; what counts is what is more than the margin.</summary>
    public fixed float Gap[Lanes];

    /// <summary>-1: that axis turns with A; 1: with B; 0: it leads from one centre to the other.</summary>
    public fixed float GapOwner[Lanes];

    public PointLanes Point0;
    public PointLanes Point1;

    /// <summary>How deep the pair would be at the end of the step with the velocities of its start; known of those that touch.</summary>
    public fixed float Sinking[Lanes];

    /// <summary>Corners of the pieces, gathered only for pairs that need them.</summary>
    public HullPairLanes Hulls;

    public static void Write(PairLanes* pairs, int lane, in Manifold manifold)
    {
        pairs->NormalX[lane] = manifold.Normal.X;
        pairs->NormalY[lane] = manifold.Normal.Y;
        pairs->Count[lane] = manifold.Count;
        pairs->Gap[lane] = UnknownGap;
        Write(&pairs->Point0, lane, manifold.Point0);
        Write(&pairs->Point1, lane, manifold.Point1);
    }

    public static Manifold Read(PairLanes* pairs, int lane)
    {
        Manifold manifold = default;
        manifold.Count = (int)pairs->Count[lane];
        if (manifold.Count > 0)
        {
            manifold.Normal = new System.Numerics.Vector2(pairs->NormalX[lane], pairs->NormalY[lane]);
            manifold.Point0 = Read(&pairs->Point0, lane);
        }

        if (manifold.Count > 1)
        {
            manifold.Point1 = Read(&pairs->Point1, lane);
        }

        return manifold;
    }

    private static void Write(PointLanes* points, int lane, in ManifoldPoint point)
    {
        points->X[lane] = point.Anchor.X;
        points->Y[lane] = point.Anchor.Y;
        points->Separation[lane] = point.Separation;
        points->Id[lane] = point.Id;
    }

    private static ManifoldPoint Read(PointLanes* points, int lane)
    {
        ManifoldPoint point;
        point.Anchor = new System.Numerics.Vector2(points->X[lane], points->Y[lane]);
        point.Separation = points->Separation[lane];
        point.Id = points->Id[lane];
        return point;
    }
}
