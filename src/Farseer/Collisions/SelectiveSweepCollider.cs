namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>Sweeps along the axis on which the geoms are spread more. The default of a simulator.</summary>
/// <example>
/// <code>
/// simulator.BroadPhaseCollider = new SelectiveSweepCollider(simulator);
/// </code>
/// </example>
public sealed class SelectiveSweepCollider : LibraryCollider
{
    /// <summary>Makes a collider for a simulator; set <see cref="PhysicsSimulator.BroadPhaseCollider"/> to use it.</summary>
    /// <param name="physicsSimulator">The simulator.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    public SelectiveSweepCollider(PhysicsSimulator physicsSimulator)
        : base(physicsSimulator, new Farseer.Engine.BroadPhase.SelectiveSweep())
    {
    }

    /// <summary>Geoms leave the collider with the simulator's own <see cref="PhysicsSimulator.Clear"/>, so it does nothing.</summary>
    public void Clear()
    {
    }

    /// <summary>The pairs are found within <see cref="PhysicsSimulator.Update(float)"/>; a call from outside does nothing.</summary>
    public void InternalUpdate()
    {
    }
}
