using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// A list of joints that tells of additions and removals. That of a simulator is a view of what it simulates:
/// <see cref="Add"/> and <see cref="Remove"/> then stand for those of the simulator, which take effect at the next update.
/// </summary>
/// <example>
/// <code>
/// foreach (Joint joint in simulator.JointList)
/// {
///     Console.WriteLine(joint);
/// }
/// </code>
/// </example>
public class JointList : ItemList<Joint>
{
    /// <summary>Handles a change of the list.</summary>
    /// <param name="joint">The joint added or removed.</param>
    public delegate void ContentsChangedEventHandler(Joint joint);

    /// <summary>Called when a joint has been added. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Added { get; set; }

    /// <summary>Called when a joint has been removed. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Removed { get; set; }

    private protected override bool IsHeard => Removed is not null;

    /// <summary>Adds a joint.</summary>
    /// <param name="joint">The joint.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="joint"/> is null.</exception>
    public new void Add(Joint joint) => AddItem(joint, nameof(joint));

    /// <summary>Removes a joint; one that is not in the list is ignored.</summary>
    /// <param name="joint">The joint.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="joint"/> is null.</exception>
    public new void Remove(Joint joint) => RemoveItem(joint, nameof(joint));

    /// <summary>Takes disposed joints out of the list. A simulator does it by itself at each update.</summary>
    public void RemoveDisposed() => DropDisposed();

    private protected override bool IsDisposed(Joint item) => item.IsDisposed;

    private protected override void TellAdded(Joint item) => Added?.Invoke(item);

    private protected override void TellRemoved(Joint item) => Removed?.Invoke(item);

    private protected override void OwnerAdd(Joint item) => Owner!.Add(item);

    private protected override void OwnerRemove(Joint item) => Owner!.Remove(item);

    private protected override void VisitHandlers(StateStream s)
    {
        Added = s.Reference(Added);
        Removed = s.Reference(Removed);
    }
}
