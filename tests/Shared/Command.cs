using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Text;

namespace Farseer.Tests.Shared;

/// <summary>Runs a program to its end and keeps what it wrote.</summary>
internal static class Command
{
    // What a test run hands down to its children and a child build would take for its own settings.
    private static readonly string[] _inherited =
        ["MSBUILD_EXE_PATH", "MSBuildSDKsPath", "MSBuildExtensionsPath", "MSBuildLoadMicrosoftTargetsReadOnly", "DOTNET_ROOT_X64"];

    /// <summary>Runs <c>dotnet</c>; the output is that of both streams, line by line.</summary>
    /// <exception cref="TimeoutException">The program was still running after <paramref name="limit"/> and was ended.</exception>
    public static (int Code, string Output) Dotnet(
        string folder, IEnumerable<string> arguments, IReadOnlyDictionary<string, string> environment, TimeSpan limit) =>
        Run(Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") ?? "dotnet", folder, arguments, environment, limit);

    /// <summary>Runs a program; the output is that of both streams, line by line.</summary>
    /// <exception cref="TimeoutException">The program was still running after <paramref name="limit"/> and was ended.</exception>
    public static (int Code, string Output) Run(
        string program, string folder, IEnumerable<string> arguments, IReadOnlyDictionary<string, string> environment, TimeSpan limit)
    {
        ProcessStartInfo start = new(program, arguments)
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

        foreach ((string name, string value) in environment)
        {
            start.Environment[name] = value;
        }

        StringBuilder output = new();
        using Process process = new() { StartInfo = start };
        process.OutputDataReceived += (_, line) => Append(output, line.Data);
        process.ErrorDataReceived += (_, line) => Append(output, line.Data);
        process.Start();
        process.StandardInput.Close();
        process.BeginOutputReadLine();
        process.BeginErrorReadLine();
        if (!process.WaitForExit(limit))
        {
            process.Kill(entireProcessTree: true);
            throw new TimeoutException($"'{program} {string.Join(' ', start.ArgumentList)}' ran longer than {limit}.\n{output}");
        }

        process.WaitForExit(); // the overload without a limit also waits for the last lines
        return (process.ExitCode, output.ToString());
    }

    private static void Append(StringBuilder output, string? line)
    {
        if (line is not null)
        {
            lock (output)
            {
                output.Append(line).Append('\n');
            }
        }
    }
}
