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

    /// <summary>What an observed angle or translation of a joint may differ by.</summary>
    public static double OfObserved(SceneFile file, string what) => !HasLimits(file) ? 0
        : what.EndsWith("GetJointAngle", StringComparison.Ordinal) ? Angular
        : what.EndsWith("GetJointTranslation", StringComparison.Ordinal) ? file.RestDepth : 0;

    /// <summary>
    /// A limit of the rows with the slops, and with what float velocities lose in the substeps of a steady push: half an ulp each, always
    /// to the same side.
    /// </summary>
    public static Difference Add(SceneFile file, int iterations, int updates, Row row, Difference limit)
    {
        if (SceneSizes.MayTouch(file) || file.Joints.Count > 0)
        {
            double substeps = 0.5 * updates * iterations;
            double speed = Math.Max(Math.Abs(row.VelocityX), Math.Abs(row.VelocityY));
            limit = limit with
            {
                LinearVelocity = limit.LinearVelocity + (substeps * FloatTolerance.Ulp(speed)),
                AngularVelocity = limit.AngularVelocity + (substeps * FloatTolerance.Ulp(Math.Abs(row.AngularVelocity))),
            };
        }

        if (Json.Optional(file.Root, "inAddCallback").ValueKind == JsonValueKind.Array)
        {
            // What a listener does comes with the contact, which may begin a step earlier or later.
            limit = limit with { LinearVelocity = limit.LinearVelocity + (Impacts.Gravity(file) * file.Dt * 1.001) };
        }

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
