using System;
using System.Collections.Generic;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Numerics;
using Xunit;

namespace Farseer.Engine.Tests.BroadPhase;

public sealed class BoxPacksTests
{
    /// <summary>Numbers of boxes on both sides of a pack, of eight packs, and of the padding behind them.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(8)]
    [InlineData(9)]
    [InlineData(64)]
    [InlineData(65)]
    [InlineData(500)]
    public void Packs_AskedForABox_AreThoseWithBoxesThatMeetIt_InTheirOrder(int count)
    {
        var random = new Random(count);
        var packs = new BoxPacks();
        for (int run = 0; run < 2; run++)
        {
            // What was listed before is forgotten, whether it was more or less.
            Fill(packs, new Box[random.Next(100)], random);
            var boxes = new Box[count];
            Fill(packs, boxes, random);

            for (int question = 0; question < 200; question++)
            {
                Box asked = Near(random, 0, question);
                var expected = new List<int>();
                for (int i = 0; i < count; i++)
                {
                    if (Box.Overlap(boxes[i], asked))
                    {
                        expected.Add(i);
                    }
                }

                Assert.Equal(expected, Find(packs, asked));
            }
        }
    }

    private static void Fill(BoxPacks packs, Box[] boxes, Random random)
    {
        packs.Clear();
        for (int i = 0; i < boxes.Length; i++)
        {
            boxes[i] = Near(random, i * 0.4f, 3);
            packs.Add(1000 + i, boxes[i]);
        }

        Assert.Equal(boxes.Length, packs.Count);
    }

    private static List<int> Find(BoxPacks packs, in Box asked)
    {
        var found = new List<int>();
        var spread = new SpreadBox(asked);
        for (int pack = packs.NextPack(0, spread); pack >= 0; pack = packs.NextPack(pack + 1, spread))
        {
            for (uint mask = packs.Boxes.Overlaps(pack * WideBoxes.Width, spread); mask != 0; mask &= mask - 1)
            {
                found.Add(packs.Proxy((pack * WideBoxes.Width) + WideBoxes.LowestLane(mask)) - 1000);
            }
        }

        return found;
    }

    private static Box Near(Random random, float x, float size)
    {
        float minX = x + (random.Next(200) / 10f);
        float minY = random.Next(200) / 10f;
        return new Box(minX, minY, minX + (random.Next(10) * size / 10f), minY + (random.Next(10) * size / 10f));
    }
}
