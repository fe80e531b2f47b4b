using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Serialization;

/// <summary>How <see cref="SceneFile"/> saves and loads.</summary>
/// <example>
/// <code>
/// SceneFile.Save(simulator, stream, new SceneFileOptions { Format = SceneFormat.Binary, ExactState = true });
/// </code>
/// </example>
public sealed class SceneFileOptions
{
    private long _mostBytes = 1 << 30;

    /// <summary>Makes options that are all at their defaults.</summary>
    public SceneFileOptions()
    {
    }

    /// <summary>In saving, what is written. Default <see cref="SceneFormat.Json"/>.</summary>
    public SceneFormat Format { get; set; }

    /// <summary>
    /// In saving, true writes besides the scene all that the simulator remembers, so that the loaded one goes on with the same bits. In
    /// loading, false leaves that part aside, and the scene begins anew from where its bodies were. Default true in loading; in saving it
    /// counts as false unless it is set.
    /// </summary>
    /// <remarks>It is for the version of the library that wrote it: one whose state has another layout refuses it by name.</remarks>
    public bool? ExactState { get; set; }

    /// <summary>In saving, the paths to be saved with the simulator, which does not know them. Default none.</summary>
    public IList<Path> Paths { get; } = new List<Path>();

    /// <summary>In saving, turns a tag or user data into text; null leaves it out. Default: strings are kept, and nothing else.</summary>
    public Func<object, string?>? TagToText { get; set; }

    /// <summary>In loading, makes a tag or user data from the text. Default: the text itself.</summary>
    public Func<string, object?>? TextToTag { get; set; }

    /// <summary>
    /// In loading a simulator, called once all objects are made and before its first update: the place to attach handlers, which no file
    /// holds. Default null.
    /// </summary>
    public Action<SceneContents>? Loaded { get; set; }

    /// <summary>In loading, the largest file that is read, bytes; at least 1. Default 2³⁰.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is below 1.</exception>
    public long MostBytes
    {
        get => _mostBytes;
        set =>
            _mostBytes = value >= 1 ? value : throw new ArgumentOutOfRangeException(nameof(MostBytes), value, "value must be at least 1.");
    }

    internal string? Text(object? tag) => tag is null ? null : TagToText is null ? tag as string : TagToText(tag);

    internal object? Tag(string text) => TextToTag is null ? text : TextToTag(text);
}
