using System;
using Spectre.Console;

namespace Farseer.Samples.Terminal;

/// <summary>A bar for what takes more than a second.</summary>
internal static class ProgressBar
{
    /// <summary>Does the work under a bar that goes when it is done.</summary>
    /// <param name="title">What is done.</param>
    /// <param name="whole">The bar's value at the end.</param>
    /// <param name="work">Sets the bar's value as it goes on.</param>
    public static T Show<T>(string title, double whole, Func<ProgressTask, T> work) =>
        AnsiConsole.Progress()
            .AutoClear(true)
            .Columns(new TaskDescriptionColumn(), new ProgressBarColumn(), new PercentageColumn(), new RemainingTimeColumn())
            .Start(context => work(context.AddTask(Markup.Escape(title), true, whole)));
}
