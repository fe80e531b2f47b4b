using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Dynamics.Springs;

/// <summary>
/// A list of springs that tells of additions and removals. That of a simulator is a view of what it simulates:
/// <see cref="Add"/> and <see cref="Remove"/> then stand for those of the simulator, which take effect at the next update.
/// </summary>
/// <example>
/// <code>
/// foreach (Spring item in simulator.SpringList)
/// {
///     Console.WriteLine(item);
/// }
/// </code>
/// </example>
public class SpringList : ItemList<Spring>
{
    /// <summary>Handles a change of the list.</summary>
    /// <param name="spring">The spring added or removed.</param>
    public delegate void ContentsChangedEventHandler(Spring spring);

    /// <summary>Called when a spring has been added. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Added { get; set; }

    /// <summary>Called when a spring has been removed. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Removed { get; set; }

    private protected override bool IsHeard => Removed is not null;

    /// <summary>Adds a spring.</summary>
    /// <param name="spring">The spring.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="spring"/> is null.</exception>
    public new void Add(Spring spring) => AddItem(spring, nameof(spring));

    /// <summary>Removes a spring; one that is not in the list is ignored.</summary>
    /// <param name="spring">The spring.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="spring"/> is null.</exception>
    public new void Remove(Spring spring) => RemoveItem(spring, nameof(spring));

    /// <summary>Takes disposed springs out of the list. A simulator does it by itself at each update.</summary>
    public void RemoveDisposed() => DropDisposed();

    private protected override bool IsDisposed(Spring item) => item.IsDisposed;

    private protected override void TellAdded(Spring item) => Added?.Invoke(item);

    private protected override void TellRemoved(Spring item) => Removed?.Invoke(item);

    private protected override void OwnerAdd(Spring item) => Owner!.Add(item);

    private protected override void OwnerRemove(Spring item) => Owner!.Remove(item);

    private protected override void VisitHandlers(StateStream s)
    {
        Added = s.Reference(Added);
        Removed = s.Reference(Removed);
    }
}
