using System;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>
/// Which geoms a ray or another query of the <see cref="PhysicsSimulator"/> sees. Without one it sees all geoms whose
/// <see cref="Geom.CollisionEnabled"/> is true and that push others away; in no case those of bodies that are not enabled. One filter can
/// serve any number of queries. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// var filter = new QueryFilter { Categories = CollisionCategory.Cat1 };
/// bool isHit = simulator.RayCast(new Vector2(0, 5), new Vector2(0, -5), out RayCastHit hit, filter);
/// </code>
/// </example>
public sealed class QueryFilter
{
    /// <summary>
    /// A geom must be in one of these categories (<see cref="Geom.CollisionCategories"/>). Default <see cref="CollisionCategory.All"/>.
    /// </summary>
    public CollisionCategory Categories { get; set; } = CollisionCategory.All;

    /// <summary>
    /// True sees also geoms that push nothing away: sensors, and those whose <see cref="Geom.CollisionResponseEnabled"/> is false.
    /// Default false.
    /// </summary>
    public bool IncludeSensors { get; set; }

    /// <summary>A body whose geoms are not seen, for example the one that looks. Default null.</summary>
    public Body? IgnoredBody { get; set; }

    /// <summary>
    /// A callback that decides about a geom which has passed all other conditions. It is called in no particular order, perhaps more than
    /// once for a geom, and must not start another query. Default null: all are accepted.
    /// </summary>
    public Predicate<Geom>? Accept { get; set; }
}
