using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>
/// Knows whether nearly all boxes belong to one group that does not collide with itself: a cloth, a soft body. Then only the few others can
/// have pairs, and each box need be tested against these alone. A net of ten thousand discs otherwise spends half of its step on
/// finding pairs of neighbours that are then refused.
/// </summary>
internal sealed unsafe class MainGroup
{
    /// <summary>Fewer boxes are sorted in no time.</summary>
    private const int LeastBoxes = 4 * FewSeekers.Most;

    private readonly IndexList _all = new IndexList();
    private bool _any;
    private bool _isOld;

    /// <summary>The group, or 0 if there is none with so few others that these are tested against all.</summary>
    public int Group { get; private set; }

    /// <summary>All live boxes, while there is such a group.</summary>
    public IndexList All => _all;

    /// <summary>A box came, went, or changed its group.</summary>
    public void Change(in ProxyInfo info)
    {
        _any |= info.Group != 0;
        _isOld = true;
    }

    /// <summary>Finds the group anew if boxes have changed.</summary>
    public void Find(ProxyStore proxies)
    {
        if (!_isOld || !_any)
        {
            return;
        }

        _isOld = false;
        _all.Clear();
        ProxyInfo* info = proxies.Info.Pointer;
        int candidate = Majority(info, proxies.End);
        int others = 0;
        for (int i = 0; i < proxies.End; i++)
        {
            if ((info[i].Flags & ProxyFlags.Alive) != 0)
            {
                _all.Add(i);
                others += info[i].Group != candidate ? 1 : 0;
            }
        }

        Group = others <= FewSeekers.Most && _all.Count >= LeastBoxes ? candidate : 0;
    }

    /// <summary>The group of more than half of the live boxes, if there is one; else any.</summary>
    private static int Majority(ProxyInfo* info, int end)
    {
        int candidate = 0;
        int lead = 0;
        for (int i = 0; i < end; i++)
        {
            if ((info[i].Flags & ProxyFlags.Alive) == 0)
            {
                continue;
            }

            if (lead == 0)
            {
                candidate = info[i].Group;
            }

            lead += info[i].Group == candidate ? 1 : -1;
        }

        return candidate;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        _all.Visit(s);
        s.Value(ref _any);
        s.Value(ref _isOld);
        Group = s.Value(Group);
    }
}
