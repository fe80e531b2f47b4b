namespace Farseer.Engine.Storage;

/// <summary>Marks of a byte each, which workers may write beside each other, and of which few are set.</summary>
internal static unsafe class ByteMarks
{
    /// <summary>The first mark of a range that is not 0, or <paramref name="to"/>.</summary>
    public static int Next(byte* marks, int from, int to)
    {
        while (from < to && marks[from] == 0)
        {
            from += from + sizeof(ulong) <= to && *(ulong*)(marks + from) == 0 ? sizeof(ulong) : 1;
        }

        return from;
    }
}
