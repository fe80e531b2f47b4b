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
    /// iterations. The original's sinks by its slop too, in the steps before it is caught.
    /// </summary>
    public static Difference AfterTouch(SceneFile file, int iterations, Impacts impacts, int row)
    {
        const double Share = Math.PI / 2 / (20 + (Math.PI / 2));

        // A hundredth of the speed below which a body counts as resting.
        const double Still = 1e-4;
        if (!SceneSizes.MayTouch(file))
        {
            return default;
        }

        int touch = row;
        while (touch > 0 && !impacts.Between(touch - 1))
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
        double speed = Math.Max(depth * rate * rest, Still);
        double halfWidth = SceneSizes.SmallestHalfWidth(file);
        return new Difference(0, depth * rest / halfWidth, speed, speed / halfWidth);
    }
}
