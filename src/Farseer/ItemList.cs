using System;
using System.Collections.Generic;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// The base of the lists of bodies, geoms, joints, springs and controllers. A list of a simulator is a view of what it simulates: what adds
/// and removes there calls the methods of the simulator, which take effect at the next update. Its order is that in which items were added,
/// and calls that would change only the order are refused. A list of your own changes at once. (An addition to the original, where clearing
/// the list of a simulator left everything in it.)
/// </summary>
/// <typeparam name="T">The kind of item.</typeparam>
/// <example>
/// <code>
/// foreach (Body item in simulator.BodyList)
/// {
///     item.ApplyForce(new Vector2(0, -1));
/// }
/// </code>
/// </example>
public abstract class ItemList<T> : List<T>
    where T : class
{
    private protected ItemList()
    {
    }

    /// <summary>An item by its index. Only a list of your own lets you set it.</summary>
    /// <param name="index">From 0 to below <see cref="List{T}.Count"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such index.</exception>
    /// <exception cref="InvalidOperationException">It is set, and the list is that of a simulator.</exception>
    public new T this[int index]
    {
        get => base[index];
        set
        {
            Require.NotNull(value, nameof(value));
            RequireOwnOrder();
            T before = base[index];
            base[index] = value;
            TellRemoved(before);
            TellAdded(value);
        }
    }

    [NotState(Why.Fixed)]
    internal PhysicsSimulator? Owner { get; set; }

    /// <summary>Removes all items: from a simulator at its next update.</summary>
    public new void Clear()
    {
        if (Owner is null)
        {
            Array.ForEach(Empty(), TellRemoved);
            return;
        }

        for (int i = 0; i < Count; i++)
        {
            OwnerRemove(base[i]);
        }
    }

    /// <summary>Adds several items.</summary>
    /// <param name="collection">The items.</param>
    /// <exception cref="ArgumentNullException"><paramref name="collection"/> or an item of it is null.</exception>
    public new void AddRange(IEnumerable<T> collection)
    {
        foreach (T item in Require.NotNull(collection, nameof(collection)))
        {
            AddItem(item, nameof(collection));
        }
    }

    /// <summary>Inserts an item.</summary>
    /// <param name="index">The index.</param>
    /// <param name="item">The item.</param>
    /// <exception cref="ArgumentNullException"><paramref name="item"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such index.</exception>
    /// <exception cref="InvalidOperationException">The list is that of a simulator.</exception>
    public new void Insert(int index, T item)
    {
        Require.NotNull(item, nameof(item));
        RequireOwnOrder();
        Require.Within(index, 0, Count, nameof(index));
        base.Insert(index, item);
        TellAdded(item);
    }

    /// <summary>Inserts several items.</summary>
    /// <param name="index">The index.</param>
    /// <param name="collection">The items.</param>
    /// <exception cref="ArgumentNullException"><paramref name="collection"/> or an item of it is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such index.</exception>
    /// <exception cref="InvalidOperationException">The list is that of a simulator.</exception>
    public new void InsertRange(int index, IEnumerable<T> collection)
    {
        RequireOwnOrder();
        Require.Within(index, 0, Count, nameof(index));
        foreach (T item in Require.NotNull(collection, nameof(collection)))
        {
            Insert(index++, item);
        }
    }

    /// <summary>Removes the item at an index: from a simulator at its next update.</summary>
    /// <param name="index">The index.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such index.</exception>
    public new void RemoveAt(int index)
    {
        T item = base[Require.Within(index, 0, Count - 1, nameof(index))];
        if (Owner is null)
        {
            base.RemoveAt(index);
            TellRemoved(item);
        }
        else
        {
            OwnerRemove(item);
        }
    }

    /// <summary>Removes the items that match: from a simulator at its next update.</summary>
    /// <param name="match">Tells which.</param>
    /// <returns>The number of geoms.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="match"/> is null.</exception>
    public new int RemoveAll(Predicate<T> match)
    {
        Require.NotNull(match, nameof(match));
        int count = 0;
        for (int i = Count - 1; i >= 0; i--)
        {
            if (match(base[i]))
            {
                RemoveAt(i);
                count++;
            }
        }

        return count;
    }

    /// <summary>Removes a range of items: from a simulator at its next update.</summary>
    /// <param name="index">The first index.</param>
    /// <param name="count">The number of items.</param>
    /// <exception cref="ArgumentOutOfRangeException">The list has no such items.</exception>
    public new void RemoveRange(int index, int count)
    {
        RequireRange(index, count);
        for (int i = index + count - 1; i >= index; i--)
        {
            RemoveAt(i);
        }
    }

    /// <summary>Reverses the order.</summary>
    /// <exception cref="InvalidOperationException">The list is that of a simulator.</exception>
    public new void Reverse()
    {
        RequireOwnOrder();
        base.Reverse();
    }

    /// <summary>Reverses the order of a range of items.</summary>
    /// <param name="index">The first index.</param>
    /// <param name="count">The number of items.</param>
    /// <exception cref="ArgumentOutOfRangeException">The list has no such items.</exception>
    /// <exception cref="InvalidOperationException">The list is that of a simulator.</exception>
    public new void Reverse(int index, int count)
    {
        RequireOwnOrder();
        RequireRange(index, count);
        base.Reverse(index, count);
    }

    /// <summary>Sorts the items.</summary>
    /// <param name="comparison">Compares two of them.</param>
    /// <exception cref="ArgumentNullException"><paramref name="comparison"/> is null.</exception>
    /// <exception cref="InvalidOperationException">The list is that of a simulator.</exception>
    public new void Sort(Comparison<T> comparison)
    {
        Require.NotNull(comparison, nameof(comparison));
        RequireOwnOrder();
        base.Sort(comparison);
    }

    /// <summary>Sorts the items.</summary>
    /// <param name="comparer">Compares two of them.</param>
    /// <exception cref="ArgumentNullException"><paramref name="comparer"/> is null.</exception>
    /// <exception cref="InvalidOperationException">The list is that of a simulator.</exception>
    public new void Sort(IComparer<T> comparer)
    {
        Require.NotNull(comparer, nameof(comparer));
        RequireOwnOrder();
        base.Sort(comparer);
    }

    internal void TakeIn(T item)
    {
        base.Add(item);
        try
        {
            TellAdded(item);
        }
        catch (Exception exception) when (Owner is not null)
        {
            Owner.Relay.Keep(exception);
        }
    }

    internal void TakeOut(T item)
    {
        if (!base.Remove(item))
        {
            return;
        }

        try
        {
            TellRemoved(item);
        }
        catch (Exception exception) when (Owner is not null)
        {
            Owner.Relay.Keep(exception);
        }
    }

    /// <summary>Takes all out at once: one after the other, each would move all those behind it.</summary>
    /// <returns>Those of whom somebody is to be told.</returns>
    internal T[] Empty()
    {
        T[] removed = IsHeard ? ToArray() : [];
        base.Clear();
        return removed;
    }

    /// <summary>Tells of removals, of all of them even if a handler throws.</summary>
    internal void Tell(T[] removed, EventRelay relay)
    {
        foreach (T item in removed)
        {
            try
            {
                TellRemoved(item);
            }
            catch (Exception exception)
            {
                relay.Keep(exception);
            }
        }
    }

    /// <summary>Writes, or reads, what is in it and who hears of it.</summary>
    internal void Visit(StateStream s)
    {
        s.References(this, GetType().Name);
        VisitHandlers(s);
    }

    private protected abstract void VisitHandlers(StateStream s);

    /// <summary>Somebody is told of what leaves.</summary>
    private protected abstract bool IsHeard { get; }

    private protected abstract bool IsDisposed(T item);

    private protected abstract void TellAdded(T item);

    private protected abstract void TellRemoved(T item);

    private protected abstract void OwnerAdd(T item);

    private protected abstract void OwnerRemove(T item);

    private protected void AddItem(T item, string name)
    {
        Require.NotNull(item, name);
        if (Owner is null)
        {
            TakeIn(item);
        }
        else
        {
            OwnerAdd(item);
        }
    }

    private protected void RemoveItem(T item, string name)
    {
        Require.NotNull(item, name);
        if (Owner is null)
        {
            TakeOut(item);
        }
        else
        {
            OwnerRemove(item);
        }
    }

    /// <summary>Takes disposed items out of the list at once.</summary>
    private protected int DropDisposed()
    {
        int count = 0;
        for (int i = Count - 1; i >= 0; i--)
        {
            T item = base[i];
            if (IsDisposed(item))
            {
                base.RemoveAt(i);
                TellRemoved(item);
                count++;
            }
        }

        return count;
    }

    private void RequireRange(int index, int count)
    {
        Require.Within(index, 0, Count, nameof(index));
        Require.Within(count, 0, Count - index, nameof(count));
    }

    private void RequireOwnOrder()
    {
        if (Owner is not null)
        {
            throw new InvalidOperationException("The list is that of a simulator: its order is that in which the items were added.");
        }
    }
}
