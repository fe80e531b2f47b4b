using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace Farseer.Accuracy.Truth;

/// <summary>A figure of a build, with what it is held against.</summary>
/// <param name="Name">Where it is from, the scene and the metric.</param>
/// <param name="Value">As measured.</param>
/// <param name="Limit">The largest value that is right; with <paramref name="AtLeast"/> the smallest.</param>
/// <param name="AtLeast">More is better.</param>
internal sealed record TruthFigure(string Name, double Value, double Limit, bool AtLeast)
{
    private const string Header = "name,value,limit,better";
    private const string More = "more";
    private const string Less = "less";

    public bool IsMet => Value < Runner.Exploded && (AtLeast ? Value >= Limit : Value <= Limit);

    public static void Write(TextWriter csv, IEnumerable<TruthFigure> figures)
    {
        csv.WriteLine(Header);
        foreach (TruthFigure figure in figures)
        {
            csv.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{figure.Name.Replace(',', ';')},{figure.Value:G9},{figure.Limit:G9},{(figure.AtLeast ? More : Less)}"));
        }
    }
}
