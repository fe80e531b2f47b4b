using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.NarrowPhase;

/// <summary>A piece on its way: what the search for a time of impact asks of it, in double precision.</summary>
internal unsafe struct MovingHull
{
    public readonly Vector2* Vertices;
    public readonly Vector2* Normals;
    public readonly int Count;
    public readonly double Radius;
    public double X;
    public double Y;
    private readonly double _arm;
    private readonly BodyPath _path;
    private double _cos;
    private double _sin;
    private double _spin;

    public MovingHull(ShapeStore shapes, int piece, in BodyPath path)
    {
        ref Piece p = ref shapes.Pieces[piece];
        Vertices = shapes.Vertices.Pointer + p.VertexStart;
        Normals = shapes.Normals.Pointer + p.VertexStart;
        Count = p.VertexCount;
        Radius = p.Radius;
        X = 0;
        Y = 0;
        _arm = Math.Max(0, (double)p.Reach - p.Radius);
        _path = path;
        _cos = 1;
        _sin = 0;
        _spin = 0;
    }

    public readonly BodyPath Path => _path;

    /// <summary>Puts both pieces of a pair where they are at <paramref name="f"/>. Of two rotors at once each costs half.</summary>
    public static void MoveTo(double f, ref MovingHull a, ref MovingHull b)
    {
        double* sin = stackalloc double[StableMath.Lanes];
        double* cos = stackalloc double[StableMath.Lanes];
        double angleA = a._path.AngleAt(f);
        double angleB = b._path.AngleAt(f);
        StableMath.SinCos(angleA, angleB, angleA, angleB, sin, cos);
        a.Place(f, sin[0], cos[0]);
        b.Place(f, sin[1], cos[1]);
    }

    /// <summary>A direction or an arm in world axes.</summary>
    public readonly void ToWorld(Vector2 v, out double x, out double y)
    {
        x = (_cos * v.X) - (_sin * v.Y);
        y = (_sin * v.X) + (_cos * v.Y);
    }

    /// <summary>The least of d·r over the vertices r, from the body's centre, and where it is.</summary>
    public readonly double Lowest(double dx, double dy, out int index)
    {
        double x = (_cos * dx) + (_sin * dy);
        double y = (_cos * dy) - (_sin * dx);
        index = 0;
        double lowest = (x * Vertices[0].X) + (y * Vertices[0].Y);
        for (int i = 1; i < Count; i++)
        {
            double h = (x * Vertices[i].X) + (y * Vertices[i].Y);
            if (h < lowest)
            {
                lowest = h;
                index = i;
            }
        }

        return lowest;
    }

    /// <summary>The least of d·r when every vertex goes on as fast as now for <paramref name="time"/>.</summary>
    public readonly double LowestAhead(double dx, double dy, double time)
    {
        // d·(ω×r) = ω·(r×d), so each vertex adds to d·r the part of it along ω·t·d turned by a right angle.
        double turn = _spin * time;
        double x = dx + (turn * dy);
        double y = dy - (turn * dx);
        return Lowest(x, y, out _);
    }

    /// <summary>The fastest that the arm of a vertex changes its speed along any direction, over the rest from <paramref name="f"/> on.</summary>
    public readonly double Bend(double f)
    {
        double fastest = Math.Max(Math.Abs(_path.SpinAt(f)), Math.Abs(_path.SpinAt(1)));
        return _arm * ((fastest * fastest) + Math.Abs(_path.SpinGain));
    }

    private void Place(double f, double sin, double cos)
    {
        X = _path.XAt(f);
        Y = _path.YAt(f);
        _spin = _path.SpinAt(f);
        _sin = sin;
        _cos = cos;
    }
}
