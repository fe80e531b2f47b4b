using System;
using System.Linq;
using System.Numerics;
using BenchmarkDotNet.Attributes;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Benchmarks.Suites;

/// <summary>Contacts of regular polygons, eight pairs on lanes beside the same eight one by one, ns a pair.</summary>
public unsafe class HullSuite
{
    private const int AllLanes = (1 << PairLanes.Lanes) - 1;
    private const float Margin = 0.02f;
    private readonly Column<PairLanes> _touching = new Column<PairLanes>(1);
    private readonly Column<PairLanes> _apart = new Column<PairLanes>(1);
    private readonly Column<PairLanes> _circles = new Column<PairLanes>(1);
    private readonly ShapeStore _shapes = new ShapeStore();
    private readonly Column<PairInput> _inputs = new Column<PairInput>(3 * PairLanes.Lanes);

    [Params(3, 5, 8)]
    public int Corners { get; set; }

    [GlobalSetup]
    public void Setup()
    {
        Vector2[] outline = [.. Enumerable.Range(0, Corners).Select(Corner)];
        int hull = _shapes.AttachPieces(ShapeBuilder.Polygon(outline), 0, 0, Vector2.Zero, Rotation.Identity);
        int circle = _shapes.AttachPieces(ShapeBuilder.Circle(0.5f), 1, 1, Vector2.Zero, Rotation.Identity);
        for (int lane = 0; lane < PairLanes.Lanes; lane++)
        {
            float turn = 0.7f * lane;
            Set(_touching.Pointer, lane, hull, hull, Away(turn, 0.8f));
            Set(_apart.Pointer, lane, hull, hull, Away(turn, 1.3f));
            Set(_circles.Pointer, lane, hull, circle, Away(turn, 0.9f));
            _inputs[lane] = Input(hull, hull, turn, Away(turn, 0.8f));
            _inputs[lane + PairLanes.Lanes] = Input(hull, hull, turn, Away(turn, 1.3f));
            _inputs[lane + (2 * PairLanes.Lanes)] = Input(hull, circle, turn, Away(turn, 0.9f));
        }

        foreach (Column<PairLanes> pairs in new[] { _touching, _apart, _circles })
        {
            Name(&pairs.Pointer->Hulls.A, hull);
            Name(&pairs.Pointer->Hulls.B, hull);
        }
    }

    [Benchmark(OperationsPerInvoke = PairLanes.Lanes)]
    public void TouchingOnLanes() => WideConvex.Collide(_touching.Pointer, AllLanes, _shapes.Vertices.Pointer, _shapes.Normals.Pointer);

    [Benchmark(OperationsPerInvoke = PairLanes.Lanes)]
    public int TouchingOneByOne() => OneByOne(0);

    [Benchmark(OperationsPerInvoke = PairLanes.Lanes)]
    public void ApartOnLanes() => WideConvex.Collide(_apart.Pointer, AllLanes, _shapes.Vertices.Pointer, _shapes.Normals.Pointer);

    [Benchmark(OperationsPerInvoke = PairLanes.Lanes)]
    public int ApartOneByOne() => OneByOne(PairLanes.Lanes);

    [Benchmark(OperationsPerInvoke = PairLanes.Lanes)]
    public void CirclesOnLanes() =>
        WideCircleHull.Collide(_circles.Pointer, AllLanes, 0, _shapes.Vertices.Pointer, _shapes.Normals.Pointer);

    [Benchmark(OperationsPerInvoke = PairLanes.Lanes)]
    public int CirclesOneByOne() => OneByOne(2 * PairLanes.Lanes);

    private static Vector2 Away(float turn, float distance) => new Vector2(MathF.Cos(3 * turn), MathF.Sin(3 * turn)) * distance;

    private static Rotation Turn(float angle) => new Rotation(MathF.Cos(angle), MathF.Sin(angle));

    private Vector2 Corner(int i) => new Vector2(MathF.Cos(i * 2 * MathF.PI / Corners), MathF.Sin(i * 2 * MathF.PI / Corners)) * 0.5f;

    private int OneByOne(int first)
    {
        int points = 0;
        for (int i = first; i < first + PairLanes.Lanes; i++)
        {
            Collision.Collide(_inputs[i], out Manifold manifold);
            points += manifold.Count;
        }

        return points;
    }

    private PairInput Input(int a, int b, float turn, Vector2 offset) => new PairInput
    {
        Vertices = _shapes.Vertices.Pointer,
        Normals = _shapes.Normals.Pointer,
        OutlineBefore = _shapes.OutlineBefore.Pointer,
        OutlineAfter = _shapes.OutlineAfter.Pointer,
        PieceA = _shapes.Pieces.Pointer + a,
        PieceB = _shapes.Pieces.Pointer + b,
        RotationA = Turn(turn),
        RotationB = Turn(2 * turn),
        Offset = offset,
        Margin = Margin,
    };

    private void Set(PairLanes* pairs, int lane, int a, int b, Vector2 offset)
    {
        float turn = 0.7f * lane;
        pairs->OffsetX[lane] = offset.X;
        pairs->OffsetY[lane] = offset.Y;
        pairs->Margin[lane] = Margin;
        pairs->A.Extent[lane] = _shapes.Pieces[a].Extent;
        pairs->B.Extent[lane] = _shapes.Pieces[b].Extent;
        pairs->B.HalfX[lane] = _shapes.Pieces[b].Radius;
        Set(&pairs->Hulls.A, lane, Turn(turn));
        Set(&pairs->Hulls.B, lane, Turn(2 * turn));
    }

    private static void Set(HullLanes* hulls, int lane, Rotation turn)
    {
        hulls->Cos[lane] = turn.Cos;
        hulls->Sin[lane] = turn.Sin;
    }

    private void Name(HullLanes* hulls, int piece)
    {
        int* pieces = stackalloc int[PairLanes.Lanes];
        int* packed = stackalloc int[PairLanes.Lanes];
        for (int lane = 0; lane < PairLanes.Lanes; lane++)
        {
            pieces[lane] = lane;
            packed[lane] = HullLanes.Pack(_shapes.Pieces[piece].VertexStart, _shapes.Pieces[piece].VertexCount);
        }

        HullLanes.Name(hulls, AllLanes, pieces, packed);
    }
}
