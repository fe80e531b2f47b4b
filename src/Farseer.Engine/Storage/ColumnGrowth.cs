using System;

namespace Farseer.Engine.Storage;

/// <summary>
/// How large a column becomes that is full: twice as large while it is small, a quarter larger beyond. Doubling alone left a third of the
/// memory of a large world unused on average, and the moves are few against the work that fills a large column.
/// </summary>
internal static class ColumnGrowth
{
    /// <summary>A column begins with as many records as fit, or with one: there are hundreds, and most of a small world have few records or none.</summary>
    private const int LeastBytes = 64;

    /// <summary>Bytes of a column that is large.</summary>
    private const int Large = 1 << 14;

    /// <param name="capacity">Records that there is room for.</param>
    /// <param name="needed">Records for which there must be room.</param>
    /// <param name="size">Bytes a record.</param>
    public static int Next(int capacity, int needed, int size)
    {
        int grown = capacity < Large / size ? capacity * 2 : capacity + (capacity / 4);
        return Math.Max(needed, Math.Max(LeastBytes / size, grown));
    }
}
