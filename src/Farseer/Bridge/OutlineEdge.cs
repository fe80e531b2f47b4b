using System;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>A straight side of an outline, or an arc of less than half a turn in the positive sense.</summary>
internal struct OutlineEdge
{
    public double X;
    public double Y;
    public double EndX;
    public double EndY;

    /// <summary>Centre of the arc.</summary>
    public double CentreX;
    public double CentreY;

    /// <summary>0: straight.</summary>
    public double Radius;

    public static OutlineEdge Line(double x, double y, double endX, double endY)
    {
        OutlineEdge edge = default;
        edge.X = x;
        edge.Y = y;
        edge.EndX = endX;
        edge.EndY = endY;
        return edge;
    }

    /// <summary>The part of the edge between two points of it.</summary>
    public readonly OutlineEdge Piece(double x, double y, double endX, double endY)
    {
        OutlineEdge piece = this;
        piece.X = x;
        piece.Y = y;
        piece.EndX = endX;
        piece.EndY = endY;
        return piece;
    }

    /// <summary>The point of the edge midway between its ends.</summary>
    public readonly void Middle(out double x, out double y)
    {
        double chordX = EndX - X;
        double chordY = EndY - Y;
        double chord = Math.Sqrt((chordX * chordX) + (chordY * chordY));
        bool isArc = Radius > 0 && chord > 0;
        x = isArc ? CentreX + (Radius * chordY / chord) : 0.5 * (X + EndX);
        y = isArc ? CentreY - (Radius * chordX / chord) : 0.5 * (Y + EndY);
    }
}
