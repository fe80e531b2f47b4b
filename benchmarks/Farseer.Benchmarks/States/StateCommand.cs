using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using Farseer.CommandLines;
using Farseer.Scenes;
using Farseer.Scenes.Performance;
using Farseer.Tests.Shared;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.States;

/// <summary>
/// The verb <c>state</c>: every sample scene and every performance scene goes from each seventh step back to an earlier one and
/// forward again, with one and with two workers. After each of those steps the hash of the whole state must be what it was the first
/// time.
/// </summary>
internal static class StateCommand
{
    private const int Every = 7;
    private const int UsualSteps = 180;

    /// <summary>States that are kept: back by up to so many times seven steps.</summary>
    private const int Kept = 4;

    /// <summary>Steps of a performance scene are many times as long.</summary>
    private const int LessSteps = 4;

    private static readonly Argument<string[]> _scenes = new("scene") { Description = "names of scenes; none: all" };
    private static readonly Option<int> _steps = Values.Whole(
        "--steps", "steps of a sample scene; a performance scene has a quarter of them", Every, int.MaxValue, UsualSteps);

    public static Command Create() => Verb.Of(
        "state", "Every scene back from each seventh step and forward again: how often its state is another one.", Run, _scenes, _steps);

    private static int Run(ParseResult result)
    {
        TextWriter output = result.Output();
        string[] names = result.GetValue(_scenes) ?? [];
        if (Array.Find(names, n => SceneLibrary.Find(n) is null && PerformanceScenes.Find(n) is null) is { } unknown)
        {
            throw new UsageException($"no scene is called '{unknown}'.");
        }

        int steps = result.GetValue(_steps);
        (int restores, int differences) = (0, 0);
        output.WriteLine("| scene | workers | restores | steps compared | differences |");
        output.WriteLine("|---|---|---|---|---|");
        string[] all = [.. SceneLibrary.All.Select(s => s.Name), .. PerformanceScenes.All.Select(s => s.Name)];
        foreach (string name in names.Length > 0 ? names : all)
        {
            for (int workers = 1; workers <= 2; workers++)
            {
                using var rewinding = new Rewinding(name, workers);
                rewinding.Run(SceneLibrary.Find(name) is null ? Math.Max(Every, steps / LessSteps) : steps);
                output.WriteLine($"| {name} | {workers} | {rewinding.Restores} | {rewinding.Compared} | {rewinding.Differences} |");
                output.Write(rewinding.First is null ? "" : rewinding.First + Environment.NewLine);
                restores += rewinding.Restores;
                differences += rewinding.Differences;
            }
        }

        output.WriteLine($"{restores} restores, {differences} differences");
        return differences == 0 ? 0 : 1;
    }

    /// <summary>One scene.</summary>
    private sealed class Rewinding : IDisposable
    {
        private readonly List<(int Step, PhysicsSimulatorState[] States, OwnMemory Own)> _kept = [];
        private readonly List<ulong> _hashes = [];
        private readonly PhysicsSimulator[] _worlds;
        private readonly object _scene;
        private readonly Action<int> _step;

        public Rewinding(string name, int workers)
        {
            var simulator = new PhysicsSimulator { WorkerCount = workers };
            if (SceneLibrary.Find(name) is { } scene)
            {
                scene.Build(simulator);
                _scene = scene;
                _worlds = [simulator, .. scene.Companions.Select(c => c.Simulator)];
                _step = step => scene.Step(simulator, step, scene.Dt);
                return;
            }

            PerformanceScene large = PerformanceScenes.Find(name)!;
            large.Build(simulator, large.DefaultSize);
            _scene = large;
            _worlds = [simulator];
            _step = step =>
            {
                large.Drive(step);
                simulator.Update(large.Dt);
            };
        }

        public int Restores { get; private set; }

        public int Compared { get; private set; }

        public int Differences { get; private set; }

        /// <summary>What differed first.</summary>
        public string? First { get; private set; }

        public void Run(int steps)
        {
            for (int at = 0; at < steps; at++)
            {
                if (at % Every == 0)
                {
                    _kept.Add((at, [.. _worlds.Select(w => w.Capture())], new OwnMemory(_scene)));
                    _kept.RemoveRange(0, Math.Max(0, _kept.Count - Kept));
                }

                _step(at);
                _hashes.Add(Hash());
                if ((at + 1) % Every == 0)
                {
                    GoBack(at, _kept[Restores % _kept.Count]);
                }
            }
        }

        private void GoBack(int from, (int Step, PhysicsSimulatorState[] States, OwnMemory Own) to)
        {
            PhysicsSimulatorState[] first = [.. _worlds.Select(w => w.Capture())];
            for (int i = 0; i < _worlds.Length; i++)
            {
                _worlds[i].Restore(to.States[i]);
            }

            Restores++;
            to.Own.Restore();
            for (int again = to.Step; again <= from; again++)
            {
                _step(again);
                Compared++;
                Differences += Hash() == _hashes[again] ? 0 : 1;
            }

            for (int i = 0; i < _worlds.Length && Differences > 0 && First is null; i++)
            {
                StateComparison comparison = first[i].Compare(_worlds[i].Capture(), 10);
                First = comparison.IsSame ? null : $"from step {from + 1} back to {to.Step}:{Environment.NewLine}{comparison}";
            }
        }

        public void Dispose()
        {
            foreach (PhysicsSimulator world in _worlds)
            {
                world.Dispose();
            }
        }

        private ulong Hash() => _worlds.Aggregate(0ul, (hash, world) => (hash * 31) + world.StateHash());
    }
}
