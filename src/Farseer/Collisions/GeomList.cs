using System;
using System.Collections.Generic;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>
/// A list of geoms that tells of additions and removals. That of a simulator is a view of what it simulates:
/// <see cref="Add"/> and <see cref="Remove"/> then stand for those of the simulator, which take effect at the next update.
/// </summary>
public class GeomList : List<Geom>
{
    /// <summary>Handles a change of the list.</summary>
    /// <param name="geom">The geom added or removed.</param>
    public delegate void ContentsChangedEventHandler(Geom geom);

    /// <summary>Called when a geom has been added. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Added { get; set; }

    /// <summary>Called when a geom has been removed. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Removed { get; set; }

    [NotState(Why.Fixed)]
    internal PhysicsSimulator? Owner { get; set; }

    /// <summary>Adds a geom.</summary>
    /// <param name="geom">The geom.</param>
    /// <exception cref="ArgumentNullException"><paramref name="geom"/> is null.</exception>
    public new void Add(Geom geom)
    {
        Require.NotNull(geom, nameof(geom));
        if (Owner is null)
        {
            TakeIn(geom);
        }
        else
        {
            Owner.Add(geom);
        }
    }

    /// <summary>Removes a geom; one that is not in the list is ignored.</summary>
    /// <param name="geom">The geom.</param>
    /// <exception cref="ArgumentNullException"><paramref name="geom"/> is null.</exception>
    public new void Remove(Geom geom)
    {
        Require.NotNull(geom, nameof(geom));
        if (Owner is null)
        {
            TakeOut(geom);
        }
        else
        {
            Owner.Remove(geom);
        }
    }

    /// <summary>Takes disposed geoms out of the list. A simulator does it by itself at each update.</summary>
    /// <returns>How many there were.</returns>
    public int RemoveDisposed()
    {
        int count = 0;
        for (int i = Count - 1; i >= 0; i--)
        {
            if (this[i].IsDisposed)
            {
                Geom removed = this[i];
                RemoveAt(i);
                Removed?.Invoke(removed);
                count++;
            }
        }

        return count;
    }

    internal void TakeIn(Geom geom)
    {
        base.Add(geom);
        Added?.Invoke(geom);
    }

    internal void TakeOut(Geom geom)
    {
        if (base.Remove(geom))
        {
            Removed?.Invoke(geom);
        }
    }

    /// <summary>Takes all out at once: one after the other, each would move all those behind it.</summary>
    /// <returns>Those of whom <see cref="Tell"/> is to tell.</returns>
    internal Geom[] Empty()
    {
        Geom[] removed = Removed is null ? [] : ToArray();
        Clear();
        return removed;
    }

    /// <summary>Tells of removals, of all of them even if a handler throws.</summary>
    internal void Tell(Geom[] removed, EventRelay relay)
    {
        foreach (Geom geom in removed)
        {
            try
            {
                Removed?.Invoke(geom);
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
