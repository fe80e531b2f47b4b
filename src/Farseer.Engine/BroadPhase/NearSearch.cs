using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>
/// Walks a <see cref="PackedTree"/>, and the boxes that are not in it yet, towards the nearest answer: groups that can hold a near one
/// come first, and those that cannot hold a better one than is known are left out.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class NearSearch<TProbe>
    where TProbe : struct, IBoxProbe
{
    private const int LayerOfProxy = -1;
    private const int LayerOfLoose = -2;

    private readonly Column<Waiting> _stack = new Column<Waiting>();
    private readonly Column<float> _nearest = new Column<float>();
    private PackedTree _tree = null!;
    private LooseBoxes _loose = null!;
    private TProbe _probe;
    private int _depth;

    public void Begin(PackedTree tree, LooseBoxes loose, in TProbe probe)
    {
        _tree = tree;
        _loose = loose;
        _probe = probe;
        _depth = 0;
        int groups = (loose.Count + WideBoxes.Width - 1) / WideBoxes.Width;
        _stack.EnsureCapacity(groups + PackedTree.MostWaiting);
        _nearest.EnsureCapacity(WideBoxes.Width);
        for (int group = groups - 1; group >= 0; group--)
        {
            _stack[_depth++] = new Waiting { Layer = LayerOfLoose, Index = group };
        }

        if (tree.Count > 0)
        {
            _stack[_depth++] = new Waiting { Layer = tree.TopLayer };
        }
    }

    /// <summary>The next proxy whose box may hold an answer not beyond <paramref name="limit"/>.</summary>
    /// <param name="limit">The best answer so far.</param>
    /// <param name="proxy">Its proxy.</param>
    /// <param name="nearest">A bound that the answer does not fall below.</param>
    public bool Next(float limit, out int proxy, out float nearest)
    {
        Waiting* stack = _stack.Pointer;
        while (_depth > 0)
        {
            Waiting next = stack[--_depth];
            if (next.Nearest > limit)
            {
                continue;
            }

            if (next.Layer == LayerOfProxy)
            {
                proxy = next.Index;
                nearest = next.Nearest;
                return true;
            }

            Expand(next, limit, stack);
        }

        proxy = -1;
        nearest = 0;
        return false;
    }

    private void Expand(in Waiting group, float limit, Waiting* stack)
    {
        float* nearest = _nearest.Pointer;
        bool isLoose = group.Layer == LayerOfLoose;
        int first = group.Index * WideBoxes.Width;
        uint mask = isLoose
            ? _probe.Reach(_loose.Boxes, first, limit, nearest)
            : _probe.Reach(_tree.Boxes, _tree.LayerStart(group.Layer) + first, limit, nearest);
        int bottom = _depth;
        for (; mask != 0; mask &= mask - 1)
        {
            int lane = WideBoxes.LowestLane(mask);
            float near = nearest[lane];
            int place = _depth++;
            for (; place > bottom && stack[place - 1].Nearest <= near; place--)
            {
                stack[place] = stack[place - 1];
            }

            ref Waiting item = ref stack[place];
            item.Nearest = near;
            if (isLoose || group.Layer == 0)
            {
                item.Layer = LayerOfProxy;
                item.Index = isLoose ? _loose.Proxy(first + lane) : _tree.Proxy(first + lane);
            }
            else
            {
                item.Layer = group.Layer - 1;
                item.Index = first + lane;
            }
        }
    }

    private struct Waiting
    {
        public int Layer;

        /// <summary>A group of eight of the layer, or a proxy.</summary>
        public int Index;
        public float Nearest;
    }
}
