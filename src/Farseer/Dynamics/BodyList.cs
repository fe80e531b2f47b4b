using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <summary>
/// A list of bodies that tells of additions and removals. That of a simulator is a view of what it simulates:
/// <see cref="Add"/> and <see cref="Remove"/> then stand for those of the simulator, which take effect at the next update.
/// </summary>
/// <example>
/// <code>
/// simulator.BodyList.Added += born =&gt; born.LinearDragCoefficient = 0;
/// </code>
/// </example>
public class BodyList : ItemList<Body>
{
    /// <summary>Handles a change of the list.</summary>
    /// <param name="body">The body added or removed.</param>
    public delegate void ContentsChangedEventHandler(Body body);

    /// <summary>Called when a body has been added. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Added { get; set; }

    /// <summary>Called when a body has been removed. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Removed { get; set; }

    private protected override bool IsHeard => Removed is not null;

    /// <summary>Adds a body.</summary>
    /// <param name="body">The body.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="body"/> is null.</exception>
    public new void Add(Body body) => AddItem(body, nameof(body));

    /// <summary>Removes a body; one that is not in the list is ignored.</summary>
    /// <param name="body">The body.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="body"/> is null.</exception>
    public new void Remove(Body body) => RemoveItem(body, nameof(body));

    /// <summary>Takes disposed bodies out of the list. A simulator does it by itself at each update.</summary>
    public void RemoveDisposed() => DropDisposed();

    private protected override bool IsDisposed(Body item) => item.IsDisposed;

    private protected override void TellAdded(Body item) => Added?.Invoke(item);

    private protected override void TellRemoved(Body item) => Removed?.Invoke(item);

    private protected override void OwnerAdd(Body item) => Owner!.Add(item);

    private protected override void OwnerRemove(Body item) => Owner!.Remove(item);

    private protected override void VisitHandlers(StateStream s)
    {
        Added = s.Reference(Added);
        Removed = s.Reference(Removed);
    }
}
