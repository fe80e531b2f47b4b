using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Api;

public class CollisionHelperTests
{
    /// <summary>Points recorded from version 2.0.1 (tests/data/fidelity/collide_point.json), in single precision.</summary>
    private const float Tolerance = 2e-5f;

    [Theory]
    [InlineData(false, 35.414204f, 3.3416567f, 64.550446f, 3.4582021f)]
    [InlineData(true, 35f, 3.3400002f, 65f, 3.459999f)]
    public void LineSegmentGeomIntersect_OfCircle_GivesRecordedPoints(bool box, float x1, float y1, float x2, float y2)
    {
        var body = new Body { Position = new Vector2(50, 0) };
        var geom = GeomFactory.Instance.CreateCircleGeom(body, 15, 32);
        var found = new List<LineIntersectInfo>();
        Vector2 from = new(-50, 3), to = new(200, 4);
        CollisionHelper.LineSegmentGeomIntersect(from, to, geom, box, ref found);
        CollisionHelper.LineSegmentGeomIntersect(ref from, ref to, geom, box, ref found);
        Assert.Equal(2, found.Count);
        Assert.Equal(found[0].Points, found[1].Points);
        Assert.Same(geom, found[0].Geom);
        Assert.Equal(2, found[0].Points.Count);
        Near(new Vector2(x1, y1), found[0].Points[0]);
        Near(new Vector2(x2, y2), found[0].Points[1]);
        CollisionHelper.LineSegmentGeomIntersect(new Vector2(0, 90), new Vector2(9, 90), geom, box, ref found);
        Assert.Equal(2, found.Count);
    }

    [Fact]
    public void LineIntersect_OfSegmentsAndLines_TellsThemApart()
    {
        Vector2 a = new(0, 0), b = new(2, 0), c = new(3, -1), d = new(3, 1);
        Assert.False(CollisionHelper.LineIntersect(a, b, c, d, out var point));
        Assert.Equal(Vector2.Zero, point);
        Assert.True(CollisionHelper.LineIntersect(a, b, c, d, false, true, 0, out point));
        Assert.Equal(new Vector2(3, 0), point);
        Assert.True(CollisionHelper.LineIntersect(ref a, ref b, ref c, ref d, false, false, 1e-6f, out point));
        Assert.False(CollisionHelper.LineIntersect(ref a, ref b, ref c, ref d, false, false, 10f, out _));
        Assert.False(CollisionHelper.LineIntersect(ref a, ref b, ref c, ref d, out _));
        Assert.False(CollisionHelper.LineIntersect(a, b, a, b, out _), "Lines on each other count as parallel.");
        Assert.True(CollisionHelper.LineIntersect(a, b, b, d, out point), "A shared end is met.");
        Assert.Equal(b, point);
        Assert.Throws<ArgumentOutOfRangeException>(() => CollisionHelper.LineIntersect(a, b, c, d, true, true, -1, out _));
    }

    [Fact]
    public void LineSegmentVerticesIntersect_ThroughACorner_GivesItOnce()
    {
        var square = new AABB(Vector2.Zero, Vector2.One).GetVertices();
        Vector2 from = new(-1, -1), to = new(2, 2);
        List<Vector2> points = null!;
        CollisionHelper.LineSegmentVerticesIntersect(ref from, ref to, square, ref points);
        Assert.Equal(new[] { Vector2.Zero, Vector2.One }, points.OrderBy(p => p.X));
        CollisionHelper.LineSegmentAABBIntersect(ref from, ref to, new AABB(Vector2.Zero, Vector2.One), ref points);
        Assert.Equal(2, points.Count);
    }

    [Fact]
    public void FloatEqualsAndInRange_CountTheEnds()
    {
        Assert.True(CollisionHelper.FloatEquals(1, 1.5f, 0.5f));
        Assert.False(CollisionHelper.FloatEquals(1, 1.75f, 0.5f));
        Assert.True(CollisionHelper.FloatInRange(2, 1, 2));
        Assert.False(CollisionHelper.FloatInRange(float.NaN, 1, 2));
    }

    [Fact]
    public void Members_OfNull_Throw()
    {
        var from = Vector2.Zero;
        var to = Vector2.One;
        List<Vector2> points = null!;
        List<LineIntersectInfo> found = null!;
        Assert.Throws<ArgumentNullException>(
            () => CollisionHelper.LineSegmentAABBIntersect(ref from, ref to, null!, ref points));
        Assert.Throws<ArgumentNullException>(
            () => CollisionHelper.LineSegmentVerticesIntersect(ref from, ref to, null!, ref points));
        Assert.Throws<ArgumentNullException>(
            () => CollisionHelper.LineSegmentGeomIntersect(from, to, null!, false, ref found));
    }

    private static void Near(Vector2 expected, Vector2 actual)
    {
        Assert.Equal(expected.X, actual.X, Tolerance);
        Assert.Equal(expected.Y, actual.Y, Tolerance);
    }
}
