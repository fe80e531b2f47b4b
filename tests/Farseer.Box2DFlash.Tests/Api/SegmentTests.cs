using System;
using Box2D.Collision;
using Box2D.Common.Math;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Api;

/// <summary>A segment finds where another one crosses it from its front, which is the right side of its way.</summary>
public sealed class SegmentTests
{
    /// <summary>All against the line from (0, 0) to (0, 2), whose front is towards positive x, in each of four quarter turns.</summary>
    [Theory]
    [InlineData("across the middle", 3, 1, -1, 1, 1, 0.75f)]
    [InlineData("at a slant", 2, 0, -2, 2, 1, 0.5f)]
    [InlineData("at a slant the other way", 3, 3, -1, -1, 1, 0.75f)]
    [InlineData("from behind", -1, 1, 3, 1, 1, null)]
    [InlineData("through the start", 3, 0, -1, 0, 1, 0.75f)]
    [InlineData("through the end", 3, 2, -1, 2, 1, 0.75f)]
    [InlineData("before the start", 3, -0.01f, -1, -0.01f, 1, null)]
    [InlineData("past the end", 3, 2.01f, -1, 2.01f, 1, null)]
    [InlineData("ends on the line", 3, 1, 0, 1, 1, 1f)]
    [InlineData("ends short of it", 3, 1, 0.01f, 1, 1, null)]
    [InlineData("starts on the line", 0, 1, -1, 1, 1, 0f)]
    [InlineData("starts behind it", -0.01f, 1, -1, 1, 1, null)]
    [InlineData("goes away in front", 1, 1, 3, 1, 1, null)]
    [InlineData("the share just reaches it", 3, 1, -1, 1, 0.75f, 0.75f)]
    [InlineData("the share ends short", 3, 1, -1, 1, 0.74f, null)]
    [InlineData("parallel in front", 1, 0, 1, 2, 1, null)]
    [InlineData("parallel the other way", 1, 2, 1, 0, 1, null)]
    [InlineData("on it", 0, 0, 0, 2, 1, null)]
    [InlineData("a point on it", 0, 1, 0, 1, 1, null)]
    [InlineData("a point in front", 1, 1, 1, 1, 1, null)]
    public void TestSegment_AgainstALine_TellsShareAndNormalOrLeavesThem(
        string name, float x1, float y1, float x2, float y2, float most, float? share)
    {
        for (int turns = 0; turns < 4; turns++)
        {
            float[] lambda = [7];
            b2Vec2 normal = new(8, 9);
            b2Segment line = new() { p1 = Turned(0, 0, turns), p2 = Turned(0, 2, turns) };
            bool hit = line.TestSegment(lambda, normal, Segment(Turned(x1, y1, turns), Turned(x2, y2, turns)), most);

            b2Vec2 front = share is null ? new b2Vec2(8, 9) : Turned(1, 0, turns);
            Assert.Equal((name, share is not null, share ?? 7), (name, hit, lambda[0]));
            Assert.Equal((front.x, front.y), (normal.x, normal.y));
        }
    }

    [Fact]
    public void TestSegment_OfRandomLines_SolvesTheTwoEquations()
    {
        Random random = new(71);
        int hits = 0;
        for (int i = 0; i < 3000; i++)
        {
            double[] v = new double[8];
            for (int k = 0; k < v.Length; k++)
            {
                v[k] = (float)((random.NextDouble() * 10) - 5);
            }

            float most = (float)random.NextDouble();
            (double dx, double dy, double rx, double ry) = (v[2] - v[0], v[3] - v[1], v[6] - v[4], v[7] - v[5]);

            // P + t r = A + s d by Cramer's rule.
            double determinant = (dx * ry) - (dy * rx);
            double t = ((dy * (v[4] - v[0])) - (dx * (v[5] - v[1]))) / determinant;
            double s = ((ry * (v[4] - v[0])) - (rx * (v[5] - v[1]))) / determinant;
            bool front = (dx * (v[5] - v[1])) - (dy * (v[4] - v[0])) < 0;
            bool expected = front && t >= 0 && t <= most && s >= 0 && s <= 1;
            float[] lambda = [7];
            b2Vec2 normal = new(8, 9);
            bool hit = Segment(V(v[0], v[1]), V(v[2], v[3])).TestSegment(lambda, normal, Segment(V(v[4], v[5]), V(v[6], v[7])), most);

            Assert.Equal(expected, hit);
            hits += hit ? 1 : 0;
            double length = Math.Sqrt((dx * dx) + (dy * dy));

            // The results are rounded to single precision.
            Assert.Equal(hit ? t : 7, lambda[0], 1e-6);
            Assert.Equal(hit ? dy / length : 8, normal.x, 1e-6);
            Assert.Equal(hit ? -dx / length : 9, normal.y, 1e-6);
        }

        Assert.InRange(hits, 100, 2900);
    }

    /// <summary>Whether lines are parallel goes by their directions: the smallest ones meet as well.</summary>
    [Theory]
    [InlineData(1, 1e-13f)]
    [InlineData(1e-7f, 1)]
    [InlineData(1e-7f, 1e-7f)]
    [InlineData(1e-13f, 1)]
    [InlineData(1e6f, 1e6f)]
    public void TestSegment_OfAnyLength_Meets(float lineSize, float otherSize)
    {
        for (int turns = 0; turns < 4; turns++)
        {
            float[] lambda = new float[1];
            b2Segment line = Segment(Turned(0, -lineSize, turns), Turned(0, lineSize, turns));
            b2Segment other = Segment(Turned(3 * otherSize, 0, turns), Turned(-otherSize, 0, turns));

            Assert.True(line.TestSegment(lambda, new b2Vec2(), other, 1));

            // The ends of the other line are rounded.
            Assert.Equal(0.75, lambda[0], 1e-6);
        }
    }

    /// <summary>Rounding leaves no gap between two lines that share an end: each reaches out by a ten-millionth of its length.</summary>
    [Theory]
    [InlineData(-2e-7f, 0, 4, true)]
    [InlineData(-8e-7f, 0, 4, false)]
    [InlineData(2e-7f, -4, 0, true)]
    [InlineData(8e-7f, -4, 0, false)]
    public void TestSegment_AHairPastAnEnd_StillMeets(float y, float start, float end, bool meets) => Assert.Equal(
        meets,
        Segment(new b2Vec2(0, start), new b2Vec2(0, end))
            .TestSegment(new float[1], new b2Vec2(), Segment(new b2Vec2(1, y), new b2Vec2(-1, y)), 1));

    [Fact]
    public void TestSegment_OfALineThatIsAPoint_IsNone()
    {
        float[] lambda = [7];
        b2Segment point = Segment(new b2Vec2(1, 1), new b2Vec2(1, 1));

        Assert.False(point.TestSegment(lambda, new b2Vec2(), Segment(new b2Vec2(0, 1), new b2Vec2(2, 1)), 1));
        Assert.Equal(7, lambda[0]);
    }

    [Fact]
    public void TestSegment_WithABadArgument_NamesIt()
    {
        b2Segment line = Segment(new b2Vec2(0, 0), new b2Vec2(0, 2));
        b2Segment other = Segment(new b2Vec2(3, 1), new b2Vec2(-1, 1));
        float[] lambda = new float[1];
        b2Vec2 normal = new();
        string? Name<T>(float[] l, b2Vec2 n, b2Segment s, float most)
            where T : ArgumentException => Assert.Throws<T>(() => line.TestSegment(l, n, s, most)).ParamName;

        Assert.Equal("lambda", Name<ArgumentNullException>(null!, normal, other, 1));
        Assert.Equal("lambda", Name<ArgumentException>([], normal, other, 1));
        Assert.Equal("normal", Name<ArgumentNullException>(lambda, null!, other, 1));
        Assert.Equal("segment", Name<ArgumentNullException>(lambda, normal, null!, 1));
        Assert.Equal("segment", Name<ArgumentNullException>(lambda, normal, Segment(null!, other.p2), 1));
        Assert.Equal("segment", Name<ArgumentNullException>(lambda, normal, Segment(other.p1, null!), 1));
        Assert.Equal("segment", Name<ArgumentOutOfRangeException>(lambda, normal, Segment(new b2Vec2(float.NaN, 0), other.p2), 1));
        Assert.Equal("segment", Name<ArgumentOutOfRangeException>(lambda, normal, Segment(other.p1, new b2Vec2(0, float.NaN)), 1));
        Assert.Equal("maxLambda", Name<ArgumentOutOfRangeException>(lambda, normal, other, float.NaN));
        Assert.Equal("maxLambda", Name<ArgumentOutOfRangeException>(lambda, normal, other, float.PositiveInfinity));

        // What the result held before does not matter.
        Assert.True(line.TestSegment(lambda, new b2Vec2(float.NaN, float.NaN), other, 1));
    }

    private static b2Segment Segment(b2Vec2 from, b2Vec2 to) => new() { p1 = from, p2 = to };

    private static b2Vec2 V(double x, double y) => new((float)x, (float)y);

    /// <summary>Exact quarter turns; + 0 lets no zero be negative.</summary>
    private static b2Vec2 Turned(float x, float y, int turns) => turns switch
    {
        0 => new b2Vec2(x, y),
        1 => new b2Vec2(-y + 0f, x),
        2 => new b2Vec2(-x + 0f, -y + 0f),
        _ => new b2Vec2(y, -x + 0f),
    };
}
