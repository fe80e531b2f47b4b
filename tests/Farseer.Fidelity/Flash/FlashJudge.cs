using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using Box2D.Dynamics;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Running;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>Runs and judges one scene of Box2DFlash at each of its iteration counts.</summary>
internal static class FlashJudge
{
    public static void Judge(SceneFile file, List<Check> checks, List<string> notes)
    {
        Box2DFlash202Quirks quirks = FlashQuirks.All;

        notes.AddRange(new FlashExemptions(file).Reasons());
        Trajectories trajectories = new(file);
        foreach (int iterations in file.Iterations)
        {
            FlashRun run = FlashRun.Of(file, iterations, quirks);
            string prefix = file.Iterations.Length > 1 ? iterations.ToString(CultureInfo.InvariantCulture) + ": " : string.Empty;
            checks.AddRange(JudgeRun(file, iterations, run, trajectories).Select(c => c with { What = prefix + c.What }));
        }

        if (trajectories.Motion is not null)
        {
            notes.Add("by the equations of motion");
        }
    }

    private static IEnumerable<Check> JudgeRun(SceneFile file, int iterations, FlashRun run, Trajectories trajectories)
    {
        RunResult result = run.Result;
        string key = iterations.ToString(CultureInfo.InvariantCulture);
        return trajectories.Judge(iterations, result.Recording)
            .Concat(EventJudge.Judge(file, iterations, result.Recording))
            .Concat(FlashObservationJudge.Judge(file, iterations, result.Recording))
            .Concat(FlashQueryJudge.Judge(file, iterations, result.Recording))
            .Concat(FlashQueryJudge.MassProperties(file, result))
            .Concat(FlashListJudge.Lists(file, key, run))
            .Concat(FlashListJudge.States("sleepChanges", file, key, run.SleepChanges))
            .Concat(FlashListJudge.States("frozenChanges", file, key, run.FrozenChanges));
    }
}
