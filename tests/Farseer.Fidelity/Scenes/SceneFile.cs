using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Flash;

namespace Farseer.Fidelity.Scenes;

/// <summary>One scene file, read whole: how to build and step it, and what the original did with it.</summary>
public sealed class SceneFile
{
    internal SceneFile(string path, JsonElement root)
    {
        Path = path;
        Root = root;
    }

    public string Path { get; }

    public JsonElement Root { get; }

    public string Name { get; internal init; } = string.Empty;

    public string Category { get; internal init; } = string.Empty;

    /// <summary>Which library the scene was recorded with, and so which one is to be compared.</summary>
    public SceneFormat Format { get; internal init; }

    /// <summary>Depth at which a contact rests in the library: AllowedPenetration or the linear slop.</summary>
    public double RestDepth { get; internal init; }

    public string? Quirk { get; internal init; }

    public JsonElement Gravity { get; internal init; }

    public float Dt { get; internal init; }

    /// <summary>The longest step that is taken; <see cref="Dt"/> unless an action changes it.</summary>
    public float LongestDt { get; internal init; }

    public int Steps { get; internal init; }

    public int[] Iterations { get; internal init; } = [];

    public int[] SampleSteps { get; internal init; } = [];

    public IReadOnlyList<MadeObject> Bodies { get; internal init; } = [];

    public IReadOnlyList<MadeObject> Geoms { get; internal init; } = [];

    public IReadOnlyList<MadeObject> Joints { get; internal init; } = [];

    public IReadOnlyList<MadeObject> Springs { get; internal init; } = [];

    public IReadOnlyList<SceneAction> Actions { get; internal init; } = [];

    public IReadOnlyList<SceneQuery> Queries { get; internal init; } = [];

    public IReadOnlyList<string> Observe { get; internal init; } = [];

    public Difference? Spread { get; internal init; }

    /// <summary>By how much a tiny displacement of the start grows; at least 1.</summary>
    public double Growth { get; internal init; } = 1;

    public Refined? Refined { get; internal init; }

    /// <summary>By iteration count.</summary>
    public IReadOnlyDictionary<int, Recording> Recordings { get; internal init; } = new Dictionary<int, Recording>();

    /// <summary>Reads every scene of a folder, in the order of their names.</summary>
    public static IReadOnlyList<SceneFile> ReadFolder(string folder)
    {
        if (!Directory.Exists(folder))
        {
            throw new BadSceneException($"There is no folder '{folder}'.");
        }

        string[] paths = Directory.GetFiles(folder, "*.json");
        if (paths.Length == 0)
        {
            throw new BadSceneException($"The folder '{folder}' has no scene file (*.json).");
        }

        Array.Sort(paths, StringComparer.Ordinal);
        return paths.Select(Read).ToList();
    }

    public static SceneFile Read(string path)
    {
        try
        {
            using FileStream stream = File.OpenRead(path);
            using JsonDocument document = JsonDocument.Parse(stream);
            JsonElement root = document.RootElement.Clone();
            return FlashReader.IsFlash(root) ? FlashReader.Parse(path, root) : Parse(path, root);
        }
        catch (Exception e) when (e is JsonException or InvalidOperationException or FormatException or KeyNotFoundException or IOException
            or UnauthorizedAccessException)
        {
            throw new BadSceneException($"{System.IO.Path.GetFileName(path)}: {e.Message.ReplaceLineEndings(" ")}");
        }
        catch (BadSceneException e)
        {
            throw new BadSceneException($"{System.IO.Path.GetFileName(path)}: {e.Message}");
        }
    }

    private static double RestDepthOf(JsonElement root)
    {
        const double Default = 0.05;
        JsonElement value = Json.Optional(Json.Optional(root, "settings"), "allowedPenetration");
        return value.ValueKind == JsonValueKind.Number ? value.GetDouble() : Default;
    }

    private static SceneFile Parse(string path, JsonElement root)
    {
        if (root.ValueKind != JsonValueKind.Object)
        {
            throw new BadSceneException("a scene is a JSON object.");
        }

        int steps = Json.Required(root, "steps").GetInt32();
        float dt = Json.Required(root, "dt").GetSingle();
        if (steps < 0 || !float.IsFinite(dt) || dt <= 0)
        {
            throw new BadSceneException($"steps {steps} and dt {dt} must be at least 0 and above 0.");
        }

        int[] sampleSteps = Json.Items(root, "sampleSteps").Select(e => e.GetInt32()).ToArray();
        int[] iterations = Json.Items(root, "iterations").Select(e => e.GetInt32()).ToArray();
        if (iterations.Length == 0)
        {
            throw new BadSceneException("'iterations' is missing or empty.");
        }

        JsonElement gravity = Json.Required(root, "gravity");
        if (gravity.ValueKind != JsonValueKind.Array
            || gravity.GetArrayLength() != 2
            || gravity.EnumerateArray().Any(e => e.ValueKind != JsonValueKind.Number))
        {
            throw new BadSceneException($"'gravity' must be two numbers, not {gravity}.");
        }

        JsonElement spread = Json.Optional(root, "spread");
        JsonElement between = Json.Optional(spread, "between5And100Iterations");
        JsonElement perturbed = Json.Optional(spread, "underTinyPerturbation");
        return new SceneFile(path, root)
        {
            Name = Json.Text(root, "name"),
            Category = Json.Text(root, "category"),
            Quirk = Json.OptionalText(root, "quirk"),
            Format = SceneFormat.Farseer,
            RestDepth = RestDepthOf(root),
            Gravity = gravity,
            Dt = dt,
            LongestDt = dt,
            Steps = steps,
            Iterations = iterations,
            SampleSteps = sampleSteps,
            Bodies = Json.Items(root, "bodies").Select(SceneParts.ReadObject).ToList(),
            Geoms = Json.Items(root, "geoms").Select(SceneParts.ReadObject).ToList(),
            Joints = Json.Items(root, "joints").Select(SceneParts.ReadObject).ToList(),
            Springs = Json.Items(root, "springs").Select(SceneParts.ReadObject).ToList(),
            Actions = Json.Items(root, "actions").Select(SceneParts.ReadAction).ToList(),
            Queries = Json.Items(root, "queries").Select(SceneParts.ReadQuery).ToList(),
            Observe = Json.Items(root, "observe").Select(e => e.GetString()!).ToList(),
            Spread = between.ValueKind == JsonValueKind.Object ? SceneParts.ReadDifference(between) : null,
            Growth = perturbed.ValueKind == JsonValueKind.Object ? SceneParts.ReadGrowth(perturbed) : 1,
            Refined = SceneParts.ReadRefined(Json.Optional(root, "refined"), sampleSteps.Length),
            Recordings = iterations.ToDictionary(n => n, n => SceneParts.ReadRecording(root, n, sampleSteps.Length)),
        };
    }
}
