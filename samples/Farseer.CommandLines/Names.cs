using System;
using System.Collections.Generic;

namespace Farseer.CommandLines;

/// <summary>Guesses what a mistyped name was meant to be.</summary>
public static class Names
{
    /// <summary>" (did you mean ...?)" for the nearest name, or nothing when none is near.</summary>
    public static string Suggestion(string word, IEnumerable<string> names)
    {
        string? best = null;
        int least = int.MaxValue;
        foreach (string name in names)
        {
            // A part of a name is what people type when they have forgotten the rest.
            int distance = word.Length > 2 && name.Contains(word, StringComparison.OrdinalIgnoreCase) ? 1 : Distance(word, name);
            if (distance < least)
            {
                least = distance;
                best = name;
            }
        }

        // More than half of the word wrong is a different word.
        return best is not null && least <= Math.Max(2, word.Length / 2) ? $" (did you mean '{best}'?)" : string.Empty;
    }

    /// <summary>Insertions, deletions, replacements and swaps of neighbours that turn one word into the other.</summary>
    private static int Distance(string a, string b)
    {
        int[,] cost = new int[a.Length + 1, b.Length + 1];
        for (int i = 0; i <= a.Length; i++)
        {
            cost[i, 0] = i;
        }

        for (int j = 0; j <= b.Length; j++)
        {
            cost[0, j] = j;
        }

        for (int i = 1; i <= a.Length; i++)
        {
            for (int j = 1; j <= b.Length; j++)
            {
                bool same = char.ToLowerInvariant(a[i - 1]) == char.ToLowerInvariant(b[j - 1]);
                int least = Math.Min(Math.Min(cost[i - 1, j], cost[i, j - 1]) + 1, cost[i - 1, j - 1] + (same ? 0 : 1));
                if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                {
                    least = Math.Min(least, cost[i - 2, j - 2] + 1);
                }

                cost[i, j] = least;
            }
        }

        return cost[a.Length, b.Length];
    }
}
