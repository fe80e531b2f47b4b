using System;
using System.Collections.Generic;
using System.IO;
using System.Security.Cryptography;
using System.Text;
using System.Text.Json;
using System.Text.Json.Serialization;
using Farseer.CommandLines;
using Farseer.Scenes;

namespace Farseer.Samples.Sweeping;

/// <summary>One run of a sweep.</summary>
internal readonly record struct SweepItem(int Index, string Scene, int Iterations, float Dt, int Seed);

/// <summary>
/// What a sweep is to run: every combination of scenes, iterations, time steps and seeds. Its hash is that of what it says, not of how the
/// file is written.
/// </summary>
internal sealed record SweepSpecification
{
    private static readonly JsonSerializerOptions _strict = new()
    {
        PropertyNameCaseInsensitive = true,
        UnmappedMemberHandling = JsonUnmappedMemberHandling.Disallow,
    };

    /// <summary>Names of scenes of the library.</summary>
    public string[] Scenes { get; init; } = [];

    public int[] Iterations { get; init; } = [5];

    /// <summary>Seconds an update; 0: the scene's own.</summary>
    public float[] Dt { get; init; } = [0];

    /// <summary>Updates of each run; 0: the scene's own number.</summary>
    public int Steps { get; init; }

    /// <summary>
    /// How many seeds, from 0 on. Seed 0 is the scene as it is; others move each body by up to <see cref="Jitter"/> in either direction.
    /// </summary>
    public int Seeds { get; init; } = 1;

    public float Jitter { get; init; }

    [JsonIgnore]
    public int Count => Scenes.Length * Iterations.Length * Dt.Length * Seeds;

    [JsonIgnore]
    public string Hash => Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(JsonSerializer.Serialize(this))))[..16];

    public static SweepSpecification Load(string path)
    {
        try
        {
            SweepSpecification read = JsonSerializer.Deserialize<SweepSpecification>(File.ReadAllText(path), _strict)
                ?? throw new UsageException($"{path}: it is empty");
            read.Check(path);
            return read;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or JsonException)
        {
            throw new UsageException($"{path}: {e.Message.ReplaceLineEndings(" ")}");
        }
    }

    /// <summary>All runs, in the order of their numbers.</summary>
    public IEnumerable<SweepItem> Items()
    {
        int index = 0;
        foreach (string scene in Scenes)
        {
            foreach (int iterations in Iterations)
            {
                foreach (float dt in Dt)
                {
                    for (int seed = 0; seed < Seeds; seed++)
                    {
                        yield return new SweepItem(index++, scene, iterations, dt, seed);
                    }
                }
            }
        }
    }

    private void Check(string path)
    {
        foreach (string scene in Scenes)
        {
            Require(SceneLibrary.Find(scene) is not null, $"there is no scene '{scene}'");
        }

        Require(Count > 0, "it has no runs: give scenes, iterations, dt and seeds");
        Require(Array.TrueForAll(Iterations, i => i >= 1), "iterations must be at least 1");
        Require(Array.TrueForAll(Dt, dt => dt >= 0 && float.IsFinite(dt)), "dt must be seconds, or 0 for the scene's own");
        Require(Steps >= 0 && Seeds >= 1 && Jitter >= 0 && float.IsFinite(Jitter), "steps, seeds and jitter must not be negative");

        void Require(bool holds, string rule)
        {
            if (!holds)
            {
                throw new UsageException($"{path}: {rule}");
            }
        }
    }
}
