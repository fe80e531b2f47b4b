using System;
using System.Numerics;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.Shapes;

/// <summary>A run of vertices in the pools of a <see cref="ShapeStore"/>.</summary>
internal readonly unsafe struct PieceRange
{
    public PieceRange(ShapeStore store, int start, int count)
    {
        Start = start;
        Count = count;
        Vertices = store.Vertices.Pointer + start;
        Normals = store.Normals.Pointer + start;
        Before = store.OutlineBefore.Pointer + start;
        After = store.OutlineAfter.Pointer + start;
    }

    public int Start { get; }

    public int Count { get; }

    public Vector2* Vertices { get; }

    public Vector2* Normals { get; }

    public Vector2* Before { get; }

    public Vector2* After { get; }
}

/// <summary>Turns a piece of a shape into the record and the pool entries of a body: offset and rotation are baked in once.</summary>
internal static unsafe class PieceBaker
{
    public static void Write(PieceGeometry source, Vector2 offset, Rotation rotation, PieceRange range)
    {
        int count = range.Count;
        for (int i = 0; i < count; i++)
        {
            range.Vertices[i] = offset + rotation.Rotate(source.Vertices[i]);
        }

        for (int i = 0; i < count; i++)
        {
            // The normal is taken from the unmoved vertices: an offset far from the body's centre must not tilt it.
            Vector2 normal = count < 2 ? Vector2.Zero : Turn(EdgeNormal(source.Vertices[i], source.Vertices[(i + 1) % count]), rotation);
            range.Normals[i] = normal;
            range.After[i] = normal;
            range.Before[(i + 1) % count] = normal;
        }

        if (source.OutlineNormalBefore == null || source.OutlineNormalAfter == null)
        {
            return;
        }

        bool[]? seams = source.SeamEdges;
        for (int i = 0; i < count; i++)
        {
            int previous = (i + count - 1) % count;
            if (IsInner(source, seams, i))
            {
                range.After[i] = Turn(source.OutlineNormalAfter[i], rotation);
            }

            if (IsInner(source, seams, previous))
            {
                range.Before[i] = Turn(source.OutlineNormalBefore[i], rotation);
            }
        }
    }

    public static Piece Describe(PieceGeometry source, int body, int collider, PieceRange range)
    {
        double reach = 0;
        Vector2 min = range.Vertices[0];
        Vector2 max = min;
        for (int i = 0; i < range.Count; i++)
        {
            Vector2 v = range.Vertices[i];
            min = new Vector2(Math.Min(min.X, v.X), Math.Min(min.Y, v.Y));
            max = new Vector2(Math.Max(max.X, v.X), Math.Max(max.Y, v.Y));
            reach = Math.Max(reach, Math.Sqrt(((double)v.X * v.X) + ((double)v.Y * v.Y)));
        }

        bool box = source.Kind == ShapeKind.Box;
        Vector2 axis = box ? range.Normals[1] : Vector2.UnitX;
        PieceFlags flags = (source.OutlineNormalBefore != null ? PieceFlags.Seamed : PieceFlags.None)
            | (source.OneSided ? PieceFlags.OneSided : PieceFlags.None);
        return new Piece
        {
            Body = body,
            Collider = collider,
            VertexStart = range.Start,
            VertexCount = range.Count,
            Radius = source.Radius,
            Reach = FloatBits.RoundUp(reach + source.Radius),
            Extent = LengthScale(source),
            Kind = source.Kind,
            Flags = flags,
            Traits = TraitsOf(source.Kind, flags, range.Count, axis),
            Center = (min + max) * 0.5f,
            Axis = axis,
            Half = box ? HalfSides(range.Vertices, axis) : new Vector2(source.Radius, Around(range, (min + max) * 0.5f, source.Radius)),
        };
    }

    private static PieceTraits TraitsOf(ShapeKind kind, PieceFlags flags, int corners, Vector2 axis)
    {
        if ((flags & PieceFlags.OneSided) != 0)
        {
            return PieceTraits.None;
        }

        PieceTraits traits =
            flags == PieceFlags.None && corners > 1 && corners <= Piece.MostLaneCorners ? PieceTraits.Hull : PieceTraits.None;
        return kind switch
        {
            ShapeKind.Box => traits | PieceTraits.Box | (axis != Vector2.UnitX ? PieceTraits.Tilted : PieceTraits.None),
            ShapeKind.Circle => traits | PieceTraits.Circle,
            _ => traits,
        };
    }

    private static float Around(PieceRange range, Vector2 center, float radius)
    {
        double farthest = 0;
        for (int i = 0; i < range.Count; i++)
        {
            double x = (double)range.Vertices[i].X - center.X;
            double y = (double)range.Vertices[i].Y - center.Y;
            farthest = Math.Max(farthest, Math.Sqrt((x * x) + (y * y)));
        }

        return FloatBits.RoundUp(farthest + radius);
    }

    private static Vector2 HalfSides(Vector2* v, Vector2 axis) => new Vector2(
        0.5f * (((v[1].X - v[0].X) * axis.X) + ((v[1].Y - v[0].Y) * axis.Y)),
        0.5f * (((v[2].Y - v[1].Y) * axis.X) - ((v[2].X - v[1].X) * axis.Y)));

    /// <summary>
    /// Unit normal to the right of the way from <paramref name="from"/> to <paramref name="to"/>, rounded once from double.
    /// </summary>
    public static Vector2 EdgeNormal(Vector2 from, Vector2 to)
    {
        double x = (double)to.X - from.X;
        double y = (double)to.Y - from.Y;
        double length = Math.Sqrt((x * x) + (y * y));
        return length > 0 ? new Vector2((float)(y / length), (float)(-x / length)) : Vector2.Zero;
    }

    /// <summary>An inner edge: a seam, or the back of a one-sided segment.</summary>
    private static bool IsInner(PieceGeometry source, bool[]? seams, int edge) =>
        (seams != null && seams[edge]) || (source.OneSided && edge != 0);

    // Normalised again in double: the float rotor is only unit to a few ulp.
    private static Vector2 Turn(Vector2 normal, Rotation r)
    {
        double x = ((double)r.Cos * normal.X) - ((double)r.Sin * normal.Y);
        double y = ((double)r.Sin * normal.X) + ((double)r.Cos * normal.Y);
        double length = Math.Sqrt((x * x) + (y * y));
        return length > 0 ? new Vector2((float)(x / length), (float)(y / length)) : Vector2.Zero;
    }

    // Half the shorter side of the bounds before turning, so that a tilt does not change it; a bare segment has no width and
    // is measured by its length, or by the body that it bounds.
    private static float LengthScale(PieceGeometry source)
    {
        Vector2 min = source.Vertices[0];
        Vector2 max = min;
        foreach (Vector2 v in source.Vertices)
        {
            min = new Vector2(Math.Min(min.X, v.X), Math.Min(min.Y, v.Y));
            max = new Vector2(Math.Max(max.X, v.X), Math.Max(max.Y, v.Y));
        }

        Vector2 size = max - min;
        float side = source.Kind == ShapeKind.Segment ? Math.Min(Math.Max(size.X, size.Y), source.Thickness) : Math.Min(size.X, size.Y);
        return (0.5f * side) + source.Radius;
    }
}
