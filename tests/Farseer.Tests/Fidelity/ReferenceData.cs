using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Farseer.Fidelity.Scenes;
using Farseer.Tests.Shared;

namespace Farseer.Tests.Fidelity;

/// <summary>The reference scenes of the repository.</summary>
internal static class ReferenceData
{
    public static string Folder { get; } = Path.Combine(Clone.Root, "tests", "data", "fidelity");

    public static IReadOnlyList<SceneFile> Scenes { get; } = SceneFile.ReadFolder(Folder);

    public static SceneFile Scene(string name) => Scenes.Single(s => s.Name == name);
}
