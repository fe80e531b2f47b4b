using System;
using System.Numerics;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Shapes;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.NarrowPhase;

public unsafe class WideCircleCircleTests
{
    [Fact]
    public void Collide_RandomCircles_GivesTheBitsOfTheScalarCode()
    {
        var random = new Random(12);
        var pairs = new Column<PairLanes>(1);
        var expected = new Manifold[PairLanes.Lanes];
        int touching = 0;
        for (int i = 0; i < 2000; i++)
        {
            for (int lane = 0; lane < PairLanes.Lanes; lane++)
            {
                var pair = new PairFixture(ShapeBuilder.Circle((float)(0.1 + random.NextDouble())), ShapeBuilder.Circle((float)(0.1 + random.NextDouble())));

                // Every twentieth pair has one centre: there the direction is chosen, not computed.
                Vector2 offset = random.Next(20) == 0 ? Vector2.Zero : 1.6f * RandomShape.Point(random);
                PairInput input = pair.Input(pair.FirstA, pair.FirstB, random.NextDouble(), random.NextDouble(), offset, 0.1f);
                CirclePairs.CircleCircle(input, out expected[lane]);
                Set(&pairs.Pointer->A, lane, input.A, input.RotationA);
                Set(&pairs.Pointer->B, lane, input.B, input.RotationB);
                pairs.Pointer->OffsetX[lane] = offset.X;
                pairs.Pointer->OffsetY[lane] = offset.Y;
                pairs.Pointer->Margin[lane] = input.Margin;
            }

            WideCircleCircle.Collide(pairs.Pointer);
            for (int lane = 0; lane < PairLanes.Lanes; lane++)
            {
                Manifold found = PairLanes.Read(pairs.Pointer, lane);
                Assert.Equal(expected[lane], found);
                touching += found.Count;
            }
        }

        Assert.InRange(touching, 4000, 15000);
    }

    private static void Set(SideLanes* side, int lane, in Piece piece, Engine.Numerics.Rotation rotation)
    {
        Vector2 center = rotation.Rotate(piece.Center);
        side->X[lane] = center.X;
        side->Y[lane] = center.Y;
        side->HalfX[lane] = piece.Half.X;
        side->Flags[lane] = (int)SideFlags.Circle;
    }
}
