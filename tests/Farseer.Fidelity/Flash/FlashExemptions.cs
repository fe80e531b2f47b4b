using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>
/// Bodies whose motion is not compared, with the reason: where the library is truer on purpose and no formula says what the others then
/// do, or where the original's way is a detail of its method.
/// </summary>
internal static class FlashExemptions
{
    private static readonly Dictionary<string, (string[] Bodies, string Reason)> _byScene = new(StringComparer.Ordinal)
    {
        ["ccd_dynamic"] = (["plain", "p1", "p3", "p4", "fresh"], "a fast body that is no bullet meets moving planks too; planks that it throws meet others"),
        ["destruction_listener"] = (["d"], "it starts half a metre inside the ground: how it comes out is a matter of method"),
    };

    public static string? Reason(SceneFile file) => Entry(file)?.Reason;

    public static bool Holds(SceneFile file, string body) => Entry(file) is { } entry && entry.Bodies.Contains(body);

    /// <summary>An event of which a shape belongs to such a body.</summary>
    public static bool Holds(SceneFile file, SceneEvent e) => Entry(file) is not null
        && file.Geoms.Any(g => (g.Id == e.First || g.Id == e.Second) && g.Body is not null && Holds(file, g.Body));

    private static (string[] Bodies, string Reason)? Entry(SceneFile file) =>
        file.Format == SceneFormat.Box2DFlash && _byScene.TryGetValue(file.Name, out (string[] Bodies, string Reason) entry) ? entry : null;
}
