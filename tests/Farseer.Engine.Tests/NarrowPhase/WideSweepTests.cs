using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Shapes;
using Xunit;

namespace Farseer.Engine.Tests.NarrowPhase;

/// <summary>The cheap look at where pairs go, against the search for the time of impact.</summary>
public unsafe class WideSweepTests
{
    private const float Skin = 0.02f;

    [Fact]
    public void Look_RandomPiecesOnTheirWays_MissesNoImpact_AndLeavesOutMostThatHaveNone()
    {
        var random = new Random(90125);
        var lanes = new LanesFixture();
        var hits = new bool[PairLanes.Lanes];
        int impacts = 0;
        int misses = 0;
        int leftOut = 0;
        for (int run = 0; run < 500; run++)
        {
            for (int lane = 0; lane < PairLanes.Lanes; lane++)
            {
                var pair = new PairFixture(Piece(random), Piece(random));
                BodyPath a = Way(random, 0);
                BodyPath b = Way(random, 5);
                var query = new ImpactQuery { Target = 0, Tolerance = 1e-5, From = 0, Until = 1 };
                hits[lane] = new TimeOfImpact(pair.Store, pair.FirstA, a, pair.FirstB, b).Find(query, out _, out _);
                Set(lanes, lane, pair, a, b);
            }

            SweepBits bits = WideSweep.Look(lanes.Pairs, 1f, 0f, Skin);
            for (int lane = 0; lane < PairLanes.Lanes; lane++)
            {
                bool meets = (bits.Meets & (1 << lane)) != 0;
                Assert.True(meets || !hits[lane], $"Run {run}, lane {lane}: an impact was left out.");
                impacts += hits[lane] ? 1 : 0;
                misses += hits[lane] ? 0 : 1;
                leftOut += meets ? 0 : 1;
            }
        }

        Assert.InRange(impacts, 400, 3600);

        // A quarter turn widens a box by more than its own size; without turning nearly all would be left out.
        Assert.InRange(leftOut, 0.5 * misses, misses);
    }

    [Fact]
    public void Look_TwoThatFlySideBySide_KeepsThemInEachOthersReach_IfOneWouldRunIntoTheOther()
    {
        var pair = new PairFixture(ShapeBuilder.Box(1, 1), ShapeBuilder.Box(1, 1));
        var lanes = new LanesFixture();
        SetBeside(lanes, 0, pair, new Vector2(0, 1.1f));
        SetBeside(lanes, 1, pair, new Vector2(1.1f, 0));
        SetBeside(lanes, 2, pair, new Vector2(0, 9));
        for (int lane = 3; lane < PairLanes.Lanes; lane++)
        {
            SetBeside(lanes, lane, pair, new Vector2(9, 9));
        }

        SweepBits bits = WideSweep.Look(lanes.Pairs, 1f, 0f, Skin);

        // None moves as the other sees it. The one behind is half an extent off and would be there within the step.
        Assert.Equal(0, bits.Fast);
        Assert.True(lanes.Pairs->Margin[0] > 0.1f);
        Assert.True(lanes.Pairs->Margin[1] < 0);
        Assert.True(lanes.Pairs->Margin[2] < 7);
        Assert.True(lanes.Pairs->Margin[3] < 0);
    }

    private static ShapeGeometry Piece(Random random) =>
        random.Next(2) == 0
            ? ShapeBuilder.Box(RandomShape.Between(random, 0.3, 2), RandomShape.Between(random, 0.3, 2))
            : RandomShape.Hull(random);

    private static BodyPath Way(Random random, float place)
    {
        Vector2 start = RandomShape.Point(random);
        Vector2 velocity = RandomShape.Point(random) * 6;
        return new BodyPath
        {
            X = place + start.X,
            Y = start.Y,
            Angle = 3 * random.NextDouble(),
            VelocityX = (place > 0 ? -2 : 2) + velocity.X,
            VelocityY = velocity.Y,
            Spin = random.Next(2) == 0 ? 0 : RandomShape.Between(random, -1.5, 1.5),
        };
    }

    private static void SetBeside(LanesFixture lanes, int lane, PairFixture pair, Vector2 offset)
    {
        var falling = new BodyPath { VelocityY = -8 };
        var other = new BodyPath { X = offset.X, Y = offset.Y, VelocityY = -8 };
        Set(lanes, lane, pair, falling, other);
    }

    private static void Set(LanesFixture lanes, int lane, PairFixture pair, in BodyPath a, in BodyPath b)
    {
        lanes.Set(lane, pair.Input(pair.FirstA, pair.FirstB, a.Angle, b.Angle, new Vector2((float)(b.X - a.X), (float)(b.Y - a.Y)), 0));
        Set(&lanes.Pairs->A, lane, pair.Store.Pieces[pair.FirstA], a);
        Set(&lanes.Pairs->B, lane, pair.Store.Pieces[pair.FirstB], b);
    }

    private static void Set(SideLanes* side, int lane, in Piece piece, in BodyPath way)
    {
        side->VelocityX[lane] = (float)way.VelocityX;
        side->VelocityY[lane] = (float)way.VelocityY;
        side->AngularVelocity[lane] = (float)way.Spin;
        side->Reach[lane] = piece.Reach;
        side->Flags[lane] |= (int)(SideFlags.Exists | SideFlags.Moves | SideFlags.Turns | SideFlags.Fast);
    }
}
