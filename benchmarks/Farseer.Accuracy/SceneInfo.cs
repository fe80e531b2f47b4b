using System;
using System.Collections.Generic;

namespace Farseer.Accuracy;

/// <summary>A scene of the catalogue.</summary>
/// <param name="Name">Full name; the part before the first underscore is accepted too.</param>
/// <param name="Parameter">What the number after "=" means.</param>
/// <param name="Range">Values that it takes.</param>
/// <param name="Usual">Values of the published comparison.</param>
/// <param name="Metrics">Names in the order in which <paramref name="Play"/> records them.</param>
/// <param name="Play">Builds, runs and measures.</param>
internal sealed record SceneInfo(
    string Name, string Parameter, Range Range, string[] Usual, string[] Metrics, Action<Trial> Play)
{
    public string ShortName => Name[..Name.IndexOf('_', StringComparison.Ordinal)];
}

/// <summary>Bounds, both included.</summary>
internal readonly record struct Range(double Least, double Most, bool WholeNumber = false)
{
    public bool Contains(double value) =>
        value >= Least && value <= Most && (!WholeNumber || value == Math.Floor(value));

    public override string ToString() =>
        FormattableString.Invariant($"{(WholeNumber ? "a whole number" : "a number")} from {Least:R} to {Most:R}");
}

/// <summary>All scenes, in the order of their numbers.</summary>
internal static class Catalogue
{
    public static IReadOnlyList<SceneInfo> Scenes { get; } =
    [
        .. Accuracy.Scenes.FreeMotion.Scenes,
        .. Accuracy.Scenes.Impacts.Scenes,
        .. Accuracy.Scenes.Cradle.Scenes,
        .. Accuracy.Scenes.Friction.Scenes,
        .. Accuracy.Scenes.Springs.Scenes,
        .. Accuracy.Scenes.Stacks.Scenes,
        .. Accuracy.Scenes.Masonry.Scenes,
        .. Accuracy.Scenes.Overlaps.Scenes,
        .. Accuracy.Scenes.FastBodies.Scenes,
        .. Accuracy.Scenes.FarAway.Scenes,
        .. Accuracy.Scenes.Concave.Scenes,
        .. Accuracy.Scenes.Pendulums.Scenes,
        .. Accuracy.Scenes.Chains.Scenes,
        .. Accuracy.Scenes.Mechanisms.Scenes,
        .. Accuracy.Scenes.Sleepers.Scenes,
        .. Accuracy.Scenes.Endurance.Scenes,
    ];

    public static SceneInfo? Find(string name)
    {
        foreach (SceneInfo scene in Scenes)
        {
            if (name.Equals(scene.Name, StringComparison.OrdinalIgnoreCase)
                || name.Equals(scene.ShortName, StringComparison.OrdinalIgnoreCase))
            {
                return scene;
            }
        }

        return null;
    }
}
