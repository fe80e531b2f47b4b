using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Xunit;

namespace Farseer.Samples.Tests.Rendering;

/// <summary>A Chromium on this machine, without a window.</summary>
internal static class Browser
{
    private const int MostMilliseconds = 60_000;
    private static readonly string[] _names = ["chromium", "chromium-browser", "google-chrome", "chrome"];

    /// <summary>Null: there is none.</summary>
    public static string? Program { get; } = Find();

    /// <summary>Null: tests that need it run.</summary>
    public static string? ReasonToSkip => Program is null ? "there is no Chromium on this machine to look at pages with" : null;

    /// <summary>Renders an SVG file of that size.</summary>
    public static PngPicture Render(string svg, int width, int height)
    {
        string folder = Directory.CreateTempSubdirectory("farseer-browser").FullName;
        try
        {
            string png = Path.Combine(folder, "picture.png");
            ProcessStartInfo start = new(Program!) { RedirectStandardError = true, RedirectStandardOutput = true };
            string[] arguments =
            [
                "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
                "--disable-component-update", "--disable-sync", "--hide-scrollbars", "--force-device-scale-factor=1",
                "--force-color-profile=srgb", "--user-data-dir=" + folder, FormattableString.Invariant($"--window-size={width},{height}"),
                "--screenshot=" + png, new Uri(svg).AbsoluteUri,
            ];
            foreach (string argument in arguments)
            {
                start.ArgumentList.Add(argument);
            }

            using Process process = Process.Start(start)!;
            process.OutputDataReceived += (_, _) => { };
            process.ErrorDataReceived += (_, _) => { };
            process.BeginOutputReadLine();
            process.BeginErrorReadLine();
            if (!process.WaitForExit(MostMilliseconds))
            {
                process.Kill(entireProcessTree: true);
                throw new TimeoutException($"{Program} did not render {svg} in {MostMilliseconds / 1000} s.");
            }

            return PngPicture.Load(png);
        }
        finally
        {
            DeleteSoon(folder);
        }
    }

    // The browser's last children may still write for a moment; what then stays behind is in the temporary folder.
    private static void DeleteSoon(string folder)
    {
        try
        {
            Directory.Delete(folder, recursive: true);
        }
        catch (IOException)
        {
            Debug.WriteLine($"{folder} is still in use.");
        }
    }

    private static string? Find()
    {
        string[] folders = (Environment.GetEnvironmentVariable("PATH") ?? string.Empty).Split(Path.PathSeparator);
        return folders.SelectMany(folder => _names.Select(name => Path.Combine(folder, name))).FirstOrDefault(File.Exists);
    }
}

/// <summary>Tests that need a browser: skipped, and reported so, where there is none.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class BrowserTheoryAttribute : TheoryAttribute
{
    public BrowserTheoryAttribute() => Skip = Browser.ReasonToSkip!;
}

/// <summary>A test that needs a browser: skipped, and reported so, where there is none.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class BrowserFactAttribute : FactAttribute
{
    public BrowserFactAttribute() => Skip = Browser.ReasonToSkip!;
}
