using System;
using System.Linq;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>
/// By how many steps more a contact of Box2DFlash may begin or end at another time than recorded. The recording is off by E in place (the
/// file says by how much at most), so two bodies that close in at v meet up to E / v earlier or later in truth. And a contact ends when
/// its overlap is undone: the original's is up to a slop deeper, so where two bodies part slowly it ends by the steps later in
/// which their distance grows by that much.
/// </summary>
internal static class FlashShifts
{
    private const int Largest = 8;

    public static int OfBeginning(SceneFile file, int iterations, SceneEvent e, int step)
    {
        // What touches from the start has no error yet.
        if (file.Format == SceneFormat.Farseer || file.Refined is null || step <= 1 || Bodies(file, iterations, e) is not { } rows)
        {
            return 0;
        }

        int k = Array.FindLastIndex(file.SampleSteps, s => s < step);
        if (k < 0 || rows.First[k].IsAbsent || rows.Second[k].IsAbsent)
        {
            return 0;
        }

        double closing = Discretisation.Speed(rows.First[k], rows.Second[k]);
        double steps = file.Refined.FromRecorded.Position / (closing * file.Dt);
        return (int)Math.Min(Largest, Math.Ceiling(steps));
    }

    public static int OfEnding(SceneFile file, int iterations, SceneEvent e, int step)
    {
        if (file.Format == SceneFormat.Farseer || Bodies(file, iterations, e) is not { } rows)
        {
            return 0;
        }

        int end = Array.FindLastIndex(file.SampleSteps, s => s <= step);
        for (int begin = end; begin >= 0 && file.SampleSteps[end] - file.SampleSteps[begin] <= Largest; begin--)
        {
            if (Distance(rows.First[begin], rows.Second[begin]) <= Distance(rows.First[end], rows.Second[end]) - file.RestDepth)
            {
                return file.SampleSteps[end] - file.SampleSteps[begin];
            }
        }

        return 0;
    }

    /// <summary>The rows of two bodies that both move, or null.</summary>
    private static (Row[] First, Row[] Second)? Bodies(SceneFile file, int iterations, SceneEvent e)
    {
        Row[]?[] rows = [.. new[] { e.First, e.Second }
            .Select(id => file.Geoms.FirstOrDefault(g => g.Id == id)?.Body)
            .Select(body => body is not null && file.Recordings[iterations].Rows.TryGetValue(body, out Row[]? own) ? own : null)];
        return rows is [{ } first, { } second] ? (first, second) : null;
    }

    private static double Distance(Row a, Row b) => Math.Sqrt(((a.X - b.X) * (a.X - b.X)) + ((a.Y - b.Y) * (a.Y - b.Y)));
}
