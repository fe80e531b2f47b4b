using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Interfaces;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>Tests the box of every geom against that of every other: fine for few geoms.</summary>
public class BruteForceCollider : IBroadPhaseCollider, IEngineCollider
{
    private readonly EngineCollider _core;

    /// <summary>Makes a collider for a simulator; set <see cref="PhysicsSimulator.BroadPhaseCollider"/> to use it.</summary>
    /// <param name="physicsSimulator">The simulator.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    public BruteForceCollider(PhysicsSimulator physicsSimulator) =>
        _core = new EngineCollider(physicsSimulator, new Farseer.Engine.BroadPhase.BruteForce());

    /// <inheritdoc/>
    public event BroadPhaseCollisionHandler OnBroadPhaseCollision
    {
        add => _core.Add(value);
        remove => _core.Remove(value);
    }

    EngineCollider IEngineCollider.Core => _core;

    /// <summary>The simulator calls it; the collider already knows its geoms by then, so it does nothing.</summary>
    /// <param name="geom">The geom.</param>
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
