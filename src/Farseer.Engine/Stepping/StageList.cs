using System;
using System.Threading;

namespace Farseer.Engine.Stepping;

/// <summary>
/// How large the phases of a row are, for <see cref="StageRunner.RunAll"/>: known before, so that workers need not be told from one to the
/// next.
/// </summary>
internal sealed class StageList
{
    private const int BlockBits = 16;
    private const int MiddleBits = 24;
    private long[] _sizes = Array.Empty<long>();

    public int Count { get; private set; }

    public void Clear() => Count = 0;

    /// <summary>Makes room for so many phases.</summary>
    public void Reserve(int stages)
    {
        if (stages > _sizes.Length)
        {
            Array.Resize(ref _sizes, Math.Max(stages, 2 * _sizes.Length));
        }
    }

    /// <param name="items">At least 1, below 16 million.</param>
    /// <param name="blocks">Into how many it is cut; see <see cref="StageRunner.BlocksOf"/>.</param>
    public void Add(int items, int blocks) => Add(items, blocks, items / 2);

    /// <param name="items">At least 1, below 16 million.</param>
    /// <param name="blocks">Into how many it is cut; see <see cref="StageRunner.BlocksOf"/>.</param>
    /// <param name="middle">Items of the first half of the blocks.</param>
    public void Add(int items, int blocks, int middle)
    {
        Reserve(Count + 1);
        Volatile.Write(ref _sizes[Count++], ((long)items << MiddleBits << BlockBits) | ((long)middle << BlockBits) | (uint)blocks);
    }

    /// <summary>Reads a phase, on any thread at any time: who comes too late reads another one, or none.</summary>
    public bool TryRead(int stage, out int items, out int middle, out int blocks)
    {
        long[] sizes = _sizes;
        long size = stage < sizes.Length ? Volatile.Read(ref sizes[stage]) : 0;
        items = (int)(size >> MiddleBits >> BlockBits);
        middle = (int)(size >> BlockBits) & ((1 << MiddleBits) - 1);
        blocks = (int)size & ((1 << BlockBits) - 1);
        return blocks > 0;
    }
}
