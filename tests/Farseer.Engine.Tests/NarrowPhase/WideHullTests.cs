using System;
using System.Linq;
using System.Numerics;
using Farseer.Engine.NarrowPhase;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;
using FsCheck;
using FsCheck.Fluent;
using Xunit;

namespace Farseer.Engine.Tests.NarrowPhase;

/// <summary>The kernels of hulls on lanes against the code for one pair, which is the truth: not one bit may differ.</summary>
public unsafe class WideHullTests
{
    private const float Margin = 0.2f;

    private static readonly int[] Each = [.. Enumerable.Range(0, PairLanes.Lanes)];

    private readonly LanesFixture _lanes = new LanesFixture();
    private readonly int[] _packedA = new int[PairLanes.Lanes];
    private readonly int[] _packedB = new int[PairLanes.Lanes];
    private int _points;

    [Fact]
    public void Hulls_RandomPairs_GiveTheBitsOfTheScalarCode()
    {
        ForAll((random, store) => new Posed(
            new PairFixture(store, SmallHull(random), SmallHull(random)),
            7 * random.NextDouble(),
            7 * random.NextDouble(),
            1.6f * RandomShape.Point(random)));
        Assert.InRange(_points, 500, int.MaxValue);
    }

    [Fact]
    public void Hulls_RegularAndAligned_GiveTheBitsOfTheScalarCode()
    {
        // Sides that are parallel to the last bit, corners above corners: ties in every choice.
        ForAll((random, store) => new Posed(
            new PairFixture(store, Regular(random), Regular(random)),
            0.5 * Math.PI * random.Next(4),
            0.5 * Math.PI * random.Next(4),
            new Vector2(0.25f * random.Next(-8, 9), 0.25f * random.Next(-8, 9))));
        Assert.InRange(_points, 500, int.MaxValue);
    }

    /// <summary>Equal shapes share their corners, which are then read once for all lanes: one bundle in ten has no lane left out.</summary>
    [Fact]
    public void Hulls_AllOfOneShape_GiveTheBitsOfTheScalarCode()
    {
        ShapeStore? of = null;
        ShapeGeometry? shape = null;
        ForAll((random, store) =>
        {
            if (of != store)
            {
                of = store;
                shape = random.Next(2) == 0 ? SmallHull(random) : Regular(random);
            }

            return new Posed(
                new PairFixture(store, shape!, shape!), 7 * random.NextDouble(), 7 * random.NextDouble(), 1.6f * RandomShape.Point(random));
        });
        Assert.InRange(_points, 500, int.MaxValue);
    }

    [Fact]
    public void Hulls_Mirrored_GiveTheBitsOfTheScalarCode()
    {
        ForAll((random, store) =>
        {
            Vector2[] outline = SmallOutline(random);
            Vector2[] mirrored = [.. outline.Select(p => new Vector2(-p.X, p.Y))];
            float radius = random.Next(2) == 0 ? 0 : 0.1f;
            double angle = random.NextDouble();
            return new Posed(
                new PairFixture(store, ShapeBuilder.Polygon(outline, radius), ShapeBuilder.Polygon(mirrored, radius)),
                angle,
                -angle,
                new Vector2(RandomShape.Between(random, 0, 2), 0));
        });
        Assert.InRange(_points, 500, int.MaxValue);
    }

    [Fact]
    public void Hulls_SliversAndCoincident_GiveTheBitsOfTheScalarCode()
    {
        ForAll((random, store) => new Posed(
            new PairFixture(store, Sliver(random), random.Next(2) == 0 ? Sliver(random) : SmallHull(random)),
            random.NextDouble(),
            random.Next(2) * random.NextDouble(),
            random.Next(3) == 0 ? Vector2.Zero : 0.5f * RandomShape.Point(random)));
        Assert.InRange(_points, 500, int.MaxValue);
    }

    [Fact]
    public void CirclesAndHulls_RandomPairs_GiveTheBitsOfTheScalarCode()
    {
        ForAll((random, store) =>
        {
            ShapeGeometry circle = ShapeBuilder.Circle(RandomShape.Between(random, 0.05, 1));
            ShapeGeometry hull = random.Next(4) == 0 ? Regular(random) : random.Next(4) == 0 ? Sliver(random) : SmallHull(random);
            return new Posed(
                random.Next(2) == 0 ? new PairFixture(store, circle, hull) : new PairFixture(store, hull, circle),
                random.Next(2) * random.NextDouble(),
                random.Next(2) * random.NextDouble(),
                random.Next(10) == 0 ? new Vector2(random.Next(-2, 3), 0) : 1.4f * RandomShape.Point(random));
        });
        Assert.InRange(_points, 300, int.MaxValue);
    }

    /// <summary>Compares bundles of pairs; a quarter of their lanes are not to be done, and must stay as they are.</summary>
    private void ForAll(Func<Random, ShapeStore, Posed> make)
    {
        Prop.ForAll(Gen.Choose(0, int.MaxValue - 1).ToArbitrary(), seed =>
        {
            var random = new Random(seed);
            for (int bundle = 0; bundle < 10; bundle++)
            {
                var store = new ShapeStore();
                Posed[] pairs = [.. Enumerable.Range(0, PairLanes.Lanes).Select(_ => make(random, store))];
                Compare(random, store, pairs);
            }
        }).QuickCheckThrowOnFailure();
    }

    private void Compare(Random random, ShapeStore store, Posed[] pairs)
    {
        int hulls = 0;
        int circles = 0;
        int circleFirst = 0;
        var expected = new Manifold[PairLanes.Lanes];
        var untouched = new Manifold { Count = 1, Normal = new Vector2(3, 4), Point0 = new ManifoldPoint { Separation = 5, Id = 6 } };
        for (int lane = 0; lane < PairLanes.Lanes; lane++)
        {
            Posed posed = pairs[lane];
            PairInput input = posed.Pair.Input(posed.Pair.FirstA, posed.Pair.FirstB, posed.AngleA, posed.AngleB, posed.Offset, Margin);
            _lanes.Set(lane, input);
            PairLanes.Write(_lanes.Pairs, lane, untouched);
            expected[lane] = untouched;
            if (random.Next(4) == 0)
            {
                continue;
            }

            Name(lane, input, ref hulls, ref circles, ref circleFirst);
            Truth(input, out expected[lane]);
        }

        fixed (int* each = Each, a = _packedA, b = _packedB)
        {
            HullLanes.Name(&_lanes.Pairs->Hulls.A, hulls | circles, each, a);
            HullLanes.Name(&_lanes.Pairs->Hulls.B, hulls, each, b);
        }

        // Every lane is of one of the two kinds; the other kernel is to leave it alone.
        if (hulls != 0)
        {
            WideConvex.Collide(_lanes.Pairs, hulls, store.Vertices.Pointer, store.Normals.Pointer);
        }

        if (circles != 0)
        {
            WideCircleHull.Collide(_lanes.Pairs, circles, circleFirst, store.Vertices.Pointer, store.Normals.Pointer);
        }

        GC.KeepAlive(store);
        for (int lane = 0; lane < PairLanes.Lanes; lane++)
        {
            _lanes.AssertSame(lane, expected[lane]);
            _points += (hulls & (1 << lane)) != 0 || (circles & (1 << lane)) != 0 ? expected[lane].Count : 0;
        }
    }

    private void Name(int lane, in PairInput input, ref int hulls, ref int circles, ref int circleFirst)
    {
        if (input.A.Kind == ShapeKind.Circle)
        {
            Name(&_lanes.Pairs->Hulls.A, _packedA, lane, input.B, input.RotationB);
            circleFirst |= 1 << lane;
            circles |= 1 << lane;
            return;
        }

        Name(&_lanes.Pairs->Hulls.A, _packedA, lane, input.A, input.RotationA);
        if (input.B.Kind == ShapeKind.Circle)
        {
            circles |= 1 << lane;
            return;
        }

        Name(&_lanes.Pairs->Hulls.B, _packedB, lane, input.B, input.RotationB);
        hulls |= 1 << lane;
    }

    private static void Name(HullLanes* hulls, int[] packed, int lane, in Piece piece, Rotation rotation)
    {
        packed[lane] = HullLanes.Pack(piece.VertexStart, piece.VertexCount);
        hulls->Cos[lane] = rotation.Cos;
        hulls->Sin[lane] = rotation.Sin;
    }

    // Two boxes have a kernel of their own and come here only corner to corner.
    private static void Truth(in PairInput input, out Manifold manifold)
    {
        if (input.A.Kind == ShapeKind.Box && input.B.Kind == ShapeKind.Box)
        {
            ConvexConvex.Collide(input, out manifold);
        }
        else
        {
            Collision.Collide(input, out manifold);
        }
    }

    private static ShapeGeometry SmallHull(Random random) => random.Next(5) switch
    {
        0 => ShapeBuilder.Box(RandomShape.Between(random, 0.3, 2), RandomShape.Between(random, 0.3, 2)),
        1 => ShapeBuilder.Segment(RandomShape.Point(random), RandomShape.Point(random)),
        2 => ShapeBuilder.Capsule(RandomShape.Point(random), RandomShape.Point(random), RandomShape.Between(random, 0.05, 0.5)),
        3 => ShapeBuilder.Polygon(SmallOutline(random), RandomShape.Between(random, 0.05, 0.3)),
        _ => ShapeBuilder.Polygon(SmallOutline(random)),
    };

    private static Vector2[] SmallOutline(Random random)
    {
        Vector2[] outline = RandomShape.Convex(random);
        return outline.Length <= HullLanes.MostCorners ? outline : outline[..HullLanes.MostCorners];
    }

    private static ShapeGeometry Regular(Random random)
    {
        int count = random.Next(3, HullLanes.MostCorners + 1);
        float radius = random.Next(3) == 0 ? 0.125f : 0;
        return random.Next(4) switch
        {
            0 => ShapeBuilder.Box(1, 0.5f * random.Next(1, 4)),
            1 => ShapeBuilder.Segment(new Vector2(-0.5f, 0), new Vector2(0.5f, 0)),
            2 => ShapeBuilder.Capsule(new Vector2(-0.5f, 0), new Vector2(0.5f, 0), 0.25f),
            _ => ShapeBuilder.Polygon(
                [.. Enumerable.Range(0, count)
                    .Select(i => new Vector2((float)Math.Cos(i * 2 * Math.PI / count), (float)Math.Sin(i * 2 * Math.PI / count)))],
                radius),
        };
    }

    private static ShapeGeometry Sliver(Random random)
    {
        float width = RandomShape.Between(random, 1e-4, 1e-2);
        return random.Next(3) switch
        {
            0 => ShapeBuilder.Box(1, width),
            1 => ShapeBuilder.Polygon([Vector2.Zero, Vector2.UnitX, new Vector2(RandomShape.Between(random, 0, 1), width)]),
            _ => ShapeBuilder.Segment(Vector2.Zero, new Vector2(width, width)),
        };
    }

    private readonly record struct Posed(PairFixture Pair, double AngleA, double AngleB, Vector2 Offset);
}
