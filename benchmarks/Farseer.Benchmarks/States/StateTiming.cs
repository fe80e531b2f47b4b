using System;
using System.CommandLine;
using System.IO;
using System.Linq;
using Farseer.Scenes.Performance;
using Farseer.Tests.Shared.Growth;
using FarseerGames.FarseerPhysics;

namespace Farseer.Benchmarks.States;

/// <summary>
/// The verb <c>rollback</c>: what states and frames of a <see cref="RollbackBuffer"/> take, as shares of an update of the same run.
/// </summary>
internal static class StateTiming
{
    private const int WarmSteps = 60;
    private const int Turns = 30;
    private const int Back = 8;

    private static readonly Argument<string[]> _scenes = new("scene") { Description = "names of scenes; none: all" };

    public static Command Create() => Verb.Of(
        "rollback", "What states and frames of a rollback buffer take, as shares of an update.", Run, _scenes);

    private static int Run(ParseResult result)
    {
        TextWriter output = result.Output();
        string[] names = [.. (result.GetValue(_scenes) ?? []).Select(name => Verb.Scene(name).Name)];
        output.WriteLine($"one worker, after {WarmSteps} updates (half of a shorter scene), least of {Turns} turns each, processor time;");
        output.WriteLine($"rewind is by {Back} frames; bytes a frame are the mean of the frames but the newest, which is whole");
        output.WriteLine(
            "| scene | bodies | asleep | bytes a body | an update | bytes a body and frame | capture | restore | push | rewind | hash |");
        output.WriteLine("|---|---|---|---|---|---|---|---|---|---|---|");
        foreach (PerformanceScene scene in PerformanceScenes.All)
        {
            if (names.Length == 0 || names.Contains(scene.Name))
            {
                output.WriteLine(Measure(scene, false));
            }
        }

        PerformanceScene pyramid = PerformanceScenes.All.First(s => s.Name == "large_pyramid");
        if (names.Length == 0 || names.Contains(pyramid.Name))
        {
            output.WriteLine(Measure(pyramid, true));
        }

        return 0;
    }

    private static string Measure(PerformanceScene scene, bool asleep)
    {
        using var simulator = new PhysicsSimulator();
        scene.Build(simulator, scene.DefaultSize);
        int step = 0;
        for (; step < Math.Min(WarmSteps, scene.Steps / 2); step++)
        {
            Step();
        }

        if (asleep)
        {
            simulator.AllowSleep = true;
            foreach (var body in simulator.BodyList)
            {
                body.Awake = false;
            }
        }

        var state = new PhysicsSimulatorState();
        var buffer = new RollbackBuffer(simulator, (2 * Turns) + Back);
        WarmUp();
        var update = new double[Turns];
        var capture = new double[Turns];
        var restore = new double[Turns];
        var push = new double[Turns];
        var rewind = new double[Turns];
        var hash = new double[Turns];
        for (int turn = 0; turn < Turns; turn++)
        {
            capture[turn] = Time(() => simulator.Capture(state));
            update[turn] = Time(Step);
            restore[turn] = Time(() => simulator.Restore(state));
            step--;
            Step();
            push[turn] = Time(() => buffer.Push());
            hash[turn] = Time(() => simulator.StateHash());
        }

        // None of so few frames is kept whole.
        var sizes = new RollbackBuffer(simulator, Turns + 1);
        sizes.Push();
        long whole = sizes.ByteCount;
        buffer.Clear();
        buffer.Push();
        for (int i = 0; i < Turns; i++)
        {
            Step();
            sizes.Push();
            buffer.Push();
        }

        int bodies = simulator.BodyList.Count;
        double frame = (double)(sizes.ByteCount - whole) / Turns / bodies;
        int sleepers = simulator.BodyList.Count(b => !b.Awake);
        int newest = step;
        for (int turn = 0; turn < Turns; turn++)
        {
            rewind[turn] = Time(() => buffer.Rewind(buffer.NewestFrame - Back));
            step = newest - Back;
            Step();
            buffer.Push();
            while (step < newest)
            {
                Step();
                buffer.Push();
            }
        }

        return FormattableString.Invariant(
            $"| {scene.Name} | {bodies:n0} | {sleepers:n0} | {(double)state.ByteCount / bodies:n0} | {update.Min():f3} ms | {frame:n1} ")
            + FormattableString.Invariant(
                $"| {Share(capture):p0} | {Share(restore):p0} | {Share(push):p0} | {Share(rewind):p0} | {Share(hash):p0} |");

        double Share(double[] times) => times.Min() / update.Min();

        // Until all of it is compiled as well as it will be and the buffer has the memory of all its frames; then back to where it was.
        void WarmUp()
        {
            simulator.Capture(state);
            PhysicsSimulatorState start = simulator.Capture();
            int first = step;
            for (int i = 0; i < (2 * Turns) + Back; i++)
            {
                Step();
                buffer.Push();
                simulator.Restore(state);
                buffer.Rewind(buffer.NewestFrame);
                simulator.Capture(state);
                simulator.StateHash();
            }

            simulator.Restore(start);
            buffer.Clear();
            step = first;
        }

        void Step()
        {
            scene.Drive(step++);
            simulator.Update(scene.Dt);
        }
    }

    /// <summary>Milliseconds of this thread's processor time, less what reading the clock takes: all of it runs on one thread.</summary>
    private static double Time(Action action)
    {
        double start = GrowthClock.Seconds();
        double empty = GrowthClock.Seconds();
        action();
        return 1e3 * (GrowthClock.Seconds() - empty - (empty - start));
    }
}
