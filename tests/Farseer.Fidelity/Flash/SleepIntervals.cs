using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Flash;

/// <summary>When a body slept, from the steps after which its state was found changed.</summary>
internal static class SleepIntervals
{
    public static List<(int Step, bool State)> Read(JsonElement root, string key, string body)
        => [.. Json.Items(Json.Optional(Json.Optional(root, "sleepChanges"), key), body).Select(c => (c[0].GetInt32(), c[1].GetBoolean()))];

    /// <summary>The steps in which it slept all the time: from the one after it fell asleep to the one before it woke.</summary>
    public static IEnumerable<(int From, int To)> Of(IReadOnlyList<(int Step, bool State)> changes, int steps)
    {
        for (int i = 0; i < changes.Count; i++)
        {
            if (changes[i].State)
            {
                yield return (changes[i].Step + 1, i + 1 < changes.Count ? changes[i + 1].Step - 1 : steps);
            }
        }
    }
}
