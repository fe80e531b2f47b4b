using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>Judges a drawing: the same calls with the same colours, to the rounding of the coordinates.</summary>
internal static class FlashDrawingJudge
{
    /// <summary>
    /// Boxes of the original's broad phase are rounded to 1/65535 of the world, here 3e-4; half a slop covers a body's settling too.
    /// </summary>
    private const double Tolerance = 2.5e-3;

    public static string? Problem(JsonElement expected, JsonElement got)
    {
        List<JsonElement> open = [.. Json.Items(got, "calls")];
        foreach (JsonElement call in Json.Items(expected, "calls"))
        {
            int match = open.FindIndex(o => ValueComparer.Difference(call, o) <= Tolerance);
            if (match < 0)
            {
                return "missing " + call + "; drawn are " + string.Join(" ", open.Take(12));
            }

            open.RemoveAt(match);
        }

        return open.Count == 0 ? null : "not in the original: " + string.Join(" ", open.Take(4));
    }
}
