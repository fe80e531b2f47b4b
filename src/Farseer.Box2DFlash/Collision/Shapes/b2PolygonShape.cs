using System;
using System.ComponentModel;
using System.Numerics;
using Box2D.Bridge;
using Box2D.Common;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;

namespace Box2D.Collision.Shapes;

/// <summary>A convex polygon of a body. What it hands out are copies.</summary>
/// <example>
/// <code>
/// foreach (b2Vec2 corner in ((b2PolygonShape)shape).GetVertices())
/// {
///     Console.WriteLine($"{corner.x}, {corner.y}");
/// }
/// </code>
/// </example>
public class b2PolygonShape : b2Shape
{
    [NotState(Why.Fixed)]
    private readonly Vector2[] _corners;
    [NotState(Why.Fixed)]
    private readonly Vector2[] _normals;
    private readonly MassProperties _mass;
    [NotState(Why.Derived)]
    private b2OBB? _obb;

    internal b2PolygonShape(b2PolygonDef def)
        : base(def)
    {
        _corners = PolygonForm.Corners(def);
        _normals = new Vector2[_corners.Length];
        for (int i = 0; i < _corners.Length; i++)
        {
            Vector2 a = _corners[i];
            Vector2 b = _corners[(i + 1) % _corners.Length];
            double x = (double)b.X - a.X;
            double y = (double)b.Y - a.Y;
            double length = Math.Sqrt((x * x) + (y * y));
            _normals[i] = new Vector2((float)(y / length), (float)(-x / length));
        }

        _mass = MassProperties.OfOutline(_corners);
    }

    /// <summary>The centroid of an outline.</summary>
    /// <param name="vs">Its corners, counter-clockwise.</param>
    /// <param name="count">The number of corners that count, at least 3.</param>
    /// <returns>A new vector.</returns>
    /// <exception cref="ArgumentException">There are too few corners, or they go around no area.</exception>
    public static b2Vec2 ComputeCentroid(b2Vec2[] vs, int count)
    {
        Vector2 centroid = MassProperties.OfOutline(Corners(vs, count)).Centroid;
        return new b2Vec2(centroid.X, centroid.Y);
    }

    /// <summary>The smallest turned box around an outline: one of its sides lies on an edge.</summary>
    /// <param name="obb">Set to the box.</param>
    /// <param name="vs">The corners, counter-clockwise.</param>
    /// <param name="count">The number of corners that count, at least 3.</param>
    /// <exception cref="ArgumentException">There are too few corners, or they go around no area.</exception>
    public static void ComputeOBB(b2OBB obb, b2Vec2[] vs, int count)
    {
        Require.NotNull(obb, nameof(obb));
        Fill(obb, Corners(vs, count));
    }

    /// <summary>The turned box around the polygon, in the body.</summary>
    /// <returns>A new box.</returns>
    public b2OBB GetOBB()
    {
        var obb = new b2OBB();
        Fill(obb, _corners);
        return obb;
    }

    /// <summary>The centroid in the body, metres.</summary>
    /// <returns>A new vector.</returns>
    public b2Vec2 GetCentroid() => Of(_mass.Centroid);

    /// <summary>The number of corners.</summary>
    /// <returns>3 or more.</returns>
    public int GetVertexCount() => _corners.Length;

    /// <summary>The corners in the body, metres.</summary>
    /// <returns>New vectors, as many as there are corners.</returns>
    public b2Vec2[] GetVertices() => Of(_corners);

    /// <summary>The corners moved in so that each edge lies <see cref="b2Settings.b2_toiSlop"/> inside its place.</summary>
    /// <returns>New vectors. Of a polygon thinner than twice that they mean nothing; the engine does not use them.</returns>
    public b2Vec2[] GetCoreVertices() => Of(Core());

    /// <summary>The outward normals, that of edge i from corner i to the next.</summary>
    /// <returns>New unit vectors.</returns>
    public b2Vec2[] GetNormals() => Of(_normals);

    /// <summary>The first corner in the world.</summary>
    /// <param name="xf">The transform of the body.</param>
    /// <returns>A new vector.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="xf"/> is null.</exception>
    public b2Vec2 GetFirstVertex(b2XForm xf) => b2Math.b2MulX(Require.NotNull(xf, nameof(xf)), Of(_corners[0]));

    /// <summary>The centroid in the world.</summary>
    /// <param name="xf">The transform of the body.</param>
    /// <returns>A new vector.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="xf"/> is null.</exception>
    public b2Vec2 Centroid(b2XForm xf) => b2Math.b2MulX(Require.NotNull(xf, nameof(xf)), GetCentroid());

    /// <summary>The core corner that lies farthest in a direction, in the world.</summary>
    /// <param name="xf">The transform of the body.</param>
    /// <param name="dX">First component of the direction, in the world.</param>
    /// <param name="dY">Second component.</param>
    /// <returns>A new vector.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="xf"/> is null.</exception>
    public b2Vec2 Support(b2XForm xf, float dX, float dY)
    {
        Require.NotNull(xf, nameof(xf));
        b2Vec2 d = b2Math.b2MulTMV(xf.R, new b2Vec2(dX, dY));
        Vector2[] core = Core();
        int best = 0;
        for (int i = 1; i < core.Length; i++)
        {
            if (Along(core[i]) > Along(core[best]))
            {
                best = i;
            }
        }

        return b2Math.b2MulX(xf, Of(core[best]));

        double Along(Vector2 v) => ((double)v.X * d.x) + ((double)v.Y * d.y);
    }

    /// <inheritdoc/>
    public override bool TestPoint(b2XForm xf, b2Vec2 p)
    {
        Require.NotNull(xf, nameof(xf));
        Require.Vector(p, nameof(p));
        Vector2 local = Local(xf, p);
        for (int i = 0; i < _corners.Length; i++)
        {
            if (Height(i, local) > 0)
            {
                return false;
            }
        }

        return true;
    }

    /// <inheritdoc/>
    public override bool TestSegment(b2XForm xf, float[] lambda, b2Vec2 normal, b2Segment segment, float maxLambda)
    {
        CheckSegment(xf, lambda, normal, segment, maxLambda);
        Vector2 start = Local(xf, segment.p1);
        Vector2 way = Local(xf, segment.p2) - start;
        double lower = 0;
        double upper = maxLambda;
        int index = -1;
        for (int i = 0; i < _corners.Length; i++)
        {
            // n·(v − p1) against n·d: entering where the way goes against the normal.
            double numerator = -Height(i, start);
            double denominator = ((double)_normals[i].X * way.X) + ((double)_normals[i].Y * way.Y);
            if (denominator < 0 && numerator < lower * denominator)
            {
                lower = numerator / denominator;
                index = i;
            }
            else if (denominator > 0 && numerator < upper * denominator)
            {
                upper = numerator / denominator;
            }
            else if (denominator == 0 && numerator < 0)
            {
                return false;
            }

            if (upper < lower)
            {
                return false;
            }
        }

        if (index < 0)
        {
            return false;
        }

        lambda[0] = (float)lower;
        SetTurned(normal, xf, _normals[index].X, _normals[index].Y);
        return true;
    }

    /// <inheritdoc/>
    public override void ComputeAABB(b2AABB aabb, b2XForm xf)
    {
        Require.NotNull(aabb, nameof(aabb));
        Require.NotNull(xf, nameof(xf));
        if (Body is not null && (Body.World.Quirks & Box2DFlash202Quirks.BoxOfTurnedBox) != 0)
        {
            b2OBB obb = TurnedBox;
            b2Vec2 center = b2Math.b2MulX(xf, obb.center);
            b2Vec2 half = b2Math.b2MulMV(b2Math.b2AbsM(b2Math.b2MulMM(xf.R, obb.R)), obb.extents);
            aabb.lowerBound.SetV(b2Math.SubtractVV(center, half));
            aabb.upperBound.SetV(b2Math.AddVV(center, half));
            return;
        }

        b2Vec2 first = GetFirstVertex(xf);
        aabb.lowerBound.SetV(first);
        aabb.upperBound.SetV(first);
        for (int i = 1; i < _corners.Length; i++)
        {
            b2Vec2 corner = b2Math.b2MulX(xf, Of(_corners[i]));
            aabb.lowerBound.MinV(corner);
            aabb.upperBound.MaxV(corner);
        }
    }

    internal Vector2[] CornerArray => _corners;

    /// <summary>As <see cref="GetOBB"/>, and always the same object: not to be changed nor handed out.</summary>
    internal b2OBB TurnedBox => _obb ??= GetOBB();

    internal override ShapeGeometry Geometry() => ShapeBuilder.Polygon(_corners);

    internal override ShapeMass Mass()
    {
        double mass = Density * _mass.Area;
        return new ShapeMass(mass, _mass.CentroidX, _mass.CentroidY, Density * _mass.SecondMoment);
    }

    internal override double SweepRadius(b2Vec2 center)
    {
        double largest = 0;
        foreach (Vector2 v in Core())
        {
            double x = (double)v.X - center.x;
            double y = (double)v.Y - center.y;
            largest = Math.Max(largest, Math.Sqrt((x * x) + (y * y)));
        }

        return largest;
    }

    internal Vector2[] Core()
    {
        var core = new Vector2[_corners.Length];
        for (int i = 0; i < core.Length; i++)
        {
            // Where the two edges that meet here do once each has moved in: n·v = n·corner − slop for both.
            Vector2 n1 = _normals[(i + core.Length - 1) % core.Length];
            Vector2 n2 = _normals[i];
            double d = ((double)n1.X * n2.Y) - ((double)n1.Y * n2.X);
            double slop = b2Settings.b2_toiSlop;
            core[i] = new Vector2(
                (float)(_corners[i].X - (slop * ((double)n2.Y - n1.Y) / d)),
                (float)(_corners[i].Y - (slop * ((double)n1.X - n2.X) / d)));
        }

        return core;
    }

    private static Vector2[] Corners(b2Vec2[] vs, int count) =>
        PolygonForm.Corners(new b2PolygonDef { vertices = Require.NotNull(vs, nameof(vs)), vertexCount = count });

    private static void Fill(b2OBB obb, Vector2[] corners)
    {
        double smallest = double.MaxValue;
        for (int i = 0; i < corners.Length; i++)
        {
            Vector2 root = corners[i];
            double ux = (double)corners[(i + 1) % corners.Length].X - root.X;
            double uy = (double)corners[(i + 1) % corners.Length].Y - root.Y;
            double length = Math.Sqrt((ux * ux) + (uy * uy));
            ux /= length;
            uy /= length;
            double minX = double.MaxValue;
            double maxX = double.MinValue;
            double minY = double.MaxValue;
            double maxY = double.MinValue;
            foreach (Vector2 v in corners)
            {
                double dx = (double)v.X - root.X;
                double dy = (double)v.Y - root.Y;
                double along = (ux * dx) + (uy * dy);
                double across = (ux * dy) - (uy * dx);
                minX = Math.Min(minX, along);
                maxX = Math.Max(maxX, along);
                minY = Math.Min(minY, across);
                maxY = Math.Max(maxY, across);
            }

            double area = (maxX - minX) * (maxY - minY);

            // Of equal boxes the first one counts; rounding alone must not decide.
            if (area < 0.9999999 * smallest)
            {
                smallest = area;
                double x = 0.5 * (minX + maxX);
                double y = 0.5 * (minY + maxY);
                obb.R.col1.Set((float)ux, (float)uy);
                obb.R.col2.Set((float)-uy, (float)ux);
                obb.center.Set((float)(root.X + (ux * x) - (uy * y)), (float)(root.Y + (uy * x) + (ux * y)));
                obb.extents.Set((float)(0.5 * (maxX - minX)), (float)(0.5 * (maxY - minY)));
            }
        }
    }

    private static b2Vec2 Of(Vector2 v) => new b2Vec2(v.X, v.Y);

    private static b2Vec2[] Of(Vector2[] vectors) => Array.ConvertAll(vectors, Of);

    private double Height(int edge, Vector2 p) =>
        (_normals[edge].X * ((double)p.X - _corners[edge].X)) + (_normals[edge].Y * ((double)p.Y - _corners[edge].Y));

    /// <summary>A field of the original. Use <see cref="GetVertices"/> instead.</summary>
    [Obsolete("Use GetVertices().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Vec2[] m_vertices => GetVertices();

    /// <summary>A field of the original. Use <see cref="GetVertexCount"/> instead.</summary>
    [Obsolete("Use GetVertexCount().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public int m_vertexCount => GetVertexCount();

    /// <summary>A field of the original. Use <see cref="GetNormals"/> instead.</summary>
    [Obsolete("Use GetNormals().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Vec2[] m_normals => GetNormals();

    /// <summary>A field of the original. Use <see cref="GetCoreVertices"/> instead.</summary>
    [Obsolete("Use GetCoreVertices().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Vec2[] m_coreVertices => GetCoreVertices();

    /// <summary>A field of the original. Use <see cref="GetCentroid"/> instead.</summary>
    [Obsolete("Use GetCentroid().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Vec2 m_centroid => GetCentroid();

    /// <summary>A field of the original. Use <see cref="GetOBB"/> instead.</summary>
    [Obsolete("Use GetOBB().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2OBB m_obb => GetOBB();
}
