using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using System.Threading.Tasks;
using Farseer.Samples.Tests.Rendering;
using Farseer.Scenes;
using Farseer.Tests.Shared;
using FarseerGames.FarseerPhysics;
using Microsoft.Playwright;
using Xunit;

namespace Farseer.Viewer.Tests.Browsers;

/// <summary>The library as WebAssembly in a browser: the same bits, and a page that steps a world.</summary>
public sealed class BrowserBuildTests : IClassFixture<PublishedSample>
{
    private const int GoldenSteps = 600;
    private readonly PublishedSample _sample;

    public BrowserBuildTests(PublishedSample sample) => _sample = sample;

    private IPage Page => _sample.Page;

    [BrowserBuildFact]
    public async Task Scenes_InTheBrowser_GiveTheGoldenHashes()
    {
        List<string> golden = [.. File.ReadAllLines(Path.Combine(Clone.Root, "tests", "data", "golden-hashes.txt"))
            .Where(l => l.Length > 0 && l[0] != '#')];
        List<string> hashes = [];
        foreach (string name in golden.Select(l => l.Split(' ')[0]))
        {
            hashes.Add(name + " "
                + await Page.EvaluateAsync<string>("([name, steps]) => farseer.hash(name, steps)", new object[] { name, GoldenSteps }));
        }

        Assert.NotEmpty(golden);
        Assert.Equal(golden, hashes);
        Assert.Empty(_sample.Complaints);
    }

    [BrowserBuildFact]
    public async Task Page_OfAScene_StepsItOnTheCanvasWithTheBitsOfTheDesktop()
    {
        const string Name = "pyramid";
        await Page.ReloadAsync();
        await Page.WaitForFunctionAsync("() => window.farseer");
        await Page.SelectOptionAsync("#scene", Name);
        await Page.WaitForFunctionAsync("() => parseInt(figures.value.slice(5)) > 20");
        await Page.ClickAsync("#pause");

        string figures = await Page.Locator("#figures").InnerTextAsync();
        Match said = Regex.Match(figures, @"^step (\d+), [0-9.]+ ms a step, (\d+) shapes, hash ([0-9a-f]{16})$");
        Assert.True(said.Success, figures);
        Assert.Equal(Straight(Name, int.Parse(said.Groups[1].Value, CultureInfo.InvariantCulture)), said.Groups[3].Value);
        Assert.True(int.Parse(said.Groups[2].Value, CultureInfo.InvariantCulture) > 50, figures);
        Assert.True(Colours(await Picture()) > 5, "the canvas is empty");
        Assert.Equal(figures, await Page.Locator("#figures").InnerTextAsync());
        Assert.Empty(_sample.Complaints);
    }

    private static string Straight(string name, int steps)
    {
        Scene scene = SceneLibrary.Find(name)!;
        PhysicsSimulator simulator = new();
        scene.Build(simulator);
        for (int step = 0; step < steps; step++)
        {
            scene.Step(simulator, step, scene.Dt);
        }

        return simulator.StateHash().ToString("x16", CultureInfo.InvariantCulture);
    }

    private async Task<PngPicture> Picture()
    {
        string file = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName() + ".png");
        try
        {
            await Page.Locator("#canvas").ScreenshotAsync(new LocatorScreenshotOptions { Path = file });
            return PngPicture.Load(file);
        }
        finally
        {
            File.Delete(file);
        }
    }

    private static int Colours(PngPicture picture)
    {
        HashSet<(int, int, int)> colours = [];
        for (int y = 0; y < picture.Height; y += 2)
        {
            for (int x = 0; x < picture.Width; x += 2)
            {
                colours.Add(picture.At(x, y));
            }
        }

        return colours.Count;
    }
}
