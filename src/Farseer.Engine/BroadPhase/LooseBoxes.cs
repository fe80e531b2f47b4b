using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>Boxes that came after a tree was built: few, and looked at one by one, eight at a time.</summary>
internal sealed class LooseBoxes
{
    private readonly BoxRows _rows = new BoxRows();
    private readonly IndexList _proxies = new IndexList();

    public int Count => _proxies.Count;

    public WideBoxes Boxes => _rows.Wide;

    public int Proxy(int place) => _proxies[place];

    /// <summary>Makes room for so many boxes.</summary>
    public void Reserve(int count)
    {
        _proxies.Reserve(count);
        _rows.EnsureCapacity(count);
    }

    public void Clear()
    {
        _proxies.Clear();
        _rows.SetCount(0);
    }

    /// <returns>The place of the new box.</returns>
    public int Add(int proxy, in Box box)
    {
        _proxies.Add(proxy);
        _rows.SetCount(_proxies.Count);
        _rows.Wide.Set(_proxies.Count - 1, box);
        return _proxies.Count - 1;
    }

    public void Change(int place, in Box box) => _rows.Wide.Set(place, box);

    /// <summary>Removes a box; the last one takes its place.</summary>
    /// <returns>The proxy that moved to <paramref name="place"/>, or -1.</returns>
    public unsafe int Remove(int place)
    {
        int last = _proxies.Count - 1;
        int moved = -1;
        if (place != last)
        {
            moved = _proxies[last];
            _proxies.Pointer[place] = moved;
            _rows.Wide.Set(place, _rows.Wide.Get(last));
        }

        _proxies.SetCount(last);
        _rows.SetCount(last);
        return moved;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        _rows.Visit(s);
        _proxies.Visit(s);
    }
}
