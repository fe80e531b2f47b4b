using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Farseer.Rules.Tests;

/// <summary>Where things are: the tests read the sources and the built libraries of the clone they run in.</summary>
internal static class Repository
{
#if DEBUG
    private const string Configuration = "Debug";
#else
    private const string Configuration = "Release";
#endif

    public static string Root { get; } = FindRoot();

    public static string EngineFolder => Path.Combine(Root, "src", "Farseer.Engine");

    public static string Library(string name, string framework) =>
        Path.Combine(Root, "src", name, "bin", Configuration, framework, name + ".dll");

    /// <summary>Files under a folder of the clone, without what a build made.</summary>
    public static IEnumerable<string> Files(string folder, string pattern) =>
        Directory.EnumerateFiles(Path.Combine(Root, folder), pattern, SearchOption.AllDirectories)
            .Where(f => !IsBuilt(Path.GetRelativePath(Root, f)))
            .Order(StringComparer.Ordinal);

    public static string Relative(string file) => Path.GetRelativePath(Root, file).Replace('\\', '/');

    private static bool IsBuilt(string path) =>
        path.Split('/', '\\').Any(part => part is "bin" or "obj" or ".git" or "TestResults" or "artifacts");

    private static string FindRoot()
    {
        string? folder = AppContext.BaseDirectory;
        while (folder is not null && !File.Exists(Path.Combine(folder, "Farseer.sln")))
        {
            folder = Path.GetDirectoryName(folder);
        }

        return folder ?? throw new InvalidOperationException("no Farseer.sln above " + AppContext.BaseDirectory);
    }
}
