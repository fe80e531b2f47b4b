using System;
using System.Numerics;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.NarrowPhase;

/// <summary>Contacts of circles with circles and with hulls of at least two vertices: one point at most.</summary>
internal static unsafe class CirclePairs
{
    /// <summary>Centres nearer than this share of the radii give no direction.</summary>
    public const float ShortestArm = 1e-6f;

    /// <summary>
    /// A circle has one point of contact, whatever feature it rolls on: its impulses follow it from edge to edge.
    /// </summary>
    public const uint Id = 1;

    public static void CircleCircle(in PairInput pair, out Manifold manifold)
    {
        Vector2* v = pair.Vertices;
        Vector2 localA = v[pair.A.VertexStart];
        Vector2 localB = v[pair.B.VertexStart];
        float ax = (pair.RotationA.Cos * localA.X) - (pair.RotationA.Sin * localA.Y);
        float ay = (pair.RotationA.Sin * localA.X) + (pair.RotationA.Cos * localA.Y);
        float x = (pair.RotationB.Cos * localB.X) - (pair.RotationB.Sin * localB.Y) + pair.Offset.X - ax;
        float y = (pair.RotationB.Sin * localB.X) + (pair.RotationB.Cos * localB.Y) + pair.Offset.Y - ay;
        float sum = pair.A.Radius + pair.B.Radius;
        float distance = (float)Math.Sqrt((x * x) + (y * y));
        float separation = distance - sum;
        manifold = default;
        if (!(separation <= pair.Margin))
        {
            return;
        }

        bool apart = distance > ShortestArm * sum;
        float nx = apart ? x / distance : 0;
        float ny = apart ? y / distance : 1;
        float reach = pair.A.Radius + (0.5f * separation);
        manifold.Normal = new Vector2(nx, ny);
        manifold.Count = 1;
        manifold.Point0.Anchor = new Vector2(ax + (nx * reach), ay + (ny * reach));
        manifold.Point0.Separation = separation;
        manifold.Point0.Id = Id;
    }

    public static void CircleHull(in PairInput pair, out Manifold manifold)
    {
        manifold = default;
        var hull = new Hull(pair, pair.B);
        Vector2 center = pair.RotationB.InverseRotate(pair.RotationA.Rotate(pair.Vertices[pair.A.VertexStart]) - pair.Offset);
        if (!Touch(hull, center, pair.A.Radius, pair.Margin, pair.B.Extent, ref manifold))
        {
            return;
        }

        manifold.Normal = -pair.RotationB.Rotate(manifold.Normal);
        manifold.Point0.Anchor = pair.RotationB.Rotate(manifold.Point0.Anchor) + pair.Offset;
    }

    public static void HullCircle(in PairInput pair, out Manifold manifold)
    {
        manifold = default;
        var hull = new Hull(pair, pair.A);
        Vector2 center = pair.RotationA.InverseRotate(pair.RotationB.Rotate(pair.Vertices[pair.B.VertexStart]) + pair.Offset);
        if (!Touch(hull, center, pair.B.Radius, pair.Margin, pair.A.Extent, ref manifold))
        {
            return;
        }

        manifold.Normal = pair.RotationA.Rotate(manifold.Normal);
        manifold.Point0.Anchor = pair.RotationA.Rotate(manifold.Point0.Anchor);
    }

    /// <summary>The contact in the hull's frame, its normal pointing from the hull to the circle.</summary>
    private static bool Touch(in Hull hull, Vector2 center, float radius, float margin, float scale, ref Manifold manifold)
    {
        float sum = hull.Radius + radius;
        int edge = 0;
        int real = -1;
        float best = float.MinValue;
        float bestReal = float.MinValue;
        for (int i = 0; i < hull.Count; i++)
        {
            float s = Vector2.Dot(hull.Normals[i], center - hull.Vertices[i]);
            if (s > best)
            {
                best = s;
                edge = i;
            }

            if (s > bestReal && hull.IsReal(i))
            {
                bestReal = s;
                real = i;
            }
        }

        if (best - sum > margin)
        {
            return false;
        }

        Vector2 start = hull.Vertices[edge];
        Vector2 normal = hull.Normals[edge];
        var tangent = new Vector2(-normal.Y, normal.X);
        float along = Vector2.Dot(center - start, tangent);
        float length = Vector2.Dot(hull.Vertices[hull.Next(edge)] - start, tangent);
        if (best >= 0 && (along < 0 || along > length))
        {
            int vertex = along < 0 ? edge : hull.Next(edge);
            return TouchVertex(hull, vertex, normal, center, radius, margin, scale, ref manifold);
        }

        if (edge != real && !hull.IsReal(edge))
        {
            // Beyond a seam lies the neighbour, which makes the contact; inside this piece the nearest outline edge leads out.
            if (best > 0 || real < 0)
            {
                return false;
            }

            best = bestReal;
            normal = hull.Normals[real];
        }

        float separation = best - sum;
        manifold.Normal = normal;
        manifold.Count = 1;
        manifold.Point0.Anchor = center - (normal * (radius + (0.5f * separation)));
        manifold.Point0.Separation = separation;
        manifold.Point0.Id = Id;
        return true;
    }

    private static bool TouchVertex(
        in Hull hull, int vertex, Vector2 edgeNormal, Vector2 center, float radius, float margin, float scale, ref Manifold manifold)
    {
        Vector2 arm = center - hull.Vertices[vertex];
        float distance = (float)Math.Sqrt((arm.X * arm.X) + (arm.Y * arm.Y));
        float sum = hull.Radius + radius;
        if (distance - sum > margin)
        {
            return false;
        }

        Vector2 normal = distance > ShortestArm * scale ? arm / distance : edgeNormal;
        if (!hull.Admits(vertex, ref normal))
        {
            return false;
        }

        float separation = Vector2.Dot(arm, normal) - sum;
        manifold.Normal = normal;
        manifold.Count = 1;
        manifold.Point0.Anchor = center - (normal * (radius + (0.5f * separation)));
        manifold.Point0.Separation = separation;
        manifold.Point0.Id = Id;
        return true;
    }
}
