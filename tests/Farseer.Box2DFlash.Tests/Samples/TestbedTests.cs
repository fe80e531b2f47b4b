using System;
using System.Linq;
using Farseer.Testbed;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Samples;

/// <summary>Every scene of the testbed ends as it must, and can be drawn.</summary>
public sealed class TestbedTests
{
    public static TheoryData<string> Names => new(SceneList.Makers.Select(m => m().Name));

    [Theory]
    [MemberData(nameof(Names))]
    public void Scene_RunToItsEnd_EndsAsItMust(string name)
    {
        TestScene scene = SceneList.Makers.Select(m => m()).Single(s => s.Name == name);
        for (int step = 0; step < scene.Steps; step++)
        {
            scene.Step(step);
        }

        Assert.All(scene.Check(), o => Assert.True(o.Holds, o.What));
        Assert.Contains(TextDraw.Picture(scene), c => c is '#' or 'o');
        Assert.DoesNotContain(' ', scene.Name);
        Assert.EndsWith(".", scene.Description, StringComparison.Ordinal);
    }
}
