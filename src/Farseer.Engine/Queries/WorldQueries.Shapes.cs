using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Queries;

/// <summary>Convex shapes, standing or on a straight way without turning.</summary>
internal sealed unsafe partial class WorldQueries
{
    [NotState(Why.OfOneStep)]
    private readonly Column<double> _shape = new Column<double>();
    [NotState(Why.OfOneStep)]
    private readonly Column<double> _moving = new Column<double>();
    [NotState(Why.OfOneStep)]
    private readonly Column<double> _standing = new Column<double>();
    private readonly ConvexSum _sum = new ConvexSum();
    [NotState(Why.OfOneStep)]
    private int _shapeCount;
    [NotState(Why.OfOneStep)]
    private double _shapeRadius;

    /// <summary>Sets the shape of the next query: a disc about a world point.</summary>
    public void SetDisc(double x, double y, double radius)
    {
        _shapeCount = 1;
        _shape.EnsureCapacity(2);
        _shape[0] = x;
        _shape[1] = y;
        _shapeRadius = radius;
    }

    /// <summary>Sets the shape of the next query: all points within a radius of the way between two world points, which differ.</summary>
    public void SetCapsule(double x0, double y0, double x1, double y1, double radius)
    {
        _shapeCount = 2;
        _shape.EnsureCapacity(4);
        _shape[0] = x0;
        _shape[1] = y0;
        _shape[2] = x1;
        _shape[3] = y1;
        _shapeRadius = radius;
    }

    /// <summary>Sets the shape of the next query: a piece where it is.</summary>
    public void SetPiece(int piece)
    {
        ref Piece p = ref _shapes.Pieces[piece];
        ref BodyPose pose = ref PoseOf(piece);
        Vector2* v = _shapes.Vertices.Pointer + p.VertexStart;
        _shapeCount = p.VertexCount;
        _shapeRadius = p.Radius;
        _shape.EnsureCapacity(2 * p.VertexCount);
        for (int i = 0; i < p.VertexCount; i++)
        {
            _shape[2 * i] = pose.X + ((double)pose.Cos * v[i].X) - ((double)pose.Sin * v[i].Y);
            _shape[(2 * i) + 1] = pose.Y + ((double)pose.Sin * v[i].X) + ((double)pose.Cos * v[i].Y);
        }
    }

    /// <summary>Sets the shape of the next query: that of another world's.</summary>
    public void SetShape(WorldQueries other)
    {
        _shapeCount = other._shapeCount;
        _shapeRadius = other._shapeRadius;
        _shape.EnsureCapacity(2 * _shapeCount);
        for (int i = 0; i < 2 * _shapeCount; i++)
        {
            _shape[i] = other._shape[i];
        }
    }

    /// <summary>Finds the colliders that the shape touches or overlaps, in the order of their making.</summary>
    public void FindOverlapping(in QueryFilter filter, IndexList colliders)
    {
        Begin(filter);
        try
        {
            Bounds(out double minX, out double minY, out double maxX, out double maxY);
            Gather(Box.FromDouble(minX, minY, maxX, maxY));
            int kept = 0;
            for (int i = 0; i < _found.Count; i++)
            {
                int piece = _found[i];
                if (Sees(piece))
                {
                    BuildSum(piece);
                    if (_sum.HoldsOrigin())
                    {
                        _found.Pointer[kept++] = _shapes.Pieces[piece].Collider;
                    }
                }
            }

            _found.SetCount(kept);
            Deliver(colliders);
        }
        finally
        {
            _isAsking = false;
        }
    }

    /// <summary>The first collider that the shape meets on its way. One that it touches at its start is met at once.</summary>
    public bool CastShape(double dx, double dy, in QueryFilter filter, out RayHit hit)
    {
        hit = default;
        hit.Fraction = double.PositiveInfinity;
        Begin(filter);
        try
        {
            Bounds(out double minX, out double minY, out double maxX, out double maxY);
            var probe = new RayProbe(0.5 * (minX + maxX), 0.5 * (minY + maxY), dx, dy, 0.5 * (maxX - minX), 0.5 * (maxY - minY));
            _rays.Begin(_index.Tree, _index.Loose, probe);
            double limit = 1;
            while (_rays.Next(Above(limit), out int piece, out _))
            {
                if (Sees(piece) && CastShape(piece, dx, dy, limit, out RayHit found) && IsBetter(found, hit))
                {
                    hit = found;
                    limit = found.Fraction;
                }
            }
        }
        finally
        {
            _isAsking = false;
        }

        return hit.Fraction <= 1;
    }

    private void Bounds(out double minX, out double minY, out double maxX, out double maxY)
    {
        minX = maxX = _shape[0];
        minY = maxY = _shape[1];
        for (int i = 1; i < _shapeCount; i++)
        {
            minX = Math.Min(minX, _shape[2 * i]);
            maxX = Math.Max(maxX, _shape[2 * i]);
            minY = Math.Min(minY, _shape[(2 * i) + 1]);
            maxY = Math.Max(maxY, _shape[(2 * i) + 1]);
        }

        minX -= _shapeRadius;
        minY -= _shapeRadius;
        maxX += _shapeRadius;
        maxY += _shapeRadius;
    }

    private bool CastShape(int piece, double dx, double dy, double limit, out RayHit hit)
    {
        ref BodyPose pose = ref PoseOf(piece);
        hit = default;
        hit.Collider = _shapes.Pieces[piece].Collider;
        BuildSum(piece);
        if (_sum.HoldsOrigin())
        {
            hit.StartsInside = true;
            hit.X = _shape[0];
            hit.Y = _shape[1];
            return true;
        }

        RayPath way = LocalPath(piece, new RayInput { X = pose.X, Y = pose.Y, DirectionX = dx, DirectionY = dy });
        if (!_sum.Cast(way.DirectionX, way.DirectionY, limit * (1 + 3e-16), out SumHit found) || found.Fraction > limit)
        {
            return false;
        }

        hit.Fraction = found.Fraction;
        hit.X = pose.X + ((double)pose.Cos * found.X) - ((double)pose.Sin * found.Y);
        hit.Y = pose.Y + ((double)pose.Sin * found.X) + ((double)pose.Cos * found.Y);
        hit.Normal = WorldNormal(pose, found.NormalX, found.NormalY);
        return true;
    }

    /// <summary>Forms the sum of a piece and the shape, in the coordinates of the piece's body.</summary>
    private void BuildSum(int piece)
    {
        ref Piece p = ref _shapes.Pieces[piece];
        Vector2* v = _shapes.Vertices.Pointer + p.VertexStart;
        _standing.EnsureCapacity(2 * p.VertexCount);
        for (int i = 0; i < p.VertexCount; i++)
        {
            _standing[2 * i] = v[i].X;
            _standing[(2 * i) + 1] = v[i].Y;
        }

        _moving.EnsureCapacity(2 * _shapeCount);
        for (int i = 0; i < _shapeCount; i++)
        {
            RayPath point = LocalPath(piece, new RayInput { X = _shape[2 * i], Y = _shape[(2 * i) + 1] });
            _moving[2 * i] = point.X;
            _moving[(2 * i) + 1] = point.Y;
        }

        _sum.Build(
            new PointHull { Points = _standing.Pointer, Count = p.VertexCount, Radius = p.Radius },
            new PointHull { Points = _moving.Pointer, Count = _shapeCount, Radius = _shapeRadius });
    }
}
