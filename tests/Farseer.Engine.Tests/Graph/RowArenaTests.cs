using System;
using System.Collections.Generic;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Xunit;

namespace Farseer.Engine.Tests.Graph;

public sealed unsafe class RowArenaTests
{
    [Fact]
    public void Colors_WithRowsThatComeAndGo_KeepEachRowWhereTheySay()
    {
        for (int seed = 0; seed < 20; seed++)
        {
            var random = new Random(seed);
            var arena = new RowArena();
            var colors = new GraphColor[6];
            var rows = new List<int>[colors.Length];
            for (int i = 0; i < colors.Length; i++)
            {
                colors[i] = new GraphColor(arena, sequential: i == 5);
                rows[i] = [];
            }

            var places = new Dictionary<int, int>();
            int named = 0;
            for (int change = 0; change < 6000; change++)
            {
                int k = random.Next(colors.Length);
                if (random.Next(4000) < 4000 - change && (k != 5 || rows[5].Count < 200))
                {
                    int row = colors[k].AddRow();
                    arena.BundleOf(row)->Contact[RowArena.LaneOf(row)] = named;
                    places[named] = row;
                    rows[k].Add(named++);
                }
                else if (rows[k].Count > 0)
                {
                    int at = random.Next(rows[k].Count);
                    int gone = rows[k][at];
                    rows[k].RemoveAt(at);
                    int moved = colors[k].RemoveRow(places[gone]);
                    if (moved >= 0)
                    {
                        places[moved] = places[gone];
                    }

                    places.Remove(gone);
                }
            }

            for (int k = 0; k < colors.Length; k++)
            {
                Check(arena, colors[k], rows[k], places);
            }
        }
    }

    [Fact]
    public void Arena_WhoseRowsMoveFromColorToColor_DoesNotGrow()
    {
        var arena = new RowArena();
        var from = new GraphColor(arena);
        var to = new GraphColor(arena);
        var rows = new Stack<int>();
        for (int i = 0; i < 5000; i++)
        {
            rows.Push(from.AddRow());
        }

        // A full colour gives back whole extents only: one that is begun is held on both sides.
        int before = arena.Capacity;
        while (rows.TryPop(out int row))
        {
            from.RemoveRow(row);
            to.AddRow();
        }

        Assert.Equal(0, from.RowCount);
        Assert.True(arena.Capacity <= before * 9 / 8, $"{before} bundles grew to {arena.Capacity}");

        to.Clear();
        int grown = arena.Capacity;
        for (int i = 0; i < 5000; i++)
        {
            from.AddRow();
        }

        Assert.Equal(grown, arena.Capacity);
    }

    [Fact]
    public void PartOfAColor_OfAnyRange_IsTheSameBundlesInOrder()
    {
        var arena = new RowArena();
        var first = new GraphColor(arena);
        var second = new GraphColor(arena);
        for (int i = 0; i < 3000; i++)
        {
            first.AddRow();
            second.AddRow();
        }

        var all = new List<IntPtr>();
        foreach (ContactBundle* bundle in first.Bundles)
        {
            all.Add((IntPtr)bundle);
        }

        Assert.Equal(first.BundleCount, all.Count);
        for (int from = 0; from <= all.Count; from += 7)
        {
            for (int to = from; to <= all.Count; to += 31)
            {
                var part = new List<IntPtr>();
                BundleRuns runs = first.Part(from, to);
                while (runs.Next())
                {
                    for (int i = 0; i < runs.Count; i++)
                    {
                        part.Add((IntPtr)ContactBundle.At(runs.Bundles, i));
                    }
                }

                Assert.Equal(all.GetRange(from, to - from), part);
            }
        }
    }

    private static void Check(RowArena arena, GraphColor color, List<int> rows, Dictionary<int, int> places)
    {
        Assert.Equal(rows.Count, color.RowCount);
        foreach (int name in rows)
        {
            Assert.Equal(name, arena.BundleOf(places[name])->Contact[RowArena.LaneOf(places[name])]);
        }

        int found = 0;
        foreach (ContactBundle* bundle in color.Bundles)
        {
            for (int lane = 0; lane < ContactBundle.Lanes; lane++)
            {
                found += bundle->Contact[lane] >= 0 ? 1 : 0;
            }
        }

        Assert.Equal(rows.Count, found);
    }
}
