using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Numerics;
using Farseer.Engine.Shapes;

namespace Farseer.Engine.Continuous;

/// <summary>
/// Whether a piece stays before one edge of another for its whole way. Most of what a fast body has a pair with it passes at a distance,
/// and to see that takes a tenth of what a search for a time of impact takes to find none.
/// </summary>
internal static unsafe class ClearWay
{
    /// <summary>Whether one piece of a pair comes nowhere so near to an edge of the other that they would count as touching.</summary>
    /// <param name="shapes">The pieces.</param>
    /// <param name="record">The pair.</param>
    /// <param name="a">Way of A's body.</param>
    /// <param name="b">Way of B's body.</param>
    /// <param name="ofA">The edge is one of A, else of B.</param>
    /// <param name="gap">How far apart they must stay at least.</param>
    public static bool Holds(ShapeStore shapes, in ContactRecord record, in BodyPath a, in BodyPath b, bool ofA, double gap) =>
        PassesFar(shapes, record, a, b, gap)
        || (ofA ? Holds(shapes, record.PieceB, b, record.PieceA, a, gap) : Holds(shapes, record.PieceA, a, record.PieceB, b, gap));

    /// <summary>The same for an edge of either.</summary>
    /// <param name="shapes">The pieces.</param>
    /// <param name="record">The pair.</param>
    /// <param name="a">Way of A's body.</param>
    /// <param name="b">Way of B's body.</param>
    /// <param name="gap">How far apart they must stay at least.</param>
    public static bool HoldsForEither(ShapeStore shapes, in ContactRecord record, in BodyPath a, in BodyPath b, double gap)
    {
        if (PassesFar(shapes, record, a, b, gap))
        {
            return true;
        }

        // Four rotors at once take no longer than one.
        double* sin = stackalloc double[StableMath.Lanes];
        double* cos = stackalloc double[StableMath.Lanes];
        StableMath.SinCos(a.Angle, a.AngleAt(1), b.Angle, b.AngleAt(1), sin, cos);
        return Holds(shapes, record.PieceB, b, record.PieceA, a, sin, cos, gap)
            || Holds(shapes, record.PieceA, a, record.PieceB, b, sin + 2, cos + 2, gap);
    }

    /// <summary>
    /// Whether the circles around the bodies' centres in which the pieces turn stay apart: a third of what then was searched in vain, and
    /// all of it where neither has edges. The way of one seen from the other lies within an eighth of its acceleration of its chord.
    /// </summary>
    private static bool PassesFar(ShapeStore shapes, in ContactRecord record, in BodyPath a, in BodyPath b, double gap)
    {
        double gainX = a.AccelerationX - b.AccelerationX;
        double gainY = a.AccelerationY - b.AccelerationY;
        double x = a.X - b.X;
        double y = a.Y - b.Y;
        double alongX = a.VelocityX - b.VelocityX + (0.5 * gainX);
        double alongY = a.VelocityY - b.VelocityY + (0.5 * gainY);
        double length = (alongX * alongX) + (alongY * alongY);
        double nearest = length > 0 ? Math.Min(Math.Max(-((x * alongX) + (y * alongY)) / length, 0), 1) : 0;
        x += nearest * alongX;
        y += nearest * alongY;
        double need = (double)shapes.Pieces[record.PieceA].Reach + shapes.Pieces[record.PieceB].Reach
            + (0.125 * (Math.Abs(gainX) + Math.Abs(gainY))) + gap;
        return (x * x) + (y * y) > need * need;
    }

    private static bool Holds(ShapeStore shapes, int piece, in BodyPath way, int other, in BodyPath otherWay, double gap)
    {
        double* sin = stackalloc double[2];
        double* cos = stackalloc double[2];
        StableMath.SinCos(otherWay.Angle, out sin[0], out cos[0]);
        sin[1] = sin[0];
        cos[1] = cos[0];
        if (otherWay.Spin != 0 || otherWay.SpinGain != 0)
        {
            StableMath.SinCos(otherWay.AngleAt(1), out sin[1], out cos[1]);
        }

        return Holds(shapes, piece, way, other, otherWay, sin, cos, gap);
    }

    /// <summary>
    /// Sees the way of the piece's body from the other one, as if that stood still. It bends there by no more than it turns and
    /// accelerates, and so lies within an eighth of that of its chord.
    /// </summary>
    /// <param name="shapes">The pieces.</param>
    /// <param name="piece">The piece that moves, of which nothing counts but how far it reaches.</param>
    /// <param name="way">The way of its body.</param>
    /// <param name="other">The piece with edges; one without is never before an edge.</param>
    /// <param name="otherWay">The way of its body.</param>
    /// <param name="sin">Of the other body's angle, where the way begins and where it ends.</param>
    /// <param name="cos">Likewise.</param>
    /// <param name="gap">How far apart they must stay at least.</param>
    private static bool Holds(
        ShapeStore shapes, int piece, in BodyPath way, int other, in BodyPath otherWay, double* sin, double* cos, double gap)
    {
        ref Piece hull = ref shapes.Pieces[other];
        if (hull.VertexCount < 2)
        {
            return false;
        }

        double velocityX = way.VelocityX - otherWay.VelocityX;
        double velocityY = way.VelocityY - otherWay.VelocityY;
        double gainX = way.AccelerationX - otherWay.AccelerationX;
        double gainY = way.AccelerationY - otherWay.AccelerationY;
        double x = way.X - otherWay.X;
        double y = way.Y - otherWay.Y;
        double gain = Math.Abs(gainX) + Math.Abs(gainY);
        double speed = Math.Abs(velocityX) + Math.Abs(velocityY) + gain;
        double spin = Math.Abs(otherWay.Spin) + Math.Abs(otherWay.SpinGain);
        double bend = gain + (2 * spin * speed) + (((spin * spin) + Math.Abs(otherWay.SpinGain)) * (Math.Abs(x) + Math.Abs(y) + speed));
        double need = shapes.Pieces[piece].Reach + (double)hull.Radius + (0.125 * bend) + gap;

        double fromX = (cos[0] * x) + (sin[0] * y);
        double fromY = (cos[0] * y) - (sin[0] * x);
        x += velocityX + (0.5 * gainX);
        y += velocityY + (0.5 * gainY);
        double toX = (cos[1] * x) + (sin[1] * y);
        double toY = (cos[1] * y) - (sin[1] * x);
        Vector2* vertices = shapes.Vertices.Pointer + hull.VertexStart;
        Vector2* normals = shapes.Normals.Pointer + hull.VertexStart;
        for (int i = 0; i < hull.VertexCount; i++)
        {
            double nx = normals[i].X;
            double ny = normals[i].Y;
            double nearer = Math.Min((nx * fromX) + (ny * fromY), (nx * toX) + (ny * toY));
            if (nearer - ((nx * vertices[i].X) + (ny * vertices[i].Y)) > need)
            {
                return true;
            }
        }

        return false;
    }
}
