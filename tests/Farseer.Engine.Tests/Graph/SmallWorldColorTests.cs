using System;
using System.Collections.Generic;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Graph;

public sealed unsafe class SmallWorldColorTests
{
    private const int Many = 10_000;

    [Theory]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(5)]
    [InlineData(6)]
    public void Pyramid_InASmallWorld_HasFewerBundlesThanInALargeOne(int side)
    {
        int small = 0;
        int large = 0;
        for (int seed = 0; seed < 100; seed++)
        {
            small += Bundles(side, seed, side * side * 3);
            large += Bundles(side, seed, Many);
        }

        // Of 100 orders in which the contacts come: at least half a bundle less on average, of six to nine (0.7 to 1.3 when this was
        // written).
        Assert.True(small < large - 50, $"{small} bundles where a large world has {large}");
    }

    [Fact]
    public void Stack_InASmallWorld_IsSolvedInMoreThanTwoColors()
    {
        for (int seed = 0; seed < 20; seed++)
        {
            var graph = new ConstraintGraph();
            Fill(graph, Stack(10), seed, 9);
            Assert.InRange(graph.Solved.Length, 2, 4);
        }
    }

    private static int Bundles(int side, int seed, int pairs)
    {
        var graph = new ConstraintGraph();
        Column<ContactRecord> records = Fill(graph, Pyramid(side), seed, pairs);
        int bundles = 0;
        foreach (GraphColor color in graph.Solved)
        {
            bundles += color.BundleCount;
            var bodies = new HashSet<int>();
            foreach (ContactBundle* bundle in color.Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes && bundle->Contact[lane] >= 0; lane++)
                {
                    ref ContactRecord record = ref records[bundle->Contact[lane]];
                    Assert.True(bodies.Add(record.BodyA) && bodies.Add(record.BodyB), "Two rows of a colour share a body.");
                }
            }
        }

        return bundles;
    }

    private static Column<ContactRecord> Fill(ConstraintGraph graph, List<(int A, int B)> touching, int seed, int pairs)
    {
        var random = new Random(seed);
        var records = new Column<ContactRecord>(touching.Count);
        graph.EnsureBodies(64);
        graph.NotePairs(pairs);
        for (int i = touching.Count - 1; i > 0; i--)
        {
            int other = random.Next(i + 1);
            (touching[i], touching[other]) = (touching[other], touching[i]);
        }

        for (int i = 0; i < touching.Count; i++)
        {
            records[i] = new ContactRecord { BodyA = touching[i].A, BodyB = touching[i].B };
            graph.Add(i, ref records[i], movesA: true, movesB: true);
        }

        return records;
    }

    /// <summary>Boxes side by side, each row of them on the gaps of the one below.</summary>
    private static List<(int A, int B)> Pyramid(int side)
    {
        var touching = new List<(int A, int B)>();
        int first = 1;
        for (int row = side; row > 0; row--)
        {
            for (int i = 0; i < row; i++)
            {
                int body = first + i;
                if (i + 1 < row)
                {
                    touching.Add((body, body + 1));
                    touching.Add((body, first + row + i));
                    touching.Add((body + 1, first + row + i));
                }
            }

            first += row;
        }

        return touching;
    }

    private static List<(int A, int B)> Stack(int count)
    {
        var touching = new List<(int A, int B)>();
        for (int i = 1; i < count; i++)
        {
            touching.Add((i, i + 1));
        }

        return touching;
    }
}
