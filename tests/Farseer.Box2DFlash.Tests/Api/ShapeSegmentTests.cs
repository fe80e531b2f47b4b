using System;
using System.Linq;
using Box2D.Collision;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

/// <summary>Where a line first meets a circle or a polygon: by exact numbers at the limits of the rule, else by another search.</summary>
public sealed class ShapeSegmentTests
{
    /// <summary>A circle of radius 1 about the origin: the touching and the ends that numbers hold exactly.</summary>
    [Theory]
    [InlineData("across", new[] { -3f, 0, 1, 0 }, 1, 0.5f, -1, 0)]
    [InlineData("from below", new[] { 0f, -3, 0, 1 }, 1, 0.5f, 0, -1)]
    [InlineData("the share just reaches it", new[] { -3f, 0, 1, 0 }, 0.5f, 0.5f, -1, 0)]
    [InlineData("the share ends short", new[] { -3f, 0, 1, 0 }, 0.49f, null, 0, 0)]
    [InlineData("ends on the rim", new[] { -3f, 0, -1, 0 }, 1, 1f, -1, 0)]
    [InlineData("ends short", new[] { -3f, 0, -1.01f, 0 }, 1, null, 0, 0)]
    [InlineData("touches the top", new[] { -2f, 1, 2, 1 }, 1, 0.5f, 0, 1)]
    [InlineData("passes over", new[] { -2f, 1.01f, 2, 1.01f }, 1, null, 0, 0)]
    [InlineData("starts on the rim inwards", new[] { -1f, 0, 1, 0 }, 1, 0f, -1, 0)]
    [InlineData("starts on the rim outwards", new[] { -1f, 0, -3, 0 }, 1, null, 0, 0)]
    [InlineData("starts inside", new[] { -0.9f, 0, 3, 0 }, 1, null, 0, 0)]
    [InlineData("goes away", new[] { -3f, 0, -5, 0 }, 1, null, 0, 0)]
    [InlineData("a point outside", new[] { -2f, 0, -2, 0 }, 1, null, 0, 0)]
    [InlineData("a point on the rim", new[] { -1f, 0, -1, 0 }, 1, null, 0, 0)]
    [InlineData("a point inside", new[] { 0f, 0, 0, 0 }, 1, null, 0, 0)]
    public void Circle_AgainstALine_TellsShareAndNormalOrLeavesThem(
        string name, float[] line, float most, float? share, float nx, float ny) =>
        Check(new b2CircleDef { radius = 1 }, name, line, most, share, (nx, ny));

    /// <summary>A box of half size 1. A line that starts on a side does not meet it, as in the original.</summary>
    [Theory]
    [InlineData("across", new[] { -3f, 0, 1, 0 }, 1, 0.5f, -1, 0)]
    [InlineData("from below", new[] { 0f, -3, 0, 1 }, 1, 0.5f, 0, -1)]
    [InlineData("from the right", new[] { 3f, 0, -1, 0 }, 1, 0.5f, 1, 0)]
    [InlineData("from above", new[] { 0f, 3, 0, -1 }, 1, 0.5f, 0, 1)]
    [InlineData("the share just reaches it", new[] { -3f, 0, 1, 0 }, 0.5f, 0.5f, -1, 0)]
    [InlineData("the share ends short", new[] { -3f, 0, 1, 0 }, 0.49f, null, 0, 0)]
    [InlineData("ends on the side", new[] { -3f, 0, -1, 0 }, 1, 1f, -1, 0)]
    [InlineData("ends short", new[] { -3f, 0, -1.01f, 0 }, 1, null, 0, 0)]
    [InlineData("along the top", new[] { -3f, 1, 1, 1 }, 1, 0.5f, -1, 0)]
    [InlineData("above", new[] { -3f, 1.01f, 1, 1.01f }, 1, null, 0, 0)]
    [InlineData("below", new[] { -3f, -1.01f, 1, -1.01f }, 1, null, 0, 0)]
    [InlineData("touches a corner", new[] { 0f, 2, -2, 0 }, 1, 0.5f, 0, 1)]
    [InlineData("passes the corner", new[] { 0f, 2.01f, -2, 0.01f }, 1, null, 0, 0)]
    [InlineData("past one side, through the next", new[] { -3f, -2, 1, 2 }, 1, 0.5f, -1, 0)]
    [InlineData("past the next, through one side", new[] { -2f, -3, 2, 1 }, 1, 0.5f, 0, -1)]
    [InlineData("starts on a side inwards", new[] { -1f, 0, 1, 0 }, 1, null, 0, 0)]
    [InlineData("starts on a side outwards", new[] { -1f, 0, -3, 0 }, 1, null, 0, 0)]
    [InlineData("starts inside", new[] { 0f, 0, 3, 0 }, 1, null, 0, 0)]
    [InlineData("starts and ends inside", new[] { 0f, 0, 0.5f, 0.5f }, 1, null, 0, 0)]
    [InlineData("goes away", new[] { -3f, 0, -5, 0 }, 1, null, 0, 0)]
    [InlineData("a point outside", new[] { -2f, 0, -2, 0 }, 1, null, 0, 0)]
    [InlineData("a point inside", new[] { 0f, 0, 0, 0 }, 1, null, 0, 0)]
    public void Box_AgainstALine_TellsShareAndNormalOrLeavesThem(
        string name, float[] line, float most, float? share, float nx, float ny) =>
        Check(Bench.BoxDef(1, 1, 0), name, line, most, share, (nx, ny));

    [Fact]
    public void Circle_OfATurnedBody_IsMetWhereTheFootOfItsCentreSays()
    {
        Random random = new(72);
        int hits = 0;
        foreach (PlacedShape placed in PlacedShape.Circles(73, 1500))
        {
            (double X, double Y) o = placed.World(placed.Center);
            ((double X, double Y) p, (double X, double Y) q, float most) = Line(random, o);
            double length = PlacedShape.Distance(p, q);
            double foot = (((o.X - p.X) * (q.X - p.X)) + ((o.Y - p.Y) * (q.Y - p.Y))) / length;
            double aside = PlacedShape.Cross(p, q, o) / length;
            double chord = (placed.Radius * placed.Radius) - (aside * aside);
            double share = chord < 0 ? double.NaN : (foot - Math.Sqrt(chord)) / length;

            // What single precision may judge either way is left out, and grazing lines, where a little error moves the place a lot.
            if (Math.Abs(chord) < 0.05 || Math.Abs(share) < 1e-4 || Math.Abs(share - most) < 1e-4)
            {
                continue;
            }

            bool expected = share > 0 && share < most;
            (double X, double Y) at = (p.X + (share * (q.X - p.X)), p.Y + (share * (q.Y - p.Y)));
            Compare(placed, p, q, most, expected, share, ((at.X - o.X) / placed.Radius, (at.Y - o.Y) / placed.Radius));
            hits += expected ? 1 : 0;
        }

        Assert.InRange(hits, 100, 1400);
    }

    [Fact]
    public void Polygon_OfATurnedBody_IsMetAtTheFirstSideThatTheLineCrosses()
    {
        Random random = new(74);
        int hits = 0;
        foreach (PlacedShape placed in PlacedShape.Polygons(75, 3000))
        {
            (double X, double Y)[] corners = placed.WorldCorners();
            ((double X, double Y) p, (double X, double Y) q, float most) = Line(random, placed.World(placed.Corners[0]));
            double share = double.PositiveInfinity;
            (double X, double Y) normal = (0, 0);
            bool inside = true;
            bool unsure = false;
            for (int i = 0; i < corners.Length; i++)
            {
                (double X, double Y) a = corners[i];
                (double X, double Y) b = corners[(i + 1) % corners.Length];
                double side = PlacedShape.Distance(a, b);
                double before = PlacedShape.Cross(a, b, p) / side;
                double after = PlacedShape.Cross(a, b, q) / side;
                double left = PlacedShape.Cross(p, q, a) / PlacedShape.Distance(p, q);
                double right = PlacedShape.Cross(p, q, b) / PlacedShape.Distance(p, q);
                inside &= before > 0;

                // As for circles: near a corner, with an end near a side, or along a side.
                unsure |= Math.Abs(before) < 1e-3 || Math.Abs(left) < 1e-3 || Math.Abs(before - after) < 0.05 * PlacedShape.Distance(p, q);
                double t = before / (before - after);
                unsure |= Math.Abs(t - most) < 1e-3;
                if (before < 0 && after > before && left * right < 0 && t > 0 && t < share)
                {
                    share = t;
                    normal = ((b.Y - a.Y) / side, (a.X - b.X) / side);
                }
            }

            if (unsure)
            {
                continue;
            }

            bool expected = !inside && share < most;
            Compare(placed, p, q, most, expected, share, normal);
            hits += expected ? 1 : 0;
        }

        Assert.InRange(hits, 200, 2800);
    }

    [Theory]
    [InlineData(b2Shape.e_circleShape)]
    [InlineData(b2Shape.e_polygonShape)]
    public void TestSegment_WithABadArgument_NamesIt(int kind)
    {
        b2Body body = Bench.World(0).CreateBody(new b2BodyDef());
        b2Shape shape = body.CreateShape(kind == b2Shape.e_circleShape ? new b2CircleDef() : Bench.BoxDef(1, 1, 0));
        b2XForm pose = body.GetXForm();
        float[] lambda = new float[1];
        b2Vec2 normal = new();
        b2Vec2 bad = new(0, float.NaN);
        b2Segment line = new() { p1 = new b2Vec2(-3, 0), p2 = new b2Vec2(1, 0) };
        string? Name<T>(b2XForm xf, float[] l, b2Vec2 n, b2Segment s, float most)
            where T : ArgumentException => Assert.Throws<T>(() => shape.TestSegment(xf, l, n, s, most)).ParamName;

        Assert.Equal("xf", Name<ArgumentNullException>(null!, lambda, normal, line, 1));
        Assert.Equal("lambda", Name<ArgumentNullException>(pose, null!, normal, line, 1));
        Assert.Equal("lambda", Name<ArgumentException>(pose, [], normal, line, 1));
        Assert.Equal("normal", Name<ArgumentNullException>(pose, lambda, null!, line, 1));
        Assert.Equal("segment", Name<ArgumentNullException>(pose, lambda, normal, null!, 1));
        Assert.Equal("segment", Name<ArgumentOutOfRangeException>(pose, lambda, normal, new b2Segment { p1 = bad }, 1));
        Assert.Equal("segment", Name<ArgumentOutOfRangeException>(pose, lambda, normal, new b2Segment { p2 = bad }, 1));
        Assert.Equal("maxLambda", Name<ArgumentOutOfRangeException>(pose, lambda, normal, line, float.NaN));
    }

    private static void Check(b2ShapeDef def, string name, float[] line, float most, float? share, (float X, float Y) normal)
    {
        b2Body body = Bench.World(0).CreateBody(new b2BodyDef());
        b2Shape shape = body.CreateShape(def);
        float[] lambda = [7];
        b2Vec2 found = new(8, 9);
        b2Segment segment = new() { p1 = new b2Vec2(line[0], line[1]), p2 = new b2Vec2(line[2], line[3]) };
        bool hit = shape.TestSegment(body.GetXForm(), lambda, found, segment, most);

        Assert.Equal((name, share is not null, share ?? 7), (name, hit, lambda[0]));
        Assert.Equal(share is null ? (8, 9) : normal, (found.x, found.y));
    }

    private static void Compare(
        PlacedShape placed,
        (double X, double Y) p,
        (double X, double Y) q,
        float most,
        bool expected,
        double share,
        (double X, double Y) normal)
    {
        float[] lambda = [7];
        b2Vec2 found = new(8, 9);
        b2Segment segment = new() { p1 = PlacedShape.V(p), p2 = PlacedShape.V(q) };
        bool hit = placed.Shape.TestSegment(placed.Body.GetXForm(), lambda, found, segment, most);

        Assert.Equal(expected, hit);

        // Places within 20 m and the turn are of single precision, 2e-6 m; lines are 1 m and longer, and their slant makes it ten
        // times that.
        Assert.Equal(hit ? share : 7, lambda[0], 5e-5);
        Assert.Equal(hit ? normal.X : 8, found.x, 2e-4);
        Assert.Equal(hit ? normal.Y : 9, found.y, 2e-4);
    }

    /// <summary>A line of 1 to 12 m that comes near a place, of numbers that single precision holds.</summary>
    private static ((double X, double Y) P, (double X, double Y) Q, float Most) Line(Random random, (double X, double Y) near)
    {
        double angle = PlacedShape.Number(random, -4, 4);
        double back = PlacedShape.Number(random, 0, 6);
        double ahead = PlacedShape.Number(random, 1, 6);
        double aside = PlacedShape.Number(random, -2, 2);
        double[] v = [.. new[] { PlacedShape.Turned((-back, aside), angle), PlacedShape.Turned((ahead, aside), angle) }
            .SelectMany(d => new[] { (double)(float)(near.X + d.X), (double)(float)(near.Y + d.Y) })];
        return ((v[0], v[1]), (v[2], v[3]), (float)PlacedShape.Number(random, 0.3, 1));
    }
}
