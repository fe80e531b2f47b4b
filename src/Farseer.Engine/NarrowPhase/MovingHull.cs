using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.NarrowPhase;

/// <summary>How a piece is turned, in double precision.</summary>
internal struct HullRotor
{
    public double Cos;
    public double Sin;

    /// <summary>A direction of the world in the piece's axes.</summary>
    public readonly double ToLocalX(double x, double y) => (Cos * x) + (Sin * y);

    /// <inheritdoc cref="ToLocalX"/>
    public readonly double ToLocalY(double x, double y) => (Cos * y) - (Sin * x);
}

/// <summary>A piece on its way: what the search for a time of impact asks of it, in double precision.</summary>
internal unsafe struct MovingHull
{
    public Vector2* Vertices;
    public Vector2* Normals;
    public int Count;
    public double Radius;
    public double X;
    public double Y;

    /// <summary>Radians for the whole way, at the present speed.</summary>
    public double Spin;
    public BodyPath Path;
    private double _arm;
    private HullRotor _rotor;

    /// <summary>
    /// Takes a piece and its way, field by field: what was just written one by one is not there yet for a copy of all of it, which waits.
    /// </summary>
    public void Begin(ShapeStore shapes, int piece, in BodyPath path)
    {
        ref Piece p = ref shapes.Pieces[piece];
        Vertices = shapes.Vertices.Pointer + p.VertexStart;
        Normals = shapes.Normals.Pointer + p.VertexStart;
        Count = p.VertexCount;
        Radius = p.Radius;
        _arm = Math.Max(0, (double)p.Reach - p.Radius);
        Path.X = path.X;
        Path.Y = path.Y;
        Path.Angle = path.Angle;
        Path.VelocityX = path.VelocityX;
        Path.VelocityY = path.VelocityY;
        Path.Spin = path.Spin;
        Path.AccelerationX = path.AccelerationX;
        Path.AccelerationY = path.AccelerationY;
        Path.SpinGain = path.SpinGain;
    }

    public readonly HullRotor Rotor => _rotor;

    /// <summary>Takes other corners for the piece's own.</summary>
    public void Become(SolidLink* corners)
    {
        Vertices = corners->Vertices;
        Normals = corners->Normals;
        Count = SolidLink.Corners;
    }

    /// <summary>Its corners may be so much farther from the body's centre than the piece's own.</summary>
    public void Thicken(double depth) => _arm += depth;

    /// <summary>Puts both pieces of a pair where they are at <paramref name="f"/>. Of two rotors at once each costs half.</summary>
    public static void MoveTo(double f, ref MovingHull a, ref MovingHull b)
    {
        double* sin = stackalloc double[StableMath.Lanes];
        double* cos = stackalloc double[StableMath.Lanes];
        double angleA = a.Path.AngleAt(f);
        double angleB = b.Path.AngleAt(f);
        StableMath.SinCos(angleA, angleB, angleA, angleB, sin, cos);
        a.Place(f, new HullRotor { Sin = sin[0], Cos = cos[0] });
        b.Place(f, new HullRotor { Sin = sin[1], Cos = cos[1] });
    }

    /// <summary>A direction or an arm in world axes.</summary>
    public readonly void ToWorld(Vector2 v, out double x, out double y)
    {
        x = (_rotor.Cos * v.X) - (_rotor.Sin * v.Y);
        y = (_rotor.Sin * v.X) + (_rotor.Cos * v.Y);
    }

    /// <summary>The least of d·r over the vertices r, from the body's centre.</summary>
    public readonly double Lowest(double dx, double dy) =>
        HullHeights.Lowest(Vertices, Count, _rotor.ToLocalX(dx, dy), _rotor.ToLocalY(dx, dy));

    /// <summary>The vertex of the least d·r, the first one of several.</summary>
    public readonly int LowestAt(double dx, double dy)
    {
        double x = _rotor.ToLocalX(dx, dy);
        double y = _rotor.ToLocalY(dx, dy);
        int index = 0;
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

        return index;
    }

    /// <summary>
    /// The fastest that the arm of a vertex changes its speed along any direction, over the rest from <paramref name="f"/> on.
    /// </summary>
    public readonly double Bend(double f)
    {
        double fastest = Math.Max(Math.Abs(Path.SpinAt(f)), Math.Abs(Path.SpinAt(1)));
        return _arm * ((fastest * fastest) + Math.Abs(Path.SpinGain));
    }

    /// <summary>Puts the piece where it is at <paramref name="f"/>, turned as it is then.</summary>
    public void Place(double f, HullRotor rotor)
    {
        X = Path.XAt(f);
        Y = Path.YAt(f);
        Spin = Path.SpinAt(f);
        _rotor = rotor;
    }
}
