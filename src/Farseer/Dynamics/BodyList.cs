using System;
using System.Collections.Generic;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <summary>
/// A list of bodies that tells of additions and removals. That of a simulator is a view of what it simulates:
/// <see cref="Add"/> and <see cref="Remove"/> then stand for those of the simulator, which take effect at the next update.
/// </summary>
public class BodyList : List<Body>
{
    /// <summary>Handles a change of the list.</summary>
    /// <param name="body">The body added or removed.</param>
    public delegate void ContentsChangedEventHandler(Body body);

    /// <summary>Called when a body has been added. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Added { get; set; }

    /// <summary>Called when a body has been removed. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Removed { get; set; }

    [NotState(Why.Fixed)]
    internal PhysicsSimulator? Owner { get; set; }

    /// <summary>Adds a body.</summary>
    /// <param name="body">The body.</param>
    /// <exception cref="ArgumentNullException"><paramref name="body"/> is null.</exception>
    public new void Add(Body body)
    {
        Require.NotNull(body, nameof(body));
        if (Owner is null)
        {
            TakeIn(body);
        }
        else
        {
            Owner.Add(body);
        }
    }

    /// <summary>Removes a body; one that is not in the list is ignored.</summary>
    /// <param name="body">The body.</param>
    /// <exception cref="ArgumentNullException"><paramref name="body"/> is null.</exception>
    public new void Remove(Body body)
    {
        Require.NotNull(body, nameof(body));
        if (Owner is null)
        {
            TakeOut(body);
        }
        else
        {
            Owner.Remove(body);
        }
    }

    /// <summary>Takes disposed bodies out of the list. A simulator does it by itself at each update.</summary>
    public void RemoveDisposed()
    {
        for (int i = Count - 1; i >= 0; i--)
        {
            if (this[i].IsDisposed)
            {
                Body removed = this[i];
                RemoveAt(i);
                Removed?.Invoke(removed);
            }
        }
    }

    internal void TakeIn(Body body)
    {
        base.Add(body);
        Added?.Invoke(body);
    }

    internal void TakeOut(Body body)
    {
        if (base.Remove(body))
        {
            Removed?.Invoke(body);
        }
    }

    /// <summary>Takes all out at once: one after the other, each would move all those behind it.</summary>
    /// <returns>Those of whom <see cref="Tell"/> is to tell.</returns>
    internal Body[] Empty()
    {
        Body[] removed = Removed is null ? [] : ToArray();
        Clear();
        return removed;
    }

    /// <summary>Tells of removals, of all of them even if a handler throws.</summary>
    internal void Tell(Body[] removed, EventRelay relay)
    {
        foreach (Body body in removed)
        {
            try
            {
                Removed?.Invoke(body);
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
        s.References(this);
        Added = s.Reference(Added);
        Removed = s.Reference(Removed);
    }
}
