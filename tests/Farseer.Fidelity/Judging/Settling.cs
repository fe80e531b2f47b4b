using System;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Judging;

/// <summary>
/// The first moments of a scene that starts in touch. Here a contact rests AT AllowedPenetration d, so
/// a body that starts at depth 0 first falls that deep, freely, for sqrt(2 d / g), and gains up to
/// sqrt(2 g d); if it falls on one side first, that speed and that depth over its half-width turn it.
/// One step more, for the step in which it is caught.
/// </summary>
public static class Settling
{
    public static Difference At(SceneFile file, int updates)
    {
        double gravity = Impacts.Gravity(file);
        if (!SceneSizes.MayTouch(file) || gravity == 0)
        {
            return default;
        }

        double depth = SceneSizes.AllowedPenetration(file);
        double speed = Math.Sqrt(2 * gravity * depth);
        double halfWidth = SceneSizes.SmallestHalfWidth(file);
        return updates * (double)file.Dt <= Math.Sqrt(2 * depth / gravity) + file.Dt
            ? new Difference(0, depth / halfWidth, speed, speed / halfWidth)
            : default;
    }

    /// <summary>
    /// A contact of Box2DFlash that has just been made is caught at its surface and then sinks to the depth of rest d, here softly: the
    /// speed is d r e^(-r t) with the rate r of a contact's bias, (pi/2) / (20 + pi/2) of a substep, of which there are as many as
    /// iterations. The original's sinks by its slop too, in the steps before it is caught. What is caught before it is that deep sinks
    /// on slowly: a contact gives up at most a quarter of its load for it, g h / 4 in a substep of length h, until the library's depth of
    /// rest, half the original's slop, is made up for; meanwhile one corner may be that much deeper than the other. When the load
    /// changes (a box that slid stands still, a rope lets go) the corners share it anew, and that begins again.
    /// </summary>
    public static Difference AfterTouch(SceneFile file, int iterations, Row[] rows, Impacts impacts, int row)
    {
        const double Share = Math.PI / 2 / (20 + (Math.PI / 2));
        const double LoadGivenUp = 0.25;
        const double RestInSlops = 0.5;

        // A hundredth of the speed below which a body counts as resting.
        const double Still = 1e-4;
        if (!SceneSizes.MayTouch(file))
        {
            return default;
        }

        int touch = row;
        while (touch > 0 && !impacts.Between(touch - 1) && !LoadChanges(file, rows, touch))
        {
            touch--;
        }

        double gravity = Impacts.Gravity(file);
        double depth = SceneSizes.AllowedPenetration(file);

        // Bodies on one another sink by the sum of their depths.
        double sinking = gravity > 0 ? Math.Sqrt(2 * depth * file.Bodies.Count / gravity) : 0;
        double elapsed = (file.SampleSteps[row] - file.SampleSteps[touch] - 1) * (double)file.Dt;
        double rate = Share * iterations / file.Dt;
        double rest = Math.Exp(-rate * Math.Max(0, elapsed - sinking));
        double slow = LoadGivenUp * gravity * file.Dt / iterations;
        bool sinks = slow > 0 && elapsed <= sinking + (RestInSlops * depth / slow);
        double speed = Math.Max(depth * rate * rest, sinks ? Math.Max(slow, Still) : Still);
        double halfWidth = SceneSizes.SmallestHalfWidth(file);
        return new Difference(0, Math.Max(depth * rest, sinks ? RestInSlops * depth : 0) / halfWidth, speed, speed / halfWidth);
    }

    /// <summary>Whether the acceleration changes at a row by more than a twentieth of gravity's.</summary>
    private static bool LoadChanges(SceneFile file, Row[] rows, int k)
    {
        const double LeastShare = 0.05;
        if (k == 0 || k + 1 >= rows.Length || rows[k - 1].IsAbsent || rows[k].IsAbsent || rows[k + 1].IsAbsent)
        {
            return false;
        }

        double before = (file.SampleSteps[k] - file.SampleSteps[k - 1]) * (double)file.Dt;
        double after = (file.SampleSteps[k + 1] - file.SampleSteps[k]) * (double)file.Dt;
        double x = ((rows[k + 1].VelocityX - rows[k].VelocityX) / after) - ((rows[k].VelocityX - rows[k - 1].VelocityX) / before);
        double y = ((rows[k + 1].VelocityY - rows[k].VelocityY) / after) - ((rows[k].VelocityY - rows[k - 1].VelocityY) / before);
        return Math.Sqrt((x * x) + (y * y)) > LeastShare * Impacts.Gravity(file);
    }
}
