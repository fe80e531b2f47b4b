using System;
using System.Globalization;
using Farseer.CommandLines;

namespace Farseer.Samples.Sweeping;

/// <summary>Which part of a sweep a process is to run: from the command line, or from what a scheduler tells its jobs.</summary>
internal readonly record struct ShardChoice(int Index, int Count)
{
    /// <param name="shard">As <c>2/8</c>: the third of eight; null: the environment names it.</param>
    /// <param name="shards">How many there are, if the environment does not say; null.</param>
    /// <param name="environment">Reads a variable.</param>
    public static ShardChoice Find(string? shard, string? shards, Func<string, string?> environment)
    {
        if (shard is not null)
        {
            string[] parts = shard.Split('/');
            return parts.Length == 2 && TryRead(parts[0], out int index) && TryRead(parts[1], out int count)
                ? Checked(index, count)
                : throw new UsageException($"--shard needs a number of a shard and how many there are, as 0/4, not '{shard}'");
        }

        string? slurm = environment("SLURM_ARRAY_TASK_ID");
        string? told = slurm ?? environment("JOB_COMPLETION_INDEX");
        shards ??= slurm is null ? null : environment("SLURM_ARRAY_TASK_COUNT");
        if (told is null && shards is null)
        {
            return new ShardChoice(0, 1);
        }

        if (!TryRead(told, out int task) || !TryRead(shards, out int all))
        {
            throw new UsageException("the shard is not known: give --shard i/n, or --shards n in a job that names its index");
        }

        // An array may begin at another number.
        int first = slurm is not null && TryRead(environment("SLURM_ARRAY_TASK_MIN"), out int least) ? least : 0;
        return Checked(task - first, all);
    }

    private static ShardChoice Checked(int index, int count) => index >= 0 && index < count
        ? new ShardChoice(index, count)
        : throw new UsageException($"there is no shard {index} of {count}: they are numbered from 0");

    private static bool TryRead(string? text, out int value) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out value);
}
