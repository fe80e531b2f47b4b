using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Scenes;
using Farseer.Scenes.Performance;
using Farseer.Tests.Shared;
using FarseerGames.FarseerPhysics;
using Xunit;

namespace Farseer.Samples.Tests;

/// <summary>Scenes that go back from every seventh step to an earlier one and forward again come to the same.</summary>
public sealed class RewoundSceneTests
{
    private const int Every = 7;

    /// <summary>Most of what happens in a scene begins within three seconds.</summary>
    private const int MostSteps = 180;

    private const int MostPerformanceSteps = 42;

    public static TheoryData<string, int> Scenes => With(SceneLibrary.All.Select(s => s.Name));

    public static TheoryData<string, int> PerformanceNames => With(PerformanceScenes.All.Select(s => s.Name));

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Scene_BackFromEverySeventhStepAndForwardAgain_ShowsTheSame(string name, int workers)
    {
        Scene scene = SceneLibrary.Find(name)!;
        var simulator = new PhysicsSimulator { WorkerCount = workers };
        scene.Build(simulator);
        PhysicsSimulator[] worlds = [simulator, .. scene.Companions.Select(c => c.Simulator)];
        Rewind(scene, worlds, step => scene.Step(simulator, step, scene.Dt), Math.Min(scene.Steps, MostSteps));
    }

    [Theory]
    [MemberData(nameof(PerformanceNames))]
    public void PerformanceScene_BackFromEverySeventhStepAndForwardAgain_ShowsTheSame(string name, int workers)
    {
        PerformanceScene scene = PerformanceScenes.Find(name)!;
        using var simulator = new PhysicsSimulator { WorkerCount = workers };
        scene.Build(simulator, Math.Max(3, scene.DefaultSize / (scene.DefaultSize > 1000 ? 20 : 4)));
        Rewind(scene, [simulator], Step, MostPerformanceSteps);

        void Step(int step)
        {
            scene.Drive(step);
            simulator.Update(scene.Dt);
        }
    }

    /// <summary>
    /// One state back, by turns four: further than the worlds have been since. By turns with the other number of workers.
    /// </summary>
    private static void Rewind(object scene, PhysicsSimulator[] worlds, Action<int> step, int steps)
    {
        var kept = new List<(PhysicsSimulatorState[] States, OwnMemory Own)>();
        var hashes = new List<ulong>();
        for (int at = 0; at < steps; at++)
        {
            if (at % Every == 0)
            {
                kept.Add(([.. worlds.Select(w => w.Capture())], new OwnMemory(scene)));
            }

            step(at);
            hashes.Add(Hash(worlds));
            if ((at + 1) % Every != 0)
            {
                continue;
            }

            int values = Values(worlds);
            int back = Math.Max(0, kept.Count - (kept.Count % 3 == 0 ? 4 : 1));
            for (int i = 0; i < worlds.Length; i++)
            {
                worlds[i].Restore(kept[back].States[i]);
            }

            kept[back].Own.Restore();
            int workers = worlds[0].WorkerCount;
            worlds[0].WorkerCount = kept.Count % 2 == 0 ? 3 - workers : workers;
            for (int again = Every * back; again <= at; again++)
            {
                step(again);
                Assert.True(hashes[again] == Hash(worlds), $"from step {at + 1} back to {Every * back}: step {again + 1} is another one");
            }

            worlds[0].WorkerCount = workers;
            Assert.Equal(values, Values(worlds));
        }
    }

    private static ulong Hash(PhysicsSimulator[] worlds) => worlds.Aggregate(0ul, (hash, world) => (hash * 31) + world.MotionHash());

    private static int Values(PhysicsSimulator[] worlds) => PublicValues.HashOf(worlds.SelectMany(w =>
        w.BodyList.AsEnumerable<object>().Append(w)
        .Concat(w.GeomList).Concat(w.JointList).Concat(w.SpringList).Concat(w.ControllerList).Concat(w.ArbiterList)
        .Concat(w.ArbiterList.SelectMany(a => a.ContactList.Cast<object>()))));

    private static TheoryData<string, int> With(IEnumerable<string> names)
    {
        TheoryData<string, int> data = [];
        foreach (string name in names)
        {
            data.Add(name, 1);
            data.Add(name, 2);
        }

        return data;
    }
}
