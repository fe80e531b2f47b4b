using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;

namespace Farseer.Engine.NarrowPhase;

/// <summary>The best separating axis among the edge normals of one hull (the reference) against another.</summary>
internal unsafe struct AxisQuery
{
    /// <summary>Edge of the reference and vertex of the other hull nearest to it; -1: every axis was refused.</summary>
    public int Edge;
    public int Support;
    public float Separation;

    /// <summary>The same over all outline edges, whether or not the other hull's outline admits the axis.</summary>
    public int RealEdge;
    public int RealSupport;
    public float RealSeparation;

    /// <summary>The greatest separation over all edges, seams included: a lower bound of the distance.</summary>
    public float Greatest;

    public static AxisQuery Find(in Hull reference, in Hull other, in Placement placement, Vector2 otherCenter)
    {
        AxisQuery query = default;
        query.Edge = -1;
        query.RealEdge = -1;
        query.Separation = float.MinValue;
        query.RealSeparation = float.MinValue;
        query.Greatest = float.MinValue;
        if (reference.IsSeamed || other.IsSeamed)
        {
            query.FindSeamed(reference, other, placement);
        }
        else
        {
            query.FindPlain(reference, other, placement, placement.Apply(otherCenter));
        }

        return query;
    }

    /// <summary>
    /// The first of the edges with the greatest separation, and the first of the vertices lowest over it: a choice that does not
    /// depend on the way of the search, so that lanes, which measure every edge, make the same. Here every vertex of the other hull
    /// bounds the separation of every edge from above, rounding included. So the search starts with the edge that faces the other's
    /// centre, and an edge is measured in full only if the vertex nearest to the best edge does not already rule it out: for small
    /// polygons mostly one edge or two.
    /// </summary>
    private void FindPlain(in Hull reference, in Hull other, in Placement placement, Vector2 center)
    {
        Rotation q = placement.Rotation;
        Vector2* vertices = reference.Vertices;
        Vector2* normals = reference.Normals;
        int start = 0;
        float facing = float.MinValue;
        for (int i = 0; i < reference.Count; i++)
        {
            float s = ((center.X - vertices[i].X) * normals[i].X) + ((center.Y - vertices[i].Y) * normals[i].Y);
            if (s > facing)
            {
                facing = s;
                start = i;
            }
        }

        float best = Lowest(other.Vertices, other.Count, q.InverseRotate(normals[start]), out int bestSupport)
            + Base(placement.Offset, vertices[start], normals[start]);
        int bestEdge = start;
        for (int edge = 0; edge < reference.Count; edge++)
        {
            Vector2 d = q.InverseRotate(normals[edge]);
            float base0 = Base(placement.Offset, vertices[edge], normals[edge]);
            Vector2 near = other.Vertices[bestSupport];
            if (edge == start || !IsBetter(((d.X * near.X) + (d.Y * near.Y)) + base0, edge, best, bestEdge))
            {
                continue;
            }

            float separation = Lowest(other.Vertices, other.Count, d, out int support) + base0;
            if (IsBetter(separation, edge, best, bestEdge))
            {
                best = separation;
                bestEdge = edge;
                bestSupport = support;
            }
        }

        Edge = bestEdge;
        Support = bestSupport;
        Separation = best;
        Greatest = best;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsBetter(float separation, int edge, float best, int bestEdge) =>
        separation > best || (separation == best && edge < bestEdge);

    private void FindSeamed(in Hull reference, in Hull other, in Placement placement)
    {
        Rotation q = placement.Rotation;
        int support = 0;
        Vector2 last = default;
        for (int edge = 0; edge < reference.Count; edge++)
        {
            Vector2 normal = reference.Normals[edge];
            Vector2 d = q.InverseRotate(normal);
            bool fresh = IsFar(last, normal);
            float lowest = fresh ? Lowest(other.Vertices, other.Count, d, out support) : Walk(other.Vertices, other.Count, d, ref support);
            last = normal;
            float separation = lowest + Base(placement.Offset, reference.Vertices[edge], normal);
            Greatest = separation > Greatest ? separation : Greatest;
            if (separation > Separation && reference.IsReal(edge))
            {
                Offer(edge, support, separation, other, -d);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Base(Vector2 offset, Vector2 vertex, Vector2 normal) =>
        ((offset.X - vertex.X) * normal.X) + ((offset.Y - vertex.Y) * normal.Y);

    /// <summary>
    /// True unless the way on from the last direction to this one is less than a right angle (edges may have been left out).
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsFar(Vector2 last, Vector2 next) =>
        (next.X * last.X) + (next.Y * last.Y) <= 0 || (last.X * next.Y) - (last.Y * next.X) < 0;

    /// <summary>
    /// Edge normals turn one way round, and so do the vertices that lie farthest against them: walking on from the last one,
    /// all edges together cost n + m, not n·m. Where the normals turn by a right angle or more the walk could stop at once on
    /// a vertex that is farthest the other way; then the caller starts afresh. Each step goes lower, so that none comes by a vertex twice;
    /// a height that is no number ends the walk.
    /// </summary>
    private static float Walk(Vector2* vertices, int count, Vector2 d, ref int support)
    {
        float lowest = (d.X * vertices[support].X) + (d.Y * vertices[support].Y);
        while (true)
        {
            int next = support + 1 == count ? 0 : support + 1;
            float h = (d.X * vertices[next].X) + (d.Y * vertices[next].Y);
            if (!(h < lowest))
            {
                return lowest;
            }

            lowest = h;
            support = next;
        }
    }

    private static float Lowest(Vector2* vertices, int count, Vector2 d, out int index)
    {
        index = 0;
        float lowest = (d.X * vertices[0].X) + (d.Y * vertices[0].Y);
        for (int i = 1; i < count; i++)
        {
            float h = (d.X * vertices[i].X) + (d.Y * vertices[i].Y);
            if (h < lowest)
            {
                lowest = h;
                index = i;
            }
        }

        return lowest;
    }

    private void Offer(int edge, int support, float separation, in Hull other, Vector2 direction)
    {
        if (separation > RealSeparation)
        {
            RealSeparation = separation;
            RealEdge = edge;
            RealSupport = support;
        }

        if (other.Admits(support, ref direction))
        {
            Separation = separation;
            Edge = edge;
            Support = support;
        }
    }
}
