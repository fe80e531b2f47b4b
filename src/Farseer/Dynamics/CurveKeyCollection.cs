using System;
using System.Collections;
using System.Collections.Generic;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <summary>The keys of a <see cref="Curve"/>, always in the order of their positions.</summary>
/// <example>
/// <code>
/// var curve = new Curve();
/// curve.Keys.Add(new CurveKey(1, 4));
/// int first = curve.Keys.IndexOf(curve.Keys[0]);
/// </code>
/// </example>
public class CurveKeyCollection : ICollection<CurveKey>
{
    private readonly List<CurveKey> _keys = new List<CurveKey>();

    /// <summary>Makes an empty collection.</summary>
    public CurveKeyCollection()
    {
    }

    /// <summary>Number of keys.</summary>
    public int Count => _keys.Count;

    /// <summary>False: keys can be added and removed.</summary>
    public bool IsReadOnly => false;

    /// <summary>A key; setting it to one with another position moves it to its place in the order.</summary>
    /// <param name="index">Number of the key.</param>
    /// <returns>The key.</returns>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such key.</exception>
    public CurveKey this[int index]
    {
        get => _keys[Require.Within(index, 0, _keys.Count - 1, nameof(index))];
        set
        {
            Require.NotNull(value, nameof(value));
            Require.Within(index, 0, _keys.Count - 1, nameof(index));
            if (_keys[index].Position == value.Position)
            {
                _keys[index] = value;
            }
            else
            {
                _keys.RemoveAt(index);
                Add(value);
            }
        }
    }

    /// <summary>Adds a key at its place in the order, after those of the same position.</summary>
    /// <param name="item">The key.</param>
    /// <exception cref="ArgumentNullException"><paramref name="item"/> is null.</exception>
    public void Add(CurveKey item)
    {
        Require.NotNull(item, nameof(item));
        int index = _keys.Count;
        while (index > 0 && _keys[index - 1].Position > item.Position)
        {
            index--;
        }

        _keys.Insert(index, item);
    }

    /// <summary>Removes all keys.</summary>
    public void Clear() => _keys.Clear();

    /// <summary>Makes a collection of equal keys.</summary>
    /// <returns>The new collection.</returns>
    public CurveKeyCollection Clone()
    {
        var clone = new CurveKeyCollection();
        foreach (CurveKey key in _keys)
        {
            clone._keys.Add(key.Clone());
        }

        return clone;
    }

    /// <summary>True if an equal key is in the collection.</summary>
    /// <param name="item">The key.</param>
    /// <returns>True if it is.</returns>
    public bool Contains(CurveKey item) => _keys.Contains(item);

    /// <summary>Copies the keys into an array.</summary>
    /// <param name="array">The array.</param>
    /// <param name="arrayIndex">The index of the first key in the array.</param>
    /// <exception cref="ArgumentNullException"><paramref name="array"/> is null.</exception>
    /// <exception cref="ArgumentException">The array is too short.</exception>
    public void CopyTo(CurveKey[] array, int arrayIndex)
    {
        Require.NotNull(array, nameof(array));
        Require.Within(arrayIndex, 0, array.Length, nameof(arrayIndex));
        _keys.CopyTo(array, arrayIndex);
    }

    /// <summary>Goes through the keys.</summary>
    /// <returns>The enumerator.</returns>
    public IEnumerator<CurveKey> GetEnumerator() => _keys.GetEnumerator();

    /// <summary>Number of the first equal key, or −1.</summary>
    /// <param name="item">The key.</param>
    /// <returns>The number.</returns>
    public int IndexOf(CurveKey item) => _keys.IndexOf(item);

    /// <summary>Removes the first equal key.</summary>
    /// <param name="item">The key.</param>
    /// <returns>True if there was one.</returns>
    public bool Remove(CurveKey item) => _keys.Remove(item);

    /// <summary>Removes a key.</summary>
    /// <param name="index">Number of the key.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such key.</exception>
    public void RemoveAt(int index) => _keys.RemoveAt(Require.Within(index, 0, _keys.Count - 1, nameof(index)));

    /// <inheritdoc />
    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
}
