using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Building;
using Farseer.Fidelity.Flash;
using Farseer.Fidelity.Running;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Judging;

public enum Outcome
{
    Pass,
    Fail,
    Skip,
}

/// <summary>What became of one scene.</summary>
/// <param name="Scene">Its name.</param>
/// <param name="Outcome">PASS, FAIL or SKIP.</param>
/// <param name="Reason">The missing part of a skipped scene, the exception of a failed one, or the flags and closed form used.</param>
/// <param name="Checks">Every comparison made.</param>
public sealed record Verdict(string Scene, Outcome Outcome, string Reason, IReadOnlyList<Check> Checks);

/// <summary>Builds, runs and judges one scene at each of its iteration counts.</summary>
public static class SceneJudge
{
    public static Verdict Judge(SceneFile file) =>
        file.Format == SceneFormat.Box2DFlash ? Guard(file, FlashJudge.Judge) : Guard(file, JudgeFarseer);

    private static Verdict Guard(SceneFile file, Action<SceneFile, List<Check>, List<string>> judge)
    {
        List<Check> checks = [];
        List<string> notes = [];
        try
        {
            judge(file, checks, notes);
        }
        catch (MissingPartException e)
        {
            return new Verdict(file.Name, Outcome.Skip, "not built yet: " + e.Message, []);
        }
        catch (BadSceneException e)
        {
            throw new BadSceneException(file.Name + ": " + e.Message);
        }
        catch (Exception e)
        {
            // Whatever the library throws is a failure of this scene alone; the others still run.
            return new Verdict(file.Name, Outcome.Fail, e.GetType().Name + ": " + e.Message.ReplaceLineEndings(" "), checks);
        }

        return new Verdict(file.Name, checks.All(c => c.Passed) ? Outcome.Pass : Outcome.Fail, string.Join("; ", notes), checks);
    }

    private static void JudgeFarseer(SceneFile file, List<Check> checks, List<string> notes)
    {
        object? quirks = Quirks.All;
        Trajectories trajectories = new(file);
        string[] acting = Acting(file);
        if (acting.Length > 0)
        {
            notes.Add("with " + string.Join(", ", acting));
        }

        foreach (int iterations in file.Iterations)
        {
            RunResult run = SceneRunner.Run(file, iterations, quirks);
            string prefix = file.Iterations.Length > 1 ? iterations.ToString(CultureInfo.InvariantCulture) + ": " : string.Empty;
            checks.AddRange(JudgeRun(file, iterations, run, trajectories).Select(c => c with { What = prefix + c.What }));
        }

        if (trajectories.Motion is not null)
        {
            notes.Add("by the equations of motion");
        }
    }

    private static IEnumerable<Check> JudgeRun(SceneFile file, int iterations, RunResult run, Trajectories trajectories)
    {
        return trajectories.Judge(iterations, run.Recording)
            .Concat(EventJudge.Judge(file, iterations, run.Recording))
            .Concat(ObservationJudge.Judge(file, iterations, run.Recording, trajectories.Motion))
            .Concat(QueryJudge.Queries(file, iterations, run.Recording))
            .Concat(QueryJudge.MassProperties(file, run))
            .Concat(QueryJudge.Paths(file, run));
    }

    /// <summary>The flags that change the scene, each found by leaving it off.</summary>
    private static string[] Acting(SceneFile file)
    {
        int iterations = file.Iterations[0];
        RunResult run = SceneRunner.Run(file, iterations, Quirks.All);
        return Differs(run, SceneRunner.Run(file, iterations, null))
            ? [.. Quirks.Flags.Where(f => Differs(run, SceneRunner.Run(file, iterations, Quirks.Without(f)))).Select(f => f.ToString()!)]
            : [];
    }

    /// <summary>Whether two runs left anything different behind.</summary>
    private static bool Differs(RunResult a, RunResult b)
        => a.Recording.Rows.Any(p => !p.Value.SequenceEqual(b.Recording.Rows[p.Key]))
            || a.Recording.Observed.Any(p => !p.Value.Zip(b.Recording.Observed[p.Key], JsonElement.DeepEquals).All(same => same))
            || !a.Recording.QueryResults.Zip(b.Recording.QueryResults, JsonElement.DeepEquals).All(same => same)
            || a.MassProperties.Any(p => !p.Value.SequenceEqual(b.MassProperties[p.Key]))
            || !Written(a).SequenceEqual(Written(b));

    private static IEnumerable<string> Written(RunResult run)
        => run.Recording.Events!.Select(e => e.Key + string.Join(" ", e.Runs));
}
