using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <summary>
/// Pairs of geoms. That of a simulator holds the pairs in contact after the last update; changing it does not change the
/// simulation, except from the <c>Update</c> of a user's own broad phase.
/// </summary>
/// <example>
/// <code>
/// int touching = simulator.ArbiterList.Count;
/// </code>
/// </example>
public class ArbiterList : List<Arbiter>
{
    /// <summary>Makes an empty list.</summary>
    public ArbiterList()
    {
    }

    /// <summary>Calls an action for each arbiter; the action may add and remove arbiters.</summary>
    /// <param name="action">The action.</param>
    /// <exception cref="ArgumentNullException"><paramref name="action"/> is null.</exception>
    public void ForEachSafe(Action<Arbiter> action)
    {
        Require.NotNull(action, nameof(action));
        foreach (Arbiter arbiter in ToArray())
        {
            action(arbiter);
        }
    }

    /// <summary>Removes the arbiters that match.</summary>
    /// <param name="match">Tells which to remove.</param>
    /// <exception cref="ArgumentNullException"><paramref name="match"/> is null.</exception>
    public void RemoveAllSafe(Predicate<Arbiter> match)
    {
        Require.NotNull(match, nameof(match));
        for (int i = Count - 1; i >= 0; i--)
        {
            if (i < Count && match(this[i]))
            {
                RemoveAt(i);
            }
        }
    }

    /// <summary>Removes the arbiters without contacts and puts them into a pool.</summary>
    /// <param name="arbiterPool">The pool.</param>
    /// <exception cref="ArgumentNullException"><paramref name="arbiterPool"/> is null.</exception>
    public void RemoveContactCountEqualsZero(Pool<Arbiter> arbiterPool) => RemoveToPool(arbiterPool, static a => a.ContactList.Count == 0);

    /// <summary>Removes the arbiters of which a geom or body is disposed and puts them into a pool.</summary>
    /// <param name="arbiterPool">The pool.</param>
    /// <exception cref="ArgumentNullException"><paramref name="arbiterPool"/> is null.</exception>
    public void RemoveContainsDisposedBody(Pool<Arbiter> arbiterPool) =>
        RemoveToPool(arbiterPool, static a => IsGone(a.GeomA) || IsGone(a.GeomB));

    private static bool IsGone(Geom? geom) => geom is null || geom.IsDisposed || geom.Body is null || geom.Body.IsDisposed;

    private void RemoveToPool(Pool<Arbiter> arbiterPool, Predicate<Arbiter> match)
    {
        Require.NotNull(arbiterPool, nameof(arbiterPool));
        for (int i = Count - 1; i >= 0; i--)
        {
            Arbiter arbiter = this[i];
            if (match(arbiter))
            {
                RemoveAt(i);
                arbiterPool.Insert(arbiter);
            }
        }
    }
}
