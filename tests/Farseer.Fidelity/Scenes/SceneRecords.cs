using System.Collections.Generic;
using System.Text.Json;

namespace Farseer.Fidelity.Scenes;

/// <summary>Which of the two formats a scene is written in.</summary>
public enum SceneFormat
{
    Farseer,
    Box2DFlash,
}

/// <summary>An object made by a factory: its id, the call, and the properties to set afterwards.</summary>
public sealed record MadeObject(
    string Id, string Factory, JsonElement Args, IReadOnlyList<KeyValuePair<string, JsonElement>> Properties, string? Body);

/// <summary>Something done to the scene between two updates.</summary>
public sealed record SceneAction(
    int Step, int Until, string? Target, string? Call, JsonElement Args, JsonElement Set, string? Remove, string? Dispose);

/// <summary>A question asked of the library after some updates.</summary>
public sealed record SceneQuery(
    int AfterStep, string? Target, string? Static, JsonElement Vertices, string? Call, string? Get, IReadOnlyList<JsonElement> Args)
{
    public override string ToString()
    {
        string subject =
            Static ?? (Vertices.ValueKind == JsonValueKind.Undefined ? Target + "." + (Call ?? Get) : "vertices " + Vertices + "." + Call);
        return subject + "(" + string.Join(", ", Args) + ") after " + AfterStep;
    }
}

/// <summary>One kind of event of one pair (or object), in the order of first appearance.</summary>
public sealed record SceneEvent(string Type, string First, string Second, int Count, IReadOnlyList<(int First, int Last)> Runs)
{
    public string Key => Second.Length == 0 ? Type + " " + First : Type + " " + First + ", " + Second;
}

/// <summary>The state of one body at one sample.</summary>
public readonly record struct Row(double X, double Y, double Rotation, double VelocityX, double VelocityY, double AngularVelocity)
{
    /// <summary>The body is not there.</summary>
    public static readonly Row Absent = new(double.NaN, double.NaN, double.NaN, double.NaN, double.NaN, double.NaN);

    public bool IsAbsent => double.IsNaN(X);
}

/// <summary>A largest difference for each of the four recorded quantities.</summary>
public readonly record struct Difference(double Position, double Rotation, double LinearVelocity, double AngularVelocity);

/// <summary>What the original's own model converges to, and how far its own recording is from that.</summary>
public sealed record Refined(int DtDivisor, Difference FromRecorded, IReadOnlyDictionary<string, Row[]> Rows);

/// <summary>What one run left behind: rows by body, observations, events, and answers to the queries.</summary>
public sealed record Recording(
    IReadOnlyDictionary<string, Row[]> Rows,
    IReadOnlyDictionary<string, JsonElement[]> Observed,
    IReadOnlyList<SceneEvent>? Events,
    IReadOnlyList<JsonElement> QueryResults);
