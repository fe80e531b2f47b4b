using Farseer.Engine.Storage;

namespace Farseer.Engine.Accuracy;

/// <summary>Bodies that touch or are joined, as sets, and whether something fixed holds the set.</summary>
[NotState(Why.OfOneStep)]
internal sealed class BodyGroups
{
    private readonly Column<int> _parent = new Column<int>();
    private readonly Column<int> _size = new Column<int>();
    private readonly Column<byte> _held = new Column<byte>();

    public void Begin(int bodyEnd)
    {
        _parent.EnsureCapacity(bodyEnd);
        _size.EnsureCapacity(bodyEnd);
        _held.EnsureCapacity(bodyEnd);
        for (int i = 0; i < bodyEnd; i++)
        {
            _parent[i] = i;
            _size[i] = 1;
            _held[i] = 0;
        }
    }

    /// <summary>The body that stands for the group.</summary>
    public int Of(int body)
    {
        while (_parent[body] != body)
        {
            _parent[body] = _parent[_parent[body]];
            body = _parent[body];
        }

        return body;
    }

    public int Size(int body) => _size[Of(body)];

    /// <summary>Something that cannot be moved touches or holds the group.</summary>
    public bool IsHeld(int body) => _held[Of(body)] != 0;

    public void Hold(int body) => _held[Of(body)] = 1;

    public void Join(int a, int b)
    {
        int low = Of(a);
        int high = Of(b);
        if (low == high)
        {
            return;
        }

        // The lower body stands for both: the same groups whatever the order in which the pairs came.
        if (low > high)
        {
            (low, high) = (high, low);
        }

        _parent[high] = low;
        _size[low] += _size[high];
        _held[low] |= _held[high];
    }
}
