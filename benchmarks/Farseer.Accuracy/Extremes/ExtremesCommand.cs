using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace Farseer.Accuracy.Extremes;

/// <summary>Drives every quantity to the value at which its scene stops holding.</summary>
internal static class ExtremesCommand
{
    /// <summary>Prints the table; true if all holds as far as it has to.</summary>
    /// <param name="only">Words of the quantities; empty for all.</param>
    /// <param name="output">Where the table goes.</param>
    public static bool Run(string[] only, TextWriter output)
    {
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
                ExtremeResult result = ExtremeRun.Drive(extreme);
                all &= result.IsMet;
                output.WriteLine($"{extreme.Word,-16} {extreme.Quantity,-46} {Show(extreme.Asked),10} {Show(result.Last),10} {Show(result.Failed),10}  {(result.IsMet ? "holds" : "MISSED")}");
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
