using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Interfaces;

/// <summary>Handles a pair found by the broad phase.</summary>
/// <param name="geometry1">The geom created first.</param>
/// <param name="geometry2">The other geom.</param>
/// <returns>False to leave the pair out: no narrow phase, no events, no impulses.</returns>
/// <example>
/// <code>
/// simulator.BroadPhaseCollider.OnBroadPhaseCollision += (first, second) =&gt; first.Tag != second.Tag;
/// </code>
/// </example>
public delegate bool BroadPhaseCollisionHandler(Geom geometry1, Geom geometry2);

/// <summary>
/// Finds the pairs of geoms that may touch. The library's own colliders differ in speed only; a class of the user works too: its
/// <see cref="Update"/> adds an <see cref="Dynamics.Arbiter"/> for each pair to <see cref="PhysicsSimulator.ArbiterList"/>.
/// </summary>
/// <example>
/// <code>
/// IBroadPhaseCollider collider = new GridCollider(simulator);
/// simulator.BroadPhaseCollider = collider;
/// </code>
/// </example>
public interface IBroadPhaseCollider
{
    /// <summary>
    /// Raised for each pair whose boxes have come to overlap and that the filters let through. One handler that returns false
    /// leaves the pair out.
    /// </summary>
    event BroadPhaseCollisionHandler OnBroadPhaseCollision;

    /// <summary>Called when a geom has been taken into the simulator.</summary>
    /// <param name="geom">The geom.</param>
    void Add(Geom geom);

    /// <summary>Called when disposed geoms have been swept out of the simulator.</summary>
    void ProcessDisposedGeoms();

    /// <summary>Called when geoms have been removed from the simulator.</summary>
    void ProcessRemovedGeoms();

    /// <summary>Called once a step to find the pairs.</summary>
    void Update();
}
