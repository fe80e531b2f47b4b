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
    /// <returns>Worlds that differ.</returns>
    public static int Run(Facade facade, ulong seed, TimeSpan time, int mostWorlds, Profile? profile, TextWriter output)
    {
        long start = Stopwatch.GetTimestamp();
        int worlds = 0;
        int failures = 0;
        long steps = 0;
        long detours = 0;
        for (; Stopwatch.GetElapsedTime(start) < time && worlds < mostWorlds; seed++)
        {
            worlds++;
            string? wrong = Compare(facade, seed, profile, ref steps, ref detours);
            if (wrong is not null)
            {
                failures++;
                output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"seed {seed}: {wrong}"));
            }
        }

        output.WriteLine(string.Create(CultureInfo.InvariantCulture,
            $"{facade.Name}: {worlds} worlds, {steps} steps, {detours} captures and restores, {failures} worlds differ"));
        return failures;
    }

    /// <returns>What differs, or null.</returns>
    public static string? Compare(Facade facade, ulong seed, Profile? profile, ref long steps, ref long detours)
    {
        Machine plain = Make(facade, seed, profile, null, out _);
        Machine other = Make(facade, seed, profile, (int)seed, out Exception? thrown);
        steps += other.Steps;
        detours += other.Detours;
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
        return same < all || told < all
            ? string.Create(CultureInfo.InvariantCulture, $"of {all} steps the values of {same} and the events of {told} are the same, call {plain.Outcomes.Where(o => other.Outcomes.GetValueOrDefault(o.Key) != o.Value).Select(o => o.Key).DefaultIfEmpty(-1).Min()} came out otherwise; {Difference(facade, seed, profile)}")
            : null;
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
