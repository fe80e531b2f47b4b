using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>
/// A list of geoms that tells of additions and removals. That of a simulator is a view of what it simulates:
/// <see cref="Add"/> and <see cref="Remove"/> then stand for those of the simulator, which take effect at the next update.
/// </summary>
/// <example>
/// <code>
/// simulator.GeomList.Removed += gone =&gt; Console.WriteLine(gone + " left");
/// </code>
/// </example>
public class GeomList : ItemList<Geom>
{
    /// <summary>Handles a change of the list.</summary>
    /// <param name="geom">The geom added or removed.</param>
    public delegate void ContentsChangedEventHandler(Geom geom);

    /// <summary>Called when a geom has been added. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Added { get; set; }

    /// <summary>Called when a geom has been removed. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Removed { get; set; }

    private protected override bool IsHeard => Removed is not null;

    /// <summary>Adds a geom.</summary>
    /// <param name="geom">The geom.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="geom"/> is null.</exception>
    public new void Add(Geom geom) => AddItem(geom, nameof(geom));

    /// <summary>Removes a geom; one that is not in the list is ignored.</summary>
    /// <param name="geom">The geom.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="geom"/> is null.</exception>
    public new void Remove(Geom geom) => RemoveItem(geom, nameof(geom));

    /// <summary>Takes disposed geoms out of the list. A simulator does it by itself at each update.</summary>
    /// <returns>The number of geoms taken out.</returns>
    public int RemoveDisposed() => DropDisposed();

    private protected override bool IsDisposed(Geom item) => item.IsDisposed;

    private protected override void TellAdded(Geom item) => Added?.Invoke(item);

    private protected override void TellRemoved(Geom item) => Removed?.Invoke(item);

    private protected override void OwnerAdd(Geom item) => Owner!.Add(item);

    private protected override void OwnerRemove(Geom item) => Owner!.Remove(item);

    private protected override void VisitHandlers(StateStream s)
    {
        Added = s.Reference(Added);
        Removed = s.Reference(Removed);
    }
}
