using System;
using System.IO;
using Farseer.Tests.Shared;
using Xunit;

namespace Farseer.Samples.Tests.Rendering;

/// <summary>Pages of the documentation site as a browser shows them, where the site was built: see .ci/run.</summary>
public sealed class SiteTests
{
    /// <summary>The text of the page's template, which blends with white at the edges of letters.</summary>
    private static readonly (int Red, int Green, int Blue) _ink = (33, 37, 41);

    [SiteTheory]
    [InlineData("docs/index.html")]
    [InlineData("docs/tutorials/Platformer.html")]
    [InlineData("docs/api/FarseerGames.FarseerPhysics.PhysicsSimulator.html")]
    public void Page_InABrowser_ShowsText(string page)
    {
        PngPicture picture = Browser.Render(Path.Combine(SiteTheoryAttribute.Folder, page), 1000, 800);

        Assert.True(picture.Count(_ink, 60) > 1000, $"{page} shows next to nothing.");
    }
}

/// <summary>A test that needs the site and a browser: skipped, and reported so, without one of them.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class SiteTheoryAttribute : TheoryAttribute
{
    public SiteTheoryAttribute()
    {
        if (Browser.Program is null)
        {
            Skip = "there is no Chromium on this machine to open the site with";
        }
        else if (!File.Exists(Path.Combine(Folder, "docs", "index.html")))
        {
            Skip = "the site was not built: dotnet docfx docfx.json";
        }
    }

    public static string Folder { get; } = Path.Combine(Clone.Root, "artifacts", "site");
}
