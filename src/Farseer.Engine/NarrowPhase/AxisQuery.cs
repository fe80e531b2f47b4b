using System.Numerics;
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

    /// <summary>
    /// The edges' normals turn one way round, and so do the vertices that lie farthest against them: the walk costs
    /// n + m, not n·m. Where the normals turn by a right angle or more the walk could stop at once, so it starts afresh.
    /// </summary>
    public static AxisQuery Find(in Hull reference, in Hull other, in Placement placement)
    {
        AxisQuery best;
        best.Edge = -1;
        best.Support = 0;
        best.Separation = float.MinValue;
        best.RealEdge = -1;
        best.RealSupport = 0;
        best.RealSeparation = float.MinValue;
        best.Greatest = float.MinValue;
        Rotation q = placement.Rotation;
        Vector2* ov = other.Vertices;
        int count = other.Count;
        int support = 0;
        Vector2 last = default;
        for (int edge = 0; edge < reference.Count; edge++)
        {
            Vector2 normal = reference.Normals[edge];
            Vector2 d = q.InverseRotate(normal);
            float height;
            if (count <= 4 || edge == 0 || (normal.X * last.X) + (normal.Y * last.Y) <= 0)
            {
                height = Lowest(ov, count, d, out support);
            }
            else
            {
                height = (d.X * ov[support].X) + (d.Y * ov[support].Y);
                while (true)
                {
                    int next = support + 1 == count ? 0 : support + 1;
                    float h = (d.X * ov[next].X) + (d.Y * ov[next].Y);
                    if (h >= height)
                    {
                        break;
                    }

                    height = h;
                    support = next;
                }
            }

            last = normal;
            Vector2 v = reference.Vertices[edge];
            float separation = height + (((placement.Offset.X - v.X) * normal.X) + ((placement.Offset.Y - v.Y) * normal.Y));
            if (separation > best.Greatest)
            {
                best.Greatest = separation;
            }

            if (separation > best.Separation && reference.IsReal(edge))
            {
                best.Offer(edge, support, separation, other, -d);
            }
        }

        return best;
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
