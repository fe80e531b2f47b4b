namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>How many digits of a column are kept where a file with all bits would be too large.</summary>
internal enum Digits
{
    /// <summary>All bits in any case: flags and whole numbers.</summary>
    All,

    /// <summary>Places: of the size of the scene.</summary>
    Place,

    /// <summary>Depths and speeds: the same, a second for speeds, but without a steady motion.</summary>
    Length,

    /// <summary>Angles in radians: decimals.</summary>
    Angle,

    /// <summary>Angles a second: decimals.</summary>
    Spin,

    /// <summary>Parts of unit vectors: fewer decimals.</summary>
    Direction,

    /// <summary>Impulses and forces: of the largest.</summary>
    Size,
}

/// <summary>A column of a track: its name in the file and how it is kept.</summary>
internal readonly struct ColumnSpec
{
    public ColumnSpec(string name, ColumnKind kind, Digits digits = Digits.All)
    {
        Name = name;
        Kind = kind;
        Digits = digits;
    }

    public string Name { get; }

    public ColumnKind Kind { get; }

    public Digits Digits { get; }
}
