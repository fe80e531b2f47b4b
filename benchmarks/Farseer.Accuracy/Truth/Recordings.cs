using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Text.RegularExpressions;

namespace Farseer.Accuracy.Truth;

/// <summary>How many recorded scenes the runner of recordings says are met; it is built and run in a process of its own.</summary>
internal static class Recordings
{
    private const string Solution = "Farseer.sln";
    private const string Project = "tests/Farseer.Fidelity";

    private static readonly string[] _folders = ["tests/data/fidelity", "tests/data/fidelity-box2d"];

    public static void Add(List<TruthFigure> figures)
    {
        string root = Root();
        foreach (string folder in _folders)
        {
            string said = Said(root, folder);
            Match counts = Regex.Match(said, @"(\d+) passed, (\d+) failed, (\d+) skipped");
            if (!counts.Success)
            {
                throw new UsageException($"truth: {Project} told no counts of {folder}: {said}");
            }

            int passed = Count(1);
            int failed = Count(2);
            string name = $"recordings {Path.GetFileName(folder)}";
            figures.Add(new($"{name} passed", passed, passed + failed + Count(3), true));
            figures.Add(new($"{name} failed", failed, 0, false));

            int Count(int group) => int.Parse(counts.Groups[group].Value, CultureInfo.InvariantCulture);
        }
    }

    private static string Said(string root, string folder)
    {
        var start = new ProcessStartInfo("dotnet", ["run", "-c", "Release", "--project", Project, "--", folder])
        {
            WorkingDirectory = root,
            RedirectStandardOutput = true,
        };
        using Process process = Process.Start(start) ?? throw new UsageException("truth: dotnet does not start.");
        string said = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return said;
    }

    private static string Root()
    {
        for (DirectoryInfo? folder = new(Directory.GetCurrentDirectory()); folder is not null; folder = folder.Parent)
        {
            if (File.Exists(Path.Combine(folder.FullName, Solution)))
            {
                return folder.FullName;
            }
        }

        throw new UsageException($"truth: run it inside the repository; no {Solution} in this folder or above.");
    }
}
