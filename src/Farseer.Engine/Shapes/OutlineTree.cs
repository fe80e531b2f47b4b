using System;
using System.Numerics;

namespace Farseer.Engine.Shapes;

/// <summary>What is looked for among the parts of an outline.</summary>
internal interface IOutlineProbe
{
    /// <summary>False if nothing within a box is what is looked for; <paramref name="last"/> is the last part in it.</summary>
    bool Reaches(Vector2 min, Vector2 max, int last);

    /// <summary>Whether a part is what is looked for.</summary>
    bool Hits(int part);
}

/// <summary>
/// Corners or edges of an outline in boxes within boxes, so that what lies far away is not looked at one by one: with it an outline of ten
/// thousand corners takes as long as its corners are many, not their square.
/// </summary>
internal sealed class OutlineTree
{
    private const int LeafParts = 8;

    private readonly Vector2[] _min;
    private readonly Vector2[] _max;
    private readonly int[] _parts;
    private readonly bool[] _isGone;
    private readonly int[] _leafOf;
    private readonly Node[] _nodes;
    private readonly float[] _keys;
    private int _count;

    /// <param name="min">The lower corner of each part's box.</param>
    /// <param name="max">The upper corner of each part's box; the same array for points.</param>
    public OutlineTree(Vector2[] min, Vector2[] max)
    {
        int count = min.Length;
        _min = min;
        _max = max;
        _parts = new int[count];
        _isGone = new bool[count];
        _leafOf = new int[count];
        _keys = new float[count];

        // Halves of what is more than a leaf have more than half a leaf each.
        _nodes = new Node[Math.Max(1, 4 * count / LeafParts)];
        for (int i = 0; i < count; i++)
        {
            _parts[i] = i;
        }

        Build(0, count, -1);
    }

    /// <summary>Takes a part out: it is not found any more.</summary>
    public void Remove(int part)
    {
        _isGone[part] = true;
        for (int node = _leafOf[part]; node >= 0; node = _nodes[node].Parent)
        {
            _nodes[node].Left--;
        }
    }

    /// <summary>Whether any part is what the probe looks for.</summary>
    public bool Any<T>(in T probe)
        where T : struct, IOutlineProbe => Any(probe, 0);

    private bool Any<T>(in T probe, int index)
        where T : struct, IOutlineProbe
    {
        ref Node node = ref _nodes[index];
        if (node.Left == 0 || !probe.Reaches(node.Min, node.Max, node.Last))
        {
            return false;
        }

        if (node.Second > 0)
        {
            return Any(probe, index + 1) || Any(probe, node.Second);
        }

        for (int i = node.Start; i < node.End; i++)
        {
            int part = _parts[i];
            if (!_isGone[part] && probe.Hits(part))
            {
                return true;
            }
        }

        return false;
    }

    // Halves by the middle along the longer side: its depth is the logarithm of the number of parts.
    private void Build(int start, int end, int parent)
    {
        int index = _count++;
        var node = new Node { Start = start, End = end, Parent = parent, Left = end - start };
        node.Min = new Vector2(float.PositiveInfinity);
        node.Max = new Vector2(float.NegativeInfinity);
        for (int i = start; i < end; i++)
        {
            int part = _parts[i];
            node.Min = Vector2.Min(node.Min, _min[part]);
            node.Max = Vector2.Max(node.Max, _max[part]);
            node.Last = Math.Max(node.Last, part);
        }

        if (end - start <= LeafParts)
        {
            for (int i = start; i < end; i++)
            {
                _leafOf[_parts[i]] = index;
            }

            _nodes[index] = node;
            return;
        }

        bool isTall = node.Max.Y - node.Min.Y > node.Max.X - node.Min.X;
        for (int i = start; i < end; i++)
        {
            int part = _parts[i];
            _keys[i] = isTall ? (0.5f * _min[part].Y) + (0.5f * _max[part].Y) : (0.5f * _min[part].X) + (0.5f * _max[part].X);
        }

        Array.Sort(_keys, _parts, start, end - start);
        int middle = (start + end) / 2;
        _nodes[index] = node;
        Build(start, middle, index);
        _nodes[index].Second = _count;
        Build(middle, end, index);
    }

    private struct Node
    {
        public Vector2 Min;
        public Vector2 Max;
        public int Start;
        public int End;
        public int Parent;

        /// <summary>The second half; the first one is the next node. 0: a leaf.</summary>
        public int Second;

        /// <summary>Parts that are left in it.</summary>
        public int Left;

        /// <summary>The last part, by its index.</summary>
        public int Last;
    }
}
