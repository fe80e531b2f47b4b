using System.Collections.Generic;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Dynamics.Joints;

/// <summary>
/// A list of joints that tells of additions and removals. That of a simulator is a view of what it simulates:
/// <see cref="Add"/> and <see cref="Remove"/> then stand for those of the simulator, which take effect at the next update.
/// </summary>
public class JointList : List<Joint>
{
    /// <summary>Handles a change of the list.</summary>
    /// <param name="joint">The joint added or removed.</param>
    public delegate void ContentsChangedEventHandler(Joint joint);

    /// <summary>Called when a joint has been added. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Added { get; set; }

    /// <summary>Called when a joint has been removed. Use with +=. Default null.</summary>
    public ContentsChangedEventHandler? Removed { get; set; }

    [NotState(Why.Fixed)]
    internal PhysicsSimulator? Owner { get; set; }

    /// <summary>Adds a joint.</summary>
    /// <param name="joint">The joint.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="joint"/> is null.</exception>
    public new void Add(Joint joint)
    {
        Require.NotNull(joint, nameof(joint));
        if (Owner is null)
        {
            TakeIn(joint);
        }
        else
        {
            Owner.Add(joint);
        }
    }

    /// <summary>Removes a joint; one that is not in the list is ignored.</summary>
    /// <param name="joint">The joint.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="joint"/> is null.</exception>
    public new void Remove(Joint joint)
    {
        Require.NotNull(joint, nameof(joint));
        if (Owner is null)
        {
            TakeOut(joint);
        }
        else
        {
            Owner.Remove(joint);
        }
    }

    /// <summary>Takes disposed joints out of the list. A simulator does it by itself at each update.</summary>
    public void RemoveDisposed()
    {
        for (int i = Count - 1; i >= 0; i--)
        {
            if (this[i].IsDisposed)
            {
                Joint removed = this[i];
                RemoveAt(i);
                Removed?.Invoke(removed);
            }
        }
    }

    internal void TakeIn(Joint joint)
    {
        base.Add(joint);
        Added?.Invoke(joint);
    }

    internal void TakeOut(Joint joint)
    {
        if (base.Remove(joint))
        {
            Removed?.Invoke(joint);
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
