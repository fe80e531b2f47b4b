using System;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>
/// What the original lets joints give way on purpose: a limit of rotation holds two degrees, and a limit of translation 5 mm, past its
/// end. The library's limits hold where they are set, so the two may differ by that.
/// </summary>
internal static class FlashSlops
{
    private const double Angular = 2.0 / 180 * Math.PI;

    public static Difference Add(SceneFile file, Difference limit)
    {
        if (!HasLimits(file))
        {
            return limit;
        }

        double arm = file.Geoms.Select(g => SceneSizes.Largest(g)).DefaultIfEmpty(0).Max();
        return limit with { Position = limit.Position + (Angular * arm), Rotation = limit.Rotation + Angular };
    }

    private static bool HasLimits(SceneFile file) =>
        file.Joints.Any(j => j.Factory == "b2RevoluteJointDef" && Json.Optional(j.Args, "enableLimit").ValueKind == JsonValueKind.True)
        || Json.Items(file.Root, "actions").Any(a => Json.OptionalText(a, "call") == "EnableLimit");
}
