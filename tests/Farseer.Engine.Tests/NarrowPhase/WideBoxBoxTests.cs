using System;
using System.Numerics;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.NarrowPhase;

public unsafe class WideBoxBoxTests
{
    [Fact]
    public void Collide_RandomBoxes_GivesTheBitsOfTheScalarCode()
    {
        var random = new Random(11);
        var pairs = new Column<PairLanes>(1);
        var expected = new Manifold[PairLanes.Lanes];
        int two = 0;
        int corners = 0;
        for (int i = 0; i < 8000; i++)
        {
            for (int lane = 0; lane < PairLanes.Lanes; lane++)
            {
                ShapeGeometry a = ShapeBuilder.Box(RandomShape.Between(random, 0.3, 2), RandomShape.Between(random, 0.3, 2));
                ShapeGeometry b = ShapeBuilder.Box(RandomShape.Between(random, 0.3, 2), RandomShape.Between(random, 0.3, 2));
                var pair = new PairFixture(a, b);
                double angleA = random.NextDouble() * 7;
                double angleB = random.Next(2) == 0 ? angleA + (0.02 * random.NextDouble()) : random.NextDouble() * 7;
                PairInput input = pair.Input(pair.FirstA, pair.FirstB, angleA, angleB, 1.6f * RandomShape.Point(random), 0.1f);
                BoxBox.Collide(input, out expected[lane]);
                Set(pairs.Pointer, lane, input);
            }

            int corner = WideBoxBox.Collide(pairs.Pointer);
            for (int lane = 0; lane < PairLanes.Lanes; lane++)
            {
                if ((corner & (1 << lane)) != 0)
                {
                    // The scalar code hands these on, and so does the caller of the wide code.
                    corners++;
                    continue;
                }

                Manifold found = PairLanes.Read(pairs.Pointer, lane);
                two += found.Count == 2 ? 1 : 0;
                Manifold wanted = expected[lane];
                Assert.Equal(wanted.Count, found.Count);
                if (found.Count == 0)
                {
                    continue;
                }

                Assert.Equal(wanted.Normal, found.Normal);
                AssertSame(wanted.Point0, found.Point0);
                AssertSame(wanted.Point1, found.Point1);
            }
        }

        Assert.InRange(two, 5000, int.MaxValue);
        Assert.InRange(corners, 100, int.MaxValue);
    }

    private static void Set(PairLanes* pairs, int lane, in PairInput input)
    {
        Set(&pairs->A, lane, input.A, input.RotationA);
        Set(&pairs->B, lane, input.B, input.RotationB);
        pairs->OffsetX[lane] = input.Offset.X;
        pairs->OffsetY[lane] = input.Offset.Y;
        pairs->Margin[lane] = input.Margin;
    }

    private static void Set(SideLanes* side, int lane, in Piece piece, Engine.Numerics.Rotation rotation)
    {
        Vector2 axis = rotation.Rotate(piece.Axis);
        Vector2 center = rotation.Rotate(piece.Center);
        side->X[lane] = center.X;
        side->Y[lane] = center.Y;
        side->Cos[lane] = axis.X;
        side->Sin[lane] = axis.Y;
        side->HalfX[lane] = piece.Half.X;
        side->HalfY[lane] = piece.Half.Y;
        side->Extent[lane] = piece.Extent;
    }

    private static void AssertSame(in ManifoldPoint wanted, in ManifoldPoint found)
    {
        Assert.Equal(wanted.Anchor, found.Anchor);
        Assert.Equal(wanted.Separation, found.Separation);
        Assert.Equal(wanted.Id, found.Id);
    }
}
