using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading;
using Farseer.Hunt.Calls;

namespace Farseer.Hunt.Running;

/// <summary>Makes worlds from seeds, runs them, and makes each failure small and a file.</summary>
internal sealed class Hunter(Facade facade, TextWriter output)
{
    /// <summary>
    /// An update of a world of this size (some hundred bodies, 50 iterations) takes some milliseconds; a world a few seconds, the
    /// slowest that was seen eight,
    /// and a minute on a machine that had four times as much to do. What has not ended then does not end.
    /// </summary>
    private static readonly TimeSpan _patience = TimeSpan.FromSeconds(300);

    private readonly Dictionary<string, int> _kinds = new(StringComparer.Ordinal);

    public int Worlds { get; private set; }

    public long Calls { get; private set; }

    public long Steps { get; private set; }

    public double Longest { get; private set; }

    public int Failures => _kinds.Values.Sum();

    /// <summary>Failures of each kind.</summary>
    public IReadOnlyDictionary<string, int> Kinds => _kinds;

    /// <summary>Files of failures, one of each kind.</summary>
    public List<string> Files { get; } = new();

    public string? Folder { get; init; }

    public Profile? Only { get; init; }

    public TimeSpan ShrinkTime { get; init; } = TimeSpan.FromSeconds(60);

    /// <summary>Fixed for all worlds; without, one world in four runs with 1, 2 and 4 and must end with the same bits.</summary>
    public int? Workers { get; init; }

    /// <summary>Runs worlds until the time is over or as many have run.</summary>
    public void Run(ulong seed, TimeSpan time, int mostWorlds = int.MaxValue, int mostFailures = int.MaxValue)
    {
        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{facade.Name}: seeds from {seed}"));
        long start = Stopwatch.GetTimestamp();
        for (; Stopwatch.GetElapsedTime(start) < time && Worlds < mostWorlds && Failures < mostFailures; seed++)
        {
            if (Folder is not null)
            {
                // What ends the process leaves its seed.
                File.WriteAllText(Path.Combine(Folder, facade.Name + ".running.txt"), seed.ToString(CultureInfo.InvariantCulture));
            }

            Worlds++;
            Script script = Decoder.Read(facade, Choices.FromSeed(seed), Only);
            if (Try(script, seed % 4 == 0) is { } failure)
            {
                Note(script, failure, seed);
            }
        }

        if (Folder is not null)
        {
            File.Delete(Path.Combine(Folder, facade.Name + ".running.txt"));
        }

        output.WriteLine(Summary());
    }

    /// <summary>The part of a file's name that tells the kind.</summary>
    public static string FileNameOf(string kind) => string.Concat(kind.Select(c => char.IsLetterOrDigit(c) ? c : '-'));

    public string Summary() => string.Create(
        CultureInfo.InvariantCulture,
        $"{facade.Name}: {Worlds} worlds, {Calls} calls, {Steps} steps, longest step {Longest:g3} s, {Failures} failures")
        + string.Concat(_kinds.OrderByDescending(k => k.Value).Select(k => $"\n  {k.Value} {k.Key}"));

    /// <returns>The failure of a world, or null.</returns>
    public Failure? Try(Script script, bool compareWorkers)
    {
        Machine first = Run(script, Workers ?? (compareWorkers ? 1 : null), out Failure? failure);
        for (int workers = 2; failure is null && compareWorkers && Workers is null && workers <= 4; workers *= 2)
        {
            Machine other = Run(script, workers, out failure);
            int step = first.Hashes.Zip(other.Hashes).TakeWhile(h => h.First == h.Second).Count();
            if (failure is null && (step < first.Hashes.Count || first.Hashes.Count != other.Hashes.Count))
            {
                failure = new Failure("workers", string.Create(CultureInfo.InvariantCulture,
                    $"1 and {workers} workers differ after step {step}"), -1, step);
            }
        }

        return failure;
    }

    public string Text(Script script, string comment)
    {
        Machine machine = Run(script, null, out _);
        return ProgramText.Write(script, machine.Outcomes, comment, machine.Worlds);
    }

    /// <summary>By a thread of its own, so that an update without end is seen as such.</summary>
    private Machine Run(Script script, int? workers, out Failure? failure)
    {
        var machine = new Machine(script, workers);
        Exception? unforeseen = null;
        var thread = new Thread(
            () =>
            {
                try
                {
                    machine.Run();
                }
                catch (Exception exception)
                {
                    unforeseen = exception;
                }
            },
            16 << 20) { IsBackground = true };
        thread.Start();
        bool ended = thread.Join(_patience);
        failure = !ended ? new Failure("does not end", "", -1, machine.Steps)
            : unforeseen is not null ? new Failure("the model: " + unforeseen.GetType().Name, unforeseen.ToString(), -1, machine.Steps)
            : machine.Failure;
        Calls += machine.Calls;
        Steps += machine.Steps;
        Longest = Math.Max(Longest, machine.Longest);
        return machine;
    }

    private void Note(Script script, Failure failure, ulong seed)
    {
        int count = _kinds.GetValueOrDefault(failure.Kind);
        _kinds[failure.Kind] = count + 1;
        if (count >= 10)
        {
            return;
        }

        output.WriteLine(string.Create(CultureInfo.InvariantCulture,
            $"seed {seed} ({script.Profile}): {failure.Kind}: {failure.Text.Split('\n')[0]}"));

        // Three of a kind are enough to see what they have in common.
        if (Folder is null || count >= 3)
        {
            return;
        }

        bool compare = failure.Kind == "workers";
        Script small = failure.Kind == "does not end" ? script : new Shrinker(s => failure.IsShownBy(Try(s, compare)),
            ShrinkTime).Shrink(script);
        Failure last = failure.Kind == "does not end" ? failure : Try(small, compare) ?? failure;
        string file = Path.Combine(Folder, string.Create(CultureInfo.InvariantCulture,
            $"{facade.Name}-{FileNameOf(failure.Kind)}-{seed}.txt"));
        File.WriteAllText(file, failure.Kind == "does not end"
            ? ProgramText.Write(small, Call.All(small.Calls).ToDictionary(c => c.Id, _ => Outcome.Done), $"seed {seed}: does not end",
                Array.Empty<int>())
            : Text(small, string.Create(CultureInfo.InvariantCulture, $"seed {seed}: {Machine.Describe(last).Split('\n')[0]}")));
        Files.Add(file);
        output.WriteLine($"  {Call.All(small.Calls).Count()} calls of {Call.All(script.Calls).Count()} in {file}");
    }
}
