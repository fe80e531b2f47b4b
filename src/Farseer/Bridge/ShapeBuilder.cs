using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Shapes;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Turns what a geom collides as into the convex pieces of the engine.</summary>
internal static class ShapeBuilder
{
    public static ShapeGeometry Build(GeomForm form)
    {
        switch (form.Kind)
        {
            case FormKind.Circle:
                return Single(new PieceGeometry(ShapeKind.Circle, new[] { Vector2.Zero }, form.Radius));
            case FormKind.Box:
                float x = 0.5f * form.Size.X;
                float y = 0.5f * form.Size.Y;
                return Single(new PieceGeometry(
                    ShapeKind.Box,
                    new[] { new Vector2(-x, -y), new Vector2(x, -y), new Vector2(x, y), new Vector2(-x, y) },
                    0));
            case FormKind.Capsule:
                return Single(new PieceGeometry(ShapeKind.Capsule, form.Points, form.Radius));
            case FormKind.Segment:
                return Single(new PieceGeometry(ShapeKind.Segment, form.Points, 0));
            case FormKind.Chain:
                return Chain(form.Points, form.IsLoop);
            default:
                return Polygon(form.Points);
        }
    }

    private static ShapeGeometry Single(PieceGeometry piece) => new ShapeGeometry(new[] { piece });

    private static ShapeGeometry Polygon(Vector2[] outline) =>
        Single(new PieceGeometry(ShapeKind.Polygon, Positive(outline), 0));

    /// <summary>The outline in positive order without the vertices that lie on a straight side.</summary>
    private static Vector2[] Positive(Vector2[] outline)
    {
        var corners = new List<Vector2>(outline.Length);
        for (int i = outline.Length - 1; i >= 0; i--)
        {
            corners.Add(outline[i]);
        }

        return corners.ToArray();
    }

    /// <summary>
    /// One piece a link. A contact at a joint of two links may have any normal between the two links' own; at a free end only the
    /// link's own.
    /// </summary>
    private static ShapeGeometry Chain(Vector2[] points, bool loop)
    {
        int links = loop ? points.Length : points.Length - 1;
        var pieces = new PieceGeometry[links];
        for (int i = 0; i < links; i++)
        {
            Vector2 own = Normal(points, i);
            Vector2 before = loop || i > 0 ? Normal(points, (i + links - 1) % links) : own;
            Vector2 after = loop || i < links - 1 ? Normal(points, (i + 1) % links) : own;
            pieces[i] = new PieceGeometry(ShapeKind.Segment, new[] { points[i], points[(i + 1) % points.Length] }, 0)
            {
                OneSided = true,
                OutlineNormalBefore = new[] { before, own },
                OutlineNormalAfter = new[] { own, after },
            };
        }

        return new ShapeGeometry(pieces);
    }

    /// <summary>Unit normal to the outer side of the link from point i on: right of the way for x right and y up.</summary>
    private static Vector2 Normal(Vector2[] points, int link)
    {
        Vector2 along = points[(link + 1) % points.Length] - points[link];
        float length = (float)Math.Sqrt(((double)along.X * along.X) + ((double)along.Y * along.Y));
        return new Vector2(along.Y / length, -along.X / length);
    }
}
