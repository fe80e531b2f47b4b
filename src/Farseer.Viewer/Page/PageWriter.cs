using System;
using System.Globalization;
using System.IO;
using System.Text;

namespace FarseerGames.FarseerPhysics.Viewer.Page;

/// <summary>Joins the sources of the page and the recordings into one file.</summary>
internal static class PageWriter
{
    private static readonly string[] _styles = { "colors.css", "layout.css", "panels.css" };

    // In the order in which they build on one another.
    private static readonly string[] _scripts =
    {
        "numbers.js", "blocks.js", "recording.js", "camera.js", "islands.js", "contacts.js", "painter.js", "stage.js", "plots.js",
            "series.js", "timeline.js",
        "inspector.js", "report.js", "search.js", "player.js", "input.js", "main.js",
    };

    public static void Write(TextWriter writer, RunRecorder first, RunRecorder? second, RunDifference? difference)
    {
        string page = Source("page.html");
        int at = 0;
        foreach ((int start, int length, string mark) in Marks(page))
        {
            writer.Write(page.Substring(at, start - at));
            at = start + length;
            switch (mark)
            {
                case "title":
                    writer.Write(Escape(first.Options.Title));
                    break;
                case "styles":
                    Join(writer, _styles);
                    break;
                case "scripts":
                    Join(writer, _scripts);
                    break;
                default:
                    WriteData(writer, first, second, difference);
                    break;
            }
        }

        writer.Write(page.Substring(at));
    }

    private static void WriteData(TextWriter writer, RunRecorder first, RunRecorder? second, RunDifference? difference)
    {
        Run(writer, first, 0);
        if (second is not null)
        {
            Run(writer, second, 1);
            JsonText json = new JsonText();
            json.Open('{').Name("same").Value(difference is null);
            if (difference is not null)
            {
                json.Name("frame").Value(difference.Frame).Name("subject").Value(difference.Subject).Name("index").Value(difference.Index);
                json.Name("name").Value(difference.Name).Name("field").Value(difference.Field);
                json.Name("first").Value(Text(difference.First)).Name("second").Value(Text(difference.Second));
                json.Name("firstBits").Value(Bits(difference.First)).Name("secondBits").Value(Bits(difference.Second));
            }

            json.Close('}');
            Element(writer, "application/json", "difference", w => w.Write(json.ToString()));
        }
    }

    private static string Text(double value) => value.ToString("R", CultureInfo.InvariantCulture);

    private static string Bits(double value) => BitConverter.DoubleToInt64Bits(value).ToString("x16", CultureInfo.InvariantCulture);

    private static void Run(TextWriter writer, RunRecorder recorder, int number)
    {
        RunText text = new RunText(recorder);
        string name = number.ToString(CultureInfo.InvariantCulture);
        Element(writer, "application/json", "run-" + name, w => w.Write(text.Json.ToString()));
        Element(writer, "text/plain", "data-" + name, text.WriteBlocks);
    }

    private static void Element(TextWriter writer, string type, string id, Action<TextWriter> content)
    {
        writer.Write("<script type=\"" + type + "\" id=\"" + id + "\">");
        content(writer);
        writer.Write("</script>\n");
    }

    private static void Join(TextWriter writer, string[] names)
    {
        foreach (string name in names)
        {
            writer.Write(Source(name));
        }
    }

    private static System.Collections.Generic.IEnumerable<(int Start, int Length, string Mark)> Marks(string page)
    {
        const string Open = "<!--{";
        const string Close = "}-->";
        for (int at = page.IndexOf(Open, StringComparison.Ordinal); at >= 0; at = page.IndexOf(Open, at + 1, StringComparison.Ordinal))
        {
            int end = page.IndexOf(Close, at, StringComparison.Ordinal);
            yield return (at, end + Close.Length - at, page.Substring(at + Open.Length, end - at - Open.Length));
        }
    }

    private static string Escape(string text) => text.Replace("&", "&amp;").Replace("<", "&lt;").Replace(">", "&gt;");

    private static string Source(string name)
    {
        using Stream stream = typeof(PageWriter).Assembly.GetManifestResourceStream("Web/" + name)
            ?? throw new InvalidOperationException("The page has no part " + name + ".");
        using StreamReader reader = new StreamReader(stream, Encoding.UTF8);
        return reader.ReadToEnd();
    }
}
