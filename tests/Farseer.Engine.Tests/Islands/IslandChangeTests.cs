using System;
using System.Collections.Generic;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Islands;

public sealed unsafe class IslandChangeTests
{
    private const int Bodies = 24;
    private const int Ground = 1;

    /// <summary>Layers of bodies in random touch, in which contacts come and go: what is kept must be what a search would find.</summary>
    [Fact]
    public void Keep_OnRandomChanges_LeavesWhatBuildFinds()
    {
        int kept = 0;
        using var alone = new StageRunner(1, null);
        for (int seed = 0; seed < 200; seed++)
        {
            var random = new Random(seed);
            var graph = new ConstraintGraph();
            graph.EnsureBodies(Bodies);
            var records = new Column<ContactRecord>(Bodies * Bodies);
            var moves = new Column<byte>(Bodies);
            for (int i = 0; i < Bodies; i++)
            {
                moves[i] = i > Ground ? (byte)1 : (byte)0;
            }

            var islands = new IslandStore();
            var fresh = new IslandStore();
            var scratch = new Scratch();
            var present = new List<int>();
            for (int step = 0; step < 40; step++)
            {
                int changes = step == 0 ? 60 : random.Next(1, 4);
                for (int i = 0; i < changes; i++)
                {
                    Change(random, graph, records, moves, present);
                }

                if (graph.RowCount == 0)
                {
                    continue;
                }

                if (islands.Keep(graph, records, moves.Pointer))
                {
                    kept++;
                }
                else
                {
                    islands.Build(alone, graph, Bodies, moves.Pointer, scratch);
                }

                graph.ForgetChanges();
                List<int> mine = Read(graph, records, present);
                fresh.Build(alone, graph, Bodies, moves.Pointer, scratch);
                Assert.Equal(Read(graph, records, present), mine);
                Assert.Equal(fresh.Count, islands.Count);
                Assert.Equal(fresh.SlotCount, islands.SlotCount);
            }
        }

        Assert.True(kept > 500, $"only {kept} of 8000 changes were seen through");
    }

    private static void Change(Random random, ConstraintGraph graph, Column<ContactRecord> records, Column<byte> moves, List<int> present)
    {
        // Neighbours in a row of six, and those half a place off in the row below: a wall.
        int b = random.Next(Ground + 1, Bodies);
        int[] others = [b - 1, b - 6, b - 7];
        int a = Math.Max(Ground, others[random.Next(3)]);
        if (a == b)
        {
            return;
        }

        int contact = (a * Bodies) + b;
        if (present.Remove(contact))
        {
            graph.Remove(ref records[contact], records);
        }
        else
        {
            present.Add(contact);
            records[contact] = new ContactRecord { BodyA = a, BodyB = b, PieceA = a, PieceB = b };
            graph.Add(contact, ref records[contact], moves[a] != 0, moves[b] != 0);
        }
    }

    private static List<int> Read(ConstraintGraph graph, Column<ContactRecord> records, List<int> present)
    {
        var rows = new List<int>();
        foreach (int contact in present)
        {
            ContactBundle* row = graph.BundleOf(records[contact].Row);
            int lane = RowArena.LaneOf(records[contact].Row);
            rows.Add(row->Slot[lane]);
        }

        return rows;
    }
}
