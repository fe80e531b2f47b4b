using System;
using System.Globalization;
using System.Numerics;
using Box2D.Collision.Shapes;
using Farseer.Engine.Shapes;

namespace Box2D.Bridge;

/// <summary>Checks the corners of a polygon.</summary>
internal static class PolygonForm
{
    /// <summary>The corners of a definition: at least three, finite, convex and counter-clockwise.</summary>
    public static Vector2[] Corners(b2PolygonDef def)
    {
        const string Name = nameof(b2PolygonDef.vertices);
        int count = def.vertexCount;
        if (def.vertices is null || count < 3 || count > def.vertices.Length)
        {
            throw new ArgumentException(
                "A polygon needs at least 3 vertices, and vertexCount is " + count.ToString(CultureInfo.InvariantCulture)
                    + " of " + (def.vertices?.Length ?? 0).ToString(CultureInfo.InvariantCulture) + ".",
                nameof(b2PolygonDef.vertexCount));
        }

        var corners = new Vector2[count];
        for (int i = 0; i < count; i++)
        {
            Require.Vector(def.vertices[i], Name);
            corners[i] = new Vector2(def.vertices[i].x, def.vertices[i].y);
        }

        double area = MassProperties.SignedArea(corners);
        if (!(area > 0))
        {
            throw new ArgumentException("The vertices of a polygon must go counter-clockwise around an area.", Name);
        }

        // As in the original a corner in line with its neighbours is allowed to nobody: its edges would have one normal.
        for (int i = 0; i < count; i++)
        {
            Vector2 a = corners[i];
            Vector2 b = corners[(i + 1) % count];
            for (int k = 0; k < count; k++)
            {
                if (k != i && k != (i + 1) % count && !(Cross(a, b, corners[k]) > 0))
                {
                    throw new ArgumentException(
                        "The vertices of a polygon must be convex, and no two at one place; vertex "
                            + k.ToString(CultureInfo.InvariantCulture)
                            + " is not inside edge " + i.ToString(CultureInfo.InvariantCulture) + ".",
                        Name);
                }
            }
        }

        return corners;
    }

    private static double Cross(Vector2 a, Vector2 b, Vector2 p) =>
        (((double)b.X - a.X) * ((double)p.Y - a.Y)) - (((double)b.Y - a.Y) * ((double)p.X - a.X));
}
