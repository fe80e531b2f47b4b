using System;
using System.Collections.Generic;
using System.Numerics;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Shapes;

/// <summary>All pieces, colliders and their vertex pools, of which equal pieces share a run.</summary>
internal sealed class ShapeStore
{
    /// <summary>Corners that the kernels of hulls read at once, whether a piece has so many or not.</summary>
    public const int ReadAtOnce = 4;

    private readonly ColumnSet _vertexSet = new ColumnSet();
    private readonly ColumnSet _pieceSet = new ColumnSet();
    private readonly Column<Handle> _pieceHandles;
    private readonly SharedRuns _runs;

    /// <summary>
    /// Freed vertex ranges, one list per power of two up to the largest that was taken; last in, first out, so runs repeat exactly.
    /// </summary>
    private readonly List<List<int>> _freeRanges = new List<List<int>>();

    private int _vertexEnd;

    public ShapeStore()
    {
        Vertices = _vertexSet.Add<Vector2>();
        Normals = _vertexSet.Add<Vector2>();
        OutlineBefore = _vertexSet.Add<Vector2>();
        OutlineAfter = _vertexSet.Add<Vector2>();
        _runs = new SharedRuns(_vertexSet);
        Pieces = _pieceSet.Add<Piece>();
        NextPiece = _pieceSet.Add<int>();
        _pieceHandles = _pieceSet.Add<Handle>();
    }

    public Column<Piece> Pieces { get; }

    /// <summary>The collider of a piece.</summary>
    public int ColliderOf(int piece) => Pieces[piece].Collider;

    /// <summary>Who was made earlier; the lower one of a pair is its A.</summary>
    public int OrderAt(int piece) => Order[Pieces[piece].Collider];

    /// <summary>What that collider is.</summary>
    public ref ColliderInfo ColliderAt(int piece) => ref Colliders[Pieces[piece].Collider];

    /// <summary>Per piece: the next piece of the same collider, -1 after the last.</summary>
    public Column<int> NextPiece { get; }

    public Column<ColliderInfo> Colliders { get; } = new Column<ColliderInfo>();

    /// <summary>Order of creation of the colliders, which may count those of other worlds in between.</summary>
    public Column<int> Order { get; } = new Column<int>();

    public IdPool PieceIds { get; } = new IdPool();

    /// <summary>The pieces of the bodies that a step looks at.</summary>
    public BitSet VisitedPieces { get; } = new BitSet();

    public IdPool ColliderIds { get; } = new IdPool();

    public Column<Vector2> Vertices { get; }

    /// <summary>Outward unit normal of edge i.</summary>
    public Column<Vector2> Normals { get; }

    /// <summary>Outward normal of the outline edge that ends in vertex i.</summary>
    public Column<Vector2> OutlineBefore { get; }

    /// <summary>
    /// Outward normal of the outline edge that starts in vertex i. It is bit for bit the piece's own edge normal exactly where
    /// edge i belongs to the outline: that comparison is how a contact routine knows a seam.
    /// </summary>
    public Column<Vector2> OutlineAfter { get; }

    /// <summary>Columns indexed by piece.</summary>
    public ColumnSet PieceSet => _pieceSet;

    /// <summary>Columns indexed by vertex.</summary>
    public ColumnSet VertexSet => _vertexSet;

    /// <summary>
    /// Writes the pieces of <paramref name="geometry"/> in body coordinates, links them (<see cref="NextPiece"/>) and enters
    /// them in the collider. Returns the first piece.
    /// </summary>
    public int AttachPieces(ShapeGeometry geometry, int body, int collider, Vector2 offset, Rotation rotationOffset)
    {
        int first = -1;
        int previous = -1;
        foreach (PieceGeometry source in geometry.Pieces)
        {
            Handle handle = PieceIds.Take();
            int index = handle.Index;
            _pieceSet.EnsureCapacity(PieceIds.End);
            _pieceHandles[index] = handle;
            VisitedPieces.Set(index);
            NextPiece[index] = -1;
            int count = source.Vertices.Length;
            int own = TakeRange(count);
            PieceBaker.Write(source, offset, rotationOffset, new PieceRange(this, own, count));
            int start = Enter(own, count);
            Pieces[index] = PieceBaker.Describe(source, body, collider, new PieceRange(this, start, count));
            if (previous < 0)
            {
                first = index;
            }
            else
            {
                NextPiece[previous] = index;
            }

            previous = index;
        }

        Colliders.EnsureCapacity(collider + 1);
        ref ColliderInfo info = ref Colliders[collider];
        info.Body = body;
        info.FirstPiece = first;
        info.PieceCount = geometry.Pieces.Length;
        return first;
    }

    /// <summary>Moves the pieces of a collider within its body.</summary>
    public void MovePieces(int collider, double x, double y)
    {
        ref ColliderInfo info = ref Colliders[collider];
        for (int piece = info.PieceCount > 0 ? info.FirstPiece : -1; piece >= 0; piece = NextPiece[piece])
        {
            ref Piece p = ref Pieces[piece];
            p.VertexStart = Part(p.VertexStart, p.VertexCount);
            double reach = 0;
            for (int i = p.VertexStart; i < p.VertexStart + p.VertexCount; i++)
            {
                double vx = Vertices[i].X + x;
                double vy = Vertices[i].Y + y;
                Vertices[i] = new Vector2((float)vx, (float)vy);
                reach = Math.Max(reach, Math.Sqrt((vx * vx) + (vy * vy)));
            }

            p.VertexStart = Enter(p.VertexStart, p.VertexCount);
            p.Reach = FloatBits.RoundUp(reach + p.Radius);
            p.Center = new Vector2((float)(p.Center.X + x), (float)(p.Center.Y + y));
        }
    }

    /// <summary>Frees the pieces of a collider and their vertices.</summary>
    public void DetachPieces(int collider)
    {
        ref ColliderInfo info = ref Colliders[collider];
        int piece = info.PieceCount > 0 ? info.FirstPiece : -1;
        while (piece >= 0)
        {
            int next = NextPiece[piece];
            if (_runs.Leave(new PieceRange(this, Pieces[piece].VertexStart, Pieces[piece].VertexCount)))
            {
                ReturnRange(Pieces[piece].VertexStart, Pieces[piece].VertexCount);
            }

            Pieces[piece] = default;
            NextPiece[piece] = -1;
            PieceIds.Return(_pieceHandles[piece]);
            piece = next;
        }

        info.FirstPiece = -1;
        info.PieceCount = 0;
    }

    /// <summary>The smallest box around a piece, formed in double precision and rounded outwards.</summary>
    public Box TightBox(int piece, in BodyPose pose) => BoxAround(piece, pose, default);

    /// <summary>The same with something to spare on each side.</summary>
    public unsafe Box BoxAround(int piece, in BodyPose pose, in Box spare)
    {
        ref Piece p = ref Pieces[piece];
        Vector2* v = Vertices.Pointer + p.VertexStart;
        double r = p.Radius;
#if NET8_0_OR_GREATER
        // Which corner is the outermost changes as the piece turns: selections instead of branches, x beside y.
        Vector128<double> cos = Vector128.Create((double)pose.Cos);
        Vector128<double> sin = Vector128.Create(-(double)pose.Sin, pose.Sin);
        Vector128<double> least = Vector128.Create(double.MaxValue);
        Vector128<double> most = Vector128.Create(-double.MaxValue);
        for (int i = 0; i < p.VertexCount; i++)
        {
            Vector128<double> own = Vector128.Create((double)v[i].X, v[i].Y);
            Vector128<double> across = Vector128.Create((double)v[i].Y, v[i].X);
            Vector128<double> corner = (cos * own) + (sin * across);
            least = Vector128.ConditionalSelect(Vector128.LessThan(corner, least), corner, least);
            most = Vector128.ConditionalSelect(Vector128.GreaterThan(corner, most), corner, most);
        }

        Vector128<double> place = Vector128.Create(pose.X, pose.Y);
        Vector128<double> radius = Vector128.Create(r);
        return Box.FromDouble(
            place + (least - radius) - Vector128.Create((double)spare.MinX, spare.MinY),
            place + (most + radius) + Vector128.Create((double)spare.MaxX, spare.MaxY));
#else
        double cos = pose.Cos;
        double sin = pose.Sin;
        double minX = double.MaxValue;
        double minY = double.MaxValue;
        double maxX = -double.MaxValue;
        double maxY = -double.MaxValue;
        for (int i = 0; i < p.VertexCount; i++)
        {
            double x = (cos * v[i].X) - (sin * v[i].Y);
            double y = (sin * v[i].X) + (cos * v[i].Y);
            minX = x < minX ? x : minX;
            maxX = x > maxX ? x : maxX;
            minY = y < minY ? y : minY;
            maxY = y > maxY ? y : maxY;
        }

        return Box.FromDouble(
            pose.X + (minX - r) - spare.MinX,
            pose.Y + (minY - r) - spare.MinY,
            pose.X + (maxX + r) + spare.MaxX,
            pose.Y + (maxY + r) + spare.MaxY);
#endif
    }

    /// <summary>The run of a new or changed piece, or an equal one that there is.</summary>
    private int Enter(int own, int count)
    {
        int start = _runs.Enter(new PieceRange(this, own, count), this);
        if (start != own)
        {
            ReturnRange(own, count);
        }

        return start;
    }

    /// <summary>A run that a piece has for itself and may change: its own, or a copy of the one that it shared.</summary>
    private unsafe int Part(int start, int count)
    {
        if (_runs.Leave(new PieceRange(this, start, count)))
        {
            return start;
        }

        int own = TakeRange(count);
        var from = new PieceRange(this, start, count);
        var to = new PieceRange(this, own, count);
        for (int i = 0; i < count; i++)
        {
            to.Vertices[i] = from.Vertices[i];
            to.Normals[i] = from.Normals[i];
            to.Before[i] = from.Before[i];
            to.After[i] = from.After[i];
        }

        return own;
    }

    private static int SizeClass(int count)
    {
        int size = 0;
        while ((1 << size) < count)
        {
            size++;
        }

        return size;
    }

    private int TakeRange(int count)
    {
        int size = SizeClass(count);
        NeedSizes(size + 1);
        List<int> free = _freeRanges[size];
        if (free.Count > 0)
        {
            int reused = free[free.Count - 1];
            free.RemoveAt(free.Count - 1);
            return reused;
        }

        int start = _vertexEnd;
        _vertexEnd += 1 << size;
        _vertexSet.EnsureCapacity(start + Math.Max((1 << size) + 1, ReadAtOnce));
        return start;
    }

    private void NeedSizes(int count)
    {
        while (_freeRanges.Count < count)
        {
            _freeRanges.Add(new List<int>());
        }
    }

    private void ReturnRange(int start, int count) => _freeRanges[SizeClass(count)].Add(start);

    /// <exception cref="System.ArgumentException">The handle names no collider.</exception>
    public ref ColliderInfo Require(Handle collider, string name)
    {
        ColliderIds.Require(collider, name);
        return ref Colliders[collider.Index];
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        // Lists behind the last one that holds something are room: whether they are there is to change no state.
        int sizes = _freeRanges.Count;
        while (sizes > 0 && _freeRanges[sizes - 1].Count == 0)
        {
            sizes--;
        }

        sizes = s.Value(sizes);
        NeedSizes(sizes);
        for (int i = 0; i < sizes; i++)
        {
            s.List(_freeRanges[i]);
        }

        for (int i = sizes; i < _freeRanges.Count; i++)
        {
            _freeRanges[i].Clear();
        }

        s.Column(_pieceHandles);
        _runs.Visit(s);
        s.Value(ref _vertexEnd);
        s.Column(Pieces);
        s.Column(NextPiece);
        s.Column(Colliders);
        s.Local(Order);
        PieceIds.Visit(s);
        VisitedPieces.Visit(s);
        ColliderIds.Visit(s);
        s.Column(Vertices);
        s.Column(Normals);
        s.Column(OutlineBefore);
        s.Column(OutlineAfter);
    }
}
