using System;
using System.Collections.Generic;
using System.IO;
using System.Text.Json;
using System.Text.Json.Serialization;
using Farseer.CommandLines;

namespace Farseer.Samples.Sweeping;

/// <summary>The result of one run, a line of a shard's file.</summary>
internal sealed record SweepRow
{
    private static readonly JsonSerializerOptions _lines = new()
    {
        PropertyNamingPolicy = JsonNamingPolicy.CamelCase,
        UnmappedMemberHandling = JsonUnmappedMemberHandling.Disallow,
    };

    /// <summary>Hash of the specification.</summary>
    public required string Specification { get; init; }

    /// <summary>Version of the library, with the commit where the build knows it.</summary>
    public required string Version { get; init; }

    /// <summary>Number of the shard, from 0, and of how many.</summary>
    public required int Shard { get; init; }

    public required int Shards { get; init; }

    /// <summary>Number of the run, from 0, and of how many.</summary>
    public required int Index { get; init; }

    public required int Of { get; init; }

    public required string Scene { get; init; }

    public required int Iterations { get; init; }

    public required float Dt { get; init; }

    public required int Seed { get; init; }

    public required int Steps { get; init; }

    /// <summary>Hash of places and velocities after the last update.</summary>
    public required string State { get; init; }

    public required int Contacts { get; init; }

    public required float LargestPenetration { get; init; }

    public string ToLine() => JsonSerializer.Serialize(this, _lines);

    /// <summary>The rows of a file. A last line that somebody was about to write is left out.</summary>
    /// <param name="path">The file.</param>
    /// <param name="wholeBytes">Bytes of the lines that are whole.</param>
    public static List<SweepRow> Read(string path, out long wholeBytes)
    {
        var rows = new List<SweepRow>();
        wholeBytes = 0;
        byte[] bytes;
        try
        {
            bytes = File.ReadAllBytes(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new UsageException($"{path}: {e.Message.ReplaceLineEndings(" ")}");
        }

        for (int end = Array.IndexOf(bytes, (byte)'\n'); end >= 0; end = Array.IndexOf(bytes, (byte)'\n', (int)wholeBytes))
        {
            try
            {
                rows.Add(JsonSerializer.Deserialize<SweepRow>(bytes.AsSpan((int)wholeBytes, end - (int)wholeBytes), _lines)!);
            }
            catch (JsonException e)
            {
                throw new UsageException($"{path}, line {rows.Count + 1}: {e.Message.ReplaceLineEndings(" ")}");
            }

            wholeBytes = end + 1;
        }

        return rows;
    }
}
