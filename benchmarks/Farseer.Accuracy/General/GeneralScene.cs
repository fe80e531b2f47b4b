using System;
using System.Collections.Generic;

namespace Farseer.Accuracy.General;

/// <summary>What a scene is judged by.</summary>
/// <param name="Name">Metric, with its unit where it has one.</param>
/// <param name="Limit">The largest figure that meets it; with <paramref name="AtLeast"/> the smallest.</param>
/// <param name="AtLeast">More is better.</param>
internal sealed record Figure(string Name, double Limit, bool AtLeast = false)
{
    /// <summary>What a run that exploded is given.</summary>
    public double Worst => AtLeast ? -Runner.Exploded : Runner.Exploded;

    public bool IsMet(double value) => AtLeast ? value >= Limit : value <= Limit;

    public bool IsWorse(double value, double than) => AtLeast ? value < than : value > than;
}

/// <summary>A scene that must hold for a whole range of parameters.</summary>
/// <param name="Id">Name on the command line.</param>
/// <param name="What">What it is, for people.</param>
/// <param name="Figures">Its figures, in the order of the table.</param>
/// <param name="Play">Runs it at every parameter and notes the figures.</param>
internal sealed record GeneralScene(string Id, string What, Figure[] Figures, Action<GeneralRun> Play);

/// <summary>All general scenes, in the order in which they run.</summary>
internal static class GeneralCatalogue
{
    public static IReadOnlyList<GeneralScene> Scenes { get; } =
    [
        .. InOrder(
            SingleHits.Scenes,
            Rooms.Scenes,
            Meetings.Scenes,
            Throws.Scenes,
            SpringRows.Scenes,
            Drives.Scenes,
            Contacts.Scenes,
            TautBridges.Scenes,
            Pits.Scenes),
        .. InOrder(Towing.Scenes, HungChains.Scenes, Loops.Scenes, Ragdolls.Scenes),
    ];

    public static GeneralScene? Find(string id)
    {
        foreach (GeneralScene scene in Scenes)
        {
            if (id.Equals(scene.Id, StringComparison.OrdinalIgnoreCase))
            {
                return scene;
            }
        }

        return null;
    }

    private static List<GeneralScene> InOrder(params IReadOnlyList<GeneralScene>[] groups)
    {
        var scenes = new List<GeneralScene>();
        foreach (IReadOnlyList<GeneralScene> group in groups)
        {
            scenes.AddRange(group);
        }

        scenes.Sort((a, b) => string.CompareOrdinal(a.Id, b.Id));
        return scenes;
    }
}
