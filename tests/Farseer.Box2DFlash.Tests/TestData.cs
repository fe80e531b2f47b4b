using System;
using System.IO;
using System.Linq;
using Farseer.Tests.Shared;

namespace Farseer.Box2DFlash.Tests;

/// <summary>The tables, embedded in the test assembly, and the folder of the scenes.</summary>
internal static class TestData
{
    public static string SceneFolder { get; } = Path.Combine(Clone.Root, "tests", "data", "fidelity-box2d");

    public static string[][] Table(string name)
    {
        using Stream stream = typeof(TestData).Assembly.GetManifestResourceStream(name)
            ?? throw new FileNotFoundException($"No data file {name} is embedded in the tests.", name);
        using StreamReader reader = new(stream);
        return [.. reader.ReadToEnd().ReplaceLineEndings("\n").Split('\n').Skip(1).Where(l => l.Length > 0).Select(l => l.Split('\t'))];
    }
}
