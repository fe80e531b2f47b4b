using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Numerics;
using System.Reflection;
using System.Text;
using Farseer.CommandLines;
using Farseer.Scenes;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Samples.Sweeping;

/// <summary>Runs a shard of a sweep, and goes on where it stopped.</summary>
internal static class SweepCommand
{
    private static readonly Argument<string> _file =
        new("specification") { Description = "the file that says what is run, see docs/Sweeps.md" };
    private static readonly ValueOption<string?> _shard =
        Values.Word("--shard", "I/N", "a part of how many, as 0/8", "which part of how many");
    private static readonly ValueOption<string?> _shards =
        Values.Word("--shards", "N", "a whole number", "how many parts, where the job says which this is");

    private static readonly ValueOption<string?> _out = Values.File("--out", "its rows; by default sweep-I-of-N.jsonl");

    public static Command Create()
    {
        Command command = new("sweep", "Runs a shard of a sweep, or goes on with it.") { _file, _shard, _shards, _out };
        command.SetAction(Sweep);
        return command;
    }

    private static int Sweep(ParseResult words)
    {
        SweepSpecification specification = SweepSpecification.Load(words.GetRequiredValue(_file));
        ShardChoice choice = ShardChoice.Find(words.GetValue(_shard), words.GetValue(_shards), Environment.GetEnvironmentVariable);
        Run(
            specification,
            choice,
            words.GetValue(_out) ?? string.Create(CultureInfo.InvariantCulture, $"sweep-{choice.Index}-of-{choice.Count}.jsonl"));
        return 0;
    }

    private static void Run(SweepSpecification specification, ShardChoice choice, string path)
    {
        string hash = specification.Hash;
        string version =
            typeof(PhysicsSimulator).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()!.InformationalVersion;
        var done = new HashSet<int>();
        using FileStream file = Open(path);
        long whole = 0;
        if (file.Length > 0)
        {
            foreach (SweepRow row in SweepRow.Read(path, out whole))
            {
                if (row.Specification != hash || row.Version != version || row.Shard != choice.Index || row.Shards != choice.Count)
                {
                    throw new UsageException($"{path} has rows of another specification, version or shard: give another --out");
                }

                done.Add(row.Index);
            }
        }

        // A line that was cut off is written again.
        file.SetLength(whole);
        file.Position = whole;
        int before = done.Count;
        foreach (SweepItem item in specification.Items())
        {
            if (item.Index % choice.Count != choice.Index || !done.Add(item.Index))
            {
                continue;
            }

            SweepRow row = Run(item, specification, hash, version, choice);
            file.Write(Encoding.UTF8.GetBytes(row.ToLine() + "\n"));
            file.Flush(flushToDisk: true);
        }

        Console.WriteLine($"shard {choice.Index} of {choice.Count}: {done.Count} runs, {before} of them done before: {path}");
    }

    private static FileStream Open(string path)
    {
        try
        {
            return new FileStream(path, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.Read);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new UsageException($"cannot write '{path}': {e.Message.ReplaceLineEndings(" ")}");
        }
    }

    private static SweepRow Run(SweepItem item, SweepSpecification specification, string hash, string version, ShardChoice choice)
    {
        Scene scene = SceneLibrary.Find(item.Scene)!;
        var simulator = new PhysicsSimulator();
        scene.Build(simulator);
        simulator.Iterations = item.Iterations;
        float dt = item.Dt > 0 ? item.Dt : scene.Dt;
        int steps = specification.Steps > 0 ? specification.Steps : scene.Steps;
        simulator.Update(0);
        Displace(simulator, item.Seed, specification.Jitter);
        for (int step = 0; step < steps; step++)
        {
            scene.Step(simulator, step, dt);
        }

        return new SweepRow
        {
            Specification = hash,
            Version = version,
            Shard = choice.Index,
            Shards = choice.Count,
            Index = item.Index,
            Of = specification.Count,
            Scene = item.Scene,
            Iterations = item.Iterations,
            Dt = dt,
            Seed = item.Seed,
            Steps = steps,
            State = simulator.StateHash().ToString("x16", CultureInfo.InvariantCulture),
            Contacts = simulator.ContactCount,
            LargestPenetration = simulator.LargestPenetration,
        };
    }

    /// <summary>Moves what can move by a little; the same seed, in the order of the bodies, is the same on every machine.</summary>
    private static void Displace(PhysicsSimulator simulator, int seed, float most)
    {
        if (seed == 0 || most == 0)
        {
            return;
        }

        var random = new Random(seed);
        foreach (Body body in simulator.BodyList)
        {
            if (!body.IsStatic)
            {
                body.Position += most * new Vector2((2 * random.NextSingle()) - 1, (2 * random.NextSingle()) - 1);
            }
        }
    }
}
