using System;

namespace Farseer.Engine.Storage;

/// <summary>
/// A part of a whole state in memory of its own: a column, or some items of a list. It may grow without moving another one. What lies
/// behind its end is left open.
/// </summary>
internal sealed unsafe class StateSection
{
    /// <summary>Bytes behind the end that those who change a block at once may write to.</summary>
    public const int Behind = 64;

    private readonly Column<byte> _bytes = new Column<byte>();
    private object?[] _objects = Array.Empty<object?>();

    // The memory of a copy that is not needed any more: it is as large as this one's.
    private StateSection? _spare;

    /// <summary>
    /// Whose it is; null: it is told by its place among the others. With <see cref="Number"/> it is found again in the next frame.
    /// </summary>
    public object? Owner { get; set; }

    /// <summary>Which of the owner's it is.</summary>
    public int Number { get; set; }

    /// <summary>Bytes that it has.</summary>
    public int Length { get; set; }

    /// <summary>References that it has; behind them is unused room, which is null.</summary>
    public int ObjectCount { get; private set; }

    /// <summary>Another state has it as well: it is not to be changed.</summary>
    public bool IsShared { get; set; }

    /// <summary>What it is a changed copy of; null: it is none.</summary>
    public StateSection? Original { get; private set; }

    public byte* Bytes => _bytes.Pointer;

    public object?[] Objects => _objects;

    public bool Is(object? owner, int number) => ReferenceEquals(Owner, owner) && Number == number;

    public void EnsureBytes(int count) => _bytes.EnsureCapacity(checked(count + Behind));

    public void EnsureObjects(int count)
    {
        if (count > _objects.Length)
        {
            Array.Resize(ref _objects, Math.Max(count, _objects.Length * 2));
        }
    }

    /// <summary>Has so many references from now on: nothing is kept alive that is not part of the state.</summary>
    /// <param name="count">How many.</param>
    /// <param name="used">Behind so many all are null already.</param>
    public void CutObjects(int count, int used)
    {
        if (used > count)
        {
            Array.Clear(_objects, count, used - count);
        }

        ObjectCount = count;
    }

    /// <summary>Has so many bytes from now on; those that come to it are zero.</summary>
    public void Resize(int length)
    {
        EnsureBytes(length);
        if (length > Length)
        {
            StateBlock.Clear(Bytes + Length, length - Length);
        }

        Length = length;
    }

    /// <summary>A copy that may be changed.</summary>
    public StateSection Copied()
    {
        StateSection copy = _spare ?? new StateSection();
        _spare = null;
        copy.Original = this;
        copy.Owner = Owner;
        copy.Number = Number;
        copy.Length = Length;
        copy.EnsureBytes(Length);
        StateBlock.Copy(Bytes, copy.Bytes, Length);
        copy.EnsureObjects(ObjectCount);
        Array.Copy(_objects, copy._objects, ObjectCount);
        copy.ObjectCount = ObjectCount;
        return copy;
    }

    /// <summary>Takes the place of its original, and keeps that one's memory.</summary>
    public void Replace()
    {
        StateSection original = Original!;
        Original = null;
        original.Forget();
        _spare = original;
    }

    /// <summary>Its original stays, and keeps the memory of this one.</summary>
    public void GiveUp()
    {
        StateSection original = Original!;
        Forget();
        original._spare = this;
    }

    /// <summary>Holds nothing any more but its memory.</summary>
    public void Forget()
    {
        CutObjects(0, ObjectCount);
        Owner = null;
        Number = 0;
        Length = 0;
        IsShared = false;
        Original = null;
    }
}
