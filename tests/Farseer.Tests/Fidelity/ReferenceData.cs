using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Farseer.Fidelity.Scenes;

namespace Farseer.Tests.Fidelity;

/// <summary>The reference scenes of the repository.</summary>
internal static class ReferenceData
{
    public static string Folder { get; } = Path.Combine(Root(), "tests", "data", "fidelity");

    public static IReadOnlyList<SceneFile> Scenes { get; } = SceneFile.ReadFolder(Folder);

    public static SceneFile Scene(string name) => Scenes.Single(s => s.Name == name);

    private static string Root()
    {
        DirectoryInfo? folder = new(AppContext.BaseDirectory);
        while (folder is not null && !File.Exists(Path.Combine(folder.FullName, "Farseer.sln")))
        {
            folder = folder.Parent;
        }

        return folder?.FullName ?? throw new InvalidOperationException("The tests must run inside the repository.");
    }
}
