using System;
using System.IO;
using System.Linq;
using Farseer.CommandLines;
using Farseer.Scenes;

namespace Farseer.Samples;

/// <summary>Finds the scene that a word on the command line means.</summary>
internal static class SceneSelection
{
    public static Scene Find(string word)
    {
        if (SceneLibrary.Find(word) is Scene scene)
        {
            return scene;
        }

        bool isPath = word.EndsWith(".json", StringComparison.OrdinalIgnoreCase)
            || word.Contains('/') || word.Contains('\\') || File.Exists(word);
        if (isPath)
        {
            return SceneFile.Load(word);
        }

        string suggestion = Names.Suggestion(word, SceneLibrary.All.Select(s => s.Name));
        throw new UsageException($"there is no scene '{word}'{suggestion}; 'list' shows the names");
    }
}
