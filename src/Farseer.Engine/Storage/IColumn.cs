namespace Farseer.Engine.Storage;

/// <summary>What a <see cref="ColumnSet"/> needs to know of a column: growth, and its bytes for hash and snapshot.</summary>
internal interface IColumn
{
    /// <summary>Grows to just so many records, if it has fewer.</summary>
    void GrowTo(int capacity);

    unsafe byte* Bytes { get; }

    int ElementSize { get; }
}
