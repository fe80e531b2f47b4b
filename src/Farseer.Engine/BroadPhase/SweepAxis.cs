using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>
/// The box edges along one axis in ascending order: by value, at equal values the lower edges before the upper ones, then by
/// proxy. All three are packed into one number, so the order is total and no comparison can contradict another.
/// </summary>
internal sealed unsafe class SweepAxis
{
    private const ulong UpperEdge = 1UL << 31;

    private readonly Column<ulong> _edges = new Column<ulong>(1);
    private readonly RadixSort _sorter = new RadixSort();
    private readonly bool _vertical;

    public SweepAxis(bool vertical) => _vertical = vertical;

    public int Count { get; private set; }

    public ulong this[int index] => _edges[index];

    public static int Proxy(ulong edge) => (int)(edge & (UpperEdge - 1));

    public static bool IsUpper(ulong edge) => (edge & UpperEdge) != 0;

    /// <summary>Appends the two edges of a proxy; they are out of order until the next sort.</summary>
    public void Append(Box* boxes, int proxy)
    {
        _edges.EnsureCapacity(Count + 2);
        _edges[Count++] = Edge(boxes[proxy], proxy, upper: false);
        _edges[Count++] = Edge(boxes[proxy], proxy, upper: true);
    }

    /// <summary>Drops the edges of the given proxies; the order of the others stays.</summary>
    public void Drop(BitSet proxies)
    {
        int kept = 0;
        ulong* edges = _edges.Pointer;
        for (int i = 0; i < Count; i++)
        {
            if (!proxies.Test(Proxy(edges[i])))
            {
                edges[kept++] = edges[i];
            }
        }

        Count = kept;
    }

    /// <summary>Reads the new places of the moved boxes.</summary>
    public void Refresh(ProxyStore proxies)
    {
        Box* boxes = proxies.Fat.Pointer;
        ProxyInfo* info = proxies.Info.Pointer;
        ulong* edges = _edges.Pointer;
        for (int i = 0; i < Count; i++)
        {
            int proxy = Proxy(edges[i]);
            if ((info[proxy].Flags & ProxyFlags.Moved) != 0)
            {
                edges[i] = Edge(boxes[proxy], proxy, IsUpper(edges[i]));
            }
        }
    }

    public void SortAnew() => _sorter.Sort(_edges.Pointer, Count);

    /// <summary>
    /// Insertion sort, which exchanges exactly the edges that changed their order. A lower edge that comes to lie before an
    /// upper one may begin an overlap, an upper one before a lower one ends it. Returns false if it gave up after <paramref name="budget"/>
    /// exchanges.
    /// </summary>
    public bool SortStep(Box* boxes, PairSet pairs, long budget)
    {
        ulong* edges = _edges.Pointer;
        for (int i = 1; i < Count; i++)
        {
            ulong edge = edges[i];
            int j = i;
            for (; j > 0 && edges[j - 1] > edge; j--)
            {
                ulong passed = edges[j - 1];
                edges[j] = passed;
                if (((edge ^ passed) & UpperEdge) == 0)
                {
                    continue;
                }

                int a = Proxy(edge);
                int b = Proxy(passed);
                if (IsUpper(edge))
                {
                    pairs.Remove(PairBuffer.Pack(a, b));
                }
                else if (Box.Overlap(boxes[a], boxes[b]))
                {
                    pairs.Add(PairBuffer.Pack(a, b));
                }
            }

            edges[j] = edge;
            budget -= i - j;
            if (budget < 0)
            {
                return false;
            }
        }

        return true;
    }

    private ulong Edge(in Box box, int proxy, bool upper)
    {
        float value = upper ? (_vertical ? box.MaxY : box.MaxX) : (_vertical ? box.MinY : box.MinX);
        return ((ulong)RadixSort.OrderedBits(value) << 32) | (upper ? UpperEdge : 0) | (uint)proxy;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_edges);
        Count = s.Value(Count);
    }
}
