namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>
/// Sorts the geoms into the cells of grids, one grid for each size of geom: the fastest for large scenes. (An addition to the
/// original.)
/// </summary>
/// <example>
/// <code>
/// simulator.BroadPhaseCollider = new GridCollider(simulator);
/// </code>
/// </example>
public sealed class GridCollider : LibraryCollider
{
    /// <summary>Makes a collider for a simulator; set <see cref="PhysicsSimulator.BroadPhaseCollider"/> to use it.</summary>
    /// <param name="physicsSimulator">The simulator.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    public GridCollider(PhysicsSimulator physicsSimulator)
        : base(physicsSimulator, new Farseer.Engine.BroadPhase.LevelGrid())
    {
    }
}
