using System;
using System.Numerics;

namespace Farseer.Engine.NarrowPhase;

/// <summary>Builds the points of a contact once the reference edge is known, in the reference hull's frame.</summary>
internal static class EdgeContact
{
    /// <summary>Below this share of the extent the line between two vertices is too short to give a direction.</summary>
    public const float ShortestArm = 1e-6f;

    public static unsafe void Build(
        in Hull reference,
        in Hull other,
        in Placement placement,
        in AxisQuery axis,
        float margin,
        float scale,
        ref Manifold manifold,
        bool flipped)
    {
        int edge = axis.Edge;
        int edgeEnd = reference.Next(edge);
        Vector2 normal = reference.Normals[edge];
        var tangent = new Vector2(-normal.Y, normal.X);
        Vector2 origin = reference.Vertices[edge];
        float length = Vector2.Dot(reference.Vertices[edgeEnd] - origin, tangent);
        int support = axis.Support;
        Vector2 normalInOther = placement.Rotation.InverseRotate(normal);
        int incident = IncidentEdge(other, support, normalInOther);
        bool neighbours = BelongsToNeighbour(other, support, normalInOther);
        int i0 = incident < 0 ? support : incident;
        int i1 = incident < 0 ? support : other.Next(incident);
        Vector2 w0 = placement.Apply(other.Vertices[i0]) - origin;
        Vector2 w1 = placement.Apply(other.Vertices[i1]) - origin;
        var high = new Vector2(Vector2.Dot(w0, tangent), Vector2.Dot(w0, normal));
        var low = new Vector2(Vector2.Dot(w1, tangent), Vector2.Dot(w1, normal));
        bool supportIsHigh = support == i0;
        Vector2 near = supportIsHigh ? high : low;
        Vector2 far = supportIsHigh ? low : high;
        float lo = low.X > 0 ? low.X : 0;
        float hi = high.X < length ? high.X : length;
        bool seamed = reference.IsSeamed || other.IsSeamed;

        // Vertex against vertex: the support vertex is beyond the edge, and the edge's end is nearest to it, not to its side.
        if (near.Y > 0 && (near.X < 0 || near.X > length))
        {
            float end = near.X < 0 ? 0 : length;
            float along = ((end - near.X) * (far.X - near.X)) - (near.Y * (far.Y - near.Y));
            if (along <= 0 || hi < lo)
            {
                bool farIsNearer = along > 0 && Math.Abs(far.X - end) < Math.Abs(near.X - end);
                int vertex = farIsNearer == supportIsHigh ? i1 : i0;
                var corner = new Corner(near.X < 0 ? edge : edgeEnd, vertex, farIsNearer ? far : near, end);
                corner.Build(reference, other, placement, normal, margin, scale, ref manifold, flipped);
                return;
            }
        }

        manifold.Normal = normal;
        float sum = reference.Radius + other.Radius;
        var frame = new PointFrame(origin, normal, tangent, reference.Radius, sum, margin);
        if (high.X <= low.X || hi < lo)
        {
            if (neighbours || (seamed && (near.X < 0 || near.X > length)))
            {
                return;
            }

            frame.Add(near.X, near.Y, Id(near.X + near.X < length ? edge : edgeEnd, support, flipped), ref manifold);
            return;
        }

        float slope = (high.Y - low.Y) / (high.X - low.X);
        float yLo = low.X > 0 ? low.Y : low.Y - (low.X * slope);
        float yHi = high.X < length ? high.Y : high.Y + ((length - high.X) * slope);
        bool takesHigh = !(neighbours && supportIsHigh && high.X <= length);
        bool takesLow = !(neighbours && !supportIsHigh && low.X >= 0);
        if (flipped && takesHigh)
        {
            frame.Add(hi, yHi, Id(edgeEnd, i0, flipped), ref manifold);
        }

        if (takesLow)
        {
            frame.Add(lo, yLo, Id(edge, i1, flipped), ref manifold);
        }

        if (!flipped && takesHigh)
        {
            frame.Add(hi, yHi, Id(edgeEnd, i0, flipped), ref manifold);
        }
    }

    /// <summary>
    /// Name of a point by the vertex of A and the vertex of B at that end of the two edges. Which of them cuts the other short,
    /// and which edge was the reference, changes nothing. Odd, hence never 0.
    /// </summary>
    public static uint Id(int referenceVertex, int otherVertex, bool flipped)
    {
        uint a = (uint)(flipped ? otherVertex : referenceVertex) & 0x7FFF;
        uint b = (uint)(flipped ? referenceVertex : otherVertex) & 0x7FFF;
        return (a << 16) | (b << 1) | 1;
    }

    // Where a seam ends at the support vertex, one of the outline's two edges there is the neighbour's. If that one faces the
    // reference edge more, the neighbour touches it with the same vertex. Two rows that hold one point would each be solved
    // against the other: an L that falls on its side kept a spin of 2e-4 rad/s from that.
    private static unsafe bool BelongsToNeighbour(in Hull other, int support, Vector2 normal)
    {
        bool ownAfter = other.IsReal(support);
        bool ownBefore = other.IsReal(other.Previous(support));
        if (!other.IsSeamed || ownAfter == ownBefore || other.IsOpenEnd(support))
        {
            return false;
        }

        float after = Vector2.Dot(other.After[support], normal);
        float before = Vector2.Dot(other.Before[support], normal);
        return ownAfter ? before < after : after < before;
    }

    // Of the two edges at the support vertex the one that faces the reference edge more; a seam is not there to be touched.
    private static unsafe int IncidentEdge(in Hull other, int support, Vector2 normal)
    {
        int before = other.Previous(support);
        bool beforeReal = other.IsReal(before);
        if (!other.IsReal(support))
        {
            return beforeReal ? before : -1;
        }

        return beforeReal && Vector2.Dot(other.Normals[before], normal) < Vector2.Dot(other.Normals[support], normal) ? before : support;
    }
}

/// <summary>Writes points given by their place along the reference edge and their height above it.</summary>
internal readonly struct PointFrame
{
    private readonly Vector2 _origin;
    private readonly Vector2 _normal;
    private readonly Vector2 _tangent;
    private readonly float _radius;
    private readonly float _sum;
    private readonly float _margin;

    public PointFrame(Vector2 origin, Vector2 normal, Vector2 tangent, float radius, float sum, float margin)
    {
        _origin = origin;
        _normal = normal;
        _tangent = tangent;
        _radius = radius;
        _sum = sum;
        _margin = margin;
    }

    public void Add(float along, float height, uint id, ref Manifold manifold)
    {
        float separation = height - _sum;
        if (!(separation <= _margin))
        {
            return;
        }

        ManifoldPoint point;
        point.Anchor = _origin + (_tangent * along) + (_normal * (_radius + (0.5f * separation)));
        point.Separation = separation;
        point.Id = id;
        if (manifold.Count == 0)
        {
            manifold.Point0 = point;
        }
        else
        {
            manifold.Point1 = point;
        }

        manifold.Count++;
    }
}

/// <summary>Contact of two vertices, given along the reference edge's tangent and normal from its first vertex.</summary>
internal readonly struct Corner
{
    private readonly int _referenceVertex;
    private readonly int _otherVertex;
    private readonly Vector2 _place;
    private readonly float _end;

    public Corner(int referenceVertex, int otherVertex, Vector2 place, float end)
    {
        _referenceVertex = referenceVertex;
        _otherVertex = otherVertex;
        _place = place;
        _end = end;
    }

    public unsafe void Build(
        in Hull reference,
        in Hull other,
        in Placement placement,
        Vector2 edgeNormal,
        float margin,
        float scale,
        ref Manifold manifold,
        bool flipped)
    {
        float x = _place.X - _end;
        float y = _place.Y;
        float distance = (float)Math.Sqrt((x * x) + (y * y));
        float sum = reference.Radius + other.Radius;
        if (distance - sum > margin)
        {
            return;
        }

        var tangent = new Vector2(-edgeNormal.Y, edgeNormal.X);
        Vector2 arm = (tangent * x) + (edgeNormal * y);
        Vector2 normal = distance > EdgeContact.ShortestArm * scale ? arm / distance : edgeNormal;
        if (!reference.Admits(_referenceVertex, ref normal))
        {
            return;
        }

        if (other.IsSeamed)
        {
            Vector2 back = placement.Rotation.InverseRotate(-normal);
            if (!other.Admits(_otherVertex, ref back))
            {
                return;
            }

            normal = -placement.Rotation.Rotate(back);
        }

        float separation = Vector2.Dot(arm, normal) - sum;
        manifold.Normal = normal;
        manifold.Point0.Anchor = reference.Vertices[_referenceVertex] + (normal * (reference.Radius + (0.5f * separation)));
        manifold.Point0.Separation = separation;
        manifold.Point0.Id = EdgeContact.Id(_referenceVertex, _otherVertex, flipped);
        manifold.Count = 1;
    }
}
