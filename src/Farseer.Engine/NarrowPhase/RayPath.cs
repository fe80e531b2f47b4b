using System;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.NarrowPhase;

/// <summary>
/// A straight way and where it first enters something, in double precision and the coordinates of what it is held against. An edge is
/// entered by the signs of two cross products, one for each end; neighbours share the number of their common corner, so nothing
/// slips through between them.
/// </summary>
internal unsafe struct RayPath
{
    public double X;
    public double Y;
    public double DirectionX;
    public double DirectionY;

    /// <summary>Share of the way to the nearest entry so far; entries from here on do not count.</summary>
    public double Fraction;

    /// <summary>Outward unit normal there.</summary>
    public double NormalX;
    public double NormalY;

    /// <summary>The edge or corner that was entered, as its caller numbered it.</summary>
    public int Feature;

    /// <summary>
    /// Holds the way against the outline of a piece. Its seams are passed over: what enters by one is inside a neighbour already.
    /// </summary>
    /// <returns>True if the piece is entered before what was entered so far.</returns>
    public bool Enter(ShapeStore shapes, int piece)
    {
        ref Piece p = ref shapes.Pieces[piece];
        System.Numerics.Vector2* v = shapes.Vertices.Pointer + p.VertexStart;
        System.Numerics.Vector2* normals = shapes.Normals.Pointer + p.VertexStart;
        System.Numerics.Vector2* after = shapes.OutlineAfter.Pointer + p.VertexStart;
        int count = p.VertexCount;
        bool found = false;
        for (int i = 0; count > 1 && i < count; i++)
        {
            if (after[i] == normals[i])
            {
                int next = i + 1 == count ? 0 : i + 1;
                found |= EnterEdge(v[i].X, v[i].Y, v[next].X, v[next].Y, p.Radius, i);
            }
        }

        for (int i = 0; p.Radius > 0 && i < count; i++)
        {
            found |= EnterDisc(v[i].X, v[i].Y, p.Radius, i + count);
        }

        return found;
    }

    /// <summary>Whether the start lies in or on a piece; lines contain nothing.</summary>
    public readonly bool StartsIn(ShapeStore shapes, int piece)
    {
        double radius = shapes.Pieces[piece].Radius;
        return Distance.IsInCore(shapes, piece, X, Y)
            || (radius > 0 && Distance.ToOutline(shapes, piece, X, Y, seamsToo: true) <= radius);
    }

    /// <summary>An edge from a to b with the inside on its left, moved outwards by <paramref name="radius"/>.</summary>
    public bool EnterEdge(double ax, double ay, double bx, double by, double radius, int feature)
    {
        double ex = bx - ax;
        double ey = by - ay;
        double against = (DirectionX * ey) - (DirectionY * ex);
        if (!(against < 0))
        {
            return false;
        }

        if (radius > 0)
        {
            double scale = radius / Math.Sqrt((ex * ex) + (ey * ey));
            ax += ey * scale;
            bx += ey * scale;
            ay -= ex * scale;
            by -= ex * scale;
        }

        double sideA = (DirectionX * (ay - Y)) - (DirectionY * (ax - X));
        double sideB = (DirectionX * (by - Y)) - (DirectionY * (bx - X));
        if (!(sideA >= 0 && sideB <= 0))
        {
            return false;
        }

        double t = (((ax - X) * ey) - ((ay - Y) * ex)) / against;
        if (!(t >= 0 && t < Fraction))
        {
            return false;
        }

        double length = Math.Sqrt((ex * ex) + (ey * ey));
        Fraction = t;
        NormalX = ey / length;
        NormalY = -ex / length;
        Feature = feature;
        return true;
    }

    /// <summary>A disc that the start is not in.</summary>
    public bool EnterDisc(double x, double y, double radius, int feature)
    {
        double px = X - x;
        double py = Y - y;
        double approach = (px * DirectionX) + (py * DirectionY);
        double square = (DirectionX * DirectionX) + (DirectionY * DirectionY);
        double gap = (px * px) + (py * py) - (radius * radius);
        double root = (approach * approach) - (square * gap);
        if (!(approach < 0 && root >= 0))
        {
            return false;
        }

        // The form without a difference of nearly equal numbers; the gap is below 0 only by rounding.
        double t = Math.Max(0, gap / (Math.Sqrt(root) - approach));
        if (!(t < Fraction))
        {
            return false;
        }

        double nx = px + (t * DirectionX);
        double ny = py + (t * DirectionY);
        double length = Math.Sqrt((nx * nx) + (ny * ny));
        Fraction = t;
        NormalX = nx / length;
        NormalY = ny / length;
        Feature = feature;
        return true;
    }
}
