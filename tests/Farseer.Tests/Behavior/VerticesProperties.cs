using System;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Mathematics;
using FsCheck;
using FsCheck.Fluent;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Laws of outlines, tried on random star-shaped polygons of many sizes, in both orders, convex and not.</summary>
public class VerticesProperties
{
    /// <summary>
    /// Coordinates are rounded to float when a shape is moved or turned, which changes its area and inertia by some units of
    /// 6e-8 times (distance from the origin / size), here at most 50.
    /// </summary>
    private const double Tolerance = 2e-5;

    [Fact]
    public void Area_UnderTranslationRotationAndScaling_FollowsTheLaws() => Check(shape =>
    {
        var area = shape.Outline.GetArea();
        Assert.True(area > 0f);
        Near(area, Moved(shape).GetArea(), area);
        Near(area, Turned(shape).GetArea(), area);
        Near(area * shape.Scale.X * (double)shape.Scale.Y, Scaled(shape).GetArea(), area * shape.Scale.X * shape.Scale.Y);
    });

    [Fact]
    public void Centroid_UnderTranslationRotationAndScaling_GoesAlong() => Check(shape =>
    {
        var centroid = shape.Outline.GetCentroid();
        Near(centroid + shape.Shift, Moved(shape).GetCentroid(), shape.Radius);
        var turned = centroid;
        Calculator.RotateVector(ref turned, shape.Angle);
        Near(turned, Turned(shape).GetCentroid(), shape.Radius);
        Near(centroid * shape.Scale, Scaled(shape).GetCentroid(), shape.Radius * Math.Max(shape.Scale.X, shape.Scale.Y));
    });

    [Fact]
    public void MomentOfInertia_UnderTranslationRotationAndScaling_FollowsTheLaws() => Check(shape =>
    {
        var inertia = shape.Outline.GetMomentOfInertia();
        Assert.True(inertia > 0f);
        Near(inertia, Moved(shape).GetMomentOfInertia(), inertia);
        Near(inertia, Turned(shape).GetMomentOfInertia(), inertia);
        var uniform = new Vertices(shape.Outline);
        uniform.Scale(new Vector2(shape.Scale.X));
        Near(inertia * Math.Pow(shape.Scale.X, 2), uniform.GetMomentOfInertia(), inertia * Math.Pow(shape.Scale.X, 2));
    });

    [Fact]
    public void MassProperties_OfConcaveOutline_AreThoseOfItsTwoHalves() => Check(shape =>
    {
        // A star shape about the origin is cut along the vectors to vertices 0 and k; its parts and the whole must agree.
        var outline = shape.Outline;
        var k = outline.Count / 2;
        var first = new Vertices(outline.Take(k + 1).Append(Vector2.Zero).ToArray());
        var second = new Vertices(outline.Skip(k).Append(outline[0]).Append(Vector2.Zero).ToArray());
        double a = first.GetSignedArea(), b = second.GetSignedArea();
        Near(outline.GetSignedArea(), a + b, outline.GetArea());
        var centre = outline.GetCentroid();
        var d = Vector2.DistanceSquared(first.GetCentroid(), centre);
        var e = Vector2.DistanceSquared(second.GetCentroid(), centre);
        var inertia = ((a * (first.GetMomentOfInertia() + d)) + (b * (second.GetMomentOfInertia() + e))) / (a + b);
        Near(inertia, outline.GetMomentOfInertia(), shape.Radius * (double)shape.Radius);
    });

    [Fact]
    public void Winding_WhenForced_IsCounterClockWiseAndKeepsThePoints() => Check(shape =>
    {
        var forced = new Vertices(shape.Outline);
        forced.ForceCounterClockWiseOrder();
        Assert.True(forced.IsCounterClockWise());
        Assert.True(forced.SequenceEqual(shape.Outline) || forced.SequenceEqual(Enumerable.Reverse(shape.Outline)));
        var mirrored = new Vertices(forced);
        mirrored.Scale(new Vector2(-1, 1));
        Assert.False(mirrored.IsCounterClockWise());
        Assert.Equal(forced.GetArea(), mirrored.GetArea());
        Assert.True(forced.IsSimple());
    });

    [Fact]
    [ManualRow("F308")]
    public void SubDivideEdges_OfAnyShape_LeavesNoLongEdgeAndKeepsTheShape() => Check(shape =>
    {
        var length = shape.Radius * shape.Fraction;
        var divided = new Vertices(shape.Outline);
        divided.SubDivideEdges(length);

        // The rounding of a new point is half a unit of the last place of its coordinates, 6e-8 of the radius.
        var slack = 4e-7 * shape.Radius;
        for (var i = 0; i < divided.Count; i++)
        {
            Assert.True(divided.GetEdge(i).Length() <= length + slack);
        }

        // All old vertices are there in order, and every new one is on the edge between them.
        var old = 0;
        for (var i = 0; i < divided.Count; i++)
        {
            if (old < shape.Outline.Count && divided[i] == shape.Outline[old])
            {
                old++;
                continue;
            }

            var from = shape.Outline[old - 1];
            var to = shape.Outline[old % shape.Outline.Count];
            Assert.True(Calculator.DistanceBetweenPointAndLineSegment(divided[i], from, to) <= slack);
        }

        Assert.Equal(shape.Outline.Count, old);
        Near(shape.Outline.GetArea(), divided.GetArea(), shape.Outline.GetArea());
        Near(shape.Outline.GetCentroid(), divided.GetCentroid(), shape.Radius);
    });

    [Fact]
    public void Aabb_OfAnyShape_IsTheSmallestBoxAroundIt() => Check(shape =>
    {
        var box = new AABB(shape.Outline);
        Assert.All(shape.Outline, vertex => Assert.True(box.Contains(vertex)));
        Assert.Contains(shape.Outline, vertex => vertex.X == box.Min.X);
        Assert.Contains(shape.Outline, vertex => vertex.Y == box.Min.Y);
        Assert.Contains(shape.Outline, vertex => vertex.X == box.Max.X);
        Assert.Contains(shape.Outline, vertex => vertex.Y == box.Max.Y);
        Assert.True(box.Contains(shape.Outline.GetCentroid()));
        Assert.True(AABB.Intersect(box, new AABB(Turned(shape))), "Both contain the origin.");
        var x = Vector2.UnitX;
        shape.Outline.ProjectToAxis(ref x, out var min, out var max);
        Assert.Equal(box.Min.X, min);
        Assert.Equal(box.Max.X, max);
    });

    [Fact]
    public void Everything_ScaledByAPowerOfTwo_ScalesBitForBit() => Check(shape =>
    {
        var big = new Vertices(shape.Outline);
        big.Scale(new Vector2(1024f));
        Assert.Equal(shape.Outline.GetArea() * 1048576f, big.GetArea());
        Assert.Equal(shape.Outline.GetCentroid() * 1024f, big.GetCentroid());
        Assert.Equal(shape.Outline.GetMomentOfInertia() * 1048576f, big.GetMomentOfInertia());
        Assert.Equal(shape.Outline.IsConvex(), big.IsConvex());
        Assert.Equal(shape.Outline.GetEdgeNormal(0), big.GetEdgeNormal(0));
    });

    private static void Check(Action<Shape> law)
    {
        var generator =
            from seed in Gen.Choose(0, int.MaxValue)
            from count in Gen.Choose(3, 24)
            select Shape.Make(seed, count);
        Prop.ForAll(generator.ToArbitrary(), law).QuickCheckThrowOnFailure();
    }

    private static Vertices Moved(Shape shape)
    {
        var moved = new Vertices(shape.Outline);
        moved.Translate(shape.Shift);
        return moved;
    }

    private static Vertices Scaled(Shape shape)
    {
        var scaled = new Vertices(shape.Outline);
        scaled.Scale(shape.Scale);
        return scaled;
    }

    private static Vertices Turned(Shape shape)
    {
        var turned = new Vertices(shape.Outline);
        for (var i = 0; i < turned.Count; i++)
        {
            var vertex = turned[i];
            Calculator.RotateVector(ref vertex, shape.Angle);
            turned[i] = vertex;
        }

        return turned;
    }

    private static void Near(double expected, double actual, double size) =>
        Assert.InRange(actual, expected - (Tolerance * size), expected + (Tolerance * size));

    private static void Near(Vector2 expected, Vector2 actual, double size)
    {
        Near(expected.X, actual.X, size);
        Near(expected.Y, actual.Y, size);
    }

    private sealed record Shape(
        Vertices Outline,
        float Radius,
        Vector2 Shift,
        float Angle,
        Vector2 Scale,
        float Fraction)
    {
        public static Shape Make(int seed, int count)
        {
            var random = new Random(seed);
            var radius = (float)Math.Pow(10, (random.NextDouble() * 8) - 4);
            var outline = new Vertices();
            var start = random.NextDouble() * 6;

            // Evenly spread directions with a jitter of less than half a step, and radii from half to full: always simple.
            for (var i = 0; i < count; i++)
            {
                var angle = start + ((i + (0.4 * (random.NextDouble() - 0.5))) * 2 * Math.PI / count);
                var r = radius * (0.5 + (0.5 * random.NextDouble()));
                outline.Add(new Vector2((float)(r * Math.Cos(angle)), (float)(r * Math.Sin(angle))));
            }

            if (random.Next(2) == 0)
            {
                outline.Reverse();
            }

            float Signed() => (float)((random.NextDouble() * 2) - 1);
            return new Shape(
                outline,
                radius,
                new Vector2(Signed(), Signed()) * radius * 30f,
                Signed() * 4f,
                new Vector2(0.5f + (float)random.NextDouble(), 0.5f + (float)random.NextDouble()),
                0.05f + (float)random.NextDouble());
        }
    }
}
