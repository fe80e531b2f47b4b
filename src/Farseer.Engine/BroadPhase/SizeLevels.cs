using System;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>
/// Groups boxes by size, each group spanning at most two powers of two, so that one cell size (or one search margin) fits all boxes of a
/// group: O(n). Sizes are measured by their exponents, so the grouping does not depend on the unit of length.
/// </summary>
internal sealed unsafe class SizeLevels
{
    // Doubles that come from float boxes have exponents −173 … 129.
    private const int Lowest = -180;
    private const int Buckets = 320;

    // A group of so few may join any coarser one: even all in one cell they cost less than a level of their own.
    private const int Few = 16;

    // 2⁻²⁴: a box is never taken as smaller than the spacing of floats where it lies, so that cell numbers stay below 2²⁶.
    private const float Spacing = 1f / (1 << 24);

    private readonly Column<int> _bucketCount = new Column<int>(Buckets);
    private readonly Column<int> _bucketLevel = new Column<int>(Buckets);
    private readonly Column<double> _maxSize = new Column<double>(Buckets);
    private readonly Column<int> _start = new Column<int>(Buckets + 1);
    private int* _order;

    /// <summary>Groups, the finest first.</summary>
    public int Count { get; private set; }

    public int First(int level) => _start[level];

    public int Size(int level) => _start[level + 1] - _start[level];

    /// <summary>The proxies of a group, in the order they were given in.</summary>
    public int* Members(int level) => _order + _start[level];

    /// <summary>The largest side in the group.</summary>
    public double MaxSize(int level) => _maxSize[level];

    /// <summary>Sorts the members into groups. They lie in the scratch memory from then on.</summary>
    public void Assign(Scratch scratch, Box* boxes, int* members, int count)
    {
        _order = scratch.Take<int>(count);
        int mark = scratch.Mark;
        double* size = scratch.Take<double>(count);
        int* buckets = _bucketCount.Pointer;
        for (int b = 0; b < Buckets; b++)
        {
            buckets[b] = 0;
        }

        for (int i = 0; i < count; i++)
        {
            double s = EffectiveSize(boxes[members[i]]);
            size[i] = s;
            buckets[Bucket(s)]++;
        }

        MergeBuckets(buckets);
        Distribute(members, size, count);
        scratch.Release(mark);
    }

    /// <summary>The larger side, or the spacing of floats at the box if that is more.</summary>
    /// <remarks>
    /// Floats that are not negative are ordered as their bits are, and the larger of two integers is found without a branch, which would be
    /// guessed wrong for every second box. The rounding of a side, 2⁻²⁴ of it, is far within the slack of a cell.
    /// </remarks>
    public static double EffectiveSize(in Box box)
    {
        int side = Math.Max(FloatBits.ToInt(box.MaxX - box.MinX), FloatBits.ToInt(box.MaxY - box.MinY));
        int far = Math.Max(
            Math.Max(Magnitude(box.MinX), Magnitude(box.MaxX)),
            Math.Max(Magnitude(box.MinY), Magnitude(box.MaxY)));
        int spacing = FloatBits.ToInt(FloatBits.ToFloat(far) * Spacing);
        return FloatBits.ToFloat(Math.Max(side, spacing));
    }

    private static int Magnitude(float value) => FloatBits.ToInt(value) & 0x7FFFFFFF;

    private static int Bucket(double size)
    {
        int exponent = (int)(*(long*)&size >> 52) - 1023 - Lowest;
        return exponent < 0 ? 0 : exponent >= Buckets ? Buckets - 1 : exponent;
    }

    // From fine to coarse: a group takes in the next power of two while that does not crowd the larger cells.
    private void MergeBuckets(int* buckets)
    {
        int* level = _bucketLevel.Pointer;
        int* start = _start.Pointer;
        int current = 0;
        int pending = 0;
        int finest = 0;
        int total = 0;
        start[0] = 0;
        for (int b = 0; b < Buckets; b++)
        {
            int here = buckets[b];
            if (here == 0)
            {
                continue;
            }

            bool joins = pending <= Few || (b - finest <= 1 && pending <= 4L * here);
            if (!joins)
            {
                start[++current] = total;
                pending = 0;
            }

            if (pending <= Few)
            {
                finest = b;
            }

            level[b] = current;
            pending += here;
            total += here;
        }

        Count = total == 0 ? 0 : current + 1;
        start[Count] = total;
    }

    private void Distribute(int* members, double* size, int count)
    {
        int* order = _order;
        int* start = _start.Pointer;
        double* maxSize = _maxSize.Pointer;
        if (Count <= 1)
        {
            double max = 0;
            for (int i = 0; i < count; i++)
            {
                order[i] = members[i];
                max = size[i] > max ? size[i] : max;
            }

            maxSize[0] = max;
            return;
        }

        // The starts serve as cursors and are moved back afterwards.
        for (int l = 0; l < Count; l++)
        {
            maxSize[l] = 0;
        }

        for (int i = 0; i < count; i++)
        {
            int l = _bucketLevel.Pointer[Bucket(size[i])];
            order[start[l]++] = members[i];
            maxSize[l] = size[i] > maxSize[l] ? size[i] : maxSize[l];
        }

        for (int l = Count - 1; l > 0; l--)
        {
            start[l] = start[l - 1];
        }

        start[0] = 0;
    }
}
