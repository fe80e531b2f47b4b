using System;
using System.Collections.Generic;
using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Items of one kind that wait to be taken in or out at the next update. What a handler adds while the queue is worked off waits
/// for the update after.
/// </summary>
internal sealed class ItemQueue<T>
    where T : class, IItem
{
    private readonly PhysicsSimulator _owner;
    [NotState(Why.Elsewhere)]
    private readonly List<T> _list;
    private readonly Action<T> _takeIn;
    private readonly Action<T> _unlist;
    private readonly Func<bool> _isHeard;
    private readonly Action<T>? _letGo;
    private readonly List<T> _in = new List<T>();
    private readonly List<T> _out = new List<T>();

    /// <param name="owner">The simulator.</param>
    /// <param name="list">Its list of the items, the users' view.</param>
    /// <param name="takeIn">Adds to the list and tells of it.</param>
    /// <param name="unlist">Removes from the list and tells of it.</param>
    /// <param name="isHeard">Whether somebody is told of what leaves the list.</param>
    /// <param name="letGo">Frees what the item holds, while it still belongs to the simulator; or null.</param>
    public ItemQueue(PhysicsSimulator owner, List<T> list, Action<T> takeIn, Action<T> unlist, Func<bool> isHeard, Action<T>? letGo = null)
    {
        _owner = owner;
        _list = list;
        _takeIn = takeIn;
        _unlist = unlist;
        _isHeard = isHeard;
        _letGo = letGo;
    }

    /// <summary>True if the item waits from now on; false if only its removal was taken back, or if it was added before.</summary>
    public bool Add(T? item, string name)
    {
        Require.NotNull(item, name);
        if (item!.IsDisposed)
        {
            throw new ObjectDisposedException(item.GetType().Name);
        }

        if (item.Simulator is not null && !ReferenceEquals(item.Simulator, _owner))
        {
            throw new ArgumentException("The " + item.GetType().Name + " belongs to another simulator.", name);
        }

        switch (item.Membership)
        {
            case Membership.RemoveQueued:
                item.Membership = Membership.Added;
                return false;
            case Membership.None:
                item.Membership = Membership.AddQueued;
                item.Simulator = _owner;
                _in.Add(item);
                return true;
            default:
                return false;
        }
    }

    public void Remove(T? item, string name)
    {
        Require.NotNull(item, name);
        if (item!.Simulator is not null && !ReferenceEquals(item.Simulator, _owner))
        {
            throw new ArgumentException("The " + item.GetType().Name + " belongs to another simulator.", name);
        }

        if (item.Membership == Membership.AddQueued)
        {
            Forget(item);
        }
        else if (item.Membership == Membership.Added)
        {
            item.Membership = Membership.RemoveQueued;
            _out.Add(item);
        }
    }

    /// <summary>Removes all that match, of those in the list and those that wait.</summary>
    public void RemoveWhere(Predicate<T> match)
    {
        for (int i = 0; i < _list.Count + _in.Count; i++)
        {
            T item = i < _list.Count ? _list[i] : _in[i - _list.Count];
            if (ReferenceEquals(item.Simulator, _owner) && match(item))
            {
                Remove(item, nameof(match));
            }
        }
    }

    /// <summary>Lists what is there: in the list and not about to leave, or waiting to be taken in.</summary>
    public void ListPresent(List<T> items)
    {
        for (int i = 0; i < _list.Count; i++)
        {
            if (!_list[i].IsDisposed && _list[i].Membership != Membership.RemoveQueued)
            {
                items.Add(_list[i]);
            }
        }

        HashSet<T>? seen = null;
        for (int i = 0; i < _in.Count; i++)
        {
            T item = _in[i];
            if (item.Membership == Membership.AddQueued
                && ReferenceEquals(item.Simulator, _owner)
                && !item.IsDisposed
                && (seen ??= new HashSet<T>()).Add(item))
            {
                items.Add(item);
            }
        }
    }

    /// <summary>Takes in what waited when the update began.</summary>
    public void TakeIn()
    {
        int count = _in.Count;
        for (int i = 0; i < count; i++)
        {
            T item = _in[i];
            if (item.Membership == Membership.AddQueued && ReferenceEquals(item.Simulator, _owner))
            {
                if (item.IsDisposed)
                {
                    Forget(item);
                }
                else
                {
                    item.Membership = Membership.Added;
                    _takeIn(item);
                }
            }
        }

        ListRoom.WorkedOff(_in, count);
    }

    /// <summary>Takes out what waited when the update began.</summary>
    public void TakeOut() => Drop(_out);

    /// <summary>
    /// Lets those go that are to leave or are disposed, of items that are in the list or wait; tells of those that were in the list.
    /// </summary>
    /// <param name="leaving">The items, removed from here as well. What handlers add to it stays.</param>
    public void Drop(List<T> leaving)
    {
        int count = leaving.Count;
        bool unlist = _isHeard() || !ListRoom.AreMany(count);
        for (int i = 0; i < count; i++)
        {
            T item = leaving[i];
            if (ReferenceEquals(item.Simulator, _owner) && (item.Membership == Membership.RemoveQueued || item.IsDisposed))
            {
                Drop(item, unlist);
            }
        }

        leaving.RemoveRange(0, count);
        if (!unlist)
        {
            UnlistAll();
        }
    }

    /// <summary>Lets every item check what it needs, and sweeps out those that are disposed.</summary>
    public void Sweep(EventRelay relay)
    {
        bool unlist = _isHeard();
        bool any = false;
        for (int i = 0; i < _list.Count; i++)
        {
            T item = _list[i];
            if (!item.IsDisposed)
            {
                try
                {
                    item.Validate();
                }
                catch (Exception exception)
                {
                    relay.Keep(exception);
                }
            }

            if (item.IsDisposed && i < _list.Count && ReferenceEquals(_list[i], item))
            {
                any = true;
                Drop(item, unlist);
                i -= unlist ? 1 : 0;
            }
        }

        if (any && !unlist)
        {
            UnlistAll();
        }
    }

    public void Clear()
    {
        Forget(_in);
        Forget(_out);
        Forget(_list);
    }

    private void Drop(T item, bool unlist)
    {
        unlist &= item.Membership != Membership.AddQueued;
        Forget(item);
        if (unlist)
        {
            _unlist(item);
        }
    }

    /// <summary>Removes what has been let go in one walk over the list.</summary>
    private void UnlistAll() => _list.RemoveAll(static item => item.Membership == Membership.None);

    private void Forget(T item)
    {
        _letGo?.Invoke(item);
        item.Membership = Membership.None;
        item.Simulator = null;
    }

    // An item that was removed before it was taken in still stands among those that wait; by now it may be another simulator's.
    private void Forget(List<T> items)
    {
        foreach (T item in items)
        {
            if (ReferenceEquals(item.Simulator, _owner))
            {
                Forget(item);
            }
        }

        items.Clear();
    }

    /// <summary>Writes, or reads, what waits.</summary>
    public void Visit(StateStream s)
    {
        s.References(_in);
        s.References(_out);
    }

    /// <summary>What waits to be taken in; also what was removed before it came to that.</summary>
    public List<T> Waiting => _in;
}
