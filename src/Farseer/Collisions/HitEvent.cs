using System.Globalization;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>How two geoms met in an update: see <see cref="StepEvents.Hits"/>. (An addition to the original.)</summary>
/// <remarks>
/// The impulses are those of the whole update and of all contacts of the pair, not of the blow alone: a box that lands and stays is also
/// pushed by its weight in the same update. They are what changed the momentum of the bodies, mass times speed.
/// </remarks>
/// <example>
/// <code>
/// simulator.RecordedEvents = StepEventKinds.Hits;
/// simulator.Update(dt);
/// foreach (HitEvent hit in simulator.Events.Hits)
/// {
///     float loudness = hit.NormalImpulse;
/// }
/// </code>
/// </example>
public readonly struct HitEvent : IPairEvent
{
    internal HitEvent(Geom a, Geom b, Vector2 point, Vector2 normal, float approachSpeed, float normalImpulse, float tangentImpulse)
    {
        GeomA = a;
        GeomB = b;
        Point = point;
        Normal = normal;
        ApproachSpeed = approachSpeed;
        NormalImpulse = normalImpulse;
        TangentImpulse = tangentImpulse;
    }

    /// <summary>The geom created first.</summary>
    public Geom GeomA { get; }

    /// <summary>The other geom.</summary>
    public Geom GeomB { get; }

    /// <summary>The point where they met, in world coordinates; of several, the one with the largest impulse.</summary>
    public Vector2 Point { get; }

    /// <summary>The unit vector from <see cref="GeomA"/> to <see cref="GeomB"/> along which they pushed.</summary>
    public Vector2 Normal { get; }

    /// <summary>
    /// Speed at which the surfaces approached along the normal, length/s, above 0. Exact where bodies meet in free flight; otherwise as of
    /// the beginning of the substep of the impact, without its share of gravity.
    /// </summary>
    public float ApproachSpeed { get; }

    /// <summary>
    /// The impulse along the normal that pushed <see cref="GeomB"/>, and <see cref="GeomA"/> the other way; mass times length/s, above 0.
    /// </summary>
    public float NormalImpulse { get; }

    /// <summary>
    /// The impulse of friction, along (<see cref="Normal"/>.Y, -<see cref="Normal"/>.X) on <see cref="GeomB"/>; either sign.
    /// </summary>
    public float TangentImpulse { get; }

    ulong IPairEvent.Order => PairOrder.Of(GeomA, GeomB);

    /// <summary>The geoms, the speed and the impulse, for a debugger.</summary>
    /// <returns>A line of text.</returns>
    public override string ToString() => string.Format(
        CultureInfo.InvariantCulture, "{0} and {1} at {2} length/s, impulse {3}", GeomA, GeomB, ApproachSpeed, NormalImpulse);
}
