using System;
using System.Collections.Generic;
using System.Globalization;
using System.Reflection;
using FarseerGames.FarseerPhysics;

namespace Farseer.Accuracy;

/// <summary>One line of the result table.</summary>
internal sealed record Row(string Scene, int Iterations, double Dt, string Metric, double Value, double NanosecondsPerBodyStep, string Note)
{
    public const string CsvHeader = "engine,engine_version,scene,dial,dt,metric,value,ns_per_body_step,note";

    private static readonly string _version =
        typeof(PhysicsSimulator).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()?.InformationalVersion ?? "unknown";

    public string ToCsv() => string.Create(
        CultureInfo.InvariantCulture,
        $"Farseer,{_version},{Scene},iterations={Iterations},{Dt:G6},{Metric},{Value:G6},{NanosecondsPerBodyStep:G6},{Note}");
}

/// <summary>Runs a scene and turns its metrics into rows.</summary>
internal static class Runner
{
    /// <summary>What a metric is given when its scene exploded.</summary>
    public const double Exploded = 1e9;

    public static List<Row> Run(SceneChoice choice, Dial dial, int runs)
    {
        // The state repeats bit for bit; further runs serve the clock only, and the first of several is its warm-up.
        Trial trial = Play(choice, dial, out string? fault);
        Trial clock = trial;
        for (int i = 1; i < runs && fault is null; i++)
        {
            Trial again = Play(choice, dial, out _);
            again.TakeQuickerSteps(clock == trial ? again : clock);
            clock = again;
        }

        double cost = clock.NanosecondsPerBodyStep;
        var rows = new List<Row>();
        foreach (string metric in choice.Scene.Metrics)
        {
            rows.Add(new Row(choice.Label, dial.Iterations, dial.Dt, metric, Value(trial, metric, fault), cost, Note(dial, metric, fault)));
        }

        return rows;
    }

    private static Trial Play(SceneChoice choice, Dial dial, out string? fault)
    {
        var trial = new Trial(choice.Parameter, dial);
        fault = null;
        try
        {
            choice.Scene.Play(trial);
        }
        catch (ExplodedException)
        {
            fault = "exploded";
        }

        return trial;
    }

    private static double Value(Trial trial, string metric, string? fault)
    {
        if (fault is not null)
        {
            return metric == "stood" ? 0 : Exploded;
        }

        foreach ((string name, double value) in trial.Metrics)
        {
            if (name == metric)
            {
                return value;
            }
        }

        throw new InvalidOperationException($"The scene did not record {metric}.");
    }

    private static string Note(Dial dial, string metric, string? fault)
    {
        bool isDefault = dial.Iterations == Options.DefaultIterations && dial.Dt == Options.DefaultDt;
        string note = isDefault ? "default" : dial.Dt == Options.DefaultDt ? "sweep" : "dt sweep";
        note += metric == "stood" ? " 1 = yes" : string.Empty;
        return fault is null ? note : $"{note} {fault}";
    }
}
