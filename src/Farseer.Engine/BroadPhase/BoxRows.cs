using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.BroadPhase;

/// <summary>
/// Boxes as four arrays for the eight-wide test, with empty boxes behind the last one so that a test may run over the end.
/// </summary>
internal sealed unsafe class BoxRows
{
    // Twice the width, because a Vector of the netstandard2.0 asset may be wider than eight lanes.
    private const int Padding = 2 * WideBoxes.Width;

    private readonly ColumnSet _set = new ColumnSet();
    private readonly Column<float> _minX;
    private readonly Column<float> _minY;
    private readonly Column<float> _maxX;
    private readonly Column<float> _maxY;

    /// <summary>Rows of so many boxes, not yet set, in scratch memory, with the padding.</summary>
    public static WideBoxes Take(Scratch scratch, int count)
    {
        var wide = default(WideBoxes);
        wide.MinX = scratch.Take<float>(count + Padding);
        wide.MinY = scratch.Take<float>(count + Padding);
        wide.MaxX = scratch.Take<float>(count + Padding);
        wide.MaxY = scratch.Take<float>(count + Padding);
        Pad(wide, count);
        return wide;
    }

    public BoxRows()
    {
        _minX = _set.Add<float>();
        _minY = _set.Add<float>();
        _maxX = _set.Add<float>();
        _maxY = _set.Add<float>();
    }

    public int Count { get; private set; }

    /// <summary>Valid until the next growth.</summary>
    [NotState(Why.Derived)]
    public WideBoxes Wide { get; private set; }

    /// <summary>Makes room for so many boxes and the padding.</summary>
    public void EnsureCapacity(int count)
    {
        _set.EnsureCapacity(count + Padding);
        Point();
    }

    /// <summary>
    /// Sets the length; old boxes stay, new ones are undefined, the padding is empty. Without a box there may be no memory yet.
    /// </summary>
    public void SetCount(int count)
    {
        if (count == 0 && _set.Capacity == 0)
        {
            return;
        }

        EnsureCapacity(count);
        Count = count;
        Pad(Wide, count);
    }

    private static void Pad(in WideBoxes wide, int count)
    {
        for (int i = count; i < count + Padding; i++)
        {
            wide.SetEmpty(i);
        }
    }

    private void Point()
    {
        var wide = default(WideBoxes);
        wide.MinX = _minX.Pointer;
        wide.MinY = _minY.Pointer;
        wide.MaxX = _maxX.Pointer;
        wide.MaxY = _maxY.Pointer;
        Wide = wide;
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        Count = s.Value(Count);
        if (s.IsReading && Count > 0)
        {
            EnsureCapacity(Count);
        }

        s.Column(_minX, Count);
        s.Column(_minY, Count);
        s.Column(_maxX, Count);
        s.Column(_maxY, Count);
        if (s.IsReading)
        {
            // The columns of a world that was never as large have moved; the padding follows from the length.
            SetCount(Count);
        }
    }
}
