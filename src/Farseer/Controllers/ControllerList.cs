using System.Collections.Generic;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Controllers;

/// <summary>
/// A list of controllers that tells of additions and removals. That of a simulator is a view of what it simulates:
/// <see cref="Add"/> and <see cref="Remove"/> then stand for those of the simulator, which take effect at the next update.
/// </summary>
public class ControllerList : List<Controller>
{
    /// <summary>Handles a change of the list.</summary>
    /// <param name="controller">The controller added or removed.</param>
    public delegate void ContentsChangedEventHandler(Controller controller);

    /// <summary>Called when a controller has been added. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Added { get; set; }

    /// <summary>Called when a controller has been removed. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Removed { get; set; }

    [NotState(Why.Fixed)]
    internal PhysicsSimulator? Owner { get; set; }

    /// <summary>Adds a controller.</summary>
    /// <param name="controller">The controller.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="controller"/> is null.</exception>
    public new void Add(Controller controller)
    {
        Require.NotNull(controller, nameof(controller));
        if (Owner is null)
        {
            TakeIn(controller);
        }
        else
        {
            Owner.Add(controller);
        }
    }

    /// <summary>Removes a controller; one that is not in the list is ignored.</summary>
    /// <param name="controller">The controller.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="controller"/> is null.</exception>
    public new void Remove(Controller controller)
    {
        Require.NotNull(controller, nameof(controller));
        if (Owner is null)
        {
            TakeOut(controller);
        }
        else
        {
            Owner.Remove(controller);
        }
    }

    /// <summary>Takes disposed controllers out of the list. A simulator does it by itself at each update.</summary>
    public void RemoveDisposed()
    {
        for (int i = Count - 1; i >= 0; i--)
        {
            if (this[i].IsDisposed)
            {
                Controller removed = this[i];
                RemoveAt(i);
                Removed?.Invoke(removed);
            }
        }
    }

    internal void TakeIn(Controller controller)
    {
        base.Add(controller);
        Added?.Invoke(controller);
    }

    internal void TakeOut(Controller controller)
    {
        if (base.Remove(controller))
        {
            Removed?.Invoke(controller);
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
