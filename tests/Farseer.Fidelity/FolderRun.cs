using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using Farseer.CommandLines;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity;

/// <summary>Runs a folder. Exit code 0: no scene failed; 1: one failed; 2: the input cannot be used.</summary>
public static class FolderRun
{
    public static int Run(string[] args, TextWriter output, TextWriter error)
    {
        RootCommand root = Options.Root();
        root.SetAction(result => Run(Options.Read(result), result.InvocationConfiguration.Output));
        try
        {
            return CommandLine.Run(root, args, output, error);
        }
        catch (Exception e) when (e is BadSceneException or IOException or UnauthorizedAccessException)
        {
            error.WriteLine(e.Message);
            return CommandLine.Misused;
        }
    }

    private static int Run(Options options, TextWriter output)
    {
        IReadOnlyList<SceneFile> scenes = Chosen(options);
        if (options.List)
        {
            foreach (SceneFile scene in scenes)
            {
                output.WriteLine(scene.Category + " " + scene.Name);
            }

            return 0;
        }

        using StreamWriter? csv = Values.Open("--csv", options.CsvPath);
        Report report = new(output, options.Verbose);
        report.Begin();
        foreach (SceneFile scene in scenes)
        {
            report.Add(SceneJudge.Judge(scene));
        }

        report.End();
        if (csv is not null)
        {
            report.WriteCsv(csv);
        }

        return report.AnyFailed ? 1 : 0;
    }

    private static IReadOnlyList<SceneFile> Chosen(Options options)
    {
        List<SceneFile> scenes = SceneFile.ReadFolder(options.Folder)
            .Where(s => options.Categories.Count == 0 || options.Categories.Contains(s.Category))
            .Where(s => options.Scene is null || s.Name == options.Scene)
            .ToList();
        return scenes.Count > 0 ? scenes : throw new BadSceneException($"No scene of '{options.Folder}' is of that name or category.");
    }
}
