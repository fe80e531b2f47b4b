using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.NarrowPhase;

/// <summary>A point of each lane.</summary>
internal struct WidePoint
{
    public Wide X;
    public Wide Y;
}

/// <summary>
/// The points and normals that the contact of two hulls may be made of. Where lanes are turned by way of memory, they are all turned before
/// the first is read; elsewhere each is gathered when it is wanted, and nothing is kept here.
/// </summary>
internal unsafe struct FeaturePoints
{
    public WidePoint Edge;
    public WidePoint EdgeNormal;
    public WidePoint End;
    public WidePoint Before;
    public WidePoint BeforeNormal;
    public WidePoint Support;
    public WidePoint SupportNormal;
    public WidePoint After;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Turn(FeaturePoints* points, HullPairLanes* hulls, int lane, Vector2* vertices, Vector2* normals)
    {
        if (Wide.Count <= MatrixTurn.MostLanes)
        {
            Turn(&points->Edge, vertices, hulls->Edge.Place + lane);
            Turn(&points->EdgeNormal, normals, hulls->Edge.Place + lane);
            Turn(&points->End, vertices, hulls->End.Place + lane);
            Turn(&points->Before, vertices, hulls->Before.Place + lane);
            Turn(&points->BeforeNormal, normals, hulls->Before.Place + lane);
            Turn(&points->Support, vertices, hulls->Support.Place + lane);
            Turn(&points->SupportNormal, normals, hulls->Support.Place + lane);
            Turn(&points->After, vertices, hulls->After.Place + lane);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Read(WidePoint* turned, Vector2* pool, int* place, out Wide x, out Wide y)
    {
        if (Wide.Count <= MatrixTurn.MostLanes)
        {
            x = turned->X;
            y = turned->Y;
            return;
        }

        WidePoints.Gather(pool, place, out x, out y);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Turn(WidePoint* turned, Vector2* pool, int* place) =>
        MatrixTurn.ToTwoColumns(pool, place, Wide.Count, (float*)&turned->X, (float*)&turned->Y);
}
