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
}
