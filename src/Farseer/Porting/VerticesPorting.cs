using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Porting;

/// <summary>
/// Members of <see cref="Vertices"/> that neighbouring versions of the original have. In reach after
/// <c>using FarseerGames.FarseerPhysics.Porting;</c>, which the build property <c>FarseerPortingAliases</c> adds (see docs/Porting.md).
/// They call for C# 14.
/// </summary>
/// <example>
/// <code>
/// Vector2[] outline = { new Vector2(0, 0), new Vector2(2, 0), new Vector2(1, 1) };
/// Vertices.Triangulate(outline, Vertices.WindingOrder.CounterClockwise, out Vector2[] corners, out short[] indices);
/// </code>
/// </example>
public static class VerticesPorting
{
    extension(Vertices)
    {
        /// <summary>Cuts an outline into triangles, to be drawn as a list of these.</summary>
        /// <param name="inputVertices">A simple outline, in either order. Repeated and collinear vertices are left out.</param>
        /// <param name="desiredWindingOrder">The order of the results.</param>
        /// <param name="outputVertices">The corners of the outline in that order.</param>
        /// <param name="indices">Three corners for each triangle, in that order.</param>
        /// <exception cref="ArgumentNullException"><paramref name="inputVertices"/> is null.</exception>
        /// <exception cref="ArgumentException">The outline is not simple, has no area, or more than 32,767 corners.</exception>
        /// <exception cref="ArgumentOutOfRangeException">
        /// A coordinate is not finite or beyond 9.2·10¹⁸; <paramref name="desiredWindingOrder"/> is neither order.
        /// </exception>
        public static void Triangulate(
            Vector2[] inputVertices, Vertices.WindingOrder desiredWindingOrder, out Vector2[] outputVertices, out short[] indices)
        {
            if (desiredWindingOrder is not (Vertices.WindingOrder.Clockwise or Vertices.WindingOrder.CounterClockwise))
            {
                throw Require.Range(nameof(desiredWindingOrder), desiredWindingOrder, "must be Clockwise or CounterClockwise");
            }

            OutlineTriangles.Cut(
                inputVertices,
                desiredWindingOrder == Vertices.WindingOrder.Clockwise,
                nameof(inputVertices),
                out outputVertices,
                out indices);
        }
    }
}
