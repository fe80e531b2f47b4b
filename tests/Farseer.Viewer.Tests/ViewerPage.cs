using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Farseer.Samples.Tests.Rendering;
using FarseerGames.FarseerPhysics.Viewer;
using Microsoft.Playwright;
using Xunit;

namespace Farseer.Viewer.Tests;

/// <summary>A page in a browser. Closing it asks that it told no error and asked for nothing but itself.</summary>
internal sealed class ViewerPage : IAsyncDisposable
{
    private readonly List<string> _complaints = [];
    private readonly List<string> _requests = [];
    private readonly string _folder = Directory.CreateTempSubdirectory("farseer-viewer").FullName;
    private IPlaywright? _playwright;
    private IBrowser? _browser;

    private ViewerPage()
    {
    }

    public IPage Page { get; private set; } = null!;

    public long FileBytes { get; private set; }

    public static async Task<ViewerPage> Open(RunRecorder run, RunRecorder? beside = null, int width = 1280, int height = 800,
        ColorScheme scheme = ColorScheme.Light)
    {
        ViewerPage page = new();
        string file = Path.Combine(page._folder, "run.html");
        if (beside is null)
        {
            run.Save(file);
        }
        else
        {
            run.Save(file, beside);
        }

        page.FileBytes = new FileInfo(file).Length;
        await page.Start(file, width, height, scheme);
        return page;
    }

    public Task<T> Ask<T>(string script) => Page.EvaluateAsync<T>(script);

    /// <summary>Waits until the frame is drawn and its numbers are told.</summary>
    public async Task Seek(int frame)
    {
        await Page.EvaluateAsync("frame => farseer.seek(frame)", frame);
        await Page.WaitForFunctionAsync("frame => farseer.isDrawn && !farseer.needsDrawing && farseer.frame === frame", frame);
    }

    public async Task Pick(string type, int index)
    {
        await Page.EvaluateAsync("thing => farseer.pick(thing)", new { type, index });
        await Page.WaitForFunctionAsync("() => document.getElementById('values')?.dataset.frame === String(farseer.frame)");
    }

    public async Task<string> Shown(string key, int column = 0)
    {
        await Page.WaitForFunctionAsync("() => document.getElementById('values').dataset.frame === String(farseer.frame)");
        return await Page.Locator($"#values td[data-key={key}]").Nth(column).InnerTextAsync();
    }

    public async Task<PngPicture> Picture()
    {
        string file = Path.Combine(_folder, "picture.png");
        await Page.Locator(".stage canvas").First.ScreenshotAsync(new LocatorScreenshotOptions { Path = file });
        return PngPicture.Load(file);
    }

    public async ValueTask DisposeAsync()
    {
        if (_browser is not null)
        {
            await _browser.CloseAsync();
        }

        _playwright?.Dispose();
        Directory.Delete(_folder, recursive: true);
        Assert.Empty(_complaints);
        Assert.Single(_requests);
    }

    private async Task Start(string file, int width, int height, ColorScheme scheme)
    {
        _playwright = await Playwright.CreateAsync();
        _browser = await _playwright.Chromium.LaunchAsync(new BrowserTypeLaunchOptions
        {
            ExecutablePath = Browser.Program,
            Args = ["--no-sandbox", "--disable-gpu", "--force-color-profile=srgb"],
        });
        Page = await _browser.NewPageAsync(new BrowserNewPageOptions
        {
            ViewportSize = new() { Width = width, Height = height },
            ColorScheme = scheme,
            HasTouch = width < 500,
        });

        // A page that hangs fails all the same; one whose processor is shared with other tests may be late.
        Page.SetDefaultTimeout(120_000);
        Page.Console += (_, message) =>
        {
            if (message.Type is "error" or "warning")
            {
                _complaints.Add(message.Text);
            }
        };
        Page.PageError += (_, message) => _complaints.Add(message);
        Page.Request += (_, request) => _requests.Add(request.Url);
        await Page.GotoAsync(new Uri(file).AbsoluteUri);
        await Page.EvaluateAsync("() => farseer.opened");
        await Page.WaitForFunctionAsync("() => farseer.isDrawn");
    }
}
