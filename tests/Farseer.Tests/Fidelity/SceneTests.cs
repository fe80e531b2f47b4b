using System;
using System.Collections.Generic;
using System.Linq;
using Farseer.Fidelity.Judging;
using Farseer.Fidelity.Scenes;
using Xunit;

namespace Farseer.Tests.Fidelity;

/// <summary>Every reference scene, run through the public API and judged as the fidelity runner judges it.</summary>
public sealed class SceneTests
{
    /// <summary>The scenes that need a part that is not built yet, with that part.</summary>
    private static readonly Dictionary<string, string> NotBuiltYet = new(StringComparer.Ordinal)
    {
        ["chain_pin"] = "ComplexFactory",
        ["chain_revolute"] = "ComplexFactory",
        ["track"] = "ComplexFactory",
    };

    public static TheoryData<string> BuiltScenes =>
        new(ReferenceData.Scenes.Select(s => s.Name).Where(n => !NotBuiltYet.ContainsKey(n)));

    [Theory]
    [MemberData(nameof(BuiltScenes))]
    public void Scene_RunThroughTheApi_MeetsItsReference(string name)
    {
        Verdict verdict = SceneJudge.Judge(ReferenceData.Scene(name));

        string failed = string.Join(Environment.NewLine, verdict.Checks.Where(c => !c.Passed));
        Assert.True(verdict.Outcome == Outcome.Pass, $"{verdict.Outcome} {verdict.Reason}{Environment.NewLine}{failed}");
    }

    [Fact]
    public void SkippedScenes_AreThoseThatNeedAPartNotBuiltYet()
    {
        List<string> skipped = [];
        foreach (SceneFile scene in ReferenceData.Scenes.Where(s => NotBuiltYet.ContainsKey(s.Name)))
        {
            Verdict verdict = SceneJudge.Judge(scene);
            if (verdict.Outcome == Outcome.Skip && verdict.Reason.Contains(NotBuiltYet[scene.Name], StringComparison.Ordinal))
            {
                skipped.Add(scene.Name);
            }
        }

        Assert.Equal(NotBuiltYet.Keys.Order(StringComparer.Ordinal), skipped);
    }

    [Fact]
    public void ClosedForms_AreAtMostEight_AndNameScenes()
    {
        Assert.InRange(ClosedForms.ByScene.Count, 0, 8);
        Assert.All(ClosedForms.ByScene.Keys, name => ReferenceData.Scene(name));
    }
}
