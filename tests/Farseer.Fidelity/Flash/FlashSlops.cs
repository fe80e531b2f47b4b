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
    /// A limit of the rows with the slops, and with what float velocities lose in the substeps of a steady push: half an ulp each of the
    /// speed that the body has by then, always to the same side.
    /// </summary>
    public static Difference Add(SceneFile file, int iterations, string body, Row[] rows, int k, Difference limit)
    {
        if (SceneSizes.MayTouch(file) || file.Joints.Count > 0)
        {
            (double linear, double angular) = (0, 0);
            for (int i = 0; i <= k; i++)
            {
                double substeps = 0.5 * iterations * (file.SampleSteps[i] - (i > 0 ? file.SampleSteps[i - 1] : 0));
                Row faster = rows[Math.Max(0, i - 1)].IsAbsent ? rows[i] : rows[Math.Max(0, i - 1)];
                linear += substeps * FloatTolerance.Ulp(Math.Max(Speed(faster), Speed(rows[i])));
                angular += substeps * FloatTolerance.Ulp(Math.Max(Spin(faster), Spin(rows[i])));
            }

            limit = limit with { LinearVelocity = limit.LinearVelocity + linear, AngularVelocity = limit.AngularVelocity + angular };
        }

        limit = AddShorterArm(file, body, rows[k], limit);
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

    /// <summary>
    /// A circle of radius r rolls about its contact point, which here is in the middle of the overlap: half the depth of rest d inside the
    /// circle. v = w (r - d/2), so speed and spin may differ by the share d / 2r.
    /// </summary>
    private static Difference AddShorterArm(SceneFile file, string body, Row row, Difference limit)
    {
        double radius =
            file.Geoms.Where(g => g.Body == body).Select(SceneSizes.Radius).Where(r => r > 0).DefaultIfEmpty(double.PositiveInfinity).Min();
        if (!SceneSizes.MayTouch(file) || double.IsInfinity(radius))
        {
            return limit;
        }

        // The library's depth of rest is half the original's slop.
        double share = file.RestDepth / 2 / (2 * radius);
        return limit with
        {
            Rotation = limit.Rotation + (share * Math.Abs(row.Rotation)),
            LinearVelocity = limit.LinearVelocity + (share * Speed(row)),
            AngularVelocity = limit.AngularVelocity + (share * Math.Abs(row.AngularVelocity)),
        };
    }

    private static double Spin(Row row) => row.IsAbsent ? 0 : Math.Abs(row.AngularVelocity);

    private static double Speed(Row row) => row.IsAbsent ? 0 : Math.Max(Math.Abs(row.VelocityX), Math.Abs(row.VelocityY));

    private static bool HasLimits(SceneFile file) =>
        file.Joints.Any(j => j.Factory == "b2RevoluteJointDef" && Json.Optional(j.Args, "enableLimit").ValueKind == JsonValueKind.True)
        || Json.Items(file.Root, "actions").Any(a => Json.OptionalText(a, "call") == "EnableLimit");
}
