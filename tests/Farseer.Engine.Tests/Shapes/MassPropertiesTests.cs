using System;
using System.Numerics;
using Farseer.Engine.Shapes;
using Xunit;

namespace Farseer.Engine.Tests.Shapes;

public class MassPropertiesTests
{
    [Fact]
    public void OfOutline_Rectangle_IsTheClosedForm()
    {
        Vector2[] box = ShapeBuilder.Box(4, 2).Pieces[0].Vertices;
        MassProperties far = MassProperties.OfOutline(Array.ConvertAll(box, v => v + new Vector2(1024, -2048)));
        Assert.Equal(8, far.Area, 1e-12);
        Assert.Equal(1024, far.CentroidX, 1e-9);
        Assert.Equal(-2048, far.CentroidY, 1e-9);
        Assert.Equal(8 * (16 + 4) / 12.0, far.SecondMoment, 1e-10);
        Array.Reverse(box);
        Assert.Equal(8 * (16 + 4) / 12.0, MassProperties.OfOutline(box).SecondMoment, 1e-12);
    }

    [Fact]
    public void OfOutline_Concave_IsTheSumOfItsParts()
    {
        // An L of two rectangles: 2×1 about (1, 0.5) and 1×1 about (0.5, 1.5).
        MassProperties l = MassProperties.OfOutline(ShapeBuilderTests.Named("L"));
        Assert.Equal(3, l.Area, 1e-12);
        double cx = ((2 * 1) + (1 * 0.5)) / 3;
        double cy = ((2 * 0.5) + (1 * 1.5)) / 3;
        Assert.Equal(cx, l.CentroidX, 1e-12);
        Assert.Equal(cy, l.CentroidY, 1e-12);
        double first = (2 * 5 / 12.0) + (2 * (Square(1 - cx) + Square(0.5 - cy)));
        double second = (2 / 12.0) + Square(0.5 - cx) + Square(1.5 - cy);
        Assert.Equal(first + second, l.SecondMoment, 1e-12);
    }

    [Fact]
    public void OfCircleAndCapsule_MatchAFineOutline()
    {
        const int corners = 20000;
        var circle = new Vector2[corners];
        var capsule = new Vector2[corners];
        for (int i = 0; i < corners; i++)
        {
            double angle = (2 * Math.PI * i / corners) - (0.5 * Math.PI);
            circle[i] = new Vector2((float)Math.Cos(angle), (float)Math.Sin(angle));
            capsule[i] = circle[i] + new Vector2(i < corners / 2 ? 1.5f : -1.5f, 0);
        }

        // The chords leave out a share of about (2π/n)²/6 ≈ 2e-8, the float corners are off by 6e-8.
        MassProperties fine = MassProperties.OfOutline(circle);
        MassProperties exact = MassProperties.OfCircle(1);
        Assert.Equal(exact.Area, fine.Area, 1e-6);
        Assert.Equal(exact.SecondMoment, fine.SecondMoment, 1e-6);
        fine = MassProperties.OfOutline(capsule);
        exact = MassProperties.OfCapsule(new Vector2(-1.5f, 0), new Vector2(1.5f, 0), 1);
        Assert.Equal(exact.Area, fine.Area, 2e-6);
        Assert.Equal(exact.SecondMoment, fine.SecondMoment, 1e-5);
        Assert.Equal(exact.CentroidX, fine.CentroidX, 1e-6);
    }

    private static double Square(double x) => x * x;
}
