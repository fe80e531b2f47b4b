using System.Collections.Generic;

namespace Farseer.Engine.Storage;

/// <summary>Columns of equal length that grow together. Growth, state hash and snapshot are written once, here.</summary>
[NotState(Why.Room)]
internal sealed class ColumnSet
{
    private readonly List<IColumn> _columns = new List<IColumn>();

    /// <summary>Bytes of the largest record.</summary>
    private int _size = 1;

    public IReadOnlyList<IColumn> Columns => _columns;

    public int Capacity { get; private set; }

    public Column<T> Add<T>()
        where T : unmanaged
    {
        var column = new Column<T>(Capacity);
        _columns.Add(column);
        _size = System.Math.Max(_size, ((IColumn)column).ElementSize);
        return column;
    }

    public void EnsureCapacity(int capacity)
    {
        if (capacity <= Capacity)
        {
            return;
        }

        // An empty world has one body, and no need of more.
        int wanted = Capacity == 0 ? capacity : ColumnGrowth.Next(Capacity, capacity, _size);
        for (int i = 0; i < _columns.Count; i++)
        {
            _columns[i].GrowTo(wanted);
        }

        Capacity = wanted;
    }
}
