using System;
using System.ComponentModel;
using System.Numerics;
using Box2D.Bridge;
using Box2D.Common;
using Box2D.Common.Math;
using Farseer.Engine.Shapes;

namespace Box2D.Collision.Shapes;

/// <summary>A circle of a body.</summary>
/// <example>
/// <code>
/// var ball = (b2CircleShape)body.CreateShape(new b2CircleDef { radius = 0.5f, density = 1 });
/// float radius = ball.GetRadius();
/// </code>
/// </example>
public class b2CircleShape : b2Shape
{
    private readonly float _radius;
    private readonly Vector2 _center;

    internal b2CircleShape(b2CircleDef def)
        : base(def)
    {
        _radius = Require.Length(def.radius, nameof(def.radius));
        b2Vec2 center = Require.Vector(def.localPosition, nameof(def.localPosition));
        _center = new Vector2(center.x, center.y);
    }

    /// <summary>Centre in the body, metres.</summary>
    /// <returns>A new vector.</returns>
    public b2Vec2 GetLocalPosition() => new b2Vec2(_center.X, _center.Y);

    /// <summary>Radius, metres.</summary>
    /// <returns>Above 0.</returns>
    public float GetRadius() => _radius;

    /// <inheritdoc/>
    public override bool TestPoint(b2XForm xf, b2Vec2 p)
    {
        Require.NotNull(xf, nameof(xf));
        Require.Vector(p, nameof(p));
        Vector2 d = Local(xf, p) - _center;
        return ((double)d.X * d.X) + ((double)d.Y * d.Y) <= (double)_radius * _radius;
    }

    /// <inheritdoc/>
    public override bool TestSegment(b2XForm xf, float[] lambda, b2Vec2 normal, b2Segment segment, float maxLambda)
    {
        CheckSegment(xf, lambda, normal, segment, maxLambda);
        Vector2 start = Local(xf, segment.p1) - _center;
        Vector2 way = Local(xf, segment.p2) - _center - start;
        double b = ((double)start.X * start.X) + ((double)start.Y * start.Y) - ((double)_radius * _radius);
        if (b < 0)
        {
            return false;
        }

        double c = ((double)start.X * way.X) + ((double)start.Y * way.Y);
        double rr = ((double)way.X * way.X) + ((double)way.Y * way.Y);
        double sigma = (c * c) - (rr * b);
        if (sigma < 0 || rr == 0)
        {
            return false;
        }

        double a = -(c + Math.Sqrt(sigma));
        if (a < 0 || a > maxLambda * rr)
        {
            return false;
        }

        double at = a / rr;
        double nx = start.X + (at * way.X);
        double ny = start.Y + (at * way.Y);
        double length = Math.Sqrt((nx * nx) + (ny * ny));
        lambda[0] = (float)at;
        SetTurned(normal, xf, (float)(nx / length), (float)(ny / length));
        return true;
    }

    /// <inheritdoc/>
    public override void ComputeAABB(b2AABB aabb, b2XForm xf)
    {
        Require.NotNull(aabb, nameof(aabb));
        Require.NotNull(xf, nameof(xf));
        b2Vec2 center = b2Math.b2MulX(xf, GetLocalPosition());
        aabb.lowerBound.Set(center.x - _radius, center.y - _radius);
        aabb.upperBound.Set(center.x + _radius, center.y + _radius);
    }

    internal override ShapeGeometry Geometry() => ShapeBuilder.Circle(_radius);

    internal Vector2 Center => _center;

    internal override ShapeMass Mass()
    {
        double mass = Density * Math.PI * _radius * _radius;
        return new ShapeMass(mass, _center.X, _center.Y, 0.5 * mass * _radius * _radius);
    }

    internal override double SweepRadius(b2Vec2 center)
    {
        double x = (double)_center.X - center.x;
        double y = (double)_center.Y - center.y;
        return Math.Sqrt((x * x) + (y * y)) + _radius - b2Settings.b2_toiSlop;
    }

    /// <summary>A field of the original. Use <see cref="GetRadius"/> instead.</summary>
    [Obsolete("Use GetRadius().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public float m_radius => GetRadius();

    /// <summary>A field of the original. Use <see cref="GetLocalPosition"/> instead.</summary>
    [Obsolete("Use GetLocalPosition().")]
    [EditorBrowsable(EditorBrowsableState.Never)]
    public b2Vec2 m_localPosition => GetLocalPosition();
}
