using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using Farseer.CommandLines;

namespace Farseer.Accuracy.Extremes;

/// <summary>Drives every quantity to the value at which its scene stops holding.</summary>
internal static class ExtremesCommand
{
    private static readonly Argument<string[]> _only = new("word") { Description = "words of quantities; none: all" };

    public static Command Create() => Cli.Judged(
        "extremes", "How far masses, sizes, steps and speeds can be driven until a scene stops holding.", Run, _only);

    private static bool Run(ParseResult result)
    {
        TextWriter output = result.Output();
        string[] only = result.GetValue(_only) ?? [];
        foreach (string word in only)
        {
            bool known = false;
            foreach (Extreme extreme in ExtremeRun.All)
            {
                known |= extreme.Word == word;
            }

            if (!known)
            {
                var words = new List<string>();
                foreach (Extreme extreme in ExtremeRun.All)
                {
                    words.Add(extreme.Word);
                }

                throw new UsageException($"extremes: '{word}' is none of {string.Join(", ", words)}.");
            }
        }

        output.WriteLine($"{"word",-16} {"quantity",-46} {"asked",10} {"holds to",10} {"fails at",10}  result");
        bool all = true;
        foreach (Extreme extreme in ExtremeRun.All)
        {
            if (only.Length == 0 || Array.IndexOf(only, extreme.Word) >= 0)
            {
                ExtremeResult reached = ExtremeRun.Drive(extreme);
                all &= reached.IsMet;
                output.WriteLine($"{extreme.Word,-16} {extreme.Quantity,-46} {Show(extreme.Asked),10} {Show(reached.Last),10} "
                    + $"{Show(reached.Failed),10}  {(reached.IsMet ? "holds" : "MISSED")}");
                output.Flush();
            }
        }

        return all;
    }

    /// <summary>The table as lines of Markdown.</summary>
    public static List<string> Lines()
    {
        var lines = new List<string> { "| quantity | what has to hold | asked | holds to | fails at |", "|---|---|---|---|---|" };
        foreach (Extreme extreme in ExtremeRun.All)
        {
            ExtremeResult result = ExtremeRun.Drive(extreme);
            string last = result.IsMet ? Show(result.Last) : $"**{Show(result.Last)}**";
            lines.Add($"| {extreme.Quantity} | {extreme.Criterion} | {Show(extreme.Asked)} | {last} | {Show(result.Failed)} |");
        }

        return lines;
    }

    private static string Show(double? value) => value is null ? "–" : value.Value.ToString("G3", CultureInfo.InvariantCulture);
}
