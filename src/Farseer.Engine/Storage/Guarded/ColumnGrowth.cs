using System;

namespace Farseer.Engine.Storage;

/// <summary>
/// A guarded column has room for what was asked for and for no more, so that it moves often and ends where what is used ends.
/// </summary>
internal static class ColumnGrowth
{
    /// <summary>From so many records on there is a part to spare: growing one by one takes the square of the time.</summary>
    private const int Many = 256;
    private const int Parts = 16;

    /// <param name="capacity">Records that there is room for.</param>
    /// <param name="needed">Records for which there must be room.</param>
    /// <param name="size">Bytes a record.</param>
    public static int Next(int capacity, int needed, int size)
    {
        _ = size;
        return capacity < Many ? needed : Math.Max(needed, capacity + (capacity / Parts));
    }
}
