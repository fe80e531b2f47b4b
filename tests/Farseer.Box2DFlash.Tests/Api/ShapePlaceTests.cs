using System;
using System.Linq;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

/// <summary>Where a shape of a turned and displaced body is: its points, corners, normals, core and the boxes around it.</summary>
public sealed class ShapePlaceTests
{
    // Places within 15 m, turned in single precision.
    private const double Rounding = 5e-6;

    [Fact]
    public void TestPoint_OfTurnedShapes_IsTheSideOfEveryEdgeOrTheDistance()
    {
        Random random = new(91);
        int inside = 0;
        foreach (PlacedShape placed in PlacedShape.Polygons(92, 600).Concat(PlacedShape.Circles(93, 300)))
        {
            (double X, double Y)[] corners = placed.WorldCorners();
            (double X, double Y) center = placed.World(placed.Radius > 0 ? placed.Center : placed.Corners[0]);
            for (int i = 0; i < 20; i++)
            {
                (double X, double Y) p = (
                    (float)(center.X + PlacedShape.Number(random, -2.5, 2.5)), (float)(center.Y + PlacedShape.Number(random, -2.5, 2.5)));
                double depth = placed.Radius > 0
                    ? placed.Radius - PlacedShape.Distance(center, p)
                    : corners.Select((a, k) => (A: a, B: corners[(k + 1) % corners.Length]))
                        .Min(e => PlacedShape.Cross(e.A, e.B, p) / PlacedShape.Distance(e.A, e.B));
                if (Math.Abs(depth) > Rounding)
                {
                    Assert.Equal(depth > 0, placed.Shape.TestPoint(placed.Body.GetXForm(), PlacedShape.V(p)));
                    inside += depth > 0 ? 1 : 0;
                }
            }
        }

        Assert.InRange(inside, 1000, 17000);
    }

    [Theory]
    [InlineData(b2Shape.e_circleShape, 3, 2, true)]
    [InlineData(b2Shape.e_circleShape, 2, 3, true)]
    [InlineData(b2Shape.e_circleShape, 3.001f, 2, false)]
    [InlineData(b2Shape.e_circleShape, 2.8f, 2.8f, false)]
    [InlineData(b2Shape.e_polygonShape, 3, 2, true)]
    [InlineData(b2Shape.e_polygonShape, 2, 1, true)]
    [InlineData(b2Shape.e_polygonShape, 3, 3, true)]
    [InlineData(b2Shape.e_polygonShape, 3.001f, 2, false)]
    public void TestPoint_OnTheRim_IsInside(int kind, float x, float y, bool inside)
    {
        b2Shape shape = Bench.Body(Bench.World(0), 2, 2, Def(kind)).GetShapeList()!;

        Assert.Equal(inside, shape.TestPoint(shape.GetBody()!.GetXForm(), new b2Vec2(x, y)));
    }

    [Theory]
    [InlineData(b2Shape.e_circleShape)]
    [InlineData(b2Shape.e_polygonShape)]
    public void Questions_WithABadArgument_NameIt(int kind)
    {
        b2Shape shape = Bench.Body(Bench.World(0), 2, 2, Def(kind)).GetShapeList()!;
        b2XForm pose = shape.GetBody()!.GetXForm();
        b2AABB box = new();
        string? Null(Action call) => Assert.Throws<ArgumentNullException>(call).ParamName;

        Assert.Equal("xf", Null(() => shape.TestPoint(null!, new b2Vec2())));
        Assert.Equal("p", Null(() => shape.TestPoint(pose, null!)));
        Assert.Equal("p", Assert.Throws<ArgumentOutOfRangeException>(() => shape.TestPoint(pose, new b2Vec2(0, float.NaN))).ParamName);
        Assert.Equal("aabb", Null(() => shape.ComputeAABB(null!, pose)));
        Assert.Equal("xf", Null(() => shape.ComputeAABB(box, null!)));
        Assert.Equal("aabb", Null(() => shape.ComputeSweptAABB(null!, pose, pose)));
        Assert.Equal("xf1", Null(() => shape.ComputeSweptAABB(box, null!, pose)));
        Assert.Equal("xf2", Null(() => shape.ComputeSweptAABB(box, pose, null!)));
        Assert.Equal((0f, 0f), (box.lowerBound.x, box.upperBound.x));
        if (shape is b2PolygonShape polygon)
        {
            Assert.Equal("xf", Null(() => polygon.GetFirstVertex(null!)));
            Assert.Equal("xf", Null(() => polygon.Centroid(null!)));
            Assert.Equal("xf", Null(() => polygon.Support(null!, 1, 0)));
        }
    }

    /// <summary>A box that was larger, or elsewhere, is set whole.</summary>
    [Fact]
    public void ComputeAABB_IsTheLeastAndGreatestOfTheCorners_AndSweptThatOfTwo()
    {
        Random random = new(94);
        foreach (PlacedShape placed in PlacedShape.Polygons(95, 200).Concat(PlacedShape.Circles(96, 100)))
        {
            b2Vec2 place = new((float)PlacedShape.Number(random, -9, 9), (float)PlacedShape.Number(random, -9, 9));
            b2XForm end = new(place, new b2Mat22(2));
            (double X, double Y)[] corners = placed.Radius > 0 ? Around(placed.World(placed.Center), placed.Radius) : placed.WorldCorners();
            (double X, double Y)[] moved = [.. (placed.Radius > 0 ? [placed.Center] : placed.Corners)
                .Select(c => PlacedShape.Turned(c, 2))
                .Select(c => (X: end.position.x + c.X, Y: end.position.y + c.Y))
                .SelectMany(c => placed.Radius > 0 ? Around(c, placed.Radius) : [c])];
            foreach (float old in new[] { -50f, 0, 50 })
            {
                b2AABB box = new() { lowerBound = new b2Vec2(old, old), upperBound = new b2Vec2(-old, -old) };
                b2AABB swept = new() { lowerBound = new b2Vec2(old, old), upperBound = new b2Vec2(-old, -old) };
                placed.Shape.ComputeAABB(box, placed.Body.GetXForm());
                placed.Shape.ComputeSweptAABB(swept, placed.Body.GetXForm(), end);

                AssertBox(corners, box);
                AssertBox([.. corners, .. moved], swept);
            }
        }
    }

    [Fact]
    public void ComputeAABB_WithTheQuirk_IsTheBoxAroundTheTurnedBox()
    {
        foreach (PlacedShape placed in PlacedShape.Polygons(97, 100))
        {
            placed.Body.GetWorld().Quirks = Box2DFlash202Quirks.BoxOfTurnedBox;
            b2AABB box = new() { lowerBound = new b2Vec2(50, 50), upperBound = new b2Vec2(-50, -50) };
            placed.Shape.ComputeAABB(box, placed.Body.GetXForm());

            AssertBox([.. CornersOf(placed.Polygon.GetOBB()).Select(placed.World)], box);
        }
    }

    [Fact]
    public void Corners_NormalsAndCentroid_AreThoseOfTheOutline()
    {
        foreach (PlacedShape placed in PlacedShape.Polygons(98, 200))
        {
            b2PolygonShape polygon = placed.Polygon;
            (double X, double Y)[] c = placed.Corners;
            Assert.Equal(c.Length, polygon.GetVertexCount());
            Assert.Equal(c.Select(p => ((float)p.X, (float)p.Y)), polygon.GetVertices().Select(v => (v.x, v.y)));
            Assert.Equal(c.Length, polygon.GetNormals().Length);
            for (int i = 0; i < c.Length; i++)
            {
                (double X, double Y) b = c[(i + 1) % c.Length];
                double side = PlacedShape.Distance(c[i], b);
                AssertAt(((b.Y - c[i].Y) / side, (c[i].X - b.X) / side), polygon.GetNormals()[i]);
            }

            AssertAt(placed.WorldCorners()[0], polygon.GetFirstVertex(placed.Body.GetXForm()));
            b2Vec2 centroid = polygon.GetCentroid();
            AssertAt(placed.World((centroid.x, centroid.y)), polygon.Centroid(placed.Body.GetXForm()));
        }
    }

    /// <summary>What is handed out can be changed and the shape stays as it is.</summary>
    [Fact]
    public void Corners_NormalsCoreAndBoxes_AreCopies()
    {
        b2World world = Bench.World(0);
        world.Quirks = Box2DFlash202Quirks.BoxOfTurnedBox;
        b2PolygonShape polygon = (b2PolygonShape)Bench.Dynamic(world, 0, 0).GetShapeList()!;
        foreach (b2Vec2 v in polygon.GetVertices().Concat(polygon.GetNormals()).Concat(polygon.GetCoreVertices()))
        {
            v.Set(9, 9);
        }

        polygon.GetCentroid().Set(9, 9);
        polygon.GetOBB().extents.Set(9, 9);
        b2AABB box = new();
        polygon.ComputeAABB(box, polygon.GetBody()!.GetXForm());

        Assert.Equal((0.5f, 0f, 0.5f), (polygon.GetVertices()[2].x, polygon.GetNormals()[0].x, box.upperBound.x));
        Assert.Equal((0.46f, 0f, 0.5f), (polygon.GetCoreVertices()[2].x, polygon.GetCentroid().x, polygon.GetOBB().extents.x));
    }

    /// <summary>Each core corner is where the two sides beside it cross, moved inwards by the slop.</summary>
    [Fact]
    public void Core_LiesTheSlopInsideEachSide_AndSupportIsItsFarthestCorner()
    {
        Random random = new(99);
        foreach (PlacedShape placed in PlacedShape.Polygons(100, 200))
        {
            (double X, double Y)[] core = Core(placed.Corners);
            b2Vec2[] found = placed.Polygon.GetCoreVertices();
            Assert.Equal(core.Length, found.Length);
            for (int i = 0; i < core.Length; i++)
            {
                AssertAt(core[i], found[i]);
            }

            for (int i = 0; i < 20; i++)
            {
                (double X, double Y) d = (PlacedShape.Number(random, -1, 1), PlacedShape.Number(random, -1, 1));
                b2Vec2 support = placed.Polygon.Support(placed.Body.GetXForm(), (float)d.X, (float)d.Y);
                (double X, double Y)[] world = [.. core.Select(placed.World)];
                Assert.Equal(world.Max(v => (v.X * d.X) + (v.Y * d.Y)), (support.x * d.X) + (support.y * d.Y), Rounding);
                Assert.True(world.Min(v => PlacedShape.Distance(v, (support.x, support.y))) < Rounding);
            }
        }
    }

    /// <summary>Of corners that lie equally far the first one counts, as in the original.</summary>
    [Theory]
    [InlineData(1, 0, 0.5f, -0.5f)]
    [InlineData(0, 1, 0.5f, 0.5f)]
    [InlineData(-1, 0, -0.5f, -0.5f)]
    [InlineData(0, -1, -0.5f, -0.5f)]
    [InlineData(-1, 1, -0.5f, 0.5f)]
    public void Support_OfEqualCorners_IsTheFirst(float dX, float dY, float x, float y)
    {
        b2PolygonShape box = (b2PolygonShape)Bench.Dynamic(Bench.World(0), 0, 0).GetShapeList()!;
        b2Vec2 support = box.Support(box.GetBody()!.GetXForm(), dX, dY);
        float part = 1 - (2 * b2Settings.b2_toiSlop);

        AssertAt((part * x, part * y), support);
    }

    [Fact]
    public void SweepRadius_IsTheFarthestOfTheCoreFromTheCentreOfMass()
    {
        foreach (PlacedShape placed in PlacedShape.Polygons(101, 100).Concat(PlacedShape.Circles(102, 50)))
        {
            placed.Body.SetMass(new b2MassData { mass = 1, I = 1, center = new b2Vec2(0.5f, -1.5f) });
            double Farthest((double X, double Y) from) => placed.Radius > 0
                ? PlacedShape.Distance(placed.Center, from) + placed.Radius - b2Settings.b2_toiSlop
                : Core(placed.Corners).Max(c => PlacedShape.Distance(c, from));

            Assert.Equal(Farthest((0.5, -1.5)), placed.Shape.GetSweepRadius(), Rounding);
            placed.Body.DestroyShape(placed.Shape);

            // Without a body it is from the origin.
            Assert.Equal(Farthest((0, 0)), placed.Shape.GetSweepRadius(), Rounding);
        }
    }

    /// <summary>The turned box touches on all four sides, and no box of any other turn is smaller.</summary>
    [Fact]
    public void TurnedBox_HoldsThePolygonAndIsTheSmallest()
    {
        foreach (PlacedShape placed in PlacedShape.Polygons(103, 200))
        {
            b2OBB obb = placed.Polygon.GetOBB();
            b2OBB same = new();
            b2Vec2[] vertices = placed.Polygon.GetVertices();
            b2PolygonShape.ComputeOBB(same, [.. vertices, new b2Vec2(99, 99)], vertices.Length);
            Assert.Equal((obb.center.x, obb.center.y, obb.R.col1.x), (same.center.x, same.center.y, same.R.col1.x));
            Assert.Equal((obb.extents.x, obb.extents.y, obb.R.col2.x), (same.extents.x, same.extents.y, same.R.col2.x));

            (double X, double Y) u = (obb.R.col1.x, obb.R.col1.y);
            AssertAt((-u.Y, u.X), obb.R.col2);
            double[] along = [.. placed.Corners.Select(c => ((c.X - obb.center.x) * u.X) + ((c.Y - obb.center.y) * u.Y))];
            double[] across = [.. placed.Corners.Select(c => ((c.Y - obb.center.y) * u.X) - ((c.X - obb.center.x) * u.Y))];
            Assert.Equal(
                (-obb.extents.x, obb.extents.x, -obb.extents.y, obb.extents.y),
                (along.Min(), along.Max(), across.Min(), across.Max()),
                (a, b) => Near(a.Item1, b.Item1) && Near(a.Item2, b.Item2) && Near(a.Item3, b.Item3) && Near(a.Item4, b.Item4));
            double smallest = Enumerable.Range(0, 180).Min(i => Area(placed.Corners, i * Math.PI / 360));
            Assert.True(4 * obb.extents.x * obb.extents.y < smallest + (10 * Rounding));
        }
    }

    [Fact]
    public void TurnedBox_OfABox_IsItself()
    {
        b2PolygonDef def = new();
        def.SetAsOrientedBox(0.5f, 2, new b2Vec2(3, 4), 0.3f);
        b2OBB obb = new();
        b2PolygonShape.ComputeOBB(obb, def.vertices, def.vertexCount);

        AssertAt((3, 4), obb.center);
        AssertAt((0.5, 2), obb.extents);
        AssertAt((Math.Cos(0.3f), Math.Sin(0.3f)), obb.R.col1);
        Assert.Equal("obb", Assert.Throws<ArgumentNullException>(() => b2PolygonShape.ComputeOBB(null!, def.vertices, 4)).ParamName);
        Assert.Equal("vs", Assert.Throws<ArgumentNullException>(() => b2PolygonShape.ComputeOBB(obb, null!, 4)).ParamName);
        Assert.Throws<ArgumentException>(() => b2PolygonShape.ComputeOBB(obb, def.vertices, 2));
    }

    private static b2ShapeDef Def(int kind) => kind == b2Shape.e_circleShape ? new b2CircleDef() : Bench.BoxDef(1, 1, 0);

    private static bool Near(double a, double b) => Math.Abs(a - b) < Rounding;

    private static (double X, double Y)[] Around((double X, double Y) c, double radius) =>
        [(c.X - radius, c.Y - radius), (c.X + radius, c.Y + radius)];

    private static (double X, double Y)[] CornersOf(b2OBB obb) => [.. new[] { (-1, -1), (1, -1), (1, 1), (-1, 1) }.Select(s => (
        obb.center.x + ((double)obb.R.col1.x * s.Item1 * obb.extents.x) + ((double)obb.R.col2.x * s.Item2 * obb.extents.y),
        obb.center.y + ((double)obb.R.col1.y * s.Item1 * obb.extents.x) + ((double)obb.R.col2.y * s.Item2 * obb.extents.y)))];

    /// <summary>By the angle at each corner: along its half, as far as the slop needs.</summary>
    private static (double X, double Y)[] Core((double X, double Y)[] corners) => [.. corners.Select((c, i) =>
    {
        (double X, double Y) a = corners[(i + corners.Length - 1) % corners.Length];
        (double X, double Y) b = corners[(i + 1) % corners.Length];
        double toNext = Math.Atan2(b.Y - c.Y, b.X - c.X);
        double toLast = Math.Atan2(a.Y - c.Y, a.X - c.X);
        double half = 0.5 * ((toLast - toNext + (4 * Math.PI)) % (2 * Math.PI));
        double way = b2Settings.b2_toiSlop / Math.Sin(half);
        return (c.X + (way * Math.Cos(toNext + half)), c.Y + (way * Math.Sin(toNext + half)));
    })];

    private static double Area((double X, double Y)[] corners, double angle)
    {
        (double X, double Y)[] c = [.. corners.Select(p => PlacedShape.Turned(p, angle))];
        return (c.Max(p => p.X) - c.Min(p => p.X)) * (c.Max(p => p.Y) - c.Min(p => p.Y));
    }

    private static void AssertBox((double X, double Y)[] corners, b2AABB box)
    {
        AssertAt((corners.Min(c => c.X), corners.Min(c => c.Y)), box.lowerBound);
        AssertAt((corners.Max(c => c.X), corners.Max(c => c.Y)), box.upperBound);
    }

    private static void AssertAt((double X, double Y) expected, b2Vec2 found)
    {
        Assert.Equal(expected.X, found.x, Rounding);
        Assert.Equal(expected.Y, found.y, Rounding);
    }
}
