using System;
using System.Collections.Generic;
using Farseer.Fidelity.Fine;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>
/// The scenes whose reference are the equations of motion (<see cref="FineMotion"/>) in place of the original, with the reason: they
/// have no refined run, or one that keeps the fault. The original's own error against them is the limit.
/// </summary>
internal static class FlashMotions
{
    private static readonly Dictionary<string, string> _byScene = new(StringComparer.Ordinal)
    {
        ["ccd_dynamic"] = "planks and circles are followed through the impact, where the original lets one pass and stops the others late",
        ["create_destroy"] = "a hinge made in mid-flight takes hold where exact flight has brought the body, 8 cm from the original's place",
        ["mouse_joint"] = "the spring is exact; the original's step changes the phase of a body that whirls about its anchor",
        ["restitution"] = "a ball bounces at the moment of impact with the speed that it has then",
    };

    public static IReadOnlyCollection<string> Scenes => _byScene.Keys;

    public static string? Reason(SceneFile file) => file.Format == SceneFormat.Box2DFlash ? _byScene.GetValueOrDefault(file.Name) : null;
}
