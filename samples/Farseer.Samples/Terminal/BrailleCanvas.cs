using System;
using System.Text;

namespace Farseer.Samples.Terminal;

/// <summary>A picture of dots, 2 by 4 in each character cell (Unicode braille), one colour a cell.</summary>
internal sealed class BrailleCanvas
{
    private const char Blank = '\u2800';

    /// <summary>Bit of a dot in its character, by row and column: the standard numbers the lowest row last.</summary>
    private static readonly byte[] _bits = [0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80];
    private byte[] _dots = [];
    private byte[] _colors = [];
    private byte[] _ranks = [];

    public int Columns { get; private set; }

    public int Rows { get; private set; }

    public int Width => Columns * 2;

    public int Height => Rows * 4;

    /// <summary>Empties the picture and gives it the size of so many characters.</summary>
    public void Reset(int columns, int rows)
    {
        Columns = columns;
        Rows = rows;
        int cells = columns * rows;
        if (_dots.Length < cells)
        {
            _dots = new byte[cells];
            _colors = new byte[cells];
            _ranks = new byte[cells];
        }

        Array.Clear(_dots);
        Array.Clear(_ranks);
    }

    /// <summary>Where two colours meet in a cell, the one of the higher rank shows.</summary>
    public void Dot(int x, int y, byte color, byte rank)
    {
        if ((uint)x >= (uint)Width || (uint)y >= (uint)Height)
        {
            return;
        }

        int cell = ((y >> 2) * Columns) + (x >> 1);
        _dots[cell] |= _bits[((y & 3) << 1) | (x & 1)];
        if (rank >= _ranks[cell])
        {
            _ranks[cell] = rank;
            _colors[cell] = color;
        }
    }

    /// <summary>A line between two points in dots; what lies outside the picture is cut off first.</summary>
    public void Line(double x0, double y0, double x1, double y1, byte color, byte rank)
    {
        if (!Clip(ref x0, ref y0, ref x1, ref y1))
        {
            return;
        }

        int steps = (int)Math.Ceiling(Math.Max(Math.Abs(x1 - x0), Math.Abs(y1 - y0)));
        for (int i = 0; i <= steps; i++)
        {
            double t = steps == 0 ? 0.0 : (double)i / steps;
            Dot((int)Math.Floor(x0 + (t * (x1 - x0))), (int)Math.Floor(y0 + (t * (y1 - y0))), color, rank);
        }
    }

    /// <summary>Appends one row of characters; a colour is named only where it changes.</summary>
    public void AppendRow(StringBuilder text, int row, bool colored)
    {
        int current = -1;
        for (int column = 0; column < Columns; column++)
        {
            int cell = (row * Columns) + column;
            if (_dots[cell] == 0)
            {
                text.Append(' ');
                continue;
            }

            if (colored && _colors[cell] != current)
            {
                current = _colors[cell];
                Ansi.AppendColor(text, (byte)current);
            }

            text.Append((char)(Blank + _dots[cell]));
        }

        if (current >= 0)
        {
            text.Append(Ansi.Plain);
        }
    }

    /// <summary>Liang and Barsky: the part of the line whose parameter lies between the crossings of the four borders.</summary>
    private bool Clip(ref double x0, ref double y0, ref double x1, ref double y1)
    {
        double dx = x1 - x0;
        double dy = y1 - y0;
        double from = 0.0;
        double to = 1.0;
        bool visible = Cut(-dx, x0, ref from, ref to) && Cut(dx, Width - x0, ref from, ref to)
            && Cut(-dy, y0, ref from, ref to) && Cut(dy, Height - y0, ref from, ref to);
        if (!visible)
        {
            return false;
        }

        x1 = x0 + (to * dx);
        y1 = y0 + (to * dy);
        x0 += from * dx;
        y0 += from * dy;
        return true;
    }

    private static bool Cut(double direction, double distance, ref double from, ref double to)
    {
        if (direction == 0.0)
        {
            return distance >= 0.0;
        }

        double t = distance / direction;
        if (direction < 0.0)
        {
            from = Math.Max(from, t);
        }
        else
        {
            to = Math.Min(to, t);
        }

        // False also for NaN, so that a body gone astray is not drawn at all.
        return from <= to;
    }
}
