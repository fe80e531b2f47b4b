using System.Collections.Generic;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Springs;

/// <summary>
/// A list of springs that tells of additions and removals. That of a simulator is a view of what it simulates:
/// <see cref="Add"/> and <see cref="Remove"/> then stand for those of the simulator, which take effect at the next update.
/// </summary>
public class SpringList : List<Spring>
{
    /// <summary>Handles a change of the list.</summary>
    /// <param name="spring">The spring added or removed.</param>
    public delegate void ContentsChangedEventHandler(Spring spring);

    /// <summary>Called when a spring has been added. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Added { get; set; }

    /// <summary>Called when a spring has been removed. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Removed { get; set; }

    [NotState(Why.Fixed)]
    internal PhysicsSimulator? Owner { get; set; }

    /// <summary>Adds a spring.</summary>
    /// <param name="spring">The spring.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="spring"/> is null.</exception>
    public new void Add(Spring spring)
    {
        Require.NotNull(spring, nameof(spring));
        if (Owner is null)
        {
            TakeIn(spring);
        }
        else
        {
            Owner.Add(spring);
        }
    }

    /// <summary>Removes a spring; one that is not in the list is ignored.</summary>
    /// <param name="spring">The spring.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="spring"/> is null.</exception>
    public new void Remove(Spring spring)
    {
        Require.NotNull(spring, nameof(spring));
        if (Owner is null)
        {
            TakeOut(spring);
        }
        else
        {
            Owner.Remove(spring);
        }
    }

    /// <summary>Takes disposed springs out of the list. A simulator does it by itself at each update.</summary>
    public void RemoveDisposed()
    {
        for (int i = Count - 1; i >= 0; i--)
        {
            if (this[i].IsDisposed)
            {
                Spring removed = this[i];
                RemoveAt(i);
                Removed?.Invoke(removed);
            }
        }
    }

    internal void TakeIn(Spring spring)
    {
        base.Add(spring);
        Added?.Invoke(spring);
    }

    internal void TakeOut(Spring spring)
    {
        if (base.Remove(spring))
        {
            Removed?.Invoke(spring);
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
