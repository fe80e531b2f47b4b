namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>Tests the box of every geom against that of every other: fine for few geoms.</summary>
/// <example>
/// <code>
/// simulator.BroadPhaseCollider = new BruteForceCollider(simulator);
/// </code>
/// </example>
public class BruteForceCollider : LibraryCollider
{
    /// <summary>Makes a collider for a simulator; set <see cref="PhysicsSimulator.BroadPhaseCollider"/> to use it.</summary>
    /// <param name="physicsSimulator">The simulator.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    public BruteForceCollider(PhysicsSimulator physicsSimulator)
        : base(physicsSimulator, new Farseer.Engine.BroadPhase.BruteForce())
    {
    }
}
