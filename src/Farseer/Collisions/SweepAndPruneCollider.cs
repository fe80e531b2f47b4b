using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>Keeps the boxes sorted along both axes: good when geoms move little between updates.</summary>
/// <example>
/// <code>
/// simulator.BroadPhaseCollider = new SweepAndPruneCollider(simulator);
/// </code>
/// </example>
public partial class SweepAndPruneCollider : LibraryCollider
{
    /// <summary>Makes a collider for a simulator; set <see cref="PhysicsSimulator.BroadPhaseCollider"/> to use it.</summary>
    /// <param name="physicsSimulator">The simulator.</param>
    /// <exception cref="System.ArgumentNullException"><paramref name="physicsSimulator"/> is null.</exception>
    public SweepAndPruneCollider(PhysicsSimulator physicsSimulator)
        : base(physicsSimulator, new Farseer.Engine.BroadPhase.SweepAndPrune())
    {
    }

    /// <summary>The pairs found by the last <see cref="Run"/>. The simulation does not use it.</summary>
    [NotState(Why.OfOneStep)]
    public CollisionPairDictionary CollisionPairs { get; } = new CollisionPairDictionary();

    /// <summary>Tells if two geoms would become a pair once their boxes overlap.</summary>
    /// <param name="g1">One geom.</param>
    /// <param name="g2">The other geom.</param>
    /// <returns>False if a filter, a disabled body or two static bodies forbid it, or a geom has no body.</returns>
    /// <exception cref="System.ArgumentNullException">A geom is null.</exception>
    public static bool DoCollision(Geom g1, Geom g2) =>
        EngineCollider.MayCollide(Require.NotNull(g1, nameof(g1)), Require.NotNull(g2, nameof(g2)));

    /// <summary>Teleports are found by themselves, so there is nothing to force and it does nothing.</summary>
    public void ForceNonIncrementalUpdate()
    {
    }

    /// <summary>Fills <see cref="CollisionPairs"/> with the pairs whose boxes overlap now. For inspection.</summary>
    public void Run()
    {
        CollisionPairs.Clear();
        GeomList geoms = Core.Owner.GeomList;
        for (int i = 0; i < geoms.Count; i++)
        {
            for (int j = i + 1; j < geoms.Count; j++)
            {
                if (AABB.Intersect(geoms[i].AABB, geoms[j].AABB) && DoCollision(geoms[i], geoms[j]))
                {
                    CollisionPairs.AddPair(geoms[i], geoms[j]);
                }
            }
        }
    }
}
