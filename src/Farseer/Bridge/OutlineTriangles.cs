using System;
using System.Numerics;
using Farseer.Engine.Shapes;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Cuts an outline into triangles for drawing.</summary>
internal static class OutlineTriangles
{
    /// <param name="vertices">The outline, in either order.</param>
    /// <param name="positive">The wanted order: from the x axis towards the y axis.</param>
    /// <param name="name">What the caller calls the outline.</param>
    /// <param name="corners">Its corners in the wanted order.</param>
    /// <param name="indices">Three corners for each triangle, in the wanted order.</param>
    public static void Cut(Vector2[] vertices, bool positive, string name, out Vector2[] corners, out short[] indices)
    {
        Vertices outline = OutlineRules.Normalised(new Vertices(Require.NotNull(vertices, name)), name);
        corners = Outline.Tidy(outline.ToArray());
        if (corners.Length > short.MaxValue)
        {
            throw new ArgumentException($"The outline has {corners.Length} corners; indices of 16 bits count to {short.MaxValue}.", name);
        }

        int[][] triangles = Decomposition.Triangles(corners);
        indices = new short[3 * triangles.Length];
        for (int i = 0; i < indices.Length; i++)
        {
            int corner = triangles[i / 3][positive ? i % 3 : 2 - (i % 3)];
            indices[i] = (short)(positive ? corner : corners.Length - 1 - corner);
        }

        if (!positive)
        {
            Array.Reverse(corners);
        }
    }
}
