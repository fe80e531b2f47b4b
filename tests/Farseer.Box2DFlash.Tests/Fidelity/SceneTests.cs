using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Scenes;
using Farseer.Tests.Shared;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Fidelity;

/// <summary>Every recorded scene of the original, run through the public API and judged as the fidelity runner judges it.</summary>
public sealed class SceneTests
{
    private static readonly IReadOnlyList<SceneFile> _scenes = SceneFile.ReadFolder(TestData.SceneFolder);

    public static TheoryData<string> Scenes => new(_scenes.Select(s => s.Name));

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Scene_RunThroughTheApi_MeetsItsReference(string name)
    {
        Verdict verdict = SceneJudge.Judge(_scenes.Single(s => s.Name == name));

        string failed = string.Join(Environment.NewLine, verdict.Checks.Where(c => !c.Passed));
        Assert.True(verdict.Outcome == Outcome.Pass, $"{verdict.Outcome} {verdict.Reason}{Environment.NewLine}{failed}");
    }

    /// <summary>The judge goes by what a scene holds: no name, no category and no text in it matters.</summary>
    [Fact]
    public void Scenes_UnderOtherNames_MeetTheirReference()
    {
        string folder = Directory.CreateTempSubdirectory("fidelity").FullName;
        try
        {
            IReadOnlyDictionary<string, string> names = RenamedScenes.Write(TestData.SceneFolder, folder);
            IEnumerable<Verdict> verdicts = SceneFile.ReadFolder(folder).Select(SceneJudge.Judge);

            Assert.Equal(_scenes.Count, names.Count);
            Assert.All(verdicts, v => Assert.True(v.Outcome == Outcome.Pass, names[v.Scene] + " " + v.Reason));
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }
}
