using Farseer.Engine.BroadPhase;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Interfaces;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>
/// A collider of the library: the engine finds the pairs within <see cref="PhysicsSimulator.Update(float)"/>, and what the interface has
/// for colliders written by users does nothing.
/// </summary>
/// <example>
/// <code>
/// LibraryCollider search = new GridCollider(simulator);
/// search.OnBroadPhaseCollision += (one, two) =&gt; one.Tag != two.Tag;
/// simulator.BroadPhaseCollider = search;
/// </code>
/// </example>
public abstract class LibraryCollider : IBroadPhaseCollider
{
    private protected LibraryCollider(PhysicsSimulator physicsSimulator, IBroadPhase engine) =>
        Core = new EngineCollider(physicsSimulator, engine);

    /// <inheritdoc/>
    public event BroadPhaseCollisionHandler OnBroadPhaseCollision
    {
        add => Core.Add(value);
        remove => Core.Remove(value);
    }

    [NotState(Why.Fixed)]
    internal EngineCollider Core { get; }

    /// <summary>The simulator calls it; the collider already knows its geoms by then, so it does nothing.</summary>
    /// <param name="geom">The geom.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="geom"/> is null.</exception>
    public void Add(Geom geom) => Require.NotNull(geom, nameof(geom));

    /// <summary>The simulator calls it; geoms leave the collider by themselves, so it does nothing.</summary>
    public void ProcessDisposedGeoms()
    {
    }

    /// <summary>The simulator calls it; geoms leave the collider by themselves, so it does nothing.</summary>
    public void ProcessRemovedGeoms()
    {
    }

    /// <summary>The pairs are found within <see cref="PhysicsSimulator.Update(float)"/>; a call from outside does nothing.</summary>
    public void Update()
    {
    }
}
