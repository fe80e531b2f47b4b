using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Farseer.Tests.Shared;

namespace Farseer.Rules.Tests;

/// <summary>Where things are: the tests read the sources and the built libraries of the clone they run in.</summary>
internal static class Repository
{
    public static string Root => Clone.Root;

    public static string EngineFolder => Path.Combine(Root, "src", "Farseer.Engine");

    public static string Library(string name, string framework) =>
        Path.Combine(Root, "src", name, "bin", Clone.Configuration, framework, name + ".dll");

    /// <summary>Files under a folder of the clone, without what a build made.</summary>
    public static IEnumerable<string> Files(string folder, string pattern) =>
        Directory.EnumerateFiles(Path.Combine(Root, folder), pattern, SearchOption.AllDirectories)
            .Where(f => !IsBuilt(Path.GetRelativePath(Root, f)))
            .Order(StringComparer.Ordinal);

    public static string Relative(string file) => Path.GetRelativePath(Root, file).Replace('\\', '/');

    private static bool IsBuilt(string path) =>
        path.Split('/', '\\').Any(part => part is "bin" or "obj" or ".git" or "TestResults" or "artifacts");
}
