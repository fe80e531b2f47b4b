using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Threading.Tasks;
using Farseer.CommandLines;

namespace Farseer.Beside;

/// <summary>How a program ended, and the last line that it told.</summary>
internal sealed record Ending(int Code, string LastLine);

/// <summary>A build of the library: a checkout, or a folder with its programs.</summary>
internal sealed class Build
{
    private const string Solution = "Farseer.sln";

    /// <summary>What <c>dotnet run</c> hands down to its children, and what a child build would take for its own settings.</summary>
    private static readonly string[] _inherited =
        ["MSBUILD_EXE_PATH", "MSBuildSDKsPath", "MSBuildExtensionsPath", "MSBuildLoadMicrosoftTargetsReadOnly"];

    private readonly Dictionary<string, string> _programs = [];

    private Build(string root, string title)
    {
        Root = root;
        Title = title;
    }

    /// <summary>For people: the folder, and of a checkout its commit.</summary>
    public string Title { get; }

    /// <summary>Where recordings are looked for: the checkout itself, or the one that this program runs in.</summary>
    public string Root { get; }

    /// <summary>Builds the programs of a checkout, or finds them in a folder. One that is not there is no error.</summary>
    /// <param name="folder">The checkout or the folder.</param>
    /// <param name="parts">What is to be run.</param>
    /// <param name="progress">Is told what is built.</param>
    /// <exception cref="UsageException">There is no such folder, it has no program or one twice, or a project does not build.</exception>
    public static Build Open(string folder, IReadOnlyList<Part> parts, TextWriter progress)
    {
        if (!Directory.Exists(folder))
        {
            throw new UsageException($"'{folder}' is no folder.");
        }

        string full = Path.GetFullPath(folder);
        bool isCheckout = File.Exists(Path.Combine(full, Solution));
        var build = new Build(isCheckout ? full : RootOf(AppContext.BaseDirectory), isCheckout ? full + Commit(full) : full);
        var programs = new SortedSet<string>(StringComparer.Ordinal);
        foreach (Part part in parts)
        {
            programs.Add(part.Program);
        }

        foreach (string program in programs)
        {
            string? output = isCheckout ? Make(full, program, progress) : full;
            if (output is not null && Find(output, program) is string path)
            {
                build._programs.Add(program, path);
            }
        }

        return build._programs.Count > 0 ? build : throw new UsageException($"'{folder}' has none of {string.Join(", ", programs)}.");
    }

    /// <summary>Runs a program to its end; null if this build does not have it.</summary>
    public async Task<Ending?> RunAsync(string program, IReadOnlyList<string> arguments) =>
        _programs.TryGetValue(program, out string? path)
            ? await StartAsync("dotnet", Root, ["exec", path, .. arguments]).ConfigureAwait(false)
            : null;

    private static string? Make(string checkout, string program, TextWriter progress)
    {
        foreach (string place in (ReadOnlySpan<string>)["benchmarks", "tests"])
        {
            string project = Path.Combine(checkout, place, program);
            if (Directory.Exists(project))
            {
                progress.WriteLine($"building {project}");
                string[] arguments = ["build", "-c", "Release", project, "-nologo", "-clp:ErrorsOnly;NoSummary", "-nodeReuse:false"];
                Ending ending = StartAsync("dotnet", checkout, arguments).GetAwaiter().GetResult();
                return ending.Code == 0
                    ? Path.Combine(project, "bin", "Release")
                    : throw new UsageException($"{project} does not build: {ending.LastLine}");
            }
        }

        return null;
    }

    /// <summary>The program itself lies beside its settings; other projects have copies of the library alone.</summary>
    private static string? Find(string folder, string program)
    {
        string? found = null;
        foreach (string settings in Directory.EnumerateFiles(folder, program + ".runtimeconfig.json", SearchOption.AllDirectories))
        {
            string path = Path.Combine(Path.GetDirectoryName(settings)!, program + ".dll");
            if (File.Exists(path))
            {
                found = found is null ? path : throw new UsageException($"{program} is there twice: {found} and {path}.");
            }
        }

        return found;
    }

    private static string RootOf(string start)
    {
        for (DirectoryInfo? folder = new(start); folder is not null; folder = folder.Parent)
        {
            if (File.Exists(Path.Combine(folder.FullName, Solution)))
            {
                return folder.FullName;
            }
        }

        return Directory.GetCurrentDirectory();
    }

    private static string Commit(string checkout)
    {
        try
        {
            Ending ending = StartAsync("git", checkout, ["describe", "--always", "--dirty= with changes"]).GetAwaiter().GetResult();
            return ending.Code == 0 ? $" ({ending.LastLine})" : string.Empty;
        }
        catch (System.ComponentModel.Win32Exception)
        {
            return string.Empty; // without git a checkout has no more than its path
        }
    }

    private static async Task<Ending> StartAsync(string program, string folder, IEnumerable<string> arguments)
    {
        var start = new ProcessStartInfo(program, arguments)
        {
            WorkingDirectory = folder,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            RedirectStandardInput = true,
        };
        foreach (string name in _inherited)
        {
            start.Environment.Remove(name);
        }

        using var process = new Process { StartInfo = start };
        string last = string.Empty;
        string lastError = string.Empty;
        process.OutputDataReceived += (_, line) => last = string.IsNullOrWhiteSpace(line.Data) ? last : line.Data.Trim();
        process.ErrorDataReceived += (_, line) => lastError = string.IsNullOrWhiteSpace(line.Data) ? lastError : line.Data.Trim();
        process.Start();
        process.StandardInput.Close();
        process.BeginOutputReadLine();
        process.BeginErrorReadLine();
        await process.WaitForExitAsync().ConfigureAwait(false);
        return new Ending(process.ExitCode, lastError.Length > 0 ? lastError : last);
    }
}
