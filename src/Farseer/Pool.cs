using System;
using System.Collections.Generic;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// A store of objects to be used again instead of being created and collected over and over (manual: "Performance").
/// </summary>
/// <typeparam name="T">The type of the objects; needs a public constructor without parameters.</typeparam>
/// <remarks>
/// The object last put back is the first to be taken. The pool neither resets an object nor notices when one is put back
/// twice: both are the user's affair. Not safe for use by several threads at once.
/// </remarks>
/// <example>
/// <code>
/// Pool&lt;Body&gt; pool = new();
/// Body bullet = pool.Fetch();
/// pool.Insert(bullet);
/// </code>
/// </example>
public class Pool<T>
    where T : new()
{
    private readonly Stack<T> _items;

    /// <summary>Makes an empty pool; <see cref="Fetch"/> creates objects until some are put back.</summary>
    public Pool()
    {
        _items = new Stack<T>();
    }

    /// <summary>Makes a pool that already holds new objects.</summary>
    /// <param name="size">The number of objects to create now; 0 or more.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="size"/> is negative.</exception>
    public Pool(int size)
    {
        if (size < 0)
        {
            throw new ArgumentOutOfRangeException(nameof(size), size, "A pool cannot hold fewer than 0 objects.");
        }

        _items = new Stack<T>(size);
        for (var i = 0; i < size; i++)
        {
            _items.Push(new T());
        }
    }

    /// <summary>The number of objects that wait to be taken.</summary>
    public int Count => _items.Count;

    /// <summary>Takes an object from the pool, or makes a new one if the pool is empty.</summary>
    /// <returns>The object; from now on the caller's.</returns>
    public T Fetch() => _items.Count > 0 ? _items.Pop() : new T();

    /// <summary>Puts an object into the pool.</summary>
    /// <param name="item">The object; it must not be used any more until it is fetched.</param>
    /// <exception cref="ArgumentNullException"><paramref name="item"/> is null.</exception>
    public void Insert(T item)
    {
        if (item is null)
        {
            throw new ArgumentNullException(nameof(item));
        }

        _items.Push(item);
    }
}
