using System;
using System.Globalization;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using Xunit;

namespace Farseer.Tests.Api;

public class VerticesTests
{
    [Fact]
    [ManualRow("F034")]
    [ManualRow("F035")]
    public void Vertices_New_IsAnEmptyListOfVectors()
    {
        var vertices = new Vertices();
        Assert.Empty(vertices);
        Assert.IsAssignableFrom<System.Collections.Generic.List<Vector2>>(vertices);
        Assert.Equal(0f, vertices.GetArea());
    }

    [Fact]
    [ManualRow("F036")]
    public void Vertices_Add_AppendsThePoint()
    {
        var vertices = new Vertices();
        vertices.Add(new Vector2(-64, 64));
        vertices.Add(new Vector2(64, -64));
        Assert.Equal(new[] { new Vector2(-64, 64), new Vector2(64, -64) }, vertices.GetVerticesArray());
    }

    [Fact]
    public void Vertices_OfArrayOrList_IsACopy()
    {
        var array = new[] { new Vector2(1, 2), new Vector2(3, 4) };
        var first = new Vertices(array);
        var second = new Vertices(first);
        array[0] = Vector2.Zero;
        first[1] = Vector2.Zero;
        Assert.Equal(new[] { new Vector2(1, 2), new Vector2(3, 4) }, second);
        Assert.NotSame(second.GetVerticesArray(), second.GetVerticesArray());
    }

    [Fact]
    [ManualRow("F307")]
    public void SubDivideEdges_AsInTheManual_AddsPointsAlongEdges()
    {
        var vertices = Square(64);
        vertices.SubDivideEdges(10);

        // 128 / 10 rounded up is 13 pieces on each of the four sides.
        Assert.Equal(4 * 13, vertices.Count);
        Assert.Equal(new Vector2(-64, -64), vertices[0]);
        Assert.Equal(new Vector2(-64, -64) + new Vector2(128f / 13f, 0), vertices[1]);
    }

    [Fact]
    public void SubDivideEdges_OfShortEdges_ChangesNothing()
    {
        var vertices = Square(64);
        vertices.SubDivideEdges(128);
        Assert.Equal(Square(64), vertices);
    }

    [Theory]
    [InlineData(0f)]
    [InlineData(-1f)]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void SubDivideEdges_OfBadLength_ThrowsWithNameAndValue(float length)
    {
        var error = Assert.Throws<ArgumentOutOfRangeException>(() => Square(1).SubDivideEdges(length));
        Assert.Equal("maxEdgeLength", error.ParamName);
        Assert.Equal(length, error.ActualValue);
    }

    [Fact]
    public void SubDivideEdges_IntoTooManyPieces_ThrowsAndLeavesTheList()
    {
        var vertices = Square(1e6f);
        Assert.Throws<InvalidOperationException>(() => vertices.SubDivideEdges(1e-3f));
        Assert.Equal(Square(1e6f), vertices);
    }

    [Theory]
    [InlineData(0f, 1f, "width")]
    [InlineData(-3f, 1f, "width")]
    [InlineData(1f, float.NaN, "height")]
    [InlineData(1f, float.PositiveInfinity, "height")]
    public void CreateRectangle_OfBadSide_ThrowsWithNameAndValue(float width, float height, string name)
    {
        var error = Assert.Throws<ArgumentOutOfRangeException>(() => Vertices.CreateRectangle(width, height));
        Assert.Equal(name, error.ParamName);
        Assert.Equal(name == "width" ? width : height, error.ActualValue);
    }

    [Fact]
    public void CreateCircleAndEllipse_OfBadArguments_ThrowWithName()
    {
        Assert.Equal("radius", Assert.Throws<ArgumentOutOfRangeException>(() => Vertices.CreateCircle(0, 8)).ParamName);
        Assert.Equal(
            "numberOfEdges",
            Assert.Throws<ArgumentOutOfRangeException>(() => Vertices.CreateCircle(1, 2)).ParamName);
        Assert.Equal("xRadius", Assert.Throws<ArgumentOutOfRangeException>(() => Vertices.CreateEllipse(-1, 1, 8)).ParamName);
        Assert.Equal(
            "yRadius",
            Assert.Throws<ArgumentOutOfRangeException>(() => Vertices.CreateEllipse(1, float.NaN, 8)).ParamName);
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(4)]
    public void IndexedMembers_OfNoVertex_ThrowWithValue(int index)
    {
        var square = Square(1);
        Assert.Equal(index, Assert.Throws<ArgumentOutOfRangeException>(() => square.NextIndex(index)).ActualValue);
        Assert.Equal(index, Assert.Throws<ArgumentOutOfRangeException>(() => square.PreviousIndex(index)).ActualValue);
        Assert.Throws<ArgumentOutOfRangeException>(() => square.GetEdge(index));
        Assert.Throws<ArgumentOutOfRangeException>(() => square.GetEdgeMidPoint(index));
        Assert.Throws<ArgumentOutOfRangeException>(() => square.GetEdgeNormal(index));
        Assert.Throws<ArgumentOutOfRangeException>(() => square.GetVertexNormal(index));
    }

    [Fact]
    public void OutMembers_AgreeWithThoseThatReturn()
    {
        var vertices = Vertices.CreateEllipse(3, 2, 7);
        for (var i = 0; i < vertices.Count; i++)
        {
            vertices.GetEdge(i, out var edge);
            vertices.GetEdgeMidPoint(i, out var middle);
            vertices.GetEdgeNormal(i, out var normal);
            vertices.GetVertexNormal(i, out var vertexNormal);
            Assert.Equal(vertices.GetEdge(i), edge);
            Assert.Equal(vertices.GetEdgeMidPoint(i), middle);
            Assert.Equal(vertices.GetEdgeNormal(i), normal);
            Assert.Equal(vertices.GetVertexNormal(i), vertexNormal);
        }
    }

    [Fact]
    public void GetEdgeNormal_OfEdgeWithoutLength_IsZero()
    {
        var vertices = new Vertices(new[] { Vector2.One, Vector2.One, new Vector2(2, 5) });
        Assert.Equal(Vector2.Zero, vertices.GetEdgeNormal(0));
    }

    [Fact]
    public void GetEdgeNormal_InTheOrderOfGeoms_PointsOutwards()
    {
        foreach (var shape in new[] { Vertices.CreateCircle(3, 9), Vertices.CreateRectangle(2, 5), Square(4) })
        {
            shape.ForceCounterClockWiseOrder();
            for (var i = 0; i < shape.Count; i++)
            {
                Assert.True(Vector2.Dot(shape.GetEdgeNormal(i), shape.GetEdgeMidPoint(i)) > 0);
                Assert.True(Vector2.Dot(shape.GetVertexNormal(i), shape[i]) > 0);
            }
        }
    }

    [Fact]
    public void EmptyList_OfMembersThatNeedVertices_Throws()
    {
        var empty = new Vertices();
        var axis = Vector2.UnitX;
        Assert.Throws<InvalidOperationException>(() => empty.GetShortestEdge());
        Assert.Throws<InvalidOperationException>(() => empty.ProjectToAxis(ref axis, out _, out _));
        Assert.Throws<InvalidOperationException>(() => empty.GetCentroid());
        Assert.Throws<InvalidOperationException>(() => empty.GetMomentOfInertia());
        Assert.Throws<ArgumentNullException>(() => new Vertices((Vertices)null!));
        Assert.Throws<ArgumentNullException>(() => new Vertices((Vector2[])null!));
    }

    [Fact]
    public void GetCentroid_OfLineOrBadVertex_Throws()
    {
        var line = new Vertices(new[] { Vector2.Zero, Vector2.One, new Vector2(2, 2) });
        Assert.Throws<InvalidOperationException>(() => line.GetCentroid());
        var bad = Square(1);
        bad[2] = new Vector2(float.NaN, 0);
        Assert.Throws<InvalidOperationException>(() => bad.GetCentroid());
        Assert.Equal("area", Assert.Throws<ArgumentOutOfRangeException>(() => Square(1).GetCentroid(0f)).ParamName);
    }

    [Fact]
    public void GetCentroid_OfKnownArea_IsTheSame()
    {
        var shape = Vertices.CreateEllipse(3, 2, 7);
        shape.Translate(new Vector2(10, -4));
        var a = shape.GetCentroid();
        var b = shape.GetCentroid(shape.GetArea());
        Assert.Equal(a.X, b.X, 1e-5f);
        Assert.Equal(a.Y, b.Y, 1e-5f);
    }

    [Fact]
    public void TranslateAndScale_OfBadVector_ThrowWithName()
    {
        var bad = new Vector2(1, float.NaN);
        Assert.Equal("vector", Assert.Throws<ArgumentOutOfRangeException>(() => Square(1).Translate(bad)).ParamName);
        Assert.Equal("value", Assert.Throws<ArgumentOutOfRangeException>(() => Square(1).Scale(bad)).ParamName);
    }

    [Fact]
    public void ToString_InAnyCulture_UsesThePoint()
    {
        var before = CultureInfo.CurrentCulture;
        try
        {
            var culture = (CultureInfo)CultureInfo.InvariantCulture.Clone();
            culture.NumberFormat.NumberDecimalSeparator = ",";
            CultureInfo.CurrentCulture = culture;
            Assert.Equal("(1.5, 2) (-3, 0)", new Vertices(new[] { new Vector2(1.5f, 2), new Vector2(-3, 0) }).ToString());
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
        }
    }

    [Fact]
    public void CheckPolygon_OfEachFault_NamesIt()
    {
        Assert.Equal(PolygonFault.None, Square(1).CheckPolygon());
        Assert.Equal(PolygonFault.None, Vertices.CreateRectangle(1e-2f, 1e3f).CheckPolygon());
        Assert.Equal(PolygonFault.NoArea, Vertices.CreateRectangle(1e-6f, 1e6f).CheckPolygon());
        Assert.Equal(PolygonFault.NoArea, Of(0, 0, 1, 1e-6f, 2, 0).CheckPolygon());
        Assert.Equal(PolygonFault.OutOfRange, Of(0, 0, 1e19f, 0, 0, 1e19f).CheckPolygon());
        Assert.Equal(PolygonFault.OutOfRange, Of(0, 0, 1e-20f, 0, 0, 1e-20f).CheckPolygon());
        Assert.Equal(PolygonFault.TooFewVertices, Of(0, 0, 1, 0).CheckPolygon());
        Assert.Equal(PolygonFault.NotFinite, Of(0, 0, 1, 0, 0, float.NaN).CheckPolygon());
        Assert.Equal(PolygonFault.RepeatedVertex, Of(0, 0, 1, 0, 1, 1, 0, 0).CheckPolygon());
        Assert.Equal(PolygonFault.NoArea, Of(0, 0, 1, 1, 2, 2).CheckPolygon());
        Assert.Equal(PolygonFault.NoArea, Of(0, 0, 2, 2, 2, 0, 0, 2).CheckPolygon());
        Assert.Equal(PolygonFault.SelfIntersecting, Of(0, 0, 2, 2, 3, 0, 0, 1).CheckPolygon());
        Assert.Equal(PolygonFault.SelfIntersecting, Of(0, 0, 2, 0, 4, 0, 3, 0, 3, 3).CheckPolygon());
        Assert.Equal(PolygonFault.SelfIntersecting, Of(0, 0, 4, 0, 4, 4, 2, 0, 0, 4).CheckPolygon());
    }

    [Fact]
    public void IsConvex_OfShapes_TellsThemApart()
    {
        Assert.True(Square(1).IsConvex());
        Assert.True(Vertices.CreateRectangle(3, 4).IsConvex());
        Assert.True(Vertices.CreateCircle(3, 64).IsConvex());
        Assert.False(Of(0, 0, 60, 0, 60, 20, 20, 20, 20, 60, 0, 60).IsConvex());
        Assert.False(Of(0, 0, 1, 1, 2, 2).IsConvex());
        Assert.False(Of(0, 0, 1, 0).IsConvex());

        // A five-pointed star drawn in one line turns one way only, but goes round twice.
        var pentagon = Vertices.CreateCircle(1, 5);
        var star = new Vertices(new[] { 0, 2, 4, 1, 3 }.Select(i => pentagon[i]).ToArray());
        Assert.False(star.IsConvex());
        Assert.False(star.IsSimple());
    }

    [Fact]
    public void IsCounterClockWise_IsTheOrderThatGeomsUse()
    {
        var square = Square(1);
        Assert.Equal(4f, square.GetSignedArea());
        Assert.False(square.IsCounterClockWise());
        square.ForceCounterClockWiseOrder();
        Assert.True(square.IsCounterClockWise());
        Assert.Equal(-4f, square.GetSignedArea());
        Assert.True(Vertices.CreateRectangle(1, 1).IsCounterClockWise());
        Assert.True(Vertices.CreateCircle(1, 5).IsCounterClockWise());
    }

    private static Vertices Square(float half) => Of(-half, -half, half, -half, half, half, -half, half);

    private static Vertices Of(params float[] coordinates)
    {
        var vertices = new Vertices();
        for (var i = 0; i < coordinates.Length; i += 2)
        {
            vertices.Add(new Vector2(coordinates[i], coordinates[i + 1]));
        }

        return vertices;
    }
}
