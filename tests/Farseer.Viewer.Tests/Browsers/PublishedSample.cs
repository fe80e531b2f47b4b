using System;
using System.Collections.Generic;
using System.IO;
using System.Threading.Tasks;
using Farseer.Samples.Tests.Rendering;
using Farseer.Tests.Shared;
using Microsoft.Playwright;
using Xunit;

namespace Farseer.Viewer.Tests.Browsers;

/// <summary>
/// samples/Farseer.Browser, published once and opened in a browser. No server is needed: the browser's requests are answered from the
/// folder.
/// </summary>
public sealed class PublishedSample : IAsyncLifetime
{
    private const string Site = "https://farseer.test/";
    private static readonly TimeSpan _limit = TimeSpan.FromMinutes(6);

    private readonly string _folder = Directory.CreateTempSubdirectory("farseer-browser").FullName;
    private IPlaywright? _playwright;
    private IBrowser? _browser;

    internal IPage Page { get; private set; } = null!;

    /// <summary>Errors and warnings of the page, and files that it asked for in vain.</summary>
    internal List<string> Complaints { get; } = [];

    public async Task InitializeAsync()
    {
        if (BrowserBuildFactAttribute.ReasonToSkip is not null)
        {
            return;
        }

        (int code, string output) = Command.Dotnet(
            Clone.Root,
            ["publish", "-c", "Release", Path.Combine("samples", "Farseer.Browser"), "-o", _folder],
            new Dictionary<string, string>(),
            _limit);
        Assert.True(code == 0, output);
        _playwright = await Playwright.CreateAsync();
        _browser = await _playwright.Chromium.LaunchAsync(new BrowserTypeLaunchOptions
        {
            ExecutablePath = Browser.Program,
            Args = ["--no-sandbox", "--disable-gpu", "--force-color-profile=srgb"],
        });
        Page = await _browser.NewPageAsync(new BrowserNewPageOptions { ViewportSize = new() { Width = 800, Height = 600 } });
        Page.Console += (_, message) =>
        {
            if (message.Type is "error" or "warning")
            {
                Complaints.Add(message.Text);
            }
        };
        Page.PageError += (_, message) => Complaints.Add(message);
        await Page.RouteAsync("**/*", Answer);
        await Page.GotoAsync(Site + "index.html");
        await Page.WaitForFunctionAsync("() => window.farseer");
    }

    public async Task DisposeAsync()
    {
        if (_browser is not null)
        {
            await _browser.CloseAsync();
        }

        _playwright?.Dispose();
        Directory.Delete(_folder, recursive: true);
    }

    private Task Answer(IRoute route)
    {
        string url = route.Request.Url;
        string file = Path.Combine(_folder, "wwwroot", new Uri(url).AbsolutePath.TrimStart('/'));
        if (url.StartsWith(Site, StringComparison.Ordinal) && File.Exists(file))
        {
            return route.FulfillAsync(new RouteFulfillOptions { Path = file, ContentType = ContentType(file) });
        }

        Complaints.Add("there is no " + url);
        return route.AbortAsync();
    }

    private static string ContentType(string file) => Path.GetExtension(file) switch
    {
        ".html" => "text/html",
        ".css" => "text/css",
        ".js" => "text/javascript",
        ".wasm" => "application/wasm",
        _ => "application/octet-stream",
    };
}

/// <summary>A test that needs a browser and publishes for it: skipped, and reported so, where either cannot be.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class BrowserBuildFactAttribute : FactAttribute
{
    /// <summary>Set to a reason, the tests are skipped with it.</summary>
    private const string Unwanted = "FARSEER_NO_BROWSER_BUILD";

    public BrowserBuildFactAttribute() => Skip = ReasonToSkip!;

    internal static string? ReasonToSkip { get; } =
        Environment.GetEnvironmentVariable(Unwanted) is { Length: > 0 } reason ? reason : Browser.ReasonToSkip;
}
