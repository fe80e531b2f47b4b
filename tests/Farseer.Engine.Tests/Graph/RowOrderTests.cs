using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;
using Farseer.Engine.Tests.Simulation;
using Xunit;

namespace Farseer.Engine.Tests.Graph;

public sealed unsafe class RowOrderTests
{
    private const int Bodies = 400;
    private const int Contacts = 1500;

    [Fact]
    public void RowsPutInOrder_FollowTheirKindsAndBodiesAndKeepWhatTheyHold()
    {
        Fill(out ConstraintGraph graph, out Column<ContactRecord> records, out Column<byte> moves);
        int[] colors = new int[Contacts];
        for (int i = 0; i < Contacts; i++)
        {
            colors[i] = records[i].Color;
        }

        using var alone = new StageRunner(1, null);
        var order = new RowOrder { LeastRows = 2 };
        order.Sort(alone, graph, records, Bodies, moves.Pointer, new Scratch());

        Assert.Equal(1, order.Sorts);
        Assert.Equal(0, graph.NewRows);
        foreach (GraphColor color in graph.Used)
        {
            int last = -1;
            foreach (ContactBundle* bundle in color.Bundles)
            {
                for (int lane = 0; lane < ContactBundle.Lanes && bundle->Contact[lane] >= 0; lane++)
                {
                    int contact = bundle->Contact[lane];
                    Assert.True(bundle == graph.BundleOf(records[contact].Row) && lane == RowArena.LaneOf(records[contact].Row));
                    Assert.Equal(colors[contact], records[contact].Color);
                    Assert.Equal(records[contact].BodyA, bundle->BodyA[lane]);
                    Assert.Equal(records[contact].BodyB, bundle->BodyB[lane]);
                    Assert.Equal(contact, (int)bundle->Point0.Normal[lane]);
                    Assert.Equal((PairKind)(contact % ContactRecord.Kinds), records[contact].Kind);
                    int place = ((int)records[contact].Kind * Bodies) + Place(records[contact], moves);
                    Assert.True(color.IsSequential || color.RowCount * 40 < Bodies || place > last, "Row " + place + " behind " + last);
                    last = place;
                }
            }
        }
    }

    [Fact]
    public void RowsPutInOrder_AgainBeforeHalfOfThemAreNew_StayAsTheyAre()
    {
        Fill(out ConstraintGraph graph, out Column<ContactRecord> records, out Column<byte> moves);
        using var alone = new StageRunner(1, null);
        var order = new RowOrder { LeastRows = 2 };
        order.Sort(alone, graph, records, Bodies, moves.Pointer, new Scratch());
        for (int i = 0; i < Contacts / 3; i++)
        {
            ContactRecord record = records[i];
            graph.Remove(ref records[i], records);
            graph.Add(i, ref records[i], moves[record.BodyA] != 0, moves[record.BodyB] != 0);
        }

        order.Sort(alone, graph, records, Bodies, moves.Pointer, new Scratch());

        Assert.Equal(1, order.Sorts);
    }

    /// <summary>No result follows from the order of rows where nothing bounces and no body is fast.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void PileWithRowsInOrder_MovesAsWithout_BitForBit(int workers)
    {
        SleepScene without = Pile(int.MaxValue, 1);
        SleepScene with = Pile(16, workers);
        for (int step = 0; step < 120; step++)
        {
            without.World.Step(SleepScene.Dt);
            with.World.Step(SleepScene.Dt);
            Assert.Equal(without.World.MotionHash(), with.World.MotionHash());
        }

        Assert.Equal(0, without.World.RowOrder.Sorts);
        Assert.True(with.World.RowOrder.Sorts > 1, "The rows were put in order " + with.World.RowOrder.Sorts + " times.");
        with.World.Dispose();
    }

    private static SleepScene Pile(int leastRows, int workers)
    {
        var scene = new SleepScene(allowSleep: false);
        scene.World.RowOrder.LeastRows = leastRows;
        scene.World.SetWorkers(workers, workers, null);
        for (int i = 0; i < 300; i++)
        {
            scene.Box(1.1f * ((i * 7 % 20) - 10) + (0.03f * (i % 5)), 0.6f + (1.2f * (i / 20)), 1, 1, BodyFlags.None);
        }

        return scene;
    }

    /// <summary>Contacts between bodies drawn at random, each with its own number as an impulse; every tenth body cannot move.</summary>
    private static void Fill(out ConstraintGraph graph, out Column<ContactRecord> records, out Column<byte> moves)
    {
        var random = new Random(7);
        graph = new ConstraintGraph();
        records = new Column<ContactRecord>();
        moves = new Column<byte>();
        graph.EnsureBodies(Bodies);
        records.EnsureCapacity(Contacts);
        moves.EnsureCapacity(Bodies);
        for (int i = 0; i < Bodies; i++)
        {
            moves[i] = (byte)(i % 10 == 0 ? 0 : 1);
        }

        for (int i = 0; i < Contacts; i++)
        {
            int a = random.Next(Bodies);
            int b = (a + 1 + random.Next(30)) % Bodies;
            b = moves[a] == 0 && moves[b] == 0 ? (b + 1) % Bodies : b;
            records[i].BodyA = a;
            records[i].BodyB = b;
            records[i].Kind = (PairKind)(i % ContactRecord.Kinds);
            graph.Add(i, ref records[i], moves[a] != 0, moves[b] != 0);
            graph.BundleOf(records[i].Row)->Point0.Normal[RowArena.LaneOf(records[i].Row)] = i;
        }
    }

    private static int Place(in ContactRecord record, Column<byte> moves)
    {
        int a = record.BodyA;
        int b = record.BodyB;
        return moves[a] != 0 && moves[b] != 0 ? Math.Min(a, b) : moves[a] != 0 ? a : b;
    }
}
