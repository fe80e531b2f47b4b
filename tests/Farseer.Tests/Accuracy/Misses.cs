using System.Collections.Generic;
using Farseer.Accuracy;
using Farseer.Accuracy.General;
using Farseer.Accuracy.Surveys;

namespace Farseer.Tests.Accuracy;

/// <summary>What scenes and surveys of the accuracy runner miss at drawn parameters.</summary>
internal static class Misses
{
    public static List<string> Of(GeneralScene scene, uint seed)
    {
        var misses = new List<string>();
        foreach (Outcome outcome in GeneralRun.Of(scene, GeneralSettings.Default with { Seed = seed }))
        {
            if (!outcome.IsMet)
            {
                misses.Add(
                    $"{outcome.Figure.Name}: {outcome.Value:G4}, limit {outcome.Figure.Limit:G4}, {outcome.Parameters}, seed {seed}");
            }
        }

        return misses;
    }

    public static List<string> Of(IReadOnlyCollection<Variation> variations)
    {
        var misses = new List<string>();
        foreach (Variation variation in variations)
        {
            double figure = variation.Measure();
            if (!(figure <= variation.Limit))
            {
                misses.Add($"{variation.What}: {figure:G4}, limit {variation.Limit:G4}");
            }
        }

        return misses;
    }
}
