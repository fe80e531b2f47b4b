using System.Collections.Generic;
using System.Runtime.CompilerServices;

namespace FarseerGames.FarseerPhysics.Viewer.Recording;

/// <summary>Numbers for objects, in the order in which they were first seen; two objects that call themselves equal stay two.</summary>
internal sealed class References<T>
    where T : class
{
    private readonly Dictionary<T, int> _numbers = new Dictionary<T, int>(new Same());

    public int Count => _numbers.Count;

    /// <summary>The number of an object.</summary>
    /// <param name="item">The object.</param>
    /// <param name="isNew">True if it was never seen.</param>
    public int Number(T item, out bool isNew)
    {
        isNew = !_numbers.TryGetValue(item, out int number);
        if (isNew)
        {
            number = _numbers.Count;
            _numbers.Add(item, number);
        }

        return number;
    }

    /// <summary>The number of an object; -1 of none and of one that was never seen.</summary>
    public int Find(T? item) => item is not null && _numbers.TryGetValue(item, out int number) ? number : -1;

    private sealed class Same : IEqualityComparer<T>
    {
        public bool Equals(T? x, T? y) => ReferenceEquals(x, y);

        public int GetHashCode(T obj) => RuntimeHelpers.GetHashCode(obj);
    }
}
