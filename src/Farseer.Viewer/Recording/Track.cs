using System;
using System.Collections.Generic;

namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>
/// Numbers of things that come and go, by frame: each thing has a slot, each slot a number in each column. What is written last of a
/// slot stays until it is written again, so a thing that does nothing costs nothing.
/// </summary>
internal sealed class Track
{
    private readonly List<double[]> _rows = new List<double[]>();
    private readonly double[] _least;
    private readonly double[] _most;
    private double[] _row = Array.Empty<double>();

    public Track(string name, params ColumnSpec[] columns)
    {
        Name = name;
        Columns = columns;
        _least = new double[columns.Length];
        _most = new double[columns.Length];
        for (int c = 0; c < columns.Length; c++)
        {
            _least[c] = double.PositiveInfinity;
            _most[c] = double.NegativeInfinity;
        }
    }

    public string Name { get; }

    public ColumnSpec[] Columns { get; }

    public List<PackedChunk> Chunks { get; } = new List<PackedChunk>();

    public int Slots { get; private set; }

    /// <summary>Frames since the last chunk.</summary>
    public int Frames => _rows.Count;

    public double Least(int column) => _least[column] <= _most[column] ? _least[column] : 0;

    public double Most(int column) => _least[column] <= _most[column] ? _most[column] : 0;

    /// <summary>A frame begins: with the numbers of the last one.</summary>
    public void Begin(int slots)
    {
        Slots = Math.Max(Slots, slots);
        double[] row = new double[Slots * Columns.Length];
        Array.Copy(_row, row, Math.Min(_row.Length, row.Length));
        _row = row;
        _rows.Add(row);
    }

    /// <summary>Room for one more slot in the frame that has begun.</summary>
    public void Grow(int slots)
    {
        if (slots <= Slots)
        {
            return;
        }

        Slots = slots;
        if (_row.Length < slots * Columns.Length)
        {
            Array.Resize(ref _row, Math.Max(slots, Slots + (Slots / 2)) * Columns.Length);
            _rows[_rows.Count - 1] = _row;
        }
    }

    public void Set(int slot, int column, double value)
    {
        _row[(slot * Columns.Length) + column] = value;
        if (value < _least[column] && !double.IsNegativeInfinity(value))
        {
            _least[column] = value;
        }

        if (value > _most[column] && !double.IsPositiveInfinity(value))
        {
            _most[column] = value;
        }
    }

    public void Clear(int column)
    {
        for (int slot = 0; slot < Slots; slot++)
        {
            _row[(slot * Columns.Length) + column] = 0;
        }
    }

    /// <summary>Packs the frames since the last chunk.</summary>
    /// <param name="first">The frame that they began with.</param>
    /// <param name="keepSlots">False: the next chunk gives out its slots anew.</param>
    public void Pack(int first, bool keepSlots)
    {
        byte[][] packed = new byte[Columns.Length][];
        for (int c = 0; c < Columns.Length; c++)
        {
            packed[c] = ColumnCodec.Encode(Columns[c].Kind, Gather(c), Slots);
        }

        Chunks.Add(new PackedChunk(this, first, _rows.Count, Slots, packed));
        _rows.Clear();
        if (!keepSlots)
        {
            _row = Array.Empty<double>();
            Slots = 0;
        }
    }

    private double[] Gather(int column)
    {
        double[] values = new double[_rows.Count * Slots];
        for (int f = 0; f < _rows.Count; f++)
        {
            double[] row = _rows[f];
            int own = Math.Min(Slots, row.Length / Columns.Length);
            for (int s = 0; s < own; s++)
            {
                values[(f * Slots) + s] = row[(s * Columns.Length) + column];
            }
        }

        return values;
    }
}
