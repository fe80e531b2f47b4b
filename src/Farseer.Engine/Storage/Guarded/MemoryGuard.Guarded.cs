using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;

namespace Farseer.Engine.Storage;

/// <content>
/// Blocks of memory between pages that nobody may touch. A block ends where such a page begins, up to the alignment of columns: what goes
/// past its end stops there, with the stack that did it. What fits into the rest, and what lies before the block, is a red zone, which is
/// looked at when the block is given back and at the end of each step. A block that was given back becomes pages that nobody may touch.
/// </content>
internal static unsafe partial class MemoryGuard
{
    public const int Alignment = 64;

    /// <summary>Undefined content: as a float or double a number of 10³⁸ or 10³⁰³ below 0, as an index out of every range.</summary>
    private const byte Spoilt = 0xFE;
    private const byte RedZone = 0xFD;
    private const ulong RedZones = 0xFDFDFDFDFDFDFDFD;

    /// <summary>Bytes of the red zone before a block that are looked at.</summary>
    private const int Watched = 256;

    /// <summary>A multiple of all usual sizes of a page.</summary>
    private const int Page = 1 << 14;

    /// <summary>Blocks that were given back stay where they are until there are so many, or so many bytes, of them.</summary>
    private const int MostReturned = 4096;
    private const long MostReturnedBytes = 1L << 32;

    /// <summary>Blocks that nobody has any longer are looked for when there are so many more.</summary>
    private const int CollectEvery = 8192;

    /// <summary>Blocks that are looked at after a step: all of a few worlds, and of many worlds by turns.</summary>
    private const int MostVerified = 4096;

    private static readonly object _lock = new object();
    private static readonly List<GuardedBlock> _blocks = new List<GuardedBlock>();
    private static readonly Queue<GuardedBlock> _returned = new Queue<GuardedBlock>();
    private static long _returnedBytes;
    private static int _collectAt = CollectEvery;
    private static int _next;

    /// <summary>A block of so many bytes, which are zero, and which is looked at after each step.</summary>
    public static GuardedBlock Take(long bytes, Type type)
    {
        bool collect;
        GuardedBlock block;
        lock (_lock)
        {
            block = new GuardedBlock(bytes, type, Page);
            block.Place = _blocks.Count;
            _blocks.Add(block);
            collect = _blocks.Count >= _collectAt;
            _collectAt = collect ? _blocks.Count + CollectEvery : _collectAt;
        }

        if (collect)
        {
            // Blocks know nothing of the collector, and the collector nothing of them.
            GC.Collect();
            GC.WaitForPendingFinalizers();
            lock (_lock)
            {
                _collectAt = _blocks.Count + CollectEvery;
            }
        }

        return block;
    }

    /// <summary>Takes a block back. It must not be touched again.</summary>
    /// <param name="block">The block.</param>
    /// <param name="check">Its red zones are looked at.</param>
    public static void Return(GuardedBlock block, bool check)
    {
        lock (_lock)
        {
            if (check)
            {
                Check(block);
            }

            GuardedBlock last = _blocks[_blocks.Count - 1];
            _blocks[block.Place] = last;
            last.Place = block.Place;
            _blocks.RemoveAt(_blocks.Count - 1);
            block.Close();
            _returned.Enqueue(block);
            _returnedBytes += block.Length;
            while (_returned.Count > MostReturned || _returnedBytes > MostReturnedBytes)
            {
                GuardedBlock oldest = _returned.Dequeue();
                _returnedBytes -= oldest.Length;
                oldest.Release();
            }
        }
    }

    /// <summary>A block that is looked at by whoever takes it, and by nobody else.</summary>
    public static GuardedBlock TakeUnlisted(long bytes, Type type) => new GuardedBlock(bytes, type, Page);

    /// <summary>Throws if the red zones of a block were written.</summary>
    public static void Check(GuardedBlock block)
    {
        byte* end = block.Start + block.Bytes;
        byte* first = block.FirstByte;
        byte* from = block.Start - first > Watched ? block.Start - Watched : first;
        CheckZone(block, from, block.Start);
        CheckZone(block, end, block.EndOfPages);
    }

    /// <summary>Writes the red zones of a block.</summary>
    public static void Paint(GuardedBlock block)
    {
        byte* from = block.Start - block.FirstByte > Watched ? block.Start - Watched : block.FirstByte;
        Fill(from, block.Start - from, RedZone);
        byte* end = block.Start + block.Bytes;
        Fill(end, block.EndOfPages - end, RedZone);
    }

    static partial void VerifyBlocks()
    {
        lock (_lock)
        {
            for (int count = Math.Min(_blocks.Count, MostVerified); count > 0; count--)
            {
                _next = _next < _blocks.Count - 1 ? _next + 1 : 0;
                Check(_blocks[_next]);
            }
        }
    }

    static unsafe partial void SpoilBytes(byte* start, long bytes) => Fill(start, bytes, Spoilt);

    private static void CheckZone(GuardedBlock block, byte* from, byte* to)
    {
        // Eight at a time, as long as nothing is found.
        byte* at = from;
        for (; at + sizeof(ulong) <= to && Unsafe.ReadUnaligned<ulong>(at) == RedZones; at += sizeof(ulong))
        {
        }

        for (; at < to; at++)
        {
            if (*at != RedZone)
            {
                throw new MemoryFaultException(
                    $"Memory beside {block.Bytes} bytes of {block.Type} was written, at {at - block.Start} bytes from their start.");
            }
        }
    }

    private static void Fill(byte* start, long bytes, byte value)
    {
        Unsafe.InitBlock(start, value, checked((uint)bytes));
    }
}
