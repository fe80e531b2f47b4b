namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>What a thing is called in the page.</summary>
internal static class Label
{
    /// <summary>The name, else a tag that is a text, else null.</summary>
    public static string? Of(string? name, object? tag) => string.IsNullOrEmpty(name) ? tag as string : name;
}
