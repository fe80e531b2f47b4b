using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Scenes;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Fidelity;

/// <summary>Every recorded scene of the original, run through the public API and judged as the fidelity runner judges it.</summary>
public sealed class SceneTests
{
    /// <summary>Scenes that miss their reference today. A scene that is mended must leave the list, or its test fails.</summary>
    private static readonly HashSet<string> _knownFaults = new(StringComparer.Ordinal)
    {
        "contact_box", "set_xform",
    };

    private static readonly IReadOnlyList<SceneFile> _scenes = SceneFile.ReadFolder(TestData.SceneFolder());

    public static TheoryData<string> SoundScenes => new(_scenes.Select(s => s.Name).Where(n => !_knownFaults.Contains(n)));

    public static TheoryData<string> FaultyScenes => new(_knownFaults);

    [Theory]
    [MemberData(nameof(FaultyScenes))]
    public void Scene_WithAKnownFault_StillMissesItsReference(string name) =>
        Assert.NotEqual(Outcome.Pass, SceneJudge.Judge(_scenes.Single(s => s.Name == name)).Outcome);

    [Theory]
    [MemberData(nameof(SoundScenes))]
    public void Scene_RunThroughTheApi_MeetsItsReference(string name)
    {
        Verdict verdict = SceneJudge.Judge(_scenes.Single(s => s.Name == name));

        string failed = string.Join(Environment.NewLine, verdict.Checks.Where(c => !c.Passed));
        Assert.True(verdict.Outcome == Outcome.Pass, $"{verdict.Outcome} {verdict.Reason}{Environment.NewLine}{failed}");
    }
}
