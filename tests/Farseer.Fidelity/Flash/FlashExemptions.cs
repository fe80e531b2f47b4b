using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>
/// What is not compared, with the reason: contacts that the library has on purpose and the original has not, and motion that is a
/// detail of the original's method.
/// </summary>
internal static class FlashExemptions
{
    private static readonly Dictionary<string, (string[] Motion, string[] Contacts, string Reason)> _byScene = new(StringComparer.Ordinal)
    {
        // The quirk of the file: a contact that is slow at first has no continuous test between two bodies that are no bullets.
        ["ccd_dynamic"] = ([], ["plain", "p1", "p3", "p4"], "contacts of a fast body that is no bullet, which meets moving planks too, and of planks thrown at others"),

        // No equation says how an overlap by half a metre ends. b hangs on d by a rigid rod until step 80.
        ["destruction_listener"] = (["d", "b"], ["d"], "a body that starts half a metre inside the ground, and one joined to it"),
    };

    public static string? Reason(SceneFile file) => Entry(file)?.Reason;

    /// <summary>A body whose motion is not compared.</summary>
    public static bool Holds(SceneFile file, string body) => Entry(file) is { } entry && entry.Motion.Contains(body);

    /// <summary>An event of which a shape belongs to such a body.</summary>
    public static bool Holds(SceneFile file, SceneEvent e) => Entry(file) is { } entry
        && file.Geoms.Any(g => (g.Id == e.First || g.Id == e.Second) && entry.Contacts.Contains(g.Body));

    private static (string[] Motion, string[] Contacts, string Reason)? Entry(SceneFile file) =>
        file.Format == SceneFormat.Box2DFlash && _byScene.TryGetValue(file.Name, out (string[] Motion, string[] Contacts, string Reason) entry) ? entry : null;
}
