using System;
using System.Collections.Generic;

namespace Farseer.Engine.Storage;

/// <summary>Hands out slot indices with generations; freed slots are reused last in, first out, so runs repeat exactly.</summary>
internal sealed class IdPool
{
    private readonly List<uint> _generations = new List<uint>();
    private readonly List<int> _free = new List<int>();

    /// <summary>One past the highest slot ever used.</summary>
    public int End => _generations.Count;

    public int Count => _generations.Count - _free.Count;

    /// <summary>One past the highest slot in use once so many more are taken. Room for them is made now if they are many.</summary>
    public int EndAfter(int more)
    {
        int end = Math.Max(End, Count + more);
        if (end > _generations.Capacity && end - End > End)
        {
            _generations.Capacity = end;
        }

        return end;
    }

    public Handle Take()
    {
        if (_free.Count > 0)
        {
            int index = _free[_free.Count - 1];
            _free.RemoveAt(_free.Count - 1);
            _generations[index]++;
            return new Handle(index, _generations[index]);
        }

        _generations.Add(1);
        return new Handle(_generations.Count - 1, 1);
    }

    /// <summary>Frees the slot; its generation turns odd-to-even so that old handles are seen to be dead.</summary>
    public void Return(Handle handle)
    {
        System.Diagnostics.Debug.Assert(IsLive(handle), "returning a dead handle");
        _generations[handle.Index]++;
        _free.Add(handle.Index);
    }

    /// <summary>The present handle of a slot in use.</summary>
    public Handle HandleOf(int index) => new Handle(index, _generations[index]);

    public bool IsLive(Handle handle) =>
        handle.Generation != 0 && (uint)handle.Index < (uint)_generations.Count && _generations[handle.Index] == handle.Generation;

    /// <exception cref="ArgumentException">The handle names nothing that is there.</exception>
    public void Require(Handle handle, string name)
    {
        if (!IsLive(handle))
        {
            throw new ArgumentException($"The handle {handle.Index}/{handle.Generation} names nothing in this world.", name);
        }
    }

    /// <summary>True if the slot is in use: generations of live slots are odd, of freed ones even.</summary>
    public bool IsUsed(int index) => (_generations[index] & 1) == 1;

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.List(_generations);
        s.List(_free);
    }
}
