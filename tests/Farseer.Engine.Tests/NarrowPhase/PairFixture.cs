using System;
using System.Numerics;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.Tests.NarrowPhase;

/// <summary>Two shapes in a store, posed at will.</summary>
internal sealed unsafe class PairFixture
{
    public PairFixture(ShapeGeometry a, ShapeGeometry b)
        : this(new ShapeStore(), a, b)
    {
    }

    /// <summary>Two more shapes in a store; what was read from its pools before may have moved.</summary>
    public PairFixture(ShapeStore store, ShapeGeometry a, ShapeGeometry b)
    {
        Store = store;
        int body = store.PieceIds.End;
        FirstA = Store.AttachPieces(a, body, body, Vector2.Zero, Rotation.Identity);
        FirstB = Store.AttachPieces(b, body + 1, body + 1, Vector2.Zero, Rotation.Identity);
    }

    public ShapeStore Store { get; }

    public int FirstA { get; }

    public int FirstB { get; }

    public PairFixture Flipped() => new PairFixture(Store, FirstB, FirstA);

    private PairFixture(ShapeStore store, int a, int b)
    {
        Store = store;
        FirstA = a;
        FirstB = b;
    }

    public static Rotation Turn(double angle) => new Rotation((float)Math.Cos(angle), (float)Math.Sin(angle));

    /// <summary>
    /// The pair by pointers into the store's pools: as long as they are used the fixture must be kept alive, or the collector may
    /// give the pools' memory to others.
    /// </summary>
    public PairInput Input(int a, int b, double angleA, double angleB, Vector2 offset, float margin) => new PairInput
    {
        Vertices = Store.Vertices.Pointer,
        Normals = Store.Normals.Pointer,
        OutlineBefore = Store.OutlineBefore.Pointer,
        OutlineAfter = Store.OutlineAfter.Pointer,
        PieceA = Store.Pieces.Pointer + a,
        PieceB = Store.Pieces.Pointer + b,
        RotationA = Turn(angleA),
        RotationB = Turn(angleB),
        Offset = offset,
        Margin = margin,
    };

    public Manifold Collide(double angleA, double angleB, Vector2 offset, float margin)
    {
        Collision.Collide(Input(FirstA, FirstB, angleA, angleB, offset, margin), out Manifold manifold);
        GC.KeepAlive(this);
        return manifold;
    }

    /// <summary>Every pair of pieces of the two shapes, in order.</summary>
    public Manifold[] CollideAll(double angleA, double angleB, Vector2 offset, float margin)
    {
        var result = new System.Collections.Generic.List<Manifold>();
        for (int a = FirstA; a >= 0; a = Store.NextPiece[a])
        {
            for (int b = FirstB; b >= 0; b = Store.NextPiece[b])
            {
                Collision.Collide(Input(a, b, angleA, angleB, offset, margin), out Manifold manifold);
                if (manifold.Count > 0)
                {
                    result.Add(manifold);
                }
            }
        }

        GC.KeepAlive(this);
        return result.ToArray();
    }
}
