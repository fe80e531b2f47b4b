#if GUARDED
using System;
using System.Runtime.InteropServices;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Storage;

/// <summary>
/// What the guarded build finds. What goes far past an end stops the process, so that is asked of the system in place of being done.
/// </summary>
public sealed unsafe class MemoryGuardTests : IDisposable
{
    private readonly int* _pipe = (int*)Marshal.AllocHGlobal(2 * sizeof(int));

    public MemoryGuardTests()
    {
        Assert.Equal(0, Pipe(_pipe));
    }

    public void Dispose()
    {
        _ = Close(_pipe[0]);
        _ = Close(_pipe[1]);
        Marshal.FreeHGlobal((nint)_pipe);
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(-64)]
    [InlineData(5)]
    [InlineData(63)]
    public void WriteBesideAColumn_IsFoundAfterTheStep(int place)
    {
        // Five bytes leave 59 up to the page behind them, which starts at a multiple of 64.
        var column = new Column<byte>(5);
        byte before = column.Pointer[place];
        column.Pointer[place] ^= 1;

        Assert.Throws<MemoryFaultException>(() => MemoryGuard.Verify());
        column.Pointer[place] = before;
        MemoryGuard.Verify();
        GC.KeepAlive(column);
    }

    [Fact]
    public void WriteBesideAColumn_IsFoundWhenItGrows()
    {
        var column = new Column<int>(3);
        column.Pointer[3] ^= 1;

        Assert.Throws<MemoryFaultException>(() => column.EnsureCapacity(4));
        column.Pointer[3] ^= 1;
        column.EnsureCapacity(4);
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(7)]
    public void PlaceOutsideOfAColumn_IsRefused(int place)
    {
        var column = new Column<double>(7);

        Assert.Throws<MemoryFaultException>(() => column[place]);
    }

    [Fact]
    public void MemoryOfAColumn_EndsAtAPageThatNobodyMayTouch_AndIsGoneOnceItHasGrown()
    {
        var column = new Column<double>(1024);
        byte* old = (byte*)column.Pointer;
        int size = column.Capacity * sizeof(double);
        Assert.True(MayRead(old) && MayRead(old + size - 1));
        Assert.False(MayRead(old + size));

        column.EnsureCapacity(column.Capacity + 1);

        Assert.False(MayRead(old) || MayRead(old + size - 1));
        Assert.True(MayRead((byte*)column.Pointer));
        GC.KeepAlive(column);
    }

    [Fact]
    public void Scratch_IsSpoilt_AndAWriteBesideItIsFoundWhenItIsReleased()
    {
        var scratch = new Scratch();
        float* taken = scratch.Take<float>(3);
        Assert.True(taken[0] < -1e38f && taken[2] < -1e38f);
        taken[0] = 1;
        taken[3] = 1;

        Assert.Throws<MemoryFaultException>(() => scratch.Release(0));
    }

    [Fact]
    public void List_AskedBeyondItsCount_Refuses()
    {
        var list = new IndexList();
        list.Reserve(10);
        list.Add(1);

        Assert.Throws<MemoryFaultException>(() => list[1]);
    }

    /// <summary>The system copies from what may be read, and refuses the rest.</summary>
    private bool MayRead(byte* place) => Write(_pipe[1], place, 1) == 1;

    [DllImport("libc", EntryPoint = "pipe")]
    private static extern int Pipe(int* ends);

    [DllImport("libc", EntryPoint = "write")]
    private static extern nint Write(int file, byte* from, nint bytes);

    [DllImport("libc", EntryPoint = "close")]
    private static extern int Close(int file);
}
#endif
