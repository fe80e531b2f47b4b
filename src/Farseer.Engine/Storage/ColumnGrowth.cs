using System;

namespace Farseer.Engine.Storage;

/// <summary>
/// How large a column becomes that is full: twice as large while it is small, a quarter larger beyond. Doubling alone left a third of the
/// memory of a large world unused on average, and the moves are few against the work that fills a large column.
/// </summary>
internal static class ColumnGrowth
{
    /// <summary>
    /// A column begins with so many records, or with fewer if they would take more than <see cref="LeastBytes"/>: what comes and goes by
    /// ones is not to make it grow late, time and again.
    /// </summary>
    private const int Least = 16;
    private const int LeastBytes = 1 << 10;

    /// <summary>Bytes of a column that is large.</summary>
    private const int Large = 1 << 14;

    /// <param name="capacity">Records that there is room for.</param>
    /// <param name="needed">Records for which there must be room.</param>
    /// <param name="size">Bytes a record.</param>
    public static int Next(int capacity, int needed, int size)
    {
        int grown = capacity < Large / size ? capacity * 2 : capacity + (capacity / 4);
        int least = Math.Min(Least, Math.Max(1, LeastBytes / size));
        return Math.Max(needed, Math.Max(least, grown));
    }
}
