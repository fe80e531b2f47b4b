using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Fidelity.Fine;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>
/// The scenes whose reference are the equations of motion (<see cref="FineMotion"/>) in place of the original, with the reason: they
/// have no refined run, or one that keeps the fault. The original's own error against them is the limit, of each body by itself.
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

    /// <summary>
    /// Bodies that the original lets pass through each other, and those that meet in the same way and whose errors are their limit: an
    /// error of all of the speed would be none.
    /// </summary>
    private static readonly Dictionary<(string Scene, string Body), string> _likes = new()
    {
        [("ccd_dynamic", "plain")] = "bullet",
        [("ccd_dynamic", "p1")] = "p2",
    };

    public static IReadOnlyCollection<string> Scenes => _byScene.Keys;

    /// <summary>
    /// The bodies whose errors in the original are the limit of a body: mostly its own. In mouse_joint three whirl on springs, and
    /// where each is in its phase when the original is farthest off is chance: there the largest of all counts.
    /// </summary>
    public static IEnumerable<string> Limiting(SceneFile file, string body) => file.Name == "mouse_joint"
        ? file.Recordings.Values.First().Rows.Keys
        : [_likes.GetValueOrDefault((file.Name, body), body)];

    public static string? Reason(SceneFile file) => file.Format == SceneFormat.Box2DFlash ? _byScene.GetValueOrDefault(file.Name) : null;
}
