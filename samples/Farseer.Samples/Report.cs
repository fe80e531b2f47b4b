using System;
using System.Buffers;
using System.Globalization;
using System.IO;
using System.Text;
using System.Text.Json;
using Farseer.Scenes;
using Spectre.Console;

namespace Farseer.Samples;

/// <summary>Writes the result of a run: tables for people, one JSON object for programs.</summary>
internal static class Report
{
    public static void Tables(RunResult result)
    {
        Table table = Grid();
        table.Title = new TableTitle(Markup.Escape(result.Title));
        table.AddColumn("Result");
        table.AddColumn(new TableColumn("Value").RightAligned());
        Row(table, "steps", Invariant($"{result.Steps} of {result.Dt * 1000f:0.###} ms"));
        Row(table, "iterations", Invariant($"{result.Iterations}"));
        Row(table, "time a step", Invariant($"{result.MicrosecondsPerStep:0.0} us"));
        Row(table, "bodies", Invariant($"{result.Bodies}"));
        Row(table, "contacts", Invariant($"{result.Contacts}"));
        Row(table, "largest penetration", Number(result.LargestPenetration));
        Row(table, "energy", Number(result.Energy));
        Row(table, "bytes a step", Invariant($"{result.BytesPerStep:0.#}"));
        Row(table, "state hash", Invariant($"{result.StateHash:x16}"));
        AnsiConsole.Write(table);
        if (result.Outcomes.Count > 0)
        {
            AnsiConsole.Write(Outcomes(result));
        }
    }

    public static Table Outcomes(RunResult result)
    {
        Table table = Grid();
        table.AddColumn("Check");
        table.AddColumn(new TableColumn("Value").RightAligned().NoWrap());
        table.AddColumn(new TableColumn("Limit").RightAligned().NoWrap());
        table.AddColumn(string.Empty);
        foreach (SceneOutcome outcome in result.Outcomes)
        {
            table.AddRow(
                Markup.Escape(outcome.Name),
                Number(outcome.Value),
                Markup.Escape(outcome.Relation + " " + Number(outcome.Limit)),
                Verdict(outcome.Ok));
        }

        return table;
    }

    public static string Verdict(bool ok) => ok ? "[green]ok[/]" : "[red]FAIL[/]";

    public static Table Grid() => new Table().Border(TableBorder.Rounded).BorderColor(Color.Grey);

    /// <summary>Four figures, whatever the size.</summary>
    public static string Number(double value) => value.ToString("0.###", CultureInfo.InvariantCulture) is string plain
        && (value == 0.0 || (Math.Abs(value) >= 0.1 && Math.Abs(value) < 1e6))
        ? plain
        : value.ToString("0.###e+0", CultureInfo.InvariantCulture);

    public static void Json(RunResult result, Stream output)
    {
        ArrayBufferWriter<byte> buffer = new();
        using (Utf8JsonWriter writer = new(buffer, new JsonWriterOptions { Indented = true }))
        {
            writer.WriteStartObject();
            writer.WriteString("scene", result.Scene);
            writer.WriteNumber("steps", result.Steps);
            writer.WriteNumber("dt", result.Dt);
            writer.WriteNumber("iterations", result.Iterations);
            Number(writer, "microsecondsPerStep", result.MicrosecondsPerStep);
            writer.WriteNumber("bodies", result.Bodies);
            writer.WriteNumber("geoms", result.Geoms);
            writer.WriteNumber("contacts", result.Contacts);
            Number(writer, "largestPenetration", result.LargestPenetration);
            Number(writer, "energy", result.Energy);
            Number(writer, "bytesPerStep", result.BytesPerStep);
            writer.WriteString("stateHash", Invariant($"{result.StateHash:x16}"));
            writer.WriteBoolean("ok", result.AllOk);
            writer.WriteStartArray("checks");
            foreach (SceneOutcome outcome in result.Outcomes)
            {
                writer.WriteStartObject();
                writer.WriteString("name", outcome.Name);
                Number(writer, "value", outcome.Value);
                writer.WriteString("relation", outcome.Relation);
                Number(writer, "limit", outcome.Limit);
                writer.WriteBoolean("ok", outcome.Ok);
                writer.WriteEndObject();
            }

            writer.WriteEndArray();
            writer.WriteEndObject();
        }

        output.Write(buffer.WrittenSpan);
        output.Write(Encoding.UTF8.GetBytes(Environment.NewLine));
    }

    private static void Row(Table table, string name, string value) => table.AddRow(name, Markup.Escape(value));

    private static string Invariant(FormattableString text) => FormattableString.Invariant(text);

    private static void Number(Utf8JsonWriter writer, string name, double value)
    {
        // JSON has no NaN or infinity.
        if (double.IsFinite(value))
        {
            writer.WriteNumber(name, value);
        }
        else
        {
            writer.WriteNull(name);
        }
    }
}
