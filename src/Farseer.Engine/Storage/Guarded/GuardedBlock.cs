using System;
using System.Runtime.InteropServices;

namespace Farseer.Engine.Storage;

/// <summary>Memory between two pages that nobody may touch; see <see cref="MemoryGuard"/>.</summary>
internal sealed unsafe class GuardedBlock
{
    private const int ReadAndWrite = 3;
    private const int Private = 2;
    private const int Fixed = 0x10;

    private static readonly int _anonymous = RuntimeInformation.IsOSPlatform(OSPlatform.OSX) ? 0x1000 : 0x20;

    private readonly byte* _pages;
    private readonly int _page;

    public GuardedBlock(long bytes, Type type, int page)
    {
        if (RuntimeInformation.IsOSPlatform(OSPlatform.Windows))
        {
            throw new PlatformNotSupportedException("The guarded build asks the system for pages as Unix gives them.");
        }

        _page = page;
        Type = type;
        long inner = Math.Max(page, (bytes + page - 1) / page * page);
        Length = inner + (2L * page);
        _pages = Map(null, (nuint)Length, 0, Private | _anonymous, -1, 0);
        if ((nint)_pages == -1 || Protect(_pages + page, (nuint)inner, ReadAndWrite) != 0)
        {
            throw new OutOfMemoryException($"No {Length} bytes for {type} could be had.");
        }

        SetBytes(bytes);
    }

    public Type Type { get; private set; }

    /// <summary>Where it is in the list of all blocks.</summary>
    public int Place { get; set; }

    /// <summary>Aligned for columns.</summary>
    public byte* Start { get; private set; }

    public long Bytes { get; private set; }

    /// <summary>Bytes of all its pages.</summary>
    public long Length { get; }

    /// <summary>Most bytes that it can have.</summary>
    public long Room => Length - (2L * _page);

    /// <summary>The first byte that can be touched, and the first behind that cannot.</summary>
    public byte* FirstByte => _pages + _page;

    public byte* EndOfPages => _pages + Length - _page;

    /// <summary>Puts so many bytes to its end.</summary>
    public void SetBytes(long bytes)
    {
        Bytes = bytes;
        Start = (byte*)((nuint)(EndOfPages - bytes) & ~(nuint)(MemoryGuard.Alignment - 1));
        MemoryGuard.Paint(this);
    }

    /// <summary>Puts so many bytes of other records to its end.</summary>
    public void SetBytes(long bytes, Type type)
    {
        Type = type;
        SetBytes(bytes);
    }

    /// <summary>Lets nobody touch it any more; the memory goes back, its place is kept.</summary>
    public void Close() => _ = Map(_pages, (nuint)Length, 0, Private | _anonymous | Fixed, -1, 0);

    /// <summary>Gives its place back.</summary>
    public void Release() => _ = Unmap(_pages, (nuint)Length);

    [DllImport("libc", EntryPoint = "mmap", SetLastError = true)]
    private static extern byte* Map(byte* start, nuint length, int protection, int flags, int file, nint offset);

    [DllImport("libc", EntryPoint = "mprotect", SetLastError = true)]
    private static extern int Protect(byte* start, nuint length, int protection);

    [DllImport("libc", EntryPoint = "munmap", SetLastError = true)]
    private static extern int Unmap(byte* start, nuint length);
}
