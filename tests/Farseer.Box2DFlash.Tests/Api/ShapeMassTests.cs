using System;
using System.Linq;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

/// <summary>Mass, centre and inertia about the body's origin of a shape, against the integrals over its area.</summary>
public sealed class ShapeMassTests
{
    /// <summary>The sums of the shoelace formula, with all triangles from the origin of the body.</summary>
    [Fact]
    public void ComputeMass_OfAPolygon_IsThatOfTheTrianglesToTheOrigin()
    {
        foreach (PlacedShape placed in PlacedShape.Polygons(81, 300))
        {
            (double X, double Y)[] c = placed.Corners;
            (double area, double x, double y, double moment) = (0, 0, 0, 0);
            for (int i = 0; i < c.Length; i++)
            {
                (double X, double Y) a = c[i];
                (double X, double Y) b = c[(i + 1) % c.Length];
                double cross = (a.X * b.Y) - (a.Y * b.X);
                area += cross / 2;
                x += cross * (a.X + b.X) / 6;
                y += cross * (a.Y + b.Y) / 6;
                moment += cross * ((a.X * a.X) + (a.X * b.X) + (b.X * b.X) + (a.Y * a.Y) + (a.Y * b.Y) + (b.Y * b.Y)) / 12;
            }

            double density = placed.Shape.GetDensity();
            AssertMass(placed.Shape, density * area, x / area, y / area, density * moment);
            b2Vec2[] vertices = placed.Polygon.GetVertices();
            b2Vec2 centroid = b2PolygonShape.ComputeCentroid([.. vertices, new b2Vec2(99, 99)], vertices.Length);

            // Places within 5 m in single precision.
            Assert.Equal(x / area, centroid.x, 1e-6);
            Assert.Equal(y / area, centroid.y, 1e-6);
        }
    }

    /// <summary>No formula at all: the mean of a grid of points in the shape.</summary>
    [Fact]
    public void ComputeMass_OfATriangle_IsTheSumOfFineSquares()
    {
        b2PolygonDef def = new() { density = 2, vertexCount = 3, vertices = [new b2Vec2(1, 1), new b2Vec2(3, 2), new b2Vec2(1.5f, 4)] };
        b2Shape shape = Bench.World(0).CreateBody(new b2BodyDef()).CreateShape(def);
        const double Step = 1.0 / 256;
        (double X, double Y)[] c = [.. def.vertices.Select(v => ((double)v.x, (double)v.y))];
        (double count, double x, double y, double square) = (0, 0, 0, 0);
        for (double px = 1 + (Step / 2); px < 3; px += Step)
        {
            for (double py = 1 + (Step / 2); py < 4; py += Step)
            {
                if (Enumerable.Range(0, 3).All(i => PlacedShape.Cross(c[i], c[(i + 1) % 3], (px, py)) > 0))
                {
                    (count, x, y, square) = (count + 1, x + px, y + py, square + (px * px) + (py * py));
                }
            }
        }

        b2MassData mass = new();
        shape.ComputeMass(mass);

        // Squares that the sides cut count whole or not at all, which evens out but for a thousandth.
        Assert.Equal(1, mass.mass / (2 * count * Step * Step), 1e-3);
        Assert.Equal(x / count, mass.center.x, 1e-3);
        Assert.Equal(y / count, mass.center.y, 1e-3);
        Assert.Equal(1, mass.I / (2 * square * Step * Step), 1e-3);
    }

    [Fact]
    public void ComputeMass_OfACircle_IsThatOfADiscBesideTheOrigin()
    {
        foreach (PlacedShape placed in PlacedShape.Circles(82, 100))
        {
            double mass = placed.Shape.GetDensity() * Math.PI * placed.Radius * placed.Radius;
            (double x, double y) = placed.Center;
            AssertMass(placed.Shape, mass, x, y, mass * ((placed.Radius * placed.Radius / 2) + (x * x) + (y * y)));
        }
    }

    [Theory]
    [InlineData(0, 0, 0)]
    [InlineData(3, -2, 0)]
    [InlineData(-1, 0, 0.7f)]
    [InlineData(0, 2, -2)]
    public void ComputeMass_OfABox_IsTheClosedForm(float x, float y, float angle)
    {
        b2PolygonDef def = new() { density = 3 };
        def.SetAsOrientedBox(0.5f, 1.5f, new b2Vec2(x, y), angle);
        b2Shape shape = Bench.World(0).CreateBody(new b2BodyDef()).CreateShape(def);

        // ρ·w·h; m (w² + h²) / 12, and Steiner's part.
        AssertMass(shape, 9, x, y, 9 * (((1.0 + 9) / 12) + (x * x) + (y * y)));
    }

    [Fact]
    public void ComputeMass_WithoutDensity_IsNone_AndKeepsTheCentre()
    {
        b2PolygonDef def = new();
        def.SetAsOrientedBox(1, 1, new b2Vec2(2, 3));
        AssertMass(Bench.World(0).CreateBody(new b2BodyDef()).CreateShape(def), 0, 2, 3, 0);
    }

    [Fact]
    public void ComputeMassAndCentroid_WithABadArgument_NameIt()
    {
        b2Shape shape = Bench.Dynamic(Bench.World(0), 0, 0).GetShapeList()!;
        b2Vec2[] corners = [new b2Vec2(0, 0), new b2Vec2(1, 0), new b2Vec2(0, 1)];

        Assert.Equal("massData", Assert.Throws<ArgumentNullException>(() => shape.ComputeMass(null!)).ParamName);
        Assert.Equal("vs", Assert.Throws<ArgumentNullException>(() => b2PolygonShape.ComputeCentroid(null!, 3)).ParamName);
        Assert.Throws<ArgumentException>(() => b2PolygonShape.ComputeCentroid(corners, 2));
        Assert.Throws<ArgumentException>(() => b2PolygonShape.ComputeCentroid(corners, 4));
        Assert.Throws<ArgumentException>(() => b2PolygonShape.ComputeCentroid([.. corners.Reverse()], 3));
    }

    private static void AssertMass(b2Shape shape, double mass, double x, double y, double inertia)
    {
        b2MassData found = new() { mass = -1, center = new b2Vec2(-1, -1), I = -1 };
        shape.ComputeMass(found);

        // Results, and the corners of turned boxes, are of single precision.
        Assert.Equal(mass, found.mass, 1e-6 * (1 + mass));
        Assert.Equal(x, found.center.x, 1e-6);
        Assert.Equal(y, found.center.y, 1e-6);
        Assert.Equal(inertia, found.I, 2e-6 * (1 + inertia));
    }
}
