using System;
using System.Globalization;
using System.Linq;
using System.Threading.Tasks;
using Farseer.Samples.Tests.Rendering;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Viewer;
using Microsoft.Playwright;
using Xunit;

namespace Farseer.Viewer.Tests;

/// <summary>
/// The page in a real browser. Each test also asks for no error in the console and no request (<see cref="ViewerPage"/>).
/// </summary>
public sealed class PageTests
{
    private const int Updates = 150;

    [BrowserFact]
    public async Task Page_OfARun_DrawsItAndScrubs()
    {
        await using ViewerPage page = await ViewerPage.Open(Worlds.Recorded(Worlds.Mixed(), Updates));
        PngPicture begin = await page.Picture();

        await page.Page.Locator("#scrub").FocusAsync();
        await page.Page.Keyboard.PressAsync("End");
        await page.Page.WaitForFunctionAsync("frame => farseer.frame === frame && !farseer.needsDrawing", Updates - 1);
        PngPicture end = await page.Picture();

        Assert.True(Colors(begin) > 5, "the scene has too few colours to be there");
        Assert.True(Different(begin, end) > 500, "the last frame looks like the first");
        Assert.Equal(Updates.ToString(CultureInfo.InvariantCulture), await page.Page.Locator("#frame").InputValueAsync());
    }

    [BrowserFact]
    public async Task Play_RunsToTheEnd_AndStops()
    {
        await using ViewerPage page = await ViewerPage.Open(Worlds.Recorded(Worlds.Mixed(), 40));

        await page.Page.Keyboard.PressAsync("Space");
        await page.Page.WaitForFunctionAsync("() => farseer.frame === 39 && !farseer.player.isPlaying");
        await page.Page.Keyboard.PressAsync("ArrowLeft");

        Assert.Equal(38, await page.Ask<int>("() => farseer.frame"));
        Assert.Equal("Play", await page.Page.Locator("#play").GetAttributeAsync("aria-label"));
    }

    [BrowserFact]
    public async Task Click_OnABody_PicksIt_AndItsNameIsText()
    {
        await using ViewerPage page = await ViewerPage.Open(Worlds.Recorded(Worlds.Mixed(), 3));
        float[] at = await page.Ask<float[]>("() => farseer.camera.toScreen(-3, 4, farseer.stages[0].width, farseer.stages[0].height)");

        await page.Page.Locator(".stage canvas").ClickAsync(new LocatorClickOptions { Position = new Position { X = at[0], Y = at[1] } });

        Assert.Equal("ball </script><b> (body 1)", await page.Page.Locator("#picked-name").InnerTextAsync());
    }

    [BrowserFact]
    public async Task Numbers_OfBodiesAndJoints_AreThoseOfTheEngine()
    {
        await using ViewerPage page = await ViewerPage.Open(Worlds.Recorded(Worlds.Mixed(), Updates));
        PhysicsSimulator simulator = Worlds.Mixed();
        int[] frames = [0, 1, 7, 63, Updates - 1];
        for (int frame = 0; frame < Updates; frame++)
        {
            simulator.Update(Worlds.Dt);
            if (!frames.Contains(frame))
            {
                continue;
            }

            await page.Seek(frame);
            for (int i = 0; i < simulator.BodyList.Count; i++)
            {
                Body body = simulator.BodyList[i];
                await page.Pick("body", i);
                body.GetTotalRotation(out double angle);
                Assert.Equal(body.PositionX, await Double(page, "x"));
                Assert.Equal(body.PositionY, await Double(page, "y"));
                Assert.Equal(angle, await Double(page, "angle"));
                Assert.Equal(body.LinearVelocity.X, await Single(page, "vx"));
                Assert.Equal(body.LinearVelocity.Y, await Single(page, "vy"));
                Assert.Equal(body.AngularVelocity, await Single(page, "spin"));
                Assert.Equal(body.Mass, await Single(page, "mass"));
                Assert.Equal(body.MomentOfInertia, await Single(page, "inertia"));
            }

            for (int i = 0; i < simulator.JointList.Count; i++)
            {
                await page.Pick("link", i);
                Assert.Equal(simulator.JointList[i].JointError, await Single(page, "error"));
                Assert.Equal(simulator.JointList[i].ReactionForce.Y, await Single(page, "fy"));
            }
        }
    }

    [BrowserFact]
    public async Task Numbers_OfContactsStepsAndEvents_AreThoseOfTheEngine()
    {
        PhysicsSimulator simulator = Worlds.Mixed();
        RunRecorder recorder = Worlds.Recorded(simulator, Updates);
        await using ViewerPage page = await ViewerPage.Open(recorder);
        await page.Seek(Updates - 1);
        await page.Pick("body", 2);

        Arbiter arbiter = simulator.ArbiterList.Single(a => a.GeomA.Body == simulator.BodyList[2] || a.GeomB.Body == simulator.BodyList[2]);
        string[] pushes = [.. await page.Page.Locator("#contacts tbody tr td:nth-child(2)").AllInnerTextsAsync()];
        Assert.Equal(
            arbiter.ContactList.Select(c => c.NormalImpulse).Order(),
            pushes.Select(t => float.Parse(t, CultureInfo.InvariantCulture)).Order());

        Assert.Equal(simulator.Report.Error, await page.Ask<double>("() => farseer.recordings[0].steps.error.at(-1)"));
        Assert.Equal(simulator.Report.KineticEnergy, await page.Ask<double>("() => farseer.recordings[0].steps.kineticEnergy.at(-1)"));
        Assert.True(await page.Ask<int>("() => farseer.recordings[0].events.kind.filter(kind => kind === 2).length") > 2);
    }

    [BrowserFact]
    public async Task TwoRuns_MarkTheirFirstDifference()
    {
        RunRecorder one = Worlds.Recorded(Worlds.Mixed(), Updates);
        PhysicsSimulator pushed = Worlds.Mixed();
        RunRecorder two = new(pushed);
        for (int i = 0; i < Updates; i++)
        {
            if (i == 40)
            {
                pushed.BodyList[1].ApplyImpulse(new System.Numerics.Vector2(0.01f, 0));
            }

            pushed.Update(Worlds.Dt);
            two.Record(Worlds.Dt);
        }

        await using ViewerPage page = await ViewerPage.Open(one, two);
        string bar = await page.Page.Locator("#difference-bar").InnerTextAsync();
        await page.Page.Locator("body").PressAsync("x");
        await page.Page.WaitForFunctionAsync("() => farseer.frame === 40");
        string x = await page.Shown("x");
        string other = await page.Shown("x", 1);

        Assert.Contains("update 41", bar, StringComparison.Ordinal);
        Assert.Contains("(body 1), x", bar, StringComparison.Ordinal);
        Assert.NotEqual(x, other);
        Assert.Equal(2, await page.Page.Locator(".stage").CountAsync());
        Assert.Equal(1, await page.Page.Locator("#values tr.unlike:has(td[data-key=x])").CountAsync());
        Assert.Equal(0, await page.Page.Locator("#values tr.unlike:has(td[data-key=mass])").CountAsync());
    }

    [BrowserFact]
    public async Task TwoRuns_OfTheSame_SaySo()
    {
        await using ViewerPage page = await ViewerPage.Open(Worlds.Recorded(Worlds.Mixed(), 20), Worlds.Recorded(Worlds.Mixed(), 20));

        Assert.Contains("the same, bit for bit", await page.Page.Locator("#difference-bar").InnerTextAsync(), StringComparison.Ordinal);
    }

    [BrowserFact]
    public async Task Find_ByName_PicksWhatIsClicked()
    {
        await using ViewerPage page = await ViewerPage.Open(Worlds.Recorded(Worlds.Mixed(), 5));
        await page.Page.Locator("body").PressAsync("/");
        await page.Page.Locator("#query").FillAsync("hinge");

        await page.Page.Locator("#found button").ClickAsync();

        Assert.Equal("hinge (joint 0, Revolute)", await page.Page.Locator("#picked-name").InnerTextAsync());
    }

    [BrowserFact]
    public async Task Islands_JoinWhatHangsTogether()
    {
        await using ViewerPage page = await ViewerPage.Open(Worlds.Recorded(Worlds.Mixed(), 30));
        await page.Page.Locator("#coloring").SelectOptionAsync("island");
        await page.Seek(20);

        int[] roots = await page.Ask<int[]>("() => [...farseer.stages[0].painter.islands.roots]");

        Assert.Equal([-1, 1, 2, 3, 3], roots);
    }

    [BrowserFact]
    public async Task Theme_FollowsTheSystem_AndTheSwitch()
    {
        await using ViewerPage page = await ViewerPage.Open(Worlds.Recorded(Worlds.Mixed(), 5), scheme: ColorScheme.Dark);
        PngPicture dark = await page.Picture();
        await page.Page.Locator("#theme").ClickAsync();
        await page.Page.WaitForFunctionAsync("() => !farseer.needsDrawing");
        PngPicture light = await page.Picture();

        Assert.True(Brightness(dark) < 60 && Brightness(light) > 200, $"{Brightness(dark)} and {Brightness(light)}");
    }

    [BrowserFact]
    public async Task Phone_ShowsAll_WithoutScrollingSideways()
    {
        await using ViewerPage page = await ViewerPage.Open(Worlds.Recorded(Worlds.Mixed(), 60), width: 390, height: 844);
        float[] at = await page.Ask<float[]>("() => farseer.camera.toScreen(-3, 4, farseer.stages[0].width, farseer.stages[0].height)");

        await page.Page.Locator(".stage canvas").TapAsync(new LocatorTapOptions { Position = new Position { X = at[0], Y = at[1] } });

        Assert.Equal(390, await page.Ask<int>("() => document.documentElement.scrollWidth"));
        Assert.StartsWith("ball", await page.Page.Locator("#picked-name").InnerTextAsync(), StringComparison.Ordinal);
    }

    private static async Task<double> Double(ViewerPage page, string key) =>
        double.Parse(await page.Shown(key), CultureInfo.InvariantCulture);

    private static async Task<float> Single(ViewerPage page, string key) =>
        float.Parse(await page.Shown(key), CultureInfo.InvariantCulture);

    private static int Colors(PngPicture picture) =>
        (from y in Enumerable.Range(0, picture.Height) from x in Enumerable.Range(0, picture.Width) select picture.At(x,
            y)).Distinct().Count();

    private static int Different(PngPicture one, PngPicture two) =>
        (from y in Enumerable.Range(0, one.Height) from x in Enumerable.Range(0, one.Width) where one.At(x, y) != two.At(x,
            y) select x).Count();

    private static double Brightness(PngPicture picture) =>
        (from x in Enumerable.Range(0, picture.Width) let pixel = picture.At(x,
            2) select (pixel.Red + pixel.Green + pixel.Blue) / 3.0).Average();
}
