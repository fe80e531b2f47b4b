using System.Numerics;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.NarrowPhase;

/// <summary>Pairs put side by side for the kernels on lanes.</summary>
internal sealed unsafe class LanesFixture
{
    private readonly Column<PairLanes> _pairs = new Column<PairLanes>(1);

    public PairLanes* Pairs => _pairs.Pointer;

    /// <summary>Makes a pair a lane, as the narrow phase gathers it.</summary>
    public void Set(int lane, in PairInput input)
    {
        Set(&Pairs->A, lane, input.A, input.RotationA);
        Set(&Pairs->B, lane, input.B, input.RotationB);
        Pairs->OffsetX[lane] = input.Offset.X;
        Pairs->OffsetY[lane] = input.Offset.Y;
        Pairs->Margin[lane] = input.Margin;
    }

    /// <summary>Compares, bit for bit, all that a manifold means: what stands behind its count does not matter.</summary>
    public void AssertSame(int lane, in Manifold wanted)
    {
        Manifold found = PairLanes.Read(Pairs, lane);
        Assert.Equal(wanted.Count, found.Count);
        if (wanted.Count == 0)
        {
            return;
        }

        Assert.Equal(wanted.Normal, found.Normal);
        AssertSame(wanted.Point0, found.Point0);
        if (wanted.Count > 1)
        {
            AssertSame(wanted.Point1, found.Point1);
        }
    }

    private static void AssertSame(in ManifoldPoint wanted, in ManifoldPoint found)
    {
        Assert.Equal(wanted.Anchor, found.Anchor);
        Assert.Equal(wanted.Separation, found.Separation);
        Assert.Equal(wanted.Id, found.Id);
    }

    private static void Set(SideLanes* side, int lane, in Piece piece, Rotation rotation)
    {
        Vector2 axis = rotation.Rotate(piece.Axis);
        Vector2 center = rotation.Rotate(piece.Center);
        bool box = piece.Kind == ShapeKind.Box;
        side->X[lane] = center.X;
        side->Y[lane] = center.Y;
        side->Cos[lane] = axis.X;
        side->Sin[lane] = axis.Y;
        side->HalfX[lane] = box ? piece.Half.X : piece.Radius;
        side->HalfY[lane] = piece.Half.Y;
        side->Extent[lane] = piece.Extent;
        side->Flags[lane] = (int)(box ? SideFlags.Box : piece.Kind == ShapeKind.Circle ? SideFlags.Circle : SideFlags.None);
    }
}
