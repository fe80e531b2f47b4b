using System;
using System.Globalization;
using System.Linq;
using System.Threading.Tasks;
using Farseer.Samples.Tests.Rendering;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Viewer;
using Xunit;
using Xunit.Abstractions;

namespace Farseer.Viewer.Tests;

/// <summary>5,051 bodies and 600 updates: at most 20 MB, 60 pictures a second, and every digit shown is the engine's.</summary>
public sealed class LargeRunTests(ITestOutputHelper output)
{
    private const int Updates = 600;
    private const int Row = 100;
    private const int Checked = 457;

    [BrowserFact]
    public async Task LargePyramid_FitsInto20Megabytes_AndPlaysAt60PicturesASecond()
    {
        PhysicsSimulator simulator = Worlds.Pyramid(Row);
        RunRecorder recorder = new(simulator);
        double[] heights = [];
        float[] falls = [];
        for (int i = 0; i < Updates; i++)
        {
            simulator.Update(Worlds.Dt);
            recorder.Record(Worlds.Dt);
            if (i == Checked)
            {
                heights = [.. simulator.BodyList.Select(b => b.PositionY)];
                falls = [.. simulator.BodyList.Select(b => b.LinearVelocity.Y)];
            }
        }

        await using ViewerPage page = await ViewerPage.Open(recorder);
        await page.Seek(Checked);
        int digits = await page.Ask<int>("() => farseer.recordings[0].meta.digits");
        foreach (int body in new[] { 1, 77, 2500, 5050 })
        {
            await page.Pick("body", body);
            AssertRounded(heights[body], await page.Shown("y"));
            AssertRounded(falls[body], await page.Shown("vy"));
        }

        double drawing = await Drawing(page);
        output.WriteLine(FormattableString.Invariant($"{page.FileBytes / 1e6:0.0} MB, {digits} digits, {drawing:0.0} ms a picture"));
        Assert.True(page.FileBytes <= 20_000_000, $"{page.FileBytes} bytes");
        Assert.True(await page.Ask<bool>("() => farseer.recordings[0].meta.hasContacts"));

        // What the page's own code takes for a picture; the browser of the tests has no graphics processor to paint it with.
        Assert.True(drawing < 1000.0 / 60, FormattableString.Invariant($"{drawing} ms"));
    }

    /// <summary>
    /// What a picture takes: of the fastest tenth, for other programs share the processor. Each frame of two seconds is drawn, for a
    /// page that plays leaves the more of them out the busier the processor is, and of three pictures none need be a fast one.
    /// </summary>
    private static async Task<double> Drawing(ViewerPage page)
    {
        await page.Seek(60);
        await page.Ask<bool>("() => { farseer.player.drawTimes.length = 0; return true; }");
        for (int frame = 61; frame <= 180; frame++)
        {
            await page.Seek(frame);
        }

        double[] times = await page.Ask<double[]>("() => farseer.player.drawTimes");
        await page.Seek(60);
        await page.Ask<bool>("() => { farseer.player.toggle(); return true; }");
        await page.Page.WaitForFunctionAsync("() => farseer.frame >= 120");
        await page.Page.Keyboard.PressAsync("Space");
        Assert.InRange(times.Length, 120, 1000);
        return times.Order().ElementAt(times.Length / 10);
    }

    private static void AssertRounded(double engine, string shown)
    {
        int point = shown.IndexOf('.', StringComparison.Ordinal);
        double half = 0.5 * Math.Pow(10, point < 0 ? 0 : point + 1 - shown.Length);
        double value = double.Parse(shown, CultureInfo.InvariantCulture);

        // A text of all bits has no half digit to spare, and needs none: a double that is written out reads back as itself.
        Assert.True(Math.Abs(value - engine) <= half * (1 + 1e-9), FormattableString.Invariant($"{shown} for {engine}"));
    }
}
