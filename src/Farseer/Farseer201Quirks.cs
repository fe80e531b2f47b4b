using System;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// Behaviours of Farseer Physics 2.0.1 that deviate from physics or from its own manual. By default the library does the right
/// thing; a game that was tuned to one of these asks for it with <see cref="PhysicsSimulator.Quirks"/>. Set the quirks before
/// anything is added: what a factory or a pair in contact has already worked out is not worked out again.
/// </summary>
/// <example>
/// <code>
/// simulator.Quirks = Farseer201Quirks.All;
/// </code>
/// </example>
[Flags]
public enum Farseer201Quirks
{
    /// <summary>No quirk: the default.</summary>
    None = 0,

    /// <summary>
    /// <see cref="Dynamics.Body.ApplyImpulse(System.Numerics.Vector2)"/> divides by the mass twice: Δv = J / m² instead of J / m.
    /// </summary>
    ImpulseDividedByMassTwice = 1,

    /// <summary>
    /// The moment of inertia of an ellipse body is m (rx² + ry²) / 12 with the radii unless both are equal: a third of the right
    /// m (rx² + ry²) / 4.
    /// </summary>
    EllipseInertiaFromRectangle = 2,

    /// <summary>
    /// The moment of inertia of a polygon body adds the absolute values of its triangles: exact for convex outlines, wrong for
    /// outlines with an edge that the centroid sees from behind (an L of 6 squares: 1105.8 instead of 1157.3).
    /// </summary>
    PolygonInertiaUnsigned = 4,

    /// <summary>
    /// Setting <see cref="Dynamics.Body.Rotation"/> adds the whole turns of the value to <see cref="Dynamics.Body.Revolutions"/>
    /// instead of setting it.
    /// </summary>
    RotationSetAddsRevolutions = 8,

    /// <summary>
    /// The friction of a pair is worked out once, when the pair is made; later changes of
    /// <see cref="Collisions.Geom.FrictionCoefficient"/> do not reach a pair in contact. Switched on while pairs are in contact it keeps
    /// the frictions that they have at that time.
    /// </summary>
    PairFrictionFrozen = 16,

    /// <summary>
    /// <see cref="Collisions.Geom.OnSeparation"/> is raised on every step for pairs whose boxes overlap without contact and for
    /// pairs whose contact an <see cref="Collisions.Geom.OnCollision"/> handler cancelled.
    /// </summary>
    SeparationWithoutContact = 32,

    /// <summary>No <see cref="Collisions.Geom.OnSeparation"/> when a touching geom is removed or disposed.</summary>
    NoSeparationOnRemoval = 64,

    /// <summary>
    /// Two geoms collide if one of them wants the other; by default both must: each one's
    /// <see cref="Collisions.Geom.CollidesWith"/> must hold a category of the other.
    /// </summary>
    OneSidedCategoryFilter = 128,

    /// <summary>Forces and torques applied while the simulator is not enabled add up and act at once when it is enabled again.</summary>
    ForcesAccumulateWhilePaused = 256,

    /// <summary>The offset of a geom is turned by body rotation + rotation offset instead of by the body rotation alone.</summary>
    OffsetTurnedByRotationOffset = 512,

    /// <summary>
    /// Setting <see cref="Collisions.Geom.IsSensor"/> also sets <see cref="Dynamics.Body.IsStatic"/> of its body to the same value.
    /// </summary>
    SensorMakesBodyStatic = 1024,

    /// <summary>
    /// A spring breaks by the error that it had in the update before, and still pulls in the update in which it breaks; by default
    /// it is judged by its present error and pulls no more.
    /// </summary>
    SpringBreaksLate = 2048,

    /// <summary>A joint still holds its bodies in the update in which it breaks; by default it lets them go at once.</summary>
    JointBreaksLate = 4096,

    /// <summary>
    /// Pins, sliders and springs of a <see cref="Dynamics.Path"/> join the left end of a link with the right end of the next one, and all
    /// but the first are as long as a link is wide: a path that runs to the right shrinks until its links lie on each other. By
    /// default they join the ends that face each other, at the distance these have.
    /// </summary>
    PathLinkedAtFarEnds = 8192,

    /// <summary>
    /// Forces and torques change the velocity when an update begins, which then carries the body; by default they act evenly over the
    /// update. What is constant then moves a body too far, but a spring that a program makes of forces of its own, one for each update,
    /// neither gains nor loses, where by default each update adds the share (ω·dt)²/4 to its swing.
    /// </summary>
    ForcesActAtOnce = 16384,

    /// <summary>
    /// A fluid lifts the polygon of those vertices of a geom that are in it, from three on: what has few corners sinks to the last of them
    /// and bobs. By default the part that is in the fluid is exact.
    /// </summary>
    BuoyancyOfVertices = 32768,

    /// <summary>
    /// A target angle that is set on a <see cref="Dynamics.Springs.AngleSpring"/> is cut to ±5.5 radians; one that it had when it was
    /// made is not.
    /// </summary>
    AngleSpringTargetLimited = 65536,

    /// <summary>
    /// The links of a <see cref="Dynamics.Path"/> that runs straight up or down lie across it, at rotation 0. By default they point
    /// along it.
    /// </summary>
    UprightPathsLieAcross = 131072,

    /// <summary>
    /// The normals that an <see cref="Collisions.Geom.OnCollision"/> handler gets point from the geom created first to the other, whichever
    /// of them is the handler's first argument. By default they point from the first argument to the second.
    /// </summary>
    NormalsFromOlderGeom = 262144,

    /// <summary>All quirks.</summary>
    All = 524287,
}
