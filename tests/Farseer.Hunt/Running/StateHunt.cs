using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using Farseer.Hunt.Calls;

namespace Farseer.Hunt.Running;

/// <summary>
/// Random worlds with detours: before some steps a world is captured, something else is done with it (steps, removals, additions, other
/// outlines), and it is restored. What follows must be what comes without detours, bit for bit and event for event.
/// </summary>
internal static class StateHunt
{
    /// <returns>What was done; it differs nowhere unless it says so.</returns>
    public static StateTally Run(
        Facade facade, ulong seed, TimeSpan time, int mostWorlds, long mostCalls, Profile? profile, TextWriter output)
    {
        long start = Stopwatch.GetTimestamp();
        var tally = new StateTally();
        for (; Stopwatch.GetElapsedTime(start) < time && tally.Worlds < mostWorlds && tally.Calls < mostCalls; seed++)
        {
            if (Compare(facade, seed, profile, tally) is { } wrong)
            {
                tally.Different++;
                output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"seed {seed}: {wrong}"));
            }
        }

        output.WriteLine(string.Create(CultureInfo.InvariantCulture,
            $"{facade.Name}: {tally.Worlds} worlds, {tally.Calls} calls, {tally.Steps} steps, {tally.Detours} captures and restores, "
            + $"{tally.Different} worlds differ"));
        return tally;
    }

    /// <returns>What differs, or null.</returns>
    public static string? Compare(Facade facade, ulong seed, Profile? profile, StateTally tally)
    {
        Machine plain = Make(facade, seed, profile, null, out _);
        Machine other = Make(facade, seed, profile, (int)seed, out Exception? thrown);
        tally.Worlds++;
        tally.Calls += other.Calls;
        tally.Steps += other.Steps;
        tally.Detours += other.Detours;
        if (thrown is not null)
        {
            return thrown.ToString();
        }

        if (other.Failure is { } failure && plain.Failure is null)
        {
            return Machine.Describe(failure);
        }

        int same = plain.Hashes.Zip(other.Hashes).TakeWhile(h => h.First == h.Second).Count();
        int told = plain.EventHashes.Zip(other.EventHashes).TakeWhile(h => h.First == h.Second).Count();
        int all = Math.Max(plain.Hashes.Count, other.Hashes.Count);
        if (same == all && told == all)
        {
            return null;
        }

        int call = plain.Outcomes.Where(o => other.Outcomes.GetValueOrDefault(o.Key) != o.Value)
            .Select(o => o.Key).DefaultIfEmpty(-1).Min();
        return string.Create(CultureInfo.InvariantCulture,
            $"of {all} steps the values of {same} and the events of {told} are the same, call {call} came out otherwise; ")
            + Difference(facade, seed, profile);
    }

    private static string? Difference(Facade facade, ulong seed, Profile? profile) =>
        Make(facade, seed, profile, null, out _, keeps: true).FirstDifference(Make(facade, seed, profile, (int)seed, out _, keeps: true));

    private static Machine Make(Facade facade, ulong seed, Profile? profile, int? detours, out Exception? thrown, bool keeps = false)
    {
        Script script = Decoder.Read(facade, Choices.FromSeed(seed), profile);
        var machine = new Machine(script, null, detours) { Keeps = keeps };
        thrown = null;
        try
        {
            machine.Run();
        }
        catch (Exception exception)
        {
            thrown = exception;
        }

        return machine;
    }
}

/// <summary>What was done.</summary>
internal sealed class StateTally
{
    public int Worlds { get; set; }

    public long Calls { get; set; }

    public long Steps { get; set; }

    public long Detours { get; set; }

    /// <summary>Worlds that differ.</summary>
    public int Different { get; set; }
}
