using System;
using System.Collections.Generic;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Simulation;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;
using Farseer.Engine.Tests.Simulation;
using FsCheck;
using FsCheck.Fluent;
using Xunit;

namespace Farseer.Engine.Tests.Graph;

public sealed unsafe class RowHalvesTests
{
    private const int Bodies = 1200;
    private const int Contacts = 3000;

    [Fact]
    public void RowsThatComeAfterTheBodiesWereHalved_LieInTheHalfOfTheirFirstBody()
    {
        var rows = new Rows();
        rows.Part();
        rows.Fill(seed: 3, upTo: Bodies);

        Assert.Equal(Bodies / 2, rows.Graph.Groups.Middle);
        Assert.Equal(2, rows.Graph.Groups.InUse);
        rows.AssertHalves(Contacts);
    }

    /// <summary>What comes and goes between, and whatever bodies have the rows: each half has at least three eighths of them.</summary>
    [Fact]
    public void RowsHalvedAnew_AreEvenAndKeepWhatTheyHold() => Prop.ForAll(
        Gen.Choose(0, int.MaxValue).ToArbitrary(),
        seed =>
        {
            var random = new Random(seed);
            var rows = new Rows();
            rows.Part();
            rows.Fill(seed, upTo: random.Next(200, Bodies));
            rows.PartWhenDue();
            int removed = rows.Remove(random.Next(2, 9));
            rows.PartWhenDue();
            int[] counts = rows.AssertHalves(Contacts - removed);
            Assert.True(Math.Min(counts[0], counts[1]) * 8 >= 3 * (counts[0] + counts[1]), $"{counts[0]} and {counts[1]} rows");
        }).Check(Config.QuickThrowOnFailure.WithMaxTest(20));

    [Fact]
    public void RowsOfFewBodies_AreNotHalved()
    {
        var rows = new Rows { Halves = { LeastBodies = Bodies + 1 } };
        rows.Fill(seed: 5, upTo: Bodies);
        rows.PartWhenDue();

        Assert.False(rows.Graph.Groups.AreHalves);
        Assert.Equal(0, rows.Halves.Partings);
        Assert.All(rows.Graph.Used.ToArray(), color => Assert.Equal(0, color.Group));
    }

    [Fact]
    public void ColorsOfFewRows_AreNotHalved_UntilTheyAreSortedWithMore()
    {
        var rows = new Rows();
        rows.Halves.LeastOfColor = Contacts;
        rows.Part();
        rows.Fill(seed: 9, upTo: Bodies);
        Assert.All(rows.Graph.Used.ToArray(), color => Assert.Equal(0, color.Group));

        rows.Graph.Groups.Halve(rows.Graph.Groups.Middle, leastOfColor: 0);
        rows.Sort();

        rows.AssertHalves(Contacts);
    }

    /// <summary>Where workers begin with the rows of their own half, the phases that do not care for colours do too.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    public void BundlesOfHalves_InParts_ComeOnceAndHalfByHalf(int parts)
    {
        var rows = new Rows();
        rows.Part();
        rows.Fill(seed: 11, upTo: Bodies);
        var ranges = new ColorRanges();
        ranges.Find(rows.Graph, parts);
        var groups = new Dictionary<IntPtr, int>();
        foreach (GraphColor color in rows.Graph.Used)
        {
            foreach (ContactBundle* bundle in color.Bundles)
            {
                groups.Add((IntPtr)bundle, color.Group);
            }
        }

        int last = 0;
        for (int from = 0; from < ranges.Count;)
        {
            foreach (ContactBundle* bundle in new BundleWalk(ranges.From(from, ranges.Count, out from)))
            {
                Assert.True(groups.Remove((IntPtr)bundle, out int group), "A bundle came twice.");
                Assert.True(parts % 2 != 0 || group >= last, "A bundle of the first half came behind those of the second.");
                last = group;
            }
        }

        Assert.Empty(groups);
    }

    /// <summary>No result follows from the halves where nothing bounces and no body is fast.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void PileOfHalves_MovesAsWithout_BitForBit(int workers)
    {
        World without = Pile(int.MaxValue, 1);
        using World with = Pile(16, workers);
        for (int step = 0; step < 120; step++)
        {
            without.Step(SleepScene.Dt);
            with.Step(SleepScene.Dt);
            Assert.Equal(without.MotionHash(), with.MotionHash());
        }

        Assert.Equal(0, without.RowHalves.Partings);
        Assert.True(with.RowHalves.Partings > 0, "The rows were not halved.");
    }

    private static World Pile(int leastBodies, int workers)
    {
        var scene = new SleepScene(allowSleep: false);
        scene.World.RowHalves.LeastBodies = leastBodies;
        scene.World.RowHalves.LeastOfColor = 0;
        scene.World.SetWorkers(workers, workers, null);
        for (int i = 0; i < 300; i++)
        {
            scene.Box(1.1f * ((i * 7 % 20) - 10) + (0.03f * (i % 5)), 0.6f + (1.2f * (i / 20)), 1, 1, BodyFlags.None);
        }

        return scene.World;
    }

    /// <summary>Contacts between bodies near each other, each with its own number as an impulse; every tenth body cannot move.</summary>
    private sealed class Rows
    {
        private readonly Column<ContactRecord> _records = new Column<ContactRecord>();
        private readonly Column<byte> _moves = new Column<byte>();
        private readonly Scratch _scratch = new Scratch();

        public Rows()
        {
            Graph.EnsureBodies(Bodies);
            _records.EnsureCapacity(Contacts);
            _moves.EnsureCapacity(Bodies);
            for (int i = 0; i < Bodies; i++)
            {
                _moves[i] = (byte)(i % 10 == 0 ? 0 : 1);
            }
        }

        public ConstraintGraph Graph { get; } = new ConstraintGraph();

        public RowHalves Halves { get; } = new RowHalves { LeastBodies = Bodies, LeastOfColor = 0 };

        public void Part() => Halves.Part(Graph, _records, Bodies, _moves.Pointer, _scratch);

        public void Sort()
        {
            using var alone = new StageRunner(1, null);
            new RowOrder { LeastRows = 2 }.Sort(alone, Graph, _records, Bodies, _moves.Pointer, _scratch);
        }

        /// <summary>It looks once in so many steps.</summary>
        public void PartWhenDue()
        {
            for (int step = 0; step < 16; step++)
            {
                Part();
            }
        }

        public void Fill(int seed, int upTo)
        {
            var random = new Random(seed);
            for (int i = 0; i < Contacts; i++)
            {
                int a = random.Next(upTo);
                int b = (a + 1 + random.Next(30)) % upTo;
                b = _moves[a] == 0 && _moves[b] == 0 ? (b + 1) % upTo : b;
                _records[i].BodyA = a;
                _records[i].BodyB = b;
                Graph.Add(i, ref _records[i], _moves[a] != 0, _moves[b] != 0);
                Graph.BundleOf(_records[i].Row)->Point0.Normal[RowArena.LaneOf(_records[i].Row)] = i;
            }
        }

        /// <summary>Takes out one of so many.</summary>
        /// <returns>How many.</returns>
        public int Remove(int part)
        {
            int removed = 0;
            for (int i = 0; i < Contacts; i += part)
            {
                Graph.Remove(ref _records[i], _records);
                removed++;
            }

            return removed;
        }

        /// <returns>Rows of each half.</returns>
        public int[] AssertHalves(int rows)
        {
            int[] counts = new int[2];
            foreach (GraphColor color in Graph.Used)
            {
                foreach (ContactBundle* bundle in color.Bundles)
                {
                    for (int lane = 0; lane < ContactBundle.Lanes && bundle->Contact[lane] >= 0; lane++)
                    {
                        int contact = bundle->Contact[lane];
                        ref ContactRecord record = ref _records[contact];
                        int place = RowGroups.PlaceOf(record.BodyA, record.BodyB, _moves[record.BodyA] != 0, _moves[record.BodyB] != 0);
                        Assert.Equal(color.HasOrder || place < Graph.Groups.Middle ? 0 : 1, color.Group);
                        Assert.Equal(color.Group, record.Group);
                        Assert.True(bundle == Graph.BundleOf(record.Row) && lane == RowArena.LaneOf(record.Row));
                        Assert.Equal(contact, (int)bundle->Point0.Normal[lane]);
                        counts[color.Group]++;
                    }
                }
            }

            Assert.Equal(rows, counts[0] + counts[1]);
            return counts;
        }
    }
}
