using System;

namespace Farseer.Scenes;

/// <summary>One named result of a scene, the limit it was held against, and the verdict.</summary>
public readonly record struct SceneOutcome(string Name, double Value, string Relation, double Limit, bool Ok)
{
    /// <summary>An error or a residue that must be small. NaN fails.</summary>
    public static SceneOutcome AtMost(string name, double value, double limit) => new(name, value, "<=", limit, value <= limit);

    public static SceneOutcome AtLeast(string name, double value, double limit) => new(name, value, ">=", limit, value >= limit);

    /// <summary>A count.</summary>
    public static SceneOutcome Exactly(string name, long value, long expected) => new(name, value, "=", expected, value == expected);

    /// <summary>The distance of <paramref name="value"/> from what it should be.</summary>
    public static SceneOutcome Error(string name, double value, double expected, double limit) =>
        AtMost(name, Math.Abs(value - expected), limit);
}
