using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;
using Farseer.Engine.Queries;
using Farseer.Engine.Shapes;
using Xunit;

namespace Farseer.Engine.Tests.Shapes;

public class ShapeStoreTests
{
    [Fact]
    public void AttachPieces_WithOffsetAndTurn_BakesBodyCoordinates()
    {
        var store = new ShapeStore();
        int piece = store.AttachPieces(ShapeBuilder.Box(4, 2), 7, 0, new Vector2(10, 0), new Rotation(0, 1));
        Piece p = store.Pieces[piece];
        Assert.Equal(7, p.Body);
        Assert.Equal(new Vector2(11, -2), store.Vertices[p.VertexStart]);
        Assert.Equal(new Vector2(1, 0), store.Normals[p.VertexStart]);
        Assert.Equal(new Vector2(10, 0), p.Center);
        Assert.Equal(1, p.Extent);
        Assert.Equal(Math.Sqrt(125), p.Reach, 1e-5);
        Assert.Equal(7, store.Colliders[0].Body);
        Assert.Equal(1, store.Colliders[0].PieceCount);
    }

    /// <summary>Which kernels for lanes may do a piece: one that is let through wrongly would be solved as what it is not.</summary>
    [Fact]
    public void AttachPieces_OfEachKind_NotesTheKernelsThatCanDoIt()
    {
        Vector2[] octagon = Corners(8);
        Vector2[] nonagon = Corners(9);
        Vector2[] step = [new Vector2(0, 0), new Vector2(2, 0), new Vector2(2, 1)];
        Assert.Equal(PieceTraits.Circle, TraitsOf(ShapeBuilder.Circle(1), Rotation.Identity));
        Assert.Equal(PieceTraits.Hull | PieceTraits.Box, TraitsOf(ShapeBuilder.Box(4, 2), Rotation.Identity));
        Assert.Equal(PieceTraits.Hull | PieceTraits.Box | PieceTraits.Tilted, TraitsOf(ShapeBuilder.Box(4, 2), new Rotation(0.6f, 0.8f)));
        Assert.Equal(PieceTraits.Hull, TraitsOf(ShapeBuilder.Capsule(Vector2.Zero, Vector2.UnitX, 1), Rotation.Identity));
        Assert.Equal(PieceTraits.Hull, TraitsOf(ShapeBuilder.Segment(Vector2.Zero, Vector2.UnitX), Rotation.Identity));
        Assert.Equal(PieceTraits.Hull, TraitsOf(ShapeBuilder.Polygon(octagon), Rotation.Identity));
        Assert.Equal(PieceTraits.None, TraitsOf(ShapeBuilder.Polygon(nonagon), Rotation.Identity));
        Assert.Equal(PieceTraits.None, TraitsOf(ShapeBuilder.Chain(step, loop: false), Rotation.Identity));
    }

    private static PieceTraits TraitsOf(ShapeGeometry shape, Rotation turn)
    {
        var store = new ShapeStore();
        return store.Pieces[store.AttachPieces(shape, 0, 0, Vector2.Zero, turn)].Traits;
    }

    private static Vector2[] Corners(int count)
    {
        var corners = new Vector2[count];
        for (int i = 0; i < count; i++)
        {
            double angle = 2 * Math.PI * i / count;
            corners[i] = new Vector2((float)Math.Cos(angle), (float)Math.Sin(angle));
        }

        return corners;
    }

    [Fact]
    public void DetachPieces_ThenAttach_ReusesTheSameSlots()
    {
        var store = new ShapeStore();
        ShapeGeometry plus = ShapeBuilder.Polygon(ShapeBuilderTests.Named("plus"));
        store.AttachPieces(ShapeBuilder.Circle(1), 0, 0, Vector2.Zero, Rotation.Identity);
        store.AttachPieces(plus, 1, 1, Vector2.Zero, Rotation.Identity);
        int pieces = store.PieceIds.End;
        int vertices = store.VertexSet.Capacity;
        var other = new ShapeStore();
        for (int i = 0; i < 100; i++)
        {
            store.DetachPieces(1);
            Assert.Equal(0, store.Colliders[1].PieceCount);
            store.AttachPieces(plus, 1, 1, Vector2.Zero, Rotation.Identity);
        }

        Assert.Equal(pieces, store.PieceIds.End);
        Assert.Equal(vertices, store.VertexSet.Capacity);
        var seen = new HashSet<int>();
        for (int piece = store.Colliders[1].FirstPiece; piece >= 0; piece = store.NextPiece[piece])
        {
            Assert.True(seen.Add(piece));
            Assert.Equal(1, store.Pieces[piece].Collider);
        }

        Assert.Equal(plus.Pieces.Length, seen.Count);
    }

    [Fact]
    public void TightBox_OfATurnedBoxFarAway_EnclosesItExactly()
    {
        var store = new ShapeStore();
        int piece = store.AttachPieces(ShapeBuilder.Box(2, 2), 0, 0, Vector2.Zero, Rotation.Identity);
        float half = (float)Math.Sqrt(0.5);
        var pose = new BodyPose { X = 1e7 + 0.3, Y = -0.1, Cos = half, Sin = half };
        Box box = store.TightBox(piece, pose);
        double reach = 2.0 * half;
        Assert.True(box.MinX <= pose.X - reach && box.MaxX >= pose.X + reach);
        Assert.True(box.MinY <= pose.Y - reach && box.MaxY >= pose.Y + reach);
        Assert.Equal(pose.Y + reach, box.MaxY, 1e-6);
        Assert.Equal(pose.X + reach, box.MaxX, 1.0);
    }

    [Fact]
    public void PointQuery_OnAConcaveShape_SeesTheOutlineAndNotTheSeams()
    {
        var random = new Random(31);
        for (int n = 0; n < 100; n++)
        {
            Vector2[] star = ShapeBuilderTests.Star(random, random.Next(4, 20));
            var store = new ShapeStore();
            store.AttachPieces(ShapeBuilder.Polygon(star), 0, 0, Vector2.Zero, Rotation.Identity);
            var pose = new BodyPose { X = 3, Y = -5, Cos = 1 };
            for (int i = 0; i < 100; i++)
            {
                var point = new Vector2((float)(2 * (random.NextDouble() - 0.5)), (float)(2 * (random.NextDouble() - 0.5)));
                float expected = DistanceGrid.NearestDistance(star, point);
                Assert.Equal(expected <= 0, PointQuery.Contains(store, 0, pose, point.X + 3.0, point.Y - 5.0));
                Assert.Equal(expected, PointQuery.SignedDistance(store, 0, pose, point.X + 3.0, point.Y - 5.0), 1e-6);
            }
        }
    }

    [Fact]
    public void PointQuery_OnRoundShapes_UsesTheRadius()
    {
        var store = new ShapeStore();
        store.AttachPieces(ShapeBuilder.Capsule(new Vector2(-1, 0), new Vector2(1, 0), 0.5f), 0, 0, Vector2.Zero, Rotation.Identity);
        store.AttachPieces(ShapeBuilder.Circle(2), 0, 1, new Vector2(5, 0), Rotation.Identity);
        var pose = new BodyPose { Cos = 1 };
        Assert.True(PointQuery.Contains(store, 0, pose, 1.5, 0));
        Assert.False(PointQuery.Contains(store, 0, pose, 1.5000001, 0));
        Assert.Equal(-0.5, PointQuery.SignedDistance(store, 0, pose, 0, 0), 1e-12);
        Assert.True(PointQuery.Contains(store, 1, pose, 5, 2));
        Assert.Equal(-2, PointQuery.SignedDistance(store, 1, pose, 5, 0), 1e-12);
    }
}
