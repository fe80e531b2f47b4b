using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;
using Farseer.Accuracy.Sweeping;

namespace Farseer.Accuracy.Reporting;

/// <summary>What one line of a plot joins.</summary>
/// <param name="Name">In the legend.</param>
/// <param name="Color">Of middle brightness, so that it shows on light and on dark.</param>
/// <param name="Points">Errors as shares of failure.</param>
/// <param name="DefaultDial">Of the setting at 1/60 s that has a ring about it.</param>
internal sealed record PlotSeries(string Name, string Color, IReadOnlyList<SweepPoint> Points, int DefaultDial);

/// <summary>
/// Error against cost as an SVG picture. Both axes are logarithmic; a line joins the settings that no other of the same series beats.
/// Ground, text and frame take the colours of a light or a dark page, and the ground is the picture's own: a page whose colours are not
/// those that the system prefers does not make it unreadable.
/// </summary>
internal static class SvgPlot
{
    private const double Width = 640;
    private const double Height = 380;
    private const double Left = 70;
    private const double Right = 20;
    private const double Top = 56;
    private const double Bottom = 48;

    private static readonly (string Engine, string Color, int DefaultDial)[] _engines =
    [
        (SweepPoint.Own, "#e8590c", Options.DefaultIterations), ("Box2D.NET", "#4c7fd6", 4), ("Box2D.NET(stiff)", "#8a70d8", 4),
        ("Aether", "#2f9e62", 8), ("Farseer2.0.1", "#a0862a", 5),
    ];

    /// <summary>A scene of the sweep, a line for each engine.</summary>
    public static string Draw(SweepScene scene, IReadOnlyList<SweepPoint> points)
    {
        var series = new List<PlotSeries>();
        foreach ((string engine, string color, int dial) in _engines)
        {
            List<SweepPoint> own = SweepTables.Of(points, engine, scene.Scene, SweepKind.Dial);
            if (own.Count > 0)
            {
                series.Add(new PlotSeries(engine, color, own, dial));
            }
        }

        return Draw(scene.Title, series);
    }

    /// <summary>Any lines, in the order of the legend.</summary>
    public static string Draw(string title, IReadOnlyList<PlotSeries> lines)
    {
        (double lowX, double highX, double lowY) = Bounds(lines);
        var svg = new StringBuilder();
        svg.Append(Invariant($"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {Width} {Height}\" "));
        svg.Append(Invariant($"width=\"{Width}\" height=\"{Height}\" role=\"img\">\n"));
        svg.Append(Invariant($"<title>{title}, error against cost; rings: the default settings</title>\n"));
        svg.Append("<style>text{font:12px system-ui,sans-serif;fill:#333}.b{fill:#fff}.h{font-size:14px;font-weight:600}");
        svg.Append(".g{stroke:#888;stroke-opacity:.35}@media(prefers-color-scheme:dark){text{fill:#ddd}.b{fill:#161b22}}</style>\n");
        svg.Append(Invariant($"<rect class=\"b\" width=\"{Width}\" height=\"{Height}\" rx=\"6\"/>\n"));
        svg.Append(Invariant($"<text class=\"h\" x=\"{Left}\" y=\"20\">{title}</text>\n"));
        Axes(svg, lowX, highX, lowY);
        double legend = Left;
        foreach (PlotSeries line in lines)
        {
            svg.Append(Invariant($"<circle cx=\"{legend + 5}\" cy=\"38\" r=\"4\" fill=\"{line.Color}\"/>"));
            svg.Append(Invariant($"<text x=\"{legend + 13}\" y=\"42\">{line.Name}</text>\n"));
            legend += 30 + (7.0 * line.Name.Length);
            Series(svg, line, lowX, highX, lowY);
        }

        svg.Append("</svg>\n");
        return svg.ToString();
    }

    private static void Series(StringBuilder svg, PlotSeries series, double lowX, double highX, double lowY)
    {
        string color = series.Color;
        var line = new StringBuilder();
        foreach (SweepPoint point in Pareto.Front(series.Points))
        {
            line.Append(Invariant($"{X(point, lowX, highX):F1},{Y(point, lowY):F1} "));
        }

        svg.Append(Invariant($"<polyline fill=\"none\" stroke=\"{color}\" stroke-width=\"2\" points=\"{line.ToString().TrimEnd()}\"/>\n"));
        foreach (SweepPoint point in series.Points)
        {
            double x = X(point, lowX, highX);
            double y = Y(point, lowY);
            svg.Append(point.Failed
                ? Invariant($"<path stroke=\"{color}\" stroke-width=\"1.5\" d=\"M{x - 4:F1} {y - 4:F1}l8 8m0 -8l-8 8\"/>\n")
                : Invariant($"<circle cx=\"{x:F1}\" cy=\"{y:F1}\" r=\"3\" fill=\"{color}\"/>\n"));
            if (point.Dial == series.DefaultDial && Math.Abs(point.Dt - Options.DefaultDt) < 1e-6)
            {
                svg.Append(Invariant($"<circle fill=\"none\" stroke=\"{color}\" stroke-width=\"2\" "));
                svg.Append(Invariant($"cx=\"{x:F1}\" cy=\"{y:F1}\" r=\"7\"/>\n"));
            }
        }
    }

    private static void Axes(StringBuilder svg, double lowX, double highX, double lowY)
    {
        for (double power = lowX; power <= highX; power++)
        {
            double x = Place(power, lowX, highX, Left, Width - Right);
            svg.Append(Invariant($"<line class=\"g\" x1=\"{x:F1}\" y1=\"{Top}\" x2=\"{x:F1}\" y2=\"{Height - Bottom}\"/>"));
            svg.Append(Invariant($"<text x=\"{x:F1}\" y=\"{Height - Bottom + 18}\" text-anchor=\"middle\">{Power(power)}</text>\n"));
        }

        double every = lowY < -8 ? 2 : 1;
        for (double power = 0; power >= lowY; power -= every)
        {
            double y = Place(power, 0, lowY, Top, Height - Bottom);
            svg.Append(Invariant($"<line class=\"g\" x1=\"{Left}\" y1=\"{y:F1}\" x2=\"{Width - Right}\" y2=\"{y:F1}\"/>"));
            svg.Append(Invariant($"<text x=\"{Left - 8}\" y=\"{y + 4:F1}\" text-anchor=\"end\">{Power(power)}</text>\n"));
        }

        svg.Append(Invariant($"<text x=\"{(Left + Width
            - Right) / 2}\" y=\"{Height - 10}\" text-anchor=\"middle\">ns a body and 1/60 s of simulated time</text>\n"));
        svg.Append(Invariant($"<text transform=\"translate(16 {(Top + Height
            - Bottom) / 2}) rotate(-90)\" text-anchor=\"middle\">error, share of failure</text>\n"));
    }

    private static (double LowX, double HighX, double LowY) Bounds(IReadOnlyList<PlotSeries> lines)
    {
        double lowX = double.MaxValue;
        double highX = double.MinValue;
        double lowY = 0;
        foreach (PlotSeries line in lines)
        {
            foreach (SweepPoint point in line.Points)
            {
                double cost = Math.Log10(point.Cost);
                lowX = Math.Min(lowX, cost);
                highX = Math.Max(highX, cost);
                lowY = Math.Min(lowY, Math.Log10(Math.Max(point.Error, 1e-14)));
            }
        }

        return (Math.Floor(lowX), Math.Ceiling(highX), Math.Floor(lowY));
    }

    private static double X(SweepPoint point, double low, double high) => Place(Math.Log10(point.Cost), low, high, Left, Width - Right);

    private static double Y(SweepPoint point, double low) =>
        Place(Math.Log10(Math.Max(point.Error, 1e-14)), 0, low, Top, Height - Bottom);

    private static double Place(double value, double from, double to, double start, double end) =>
        start + ((value - from) / (to - from) * (end - start));

    private static string Power(double power) => power is >= 0 and <= 4
        ? Math.Pow(10, power).ToString("N0", CultureInfo.InvariantCulture)
        : Invariant($"1e{power:F0}");

    private static string Invariant(FormattableString text) => FormattableString.Invariant(text);
}
