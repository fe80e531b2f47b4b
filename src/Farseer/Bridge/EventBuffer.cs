using System;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Events of one kind: those that are read, and those that come meanwhile.</summary>
internal class EventBuffer<T>
{
    private T[] _read = [];
    private T[] _write = [];
    private int _readCount;
    private int _writeCount;

    public ReadOnlySpan<T> Published => new ReadOnlySpan<T>(_read, 0, _readCount);

    public void Add(T item)
    {
        if (_writeCount == _write.Length)
        {
            Array.Resize(ref _write, Math.Max(16, 2 * _write.Length));
        }

        _write[_writeCount++] = item;
    }

    /// <summary>Lets readers see what came, and forgets what they saw.</summary>
    public void Publish()
    {
        if (_readCount == 0 && _writeCount == 0)
        {
            return;
        }

        Arrange(new Span<T>(_write, 0, _writeCount));

        // Both of one length: which of them a large crowd comes into is chance.
        Array.Clear(_read, 0, _readCount);
        if (_read.Length < _write.Length)
        {
            _read = new T[_write.Length];
        }

        (_read, _write) = (_write, _read);
        _readCount = _writeCount;
        _writeCount = 0;
    }

    public void Clear()
    {
        Array.Clear(_read, 0, _readCount);
        Array.Clear(_write, 0, _writeCount);
        _readCount = 0;
        _writeCount = 0;
    }

    /// <summary>Puts what came in the order in which it is read.</summary>
    protected virtual void Arrange(Span<T> coming)
    {
    }
}
