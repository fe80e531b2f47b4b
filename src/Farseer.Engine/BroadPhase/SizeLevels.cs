using System;
using System.Runtime.CompilerServices;
using Farseer.Engine.Numerics;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>
/// Groups boxes by size, each group spanning at most two powers of two, so that one cell size (or one search margin) fits all boxes of a
/// group: O(n). Sizes are measured by their exponents, so the grouping does not depend on the unit of length.
/// </summary>
internal sealed unsafe class SizeLevels : IStageWork
{
    // Doubles that come from float boxes have exponents −173 … 129.
    private const int Lowest = -180;
    private const int Buckets = 320;

    // A group of so few may join any coarser one: even all in one cell they cost less than a level of their own.
    private const int Few = 16;

    // Boxes that are worth another worker's while, some 1 µs.
    private const int LeastBoxes = 256;

    // 2⁻²⁴: a box is never taken as smaller than the spacing of floats where it lies, so that cell numbers stay below 2²⁶.
    private const float Spacing = 1f / (1 << 24);

    // By group; grown as groups are found: most worlds have one or two.
    private readonly Column<double> _maxSize = new Column<double>();
    private readonly Column<int> _start = new Column<int>();
    private int* _order;

    // While members are sorted: the group of each power of two, their sizes, and what each worker has found of each power of two.
    private int* _bucketLevel;
    private double* _size;
    private SizeBucket* _found;
    private Box* _boxes;
    private int* _members;

    /// <summary>Groups, the finest first.</summary>
    public int Count { get; private set; }

    public int First(int level) => _start[level];

    public int Size(int level) => _start[level + 1] - _start[level];

    /// <summary>The proxies of a group, in the order they were given in.</summary>
    public int* Members(int level) => _order + _start[level];

    /// <summary>The largest side in the group.</summary>
    public double MaxSize(int level) => _maxSize[level];

    /// <summary>
    /// Sorts the members into groups. They lie in the scratch memory from then on, or where they were if there is only one.
    /// </summary>
    /// <param name="runner">Who shares the measuring out; null: nobody.</param>
    /// <param name="scratch">Where room is found.</param>
    /// <param name="boxes">All boxes.</param>
    /// <param name="members">Those that are sorted.</param>
    /// <param name="count">How many they are.</param>
    public void Assign(StageRunner? runner, Scratch scratch, Box* boxes, int* members, int count)
    {
        int workers = runner != null && runner.IsShared(count, LeastBoxes) ? runner.Workers : 1;
        _order = scratch.Take<int>(count);
        int mark = scratch.Mark;
        _size = scratch.Take<double>(count);
        _bucketLevel = scratch.Take<int>(Buckets);
        _found = scratch.Take<SizeBucket>(workers * Buckets);
        _boxes = boxes;
        _members = members;
        Unsafe.InitBlock(_found, 0, (uint)(workers * Buckets * sizeof(SizeBucket)));
        StageRunner.Share(workers == 1 ? null : runner, this, count, LeastBoxes);

        for (int i = Buckets; i < workers * Buckets; i++)
        {
            ref SizeBucket sum = ref _found[i % Buckets];
            sum.Count += _found[i].Count;
            sum.Most = _found[i].Most > sum.Most ? _found[i].Most : sum.Most;
        }

        MergeBuckets();
        Distribute(count);
        scratch.Release(mark);
    }

    /// <summary>Measures a range of the members.</summary>
    void IStageWork.Run(int worker, int from, int to)
    {
        SizeBucket* found = _found + (worker * Buckets);
        for (int i = from; i < to; i++)
        {
            double size = EffectiveSize(_boxes[_members[i]]);
            _size[i] = size;
            SizeBucket* bucket = found + Bucket(size);
            bucket->Count++;
            bucket->Most = size > bucket->Most ? size : bucket->Most;
        }
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
    private void MergeBuckets()
    {
        int current = 0;
        int pending = 0;
        int finest = 0;
        int total = 0;
        Begin(0, 0);
        for (int b = 0; b < Buckets; b++)
        {
            int here = _found[b].Count;
            if (here == 0)
            {
                continue;
            }

            bool joins = pending <= Few || (b - finest <= 1 && pending <= 4L * here);
            if (!joins)
            {
                Begin(++current, total);
                pending = 0;
            }

            if (pending <= Few)
            {
                finest = b;
            }

            _bucketLevel[b] = current;
            _maxSize[current] = Math.Max(_maxSize[current], _found[b].Most);
            pending += here;
            total += here;
        }

        Count = total == 0 ? 0 : current + 1;
        _start[Count] = total;
    }

    private void Begin(int level, int start)
    {
        _maxSize.EnsureCapacity(level + 1);
        _start.EnsureCapacity(level + 2);
        _maxSize[level] = 0;
        _start[level] = start;
    }

    private void Distribute(int count)
    {
        int* order = _order;
        int* start = _start.Pointer;
        if (Count <= 1)
        {
            _order = _members;
            return;
        }

        // The starts serve as cursors and are moved back afterwards.
        for (int i = 0; i < count; i++)
        {
            order[start[_bucketLevel[Bucket(_size[i])]]++] = _members[i];
        }

        for (int l = Count - 1; l > 0; l--)
        {
            start[l] = start[l - 1];
        }

        start[0] = 0;
    }

    // The boxes of a power of two.
    private struct SizeBucket
    {
        public int Count;

        // The largest side of one.
        public double Most;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Column(_maxSize);
        s.Column(_start);
        Count = s.Value(Count);
    }
}
