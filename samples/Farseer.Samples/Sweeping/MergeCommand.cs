using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using Farseer.CommandLines;

namespace Farseer.Samples.Sweeping;

/// <summary>Puts the shards of a sweep together, and proves that each run is there and that repeated ones agree in every bit.</summary>
internal static class MergeCommand
{
    private const int Failed = 1;

    /// <summary>Faults that are told one by one.</summary>
    private const int MostTold = 10;

    private static readonly Argument<string[]> _files = new("files") { Description = "files of shards", Arity = ArgumentArity.OneOrMore };
    private static readonly ValueOption<string?> _out = Values.File("--out", "all rows; by default sweep.jsonl");

    public static Command Create()
    {
        Command command = new("merge", "Puts shards together: each run must be there, and repeats agree.") { _files, _out };
        command.SetAction(words => Merge(words.GetRequiredValue(_files), words.GetValue(_out) ?? "sweep.jsonl"));
        return command;
    }

    private static int Merge(string[] files, string path)
    {
        var faults = new List<string>();
        var rows = new SortedDictionary<int, SweepRow>();
        SweepRow? first = null;
        int repeats = 0;
        foreach (string file in files)
        {
            List<SweepRow> read = SweepRow.Read(file, out long whole);
            if (whole < new FileInfo(file).Length)
            {
                faults.Add($"{file} ends within a line: its shard has not come to its end");
            }

            foreach (SweepRow row in read)
            {
                first ??= row;
                if (row.Specification != first.Specification || row.Of != first.Of || row.Version != first.Version)
                {
                    throw new UsageException($"{file} is of another specification or version than {files[0]}");
                }

                if (rows.TryGetValue(row.Index, out SweepRow? other))
                {
                    repeats++;
                    if (row with { Shard = other.Shard, Shards = other.Shards } != other)
                    {
                        faults.Add($"run {row.Index} ({row.Scene}, seed {row.Seed}) has the state {row.State} in {file}, and {other.State} "
                            + $"elsewhere");
                    }
                }

                rows[row.Index] = row;
            }
        }

        for (int index = 0; index < (first?.Of ?? 0); index++)
        {
            if (!rows.ContainsKey(index))
            {
                faults.Add($"run {index} is in no file");
            }
        }

        if (first is null)
        {
            faults.Add("no file has a row");
        }

        foreach (string fault in faults.Take(MostTold))
        {
            Console.Error.WriteLine("error: " + fault);
        }

        if (faults.Count > 0)
        {
            Console.Error.WriteLine($"error: {faults.Count} faults; nothing is written");
            return Failed;
        }

        Save(path, rows.Values);
        Console.WriteLine(
            $"{rows.Count} runs of specification {first!.Specification}, each there, {repeats} repeats that agree in every bit: {path}");
        return 0;
    }

    private static void Save(string path, IEnumerable<SweepRow> rows)
    {
        try
        {
            // Which shard ran a row says nothing about the result: however a sweep was cut, the merged file is the same.
            File.WriteAllText(path, string.Concat(rows.Select(r => (r with { Shard = 0, Shards = 1 }).ToLine() + "\n")));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new UsageException($"cannot write '{path}': {e.Message.ReplaceLineEndings(" ")}");
        }
    }
}
