using System;
using Farseer.Samples.Terminal;
using Spectre.Console.Testing;
using Xunit;

namespace Farseer.Samples.Tests;

/// <summary>The menu by key, on a terminal that is none.</summary>
public sealed class MenuTests : IDisposable
{
    private readonly TestConsole _console = new TestConsole().Width(100).Height(40).Interactive().EmitAnsiSequences();

    public void Dispose() => _console.Dispose();

    [Theory]
    [InlineData(ConsoleKey.Escape)]
    [InlineData(ConsoleKey.Q)]
    public void Menu_LeavingKey_EndsAndHasShownNumberedScenes(ConsoleKey key)
    {
        Push(key, key == ConsoleKey.Q ? 'q' : '\e');

        Assert.Equal(0, Menu.Show(_console));
        Assert.Contains(" 1  Falling stack", _console.Output, StringComparison.Ordinal);
        Assert.Contains("falling-stack", _console.Output, StringComparison.Ordinal);
    }

    [Fact]
    public void Menu_NumberTyped_FindsTheScene()
    {
        _console.Input.PushText("newtons-line");
        _console.Input.PushKey(ConsoleKey.Enter);
        Push(ConsoleKey.Q, 'q');
        Push(ConsoleKey.Q, 'q');

        Assert.Equal(0, Menu.Show(_console));
        Assert.Contains("What now?", _console.Output, StringComparison.Ordinal);
        Assert.Contains("Watch it live", _console.Output, StringComparison.Ordinal);
    }

    [Fact]
    public void Menu_QWithinAWord_IsSearchedFor()
    {
        _console.Input.PushText("zq");
        Push(ConsoleKey.Escape, '\e');

        Menu.Show(_console);
        Assert.False(_console.Input.IsKeyAvailable(), "q left the menu before the word was at its end.");
    }

    [Theory]
    [InlineData("[<0;12;5M", 0, 11, 4)]
    [InlineData("[<32;1;1M", 1, 0, 0)]
    [InlineData("[<0;300;99m", 2, 299, 98)]
    public void MouseEvent_Report_IsRead(string report, int action, int column, int row)
    {
        int at = 0;

        MouseEvent? mouse = MouseEvent.Read(() => at < report.Length ? report[at++] : null);

        Assert.Equal(new MouseEvent((MouseAction)action, column, row), mouse);
    }

    [Theory]
    [InlineData("[<2;12;5M")]
    [InlineData("[<0;12M")]
    [InlineData("[A")]
    [InlineData("")]
    [InlineData("[<0;x;5M")]
    public void MouseEvent_OtherReport_IsNone(string report)
    {
        int at = 0;

        Assert.Null(MouseEvent.Read(() => at < report.Length ? report[at++] : null));
    }

    private void Push(ConsoleKey key, char character) =>
        _console.Input.PushKey(new ConsoleKeyInfo(character, key, false, false, false));
}
