using System;

namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>Some frames of a track, packed with all bits.</summary>
internal sealed class PackedChunk
{
    private readonly Track _track;
    private readonly byte[][] _packed;

    public PackedChunk(Track track, int first, int frames, int slots, byte[][] packed)
    {
        _track = track;
        First = first;
        Frames = frames;
        Slots = slots;
        _packed = packed;
    }

    public int First { get; }

    public int Frames { get; }

    public int Slots { get; }

    public long Bytes
    {
        get
        {
            long sum = 0;
            foreach (byte[] column in _packed)
            {
                sum += column.Length;
            }

            return sum;
        }
    }

    public byte[] Packed(int column) => _packed[column];

    /// <summary>Frame after frame, slot after slot.</summary>
    public double[] Values(int column) => ColumnCodec.Decode(_track.Columns[column].Kind, _packed[column], Slots, Frames * Slots);

    /// <summary>The column with so many digits of a scene of that size.</summary>
    public byte[] Rounded(int column, int digits, double sceneSize)
    {
        ColumnSpec spec = _track.Columns[column];
        return spec.Digits == Digits.All
            ? _packed[column]
            : ColumnCodec.EncodeDecimals(Values(column), Slots, RoundingOf(_track, column, digits, sceneSize), IsSteady(spec));
    }

    public static bool IsSteady(in ColumnSpec spec) => spec.Digits is Digits.Place or Digits.Angle;

    public static ColumnCodec.Rounding RoundingOf(Track track, int column, int digits, double sceneSize)
    {
        double least = track.Least(column);
        double most = track.Most(column);
        double size = track.Columns[column].Digits switch
        {
            Digits.Place or Digits.Length => sceneSize / 10,
            Digits.Angle => 1,
            Digits.Spin => 10,
            Digits.Direction => 100,
            _ => Math.Max(Math.Abs(least), Math.Abs(most)),
        };
        int lead = size > 0 ? (int)Math.Ceiling(Math.Log10(size)) : 0;
        return new ColumnCodec.Rounding(digits - lead, least, most);
    }
}
