using System;
using System.Collections.Generic;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Numerics;
using FsCheck;
using FsCheck.Fluent;
using Xunit;

namespace Farseer.Engine.Tests.BroadPhase;

/// <summary>Every pair finder against brute force.</summary>
public class PairFinderTests
{
    private static readonly Dictionary<string, Func<IBroadPhase>> Finders = new Dictionary<string, Func<IBroadPhase>>
    {
        ["LevelGrid"] = () => new LevelGrid(),
        ["SweepAndPrune"] = () => new SweepAndPrune(),
        ["SelectiveSweep"] = () => new SelectiveSweep(),
        ["BruteForce"] = () => new BruteForce(),
    };

    public static TheoryData<string> Names()
    {
        var data = new TheoryData<string>();
        foreach (string name in Finders.Keys)
        {
            data.Add(name);
        }

        return data;
    }

    public static TheoryData<string, BoxKind> NamesAndKinds()
    {
        var data = new TheoryData<string, BoxKind>();
        foreach (string name in Finders.Keys)
        {
            if (name == "BruteForce")
            {
                continue;
            }

            foreach (BoxKind kind in Enum.GetValues<BoxKind>())
            {
                data.Add(name, kind);
            }
        }

        return data;
    }

    [Theory]
    [MemberData(nameof(NamesAndKinds))]
    public void Collect_OverManyFrames_FindsTheSamePairsAsBruteForce(string name, BoxKind kind)
    {
        foreach (int count in new[] { 12, 150, 400 })
        {
            Compare(name, kind, seed: count + (int)kind, count, frames: 100);
        }
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Collect_OnAnyScene_FindsTheSamePairsAsBruteForce(string name)
    {
        Gen<(int Seed, BoxKind Kind, int Count)> scenes =
            from seed in Gen.Choose(0, int.MaxValue)
            from kind in Gen.Elements(Enum.GetValues<BoxKind>())
            from count in Gen.Choose(0, 60)
            select (seed, kind, count);
        Prop.ForAll(scenes.ToArbitrary(), scene => Compare(name, scene.Kind, scene.Seed, scene.Count, frames: 25))
            .QuickCheckThrowOnFailure();
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Collect_WithNothingMoved_FindsNothing(string name)
    {
        IBroadPhase finder = Finders[name]();
        var scene = new BoxScene(1, BoxKind.Gas, 100, finder);
        var pairs = new PairBuffer();
        finder.Collect(scene.Proxies, pairs);
        Assert.NotEqual(0, pairs.Count);
        scene.ClearMoved();
        pairs.Clear();
        finder.Collect(scene.Proxies, pairs);
        Assert.Equal(0, pairs.Count);
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Collect_OfProxyThatWasReplaced_UsesTheNewBox(string name)
    {
        IBroadPhase finder = Finders[name]();
        var proxies = new ProxyStore();
        proxies.Set.EnsureCapacity(2);
        proxies.End = 2;
        Place(proxies, finder, 0, new Box(0, 0, 1, 1));
        Place(proxies, finder, 1, new Box(5, 0, 6, 1));
        Assert.Empty(Collect(finder, proxies));

        // Removed and added again within one step, twice.
        finder.Removed(proxies, 1);
        Place(proxies, finder, 1, new Box(9, 0, 10, 1));
        finder.Removed(proxies, 1);
        Place(proxies, finder, 1, new Box(1, 1, 2, 2));
        Assert.Equal(new[] { PairBuffer.Pack(0, 1) }, Collect(finder, proxies));

        proxies.Info[1].Flags = ProxyFlags.None;
        finder.Removed(proxies, 1);
        Assert.Empty(Collect(finder, proxies));
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Collect_OnceWarm_AllocatesNothing(string name)
    {
        foreach (double moving in new[] { 1.0, 0.05 })
        {
            IBroadPhase finder = Finders[name]();
            var scene = new BoxScene(3, BoxKind.Gas, 500, finder);
            var pairs = new PairBuffer();
            for (int frame = 0; frame < 200; frame++)
            {
                Step(scene, finder, pairs, moving);
            }

            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int frame = 0; frame < 50; frame++)
            {
                Step(scene, finder, pairs, moving);
            }

            Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
        }
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Collect_OfScaledScene_FindsTheSamePairsInTheSameOrder(string name)
    {
        IBroadPhase finder = Finders[name]();
        IBroadPhase scaledFinder = Finders[name]();
        var scene = new BoxScene(5, BoxKind.Mixed, 300, finder);
        var scaled = new ProxyStore();
        scaled.Set.EnsureCapacity(scene.Proxies.End);
        for (int frame = 0; frame < 40; frame++)
        {
            scene.Change(0.3, population: false);
            scaled.End = scene.Proxies.End;
            for (int i = 0; i < scaled.End; i++)
            {
                Box box = scene.Proxies.Fat[i];
                scaled.Fat[i] = new Box(box.MinX * 1024, box.MinY * 1024, box.MaxX * 1024, box.MaxY * 1024);
                scaled.Info[i] = scene.Proxies.Info[i];
                if (frame == 0)
                {
                    scaledFinder.Added(scaled, i);
                }
            }

            var pairs = new PairBuffer();
            var scaledPairs = new PairBuffer();
            finder.Collect(scene.Proxies, pairs);
            scaledFinder.Collect(scaled, scaledPairs);
            Assert.Equal(pairs.Count, scaledPairs.Count);
            for (int i = 0; i < pairs.Count; i++)
            {
                Assert.Equal(pairs[i], scaledPairs[i]);
            }

            scene.ClearMoved();
        }
    }

    [Theory]
    [MemberData(nameof(NamesAndKinds))]
    public void Collect_WithTheBoxesOfTheLastSearch_LeavesOutOnlyPairsThatOverlappedThen(string name, BoxKind kind)
    {
        IBroadPhase finder = Finders[name]();
        var reference = new BruteForce();
        var scene = new BoxScene((int)kind, kind, 300, finder);
        ProxyStore proxies = scene.Proxies;
        var pairs = new PairBuffer();
        var all = new PairBuffer();
        int left = 0;
        for (int frame = 0; frame < 100; frame++)
        {
            scene.Change(moveChance: frame % 30 == 0 ? 0.05 : 0.9, population: frame % 2 == 0);
            pairs.Clear();
            all.Clear();
            finder.Collect(proxies, pairs);
            reference.Collect(proxies, all);
            var found = new HashSet<ulong>(BoxScene.Sorted(pairs));
            Assert.Equal(found.Count, pairs.Count);
            Assert.Subset(new HashSet<ulong>(BoxScene.Sorted(all)), found);
            for (int i = 0; i < all.Count; i++)
            {
                if (!found.Contains(all[i]))
                {
                    Assert.True(Box.Overlap(proxies.Sought[PairBuffer.Lower(all[i])], proxies.Sought[PairBuffer.Higher(all[i])]));
                    left++;
                }
            }

            scene.ClearMoved(sought: true);
        }

        Assert.Equal(name == "LevelGrid", left > 0);
    }

    private static bool Compare(string name, BoxKind kind, int seed, int count, int frames)
    {
        IBroadPhase finder = Finders[name]();
        var reference = new BruteForce();
        var scene = new BoxScene(seed, kind, count, finder);
        var pairs = new PairBuffer();
        var expected = new PairBuffer();
        for (int frame = 0; frame < frames; frame++)
        {
            // Long quiet spells let boxes come to rest in whatever structure is kept for that.
            double moveChance = (frame / 30 % 3) switch { 0 => 0.9, 1 => 0.02, _ => 0.2 };
            scene.Change(moveChance, population: frame % 2 == 0);
            pairs.Clear();
            expected.Clear();
            finder.Collect(scene.Proxies, pairs);
            reference.Collect(scene.Proxies, expected);
            Assert.Equal(BoxScene.Sorted(expected), BoxScene.Sorted(pairs));
            scene.ClearMoved();
        }

        return true;
    }

    private static void Step(BoxScene scene, IBroadPhase finder, PairBuffer pairs, double moving)
    {
        scene.Change(moving, population: false);
        pairs.Clear();
        finder.Collect(scene.Proxies, pairs);
        scene.ClearMoved();
    }

    private static void Place(ProxyStore proxies, IBroadPhase finder, int proxy, Box box)
    {
        proxies.Fat[proxy] = box;
        proxies.Info[proxy] = new ProxyInfo { Body = proxy, Flags = ProxyFlags.Alive | ProxyFlags.Moved };
        finder.Added(proxies, proxy);
    }

    private static ulong[] Collect(IBroadPhase finder, ProxyStore proxies)
    {
        var pairs = new PairBuffer();
        finder.Collect(proxies, pairs);
        return BoxScene.Sorted(pairs);
    }
}
