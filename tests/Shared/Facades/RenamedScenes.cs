using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;

namespace Farseer.Tests.Shared;

/// <summary>Recorded scenes under other names, and without a word on what they are.</summary>
internal static class RenamedScenes
{
    /// <summary>Copies each scene of a folder into another one, under a name that tells nothing; the result is name by new name.</summary>
    public static IReadOnlyDictionary<string, string> Write(string from, string to)
    {
        Dictionary<string, string> names = [];
        Random random = new(7);
        string[] files = Directory.GetFiles(from, "*.json");
        random.Shuffle(files);
        foreach (string file in files)
        {
            JsonNode scene = JsonNode.Parse(File.ReadAllText(file))!;
            string name = "n" + names.Count.ToString(CultureInfo.InvariantCulture);
            names.Add(name, scene["name"]!.GetValue<string>());
            scene["name"] = name;
            scene["category"] = "any";
            foreach (string text in new[] { "description", "engine", "quirk" }.Where(t => scene[t] is not null))
            {
                scene[text] = "any";
            }

            File.WriteAllText(Path.Combine(to, name + ".json"), scene.ToJsonString());
        }

        return names;
    }
}
