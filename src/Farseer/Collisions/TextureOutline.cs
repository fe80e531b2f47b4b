using System.Collections.Generic;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>An island of a bitmap; see <see cref="Vertices.CreateOutlines"/>. (An addition to the original.)</summary>
/// <example>
/// <code>
/// foreach (TextureOutline part in Vertices.CreateOutlines(pixels, 64, 64, Vector2.Zero, 20, 1.5f))
/// {
///     Console.WriteLine($"{part.Outline.Count} corners, {part.Holes.Count} holes");
/// }
/// </code>
/// </example>
public sealed class TextureOutline
{
    internal TextureOutline(List<Vertices> contours)
    {
        Outline = contours[0];
        contours.RemoveAt(0);
        Holes = contours;
    }

    /// <summary>The outer outline, clockwise on the screen.</summary>
    public Vertices Outline { get; }

    /// <summary>The outlines of the holes, counter-clockwise on the screen; empty if there are none.</summary>
    public IReadOnlyList<Vertices> Holes { get; }
}
