using System;
using System.Linq;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Scenes;
using Xunit;

namespace Farseer.Tests.Fidelity;

/// <summary>Every reference scene, run through the public API and judged as the fidelity runner judges it.</summary>
public sealed class SceneTests
{
    public static TheoryData<string> Scenes =>
        new(ReferenceData.Scenes.Select(s => s.Name));

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Scene_RunThroughTheApi_MeetsItsReference(string name)
    {
        Verdict verdict = SceneJudge.Judge(ReferenceData.Scene(name));

        string failed = string.Join(Environment.NewLine, verdict.Checks.Where(c => !c.Passed));
        Assert.True(verdict.Outcome == Outcome.Pass, $"{verdict.Outcome} {verdict.Reason}{Environment.NewLine}{failed}");
    }

    [Fact]
    public void ClosedForms_AreAtMostEight_AndNameScenes()
    {
        Assert.InRange(ClosedForms.ByScene.Count, 0, 8);
        Assert.All(ClosedForms.ByScene.Keys, name => ReferenceData.Scene(name));
    }
}
