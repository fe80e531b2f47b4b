using System.Diagnostics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Shapes;

/// <summary>The colliders of each body, the last one first.</summary>
internal sealed class ColliderLists
{
    private readonly Column<int> _first = new Column<int>();
    private readonly Column<int> _next = new Column<int>();

    /// <summary>First collider of a body, -1: none.</summary>
    public int First(int body) => _first[body];

    /// <summary>The one after a collider, -1: none.</summary>
    public int Next(int collider) => _next[collider];

    public void EnsureBodies(int end) => _first.EnsureCapacity(end);

    public void EnsureColliders(int end) => _next.EnsureCapacity(end);

    /// <summary>A body is new and has none.</summary>
    public void Begin(int body) => _first[body] = -1;

    public void Add(int body, int collider)
    {
        _next[collider] = _first[body];
        _first[body] = collider;
    }

    public void Remove(int body, int collider)
    {
        if (_first[body] == collider)
        {
            _first[body] = _next[collider];
            return;
        }

        int at = _first[body];
        while (at >= 0 && _next[at] != collider)
        {
            at = _next[at];
        }

        Debug.Assert(at >= 0, "a collider is in the list of its body");
        if (at >= 0)
        {
            _next[at] = _next[collider];
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_first);
        s.Column(_next);
    }
}
