namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>How the numbers of a column are kept.</summary>
internal enum ColumnKind
{
    /// <summary>All 64 bits of a double.</summary>
    Double,

    /// <summary>All 32 bits of a float.</summary>
    Single,

    /// <summary>A whole number of 32 bits.</summary>
    Integer,

    /// <summary>A whole number from 0 to 255.</summary>
    Byte,
}
