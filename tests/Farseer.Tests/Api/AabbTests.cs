using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using Xunit;

namespace Farseer.Tests.Api;

public class AabbTests
{
    [Fact]
    [ManualRow("F237")]
    public void Aabb_OfCorners_HasTheirMeasures()
    {
        var box = new AABB(new Vector2(-2, 1), new Vector2(4, 5));
        Assert.Equal(new Vector2(-2, 1), box.Min);
        Assert.Equal(new Vector2(4, 5), box.Max);
        Assert.Equal(6f, box.Width);
        Assert.Equal(4f, box.Height);
        Assert.Equal(4f, box.GetShortestSide());
        Assert.Equal(new Vector2(1, 3), box.GetCenter());
        Assert.Equal(24f, box.GetVertices().GetArea());
        Assert.True(box.GetVertices().IsCounterClockWise());
        var copy = new AABB(box);
        var point = new Vertices(new[] { Vector2.One });
        box.Update(ref point);
        Assert.Equal(Vector2.One, box.Min);
        Assert.Equal(new Vector2(-2, 1), copy.Min);
        Assert.Equal(Vector2.Zero, new AABB().Max);
    }

    [Fact]
    [ManualRow("F239")]
    public void Intersect_OfBoxes_TellsWhetherTheyShareAPoint()
    {
        var box = new AABB(Vector2.Zero, new Vector2(2, 2));
        Assert.True(AABB.Intersect(box, new AABB(Vector2.One, new Vector2(3, 3))));
        Assert.True(AABB.Intersect(box, new AABB(new Vector2(0.5f), new Vector2(1, 1))));
        Assert.True(AABB.Intersect(box, new AABB(new Vector2(2, 2), new Vector2(3, 3))), "A shared corner counts.");
        Assert.False(AABB.Intersect(box, new AABB(new Vector2(2.001f, 0), new Vector2(3, 3))));
        Assert.False(AABB.Intersect(box, new AABB(new Vector2(0, -3), new Vector2(3, -1))));
    }

    [Fact]
    [ManualRow("F240")]
    public void Aabb_OfDiamonds_CanOverlapThoughTheyDoNotTouch()
    {
        var first = new Vertices(new[] { new Vector2(-1, 0), new Vector2(0, -1), new Vector2(1, 0), new Vector2(0, 1) });
        var second = new Vertices(first);
        second.Translate(new Vector2(1.2f, 1.2f));
        Assert.True(AABB.Intersect(new AABB(first), new AABB(second)));

        // Along the diagonal the first reaches 1 and the second begins at 1.4.
        var diagonal = Vector2.One;
        first.ProjectToAxis(ref diagonal, out _, out var end);
        second.ProjectToAxis(ref diagonal, out var start, out _);
        Assert.True(end < start);
    }

    [Fact]
    public void Contains_OfPoints_CountsTheEdge()
    {
        var box = new AABB(Vector2.Zero, new Vector2(2, 1));
        var corner = new Vector2(2, 1);
        Assert.True(box.Contains(ref corner));
        Assert.True(box.Contains(new Vector2(0, 0.5f)));
        Assert.False(box.Contains(new Vector2(2.0001f, 0.5f)));
        Assert.False(box.Contains(new Vector2(float.NaN, 0.5f)));
    }

    [Fact]
    public void Aabb_OfBadInput_Throws()
    {
        Assert.Equal("max", Assert.Throws<ArgumentOutOfRangeException>(() => new AABB(Vector2.One, Vector2.Zero)).ParamName);
        Assert.Equal(
            "min",
            Assert.Throws<ArgumentOutOfRangeException>(() => new AABB(new Vector2(float.NaN), Vector2.Zero)).ParamName);
        Assert.Equal("vertices", Assert.Throws<ArgumentException>(() => new AABB(new Vertices())).ParamName);
        Assert.Throws<ArgumentNullException>(() => new AABB((AABB)null!));
        Assert.Throws<ArgumentNullException>(() => new AABB((Vertices)null!));
        Assert.Throws<ArgumentNullException>(() => AABB.Intersect(new AABB(), null!));
        var bad = new Vertices(new[] { Vector2.Zero, new Vector2(1, float.PositiveInfinity) });
        var error = Assert.Throws<ArgumentException>(() => new AABB(bad));
        Assert.Contains("Vertex 1", error.Message, StringComparison.Ordinal);
    }
}
