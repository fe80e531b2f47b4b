using System;
using System.Numerics;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Shapes;
using Farseer.Engine.Tests.Shapes;
using Xunit;

namespace Farseer.Engine.Tests.NarrowPhase;

/// <summary>The pieces of a concave outline together must act as the outline: checked against its exact distance.</summary>
public class ConcaveTests
{
    [Fact]
    public void Collide_CircleOutsideAnyOutline_TouchesTheOutlineOnly()
    {
        var random = new Random(21);
        int contacts = 0;
        for (int n = 0; n < 400; n++)
        {
            Vector2[] star = ShapeBuilderTests.Star(random, random.Next(4, 20));
            const float radius = 0.3f;
            var pair = new PairFixture(ShapeBuilder.Polygon(star), ShapeBuilder.Circle(radius));
            for (int i = 0; i < 50; i++)
            {
                Vector2 center = 1.6f * RandomShape.Point(random);
                float distance = DistanceGrid.NearestDistance(star, center);
                if (distance < 0)
                {
                    continue;
                }

                Manifold[] found = pair.CollideAll(0, 0, center, 0.05f);
                float deepest = float.MaxValue;
                foreach (Manifold m in found)
                {
                    deepest = Math.Min(deepest, m.Point0.Separation);
                    AssertLeadsOut(star, m, radius, center);
                }

                if (distance - radius < 0.049f)
                {
                    contacts++;
                    Assert.Equal(distance - radius, deepest, 1e-5f);
                }
                else if (distance - radius > 0.051f)
                {
                    Assert.Empty(found);
                }
            }
        }

        Assert.True(contacts > 1000);
    }

    [Fact]
    public void Collide_BoxOverAnArch_NeverTurnsAgainstTheSlide()
    {
        // An arch of 24 edges on a flat base, with a notch below: one outline, many pieces.
        var arch = new Vector2[28];
        for (int i = 0; i <= 24; i++)
        {
            double angle = Math.PI * (0.25 + (0.5 * i / 24));
            arch[i] = new Vector2((float)(10 * Math.Cos(angle)), (float)(10 * Math.Sin(angle)));
        }

        arch[25] = new Vector2(arch[24].X, 3);
        arch[26] = new Vector2(0, 6);
        arch[27] = new Vector2(arch[0].X, 3);
        ShapeGeometry shape = ShapeBuilder.Polygon(arch);
        Assert.True(shape.Pieces.Length > 1);
        var pair = new PairFixture(shape, ShapeBuilder.Box(0.5f, 0.5f));
        for (double angle = Math.PI * 0.3; angle < Math.PI * 0.7; angle += 0.0013)
        {
            var outward = new Vector2((float)Math.Cos(angle), (float)Math.Sin(angle));
            Manifold[] found = pair.CollideAll(0, angle - (0.5 * Math.PI), 10.24f * outward, 0.05f);
            Assert.NotEmpty(found);
            foreach (Manifold m in found)
            {
                // Half a bend of the arch is 0.033, the width of the box seen from its centre 0.025.
                Assert.True(Vector2.Dot(m.Normal, outward) > 0.998f, $"at {angle}: {m.Normal} for {outward}");
            }
        }
    }

    [Fact]
    public void Collide_CircleDeepInside_FindsAWayOut()
    {
        var random = new Random(22);
        for (int n = 0; n < 200; n++)
        {
            Vector2[] star = ShapeBuilderTests.Star(random, random.Next(4, 20));
            var pair = new PairFixture(ShapeBuilder.Polygon(star), ShapeBuilder.Circle(0.1f));
            Vector2 center = 0.15f * RandomShape.Point(random);
            foreach (Manifold m in pair.CollideAll(0, 0, center, 0.05f))
            {
                Assert.InRange(m.Normal.Length(), 1 - 1e-6f, 1 + 1e-6f);
            }
        }
    }

    [Fact]
    public void Collide_BoxIntoAnyOutline_IsNeverLost()
    {
        var random = new Random(23);
        int overlaps = 0;
        for (int n = 0; n < 400; n++)
        {
            Vector2[] star = ShapeBuilderTests.Star(random, random.Next(4, 20));
            ShapeGeometry shape = ShapeBuilder.Polygon(star);
            ShapeGeometry box = ShapeBuilder.Box(0.6f, 0.4f);
            var pair = new PairFixture(shape, box);
            for (int i = 0; i < 50; i++)
            {
                Vector2 center = 1.6f * RandomShape.Point(random);
                double angle = random.NextDouble() * 7;
                double depth = Deepest(shape, box, angle, center);
                Manifold[] found = pair.CollideAll(0, angle, center, 0.02f);
                float least = float.MaxValue;
                foreach (Manifold m in found)
                {
                    least = Math.Min(least, m.Point0.Separation);
                    least = m.Count == 2 ? Math.Min(least, m.Point1.Separation) : least;
                }

                if (depth < -0.01)
                {
                    overlaps++;
                    Assert.True(least < 0, $"outline {n}, case {i}: depth {depth}, found {found.Length}, {least}");
                }
            }
        }

        Assert.True(overlaps > 3000);
    }

    private static double Deepest(ShapeGeometry shape, ShapeGeometry box, double angle, Vector2 center)
    {
        double deepest = double.MaxValue;
        ReferenceDistance.Point[] b = ReferenceDistance.Place(box.Pieces[0].Vertices, Math.Cos(angle), Math.Sin(angle), center);
        foreach (PieceGeometry piece in shape.Pieces)
        {
            deepest = Math.Min(deepest, ReferenceDistance.Signed(ReferenceDistance.Place(piece.Vertices, 1, 0, Vector2.Zero), b));
        }

        return deepest;
    }

    private static void AssertLeadsOut(Vector2[] star, Manifold m, float radius, Vector2 center)
    {
        // The claimed point of the outline is there, and the circle really is that far along that normal.
        Vector2 surface = center - (m.Normal * (radius + m.Point0.Separation));
        Assert.True(Math.Abs(DistanceGrid.NearestDistance(star, surface)) < 2e-5f, $"{surface} is not on the outline");
    }
}
