using System;
using System.IO;

namespace Farseer.Tests.Shared;

/// <summary>The clone that the tests run in.</summary>
internal static class Clone
{
#if DEBUG
    public const string Configuration = "Debug";
#else
    public const string Configuration = "Release";
#endif

    public static string Root { get; } = FindRoot();

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
