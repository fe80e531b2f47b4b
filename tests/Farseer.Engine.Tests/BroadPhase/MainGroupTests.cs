using System;
using System.Collections.Generic;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Numerics;
using Xunit;

namespace Farseer.Engine.Tests.BroadPhase;

/// <summary>The search in worlds of which nearly all is one group that does not collide with itself.</summary>
public sealed class MainGroupTests
{
    private const int Count = 300;

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(48)]
    [InlineData(49)]
    [InlineData(200)]
    public void Collect_WithFewBoxesOutsideOfAGroup_FindsAllPairsButThoseOfTheGroup(int others)
    {
        var random = new Random(others + 1);
        var proxies = new ProxyStore { End = Count };
        proxies.Set.EnsureCapacity(Count);
        var finders = new IBroadPhase[] { new LevelGrid(), new BruteForce() };
        for (int i = 0; i < Count; i++)
        {
            proxies.Info[i] = new ProxyInfo { Body = i / 2, Group = i < others ? -(i % 3) : 7 };
            Place(proxies, i, random);
            Add(finders, proxies, i);
        }

        for (int step = 0; step < 60; step++)
        {
            for (int i = 0; i < Count; i++)
            {
                proxies.Info[i].Flags &= ~ProxyFlags.Moved;
                if (random.Next(4) == 0)
                {
                    Place(proxies, i, random);
                }
            }

            // Who changes the group is removed and added: the world becomes one without a main group, or with one.
            if (step % 20 == 19)
            {
                int changed = random.Next(Count);
                Remove(finders, proxies, changed);
                proxies.Info[changed].Group = random.Next(2) * 7;
                Place(proxies, changed, random);
                Add(finders, proxies, changed);
            }

            Assert.Equal(Find(finders[1], proxies), Find(finders[0], proxies));
        }
    }

    private static void Place(ProxyStore proxies, int proxy, Random random)
    {
        float x = random.Next(200) / 10f;
        float y = random.Next(200) / 10f;
        proxies.Fat[proxy] = new Box(x, y, x + 1, y + 1);
        proxies.Info[proxy].Flags = ProxyFlags.Alive | ProxyFlags.Moved;
    }

    private static void Add(IBroadPhase[] finders, ProxyStore proxies, int proxy)
    {
        foreach (IBroadPhase finder in finders)
        {
            finder.Added(proxies, proxy);
        }
    }

    private static void Remove(IBroadPhase[] finders, ProxyStore proxies, int proxy)
    {
        proxies.Info[proxy].Flags = ProxyFlags.None;
        foreach (IBroadPhase finder in finders)
        {
            finder.Removed(proxies, proxy);
        }
    }

    /// <summary>The pairs but for those of one group, which a search may leave out.</summary>
    private static List<ulong> Find(IBroadPhase finder, ProxyStore proxies)
    {
        var pairs = new PairBuffer();
        finder.Collect(proxies, pairs);
        var found = new List<ulong>();
        for (int i = 0; i < pairs.Count; i++)
        {
            int group = proxies.Info[PairBuffer.Lower(pairs[i])].Group;
            if (group == 0 || group != proxies.Info[PairBuffer.Higher(pairs[i])].Group)
            {
                found.Add(pairs[i]);
            }
        }

        found.Sort();
        return found;
    }
}
