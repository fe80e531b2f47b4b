using System;
using System.Collections.Generic;
using System.IO;
using Farseer.Tests.Shared;
using Xunit;

namespace Farseer.Package.Tests;

/// <summary>
/// Packs the library once, under a version that no cache can know, into a folder of its own, and sets that folder up as the only source
/// of packages: what a consumer restores beside it must already be in the machine's cache, so the test needs no network.
/// </summary>
public sealed class PackedLibrary : IDisposable
{
    private static readonly TimeSpan _limit = TimeSpan.FromMinutes(5);

    // No node that outlives its build, and no cache but the folder's own.
    private static readonly Dictionary<string, string> _environment = new()
    {
        ["MSBUILDDISABLENODEREUSE"] = "1",
        ["DOTNET_CLI_USE_MSBUILD_SERVER"] = "0",
        ["DOTNET_NOLOGO"] = "1",
        ["DOTNET_CLI_TELEMETRY_OPTOUT"] = "1",
        ["DOTNET_CLI_UI_LANGUAGE"] = "en",
        ["CI"] = "true",
    };

    public PackedLibrary()
    {
        Version = "0.0.0-test" + Guid.NewGuid().ToString("N");
        Folder = Directory.CreateTempSubdirectory("farseer-package-").FullName;
        string cache = Dotnet(Folder, "nuget", "locals", "global-packages", "--list").Trim();
        cache = cache[(cache.IndexOf(": ", StringComparison.Ordinal) + 2)..];
        Pack("Farseer");
        Pack("Farseer.Box2DFlash");
        Pack("Farseer.Viewer");
        Pack("Farseer.Serialization");
        File.WriteAllText(Path.Combine(Folder, "NuGet.config"), $"""
            <?xml version="1.0" encoding="utf-8"?>
            <configuration>
              <config><add key="globalPackagesFolder" value="packages" /></config>
              <packageSources><clear /><add key="local" value="feed" /></packageSources>
              <fallbackPackageFolders><clear /><add key="cache" value="{cache}" /></fallbackPackageFolders>
            </configuration>
            """);
    }

    public string Version { get; }

    public string Folder { get; }

    public string Feed => Path.Combine(Folder, "feed");

    public string Package => PackageOf("Farseer");

    public string PackageOf(string project) => Path.Combine(Feed, $"{project}.{Version}.nupkg");

    public string Symbols => Path.Combine(Feed, $"Farseer.{Version}.snupkg");

    /// <summary>Copies a consumer's projects from <c>Consumers</c> beside the package and runs the project named.</summary>
    public string RunConsumer(string consumer, string project)
    {
        string from = Path.Combine(AppContext.BaseDirectory, "Consumers", consumer);
        string to = Path.Combine(Folder, consumer);
        foreach (string file in Directory.EnumerateFiles(from, "*", SearchOption.AllDirectories))
        {
            string copy = Path.Combine(to, Path.GetRelativePath(from, file));
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(file, copy);
        }

        return Dotnet(to, "run", "--configuration", "Release", "--project", project, "-p:FarseerVersion=" + Version);
    }

    private void Pack(string project) => Dotnet(
        Clone.Root, "pack", Path.Combine("src", project, project + ".csproj"), "--no-build", "--configuration", Clone.Configuration,
        "--output", Feed, "-p:PackageVersion=" + Version);

    public void Dispose() => Directory.Delete(Folder, recursive: true);

    private static string Dotnet(string folder, params string[] arguments)
    {
        (int code, string output) = Command.Dotnet(folder, arguments, _environment, _limit);
        Assert.True(code == 0, output);
        return output;
    }
}

/// <summary>Ties the classes that look at the package together: it is packed once, and they run one after the other.</summary>
[CollectionDefinition(Name)]
public sealed class PackageCollection : ICollectionFixture<PackedLibrary>
{
    public const string Name = "package";
}
