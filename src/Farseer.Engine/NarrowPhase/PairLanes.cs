using System.Numerics;
using System.Runtime.InteropServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.NarrowPhase;

/// <summary>One side of each pair of a bundle: shape, motion and material, as the record it was gathered from has them.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct SideLanes
{
    private const int LineLanes = PairLanes.LineLanes;

    /// <summary>Centre of a box or circle from its body's, in world axes.</summary>
    public fixed float X[LineLanes];
    public fixed float Y[LineLanes];

    /// <summary>Direction of a box's own x axis in world axes; of other pieces that of their body.</summary>
    public fixed float Cos[LineLanes];
    public fixed float Sin[LineLanes];

    /// <summary>Half sides of a box; of other pieces the first is the rounding radius (of a circle all there is).</summary>
    public fixed float HalfX[LineLanes];
    public fixed float HalfY[LineLanes];
    public fixed float Extent[LineLanes];
    public fixed float Reach[LineLanes];

    public fixed float VelocityX[LineLanes];
    public fixed float VelocityY[LineLanes];
    public fixed float AngularVelocity[LineLanes];

    /// <summary><see cref="SideFlags"/>.</summary>
    public fixed int Flags[LineLanes];

    public fixed float InverseMass[LineLanes];
    public fixed float InverseInertia[LineLanes];
    public fixed float Friction[LineLanes];
    public fixed float Restitution[LineLanes];
}

/// <summary>One point of each pair's manifold, as <see cref="ManifoldPoint"/>, and its arms in the contact frame.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct PointLanes
{
    private const int LineLanes = PairLanes.LineLanes;

    public fixed float X[LineLanes];
    public fixed float Y[LineLanes];
    public fixed float Separation[LineLanes];
    public fixed uint Id[LineLanes];

    /// <summary>-1: a corner of A, which goes along with A while B passes by; 1: a corner of B; 0: not known.</summary>
    public fixed float Owner[LineLanes];

    /// <summary>Arms an = r·n and at = r×n from the centres of both bodies.</summary>
    public fixed float NormalArmA[LineLanes];
    public fixed float TangentArmA[LineLanes];
    public fixed float NormalArmB[LineLanes];
    public fixed float TangentArmB[LineLanes];
}

/// <summary>
/// Pairs side by side on their way through the narrow phase: each stage reads what it needs at the point of use and writes its result, so
/// no stage holds more than a few vectors. It stays in the first-level cache. Stages of eight lanes and of sixteen work on the same
/// columns: see <see cref="Beside"/>.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct PairLanes
{
    public const int Lanes = WideLanes.BundleLanes;

    /// <summary>The lanes of a column as it lies in memory, as in a record of rows: the pairs of two bundles side by side.</summary>
    public const int LineLanes = Prefetch.LineBytes / sizeof(float);

    /// <summary>The gap of a pair of which none was found.</summary>
    public const float UnknownGap = float.MinValue;

    public SideLanes A;
    public SideLanes B;

    /// <summary>Centre of body B minus centre of body A.</summary>
    public fixed float OffsetX[LineLanes];
    public fixed float OffsetY[LineLanes];

    /// <summary>Points farther apart than this are left out.</summary>
    public fixed float Margin[LineLanes];

    public fixed float NormalX[LineLanes];
    public fixed float NormalY[LineLanes];

    /// <summary>-1: the normal is that of a face of A and turns with it; 1: that of a face of B; 0: not known.</summary>
    public fixed float NormalOwner[LineLanes];

    /// <summary>0, 1 or 2 points.</summary>
    public fixed float Count[LineLanes];

    /// <summary>
    /// Separation along the axis that separates the pieces, or a number that says nothing; what counts is what is more than the margin.
    /// </summary>
    public fixed float Gap[LineLanes];

    /// <summary>-1: that axis turns with A; 1: with B; 0: it leads from one centre to the other.</summary>
    public fixed float GapOwner[LineLanes];

    public PointLanes Point0;
    public PointLanes Point1;

    /// <summary>How deep the pair would be at the end of the step with the velocities of its start; known of those that touch.</summary>
    public fixed float Sinking[LineLanes];

    /// <summary>Corners of the pieces, gathered only for pairs that need them.</summary>
    public HullPairLanes Hulls;

    /// <summary>The pairs beside some: those of the second bundle of a record.</summary>
    public static PairLanes* Beside(PairLanes* pairs) => (PairLanes*)((float*)pairs + Lanes);

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
