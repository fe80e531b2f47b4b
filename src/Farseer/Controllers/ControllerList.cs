using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Controllers;

/// <summary>
/// A list of controllers that tells of additions and removals. That of a simulator is a view of what it simulates:
/// <see cref="Add"/> and <see cref="Remove"/> then stand for those of the simulator, which take effect at the next update.
/// </summary>
/// <example>
/// <code>
/// simulator.ControllerList.Added += controller =&gt; Console.WriteLine(controller + " acts from now on");
/// </code>
/// </example>
public class ControllerList : ItemList<Controller>
{
    /// <summary>Handles a change of the list.</summary>
    /// <param name="controller">The controller added or removed.</param>
    public delegate void ContentsChangedEventHandler(Controller controller);

    /// <summary>Called when a controller has been added. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Added { get; set; }

    /// <summary>Called when a controller has been removed. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Removed { get; set; }

    private protected override bool IsHeard => Removed is not null;

    /// <summary>Adds a controller.</summary>
    /// <param name="controller">The controller.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="controller"/> is null.</exception>
    public new void Add(Controller controller) => AddItem(controller, nameof(controller));

    /// <summary>Removes a controller; one that is not in the list is ignored.</summary>
    /// <param name="controller">The controller.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="controller"/> is null.</exception>
    public new void Remove(Controller controller) => RemoveItem(controller, nameof(controller));

    /// <summary>Takes disposed controllers out of the list. A simulator does it by itself at each update.</summary>
    public void RemoveDisposed() => DropDisposed();

    private protected override bool IsDisposed(Controller item) => item.IsDisposed;

    private protected override void TellAdded(Controller item) => Added?.Invoke(item);

    private protected override void TellRemoved(Controller item) => Removed?.Invoke(item);

    private protected override void OwnerAdd(Controller item) => Owner!.Add(item);

    private protected override void OwnerRemove(Controller item) => Owner!.Remove(item);

    private protected override void VisitHandlers(StateStream s)
    {
        Added = s.Reference(Added);
        Removed = s.Reference(Removed);
    }
}
