using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>What two geoms gave each other in an update: see <see cref="StepEvents.Pushes"/>. (An addition to the original.)</summary>
/// <example>
/// <code>
/// simulator.RecordedEvents = StepEventKinds.Pushes;
/// simulator.Update(1f / 60);
/// foreach (PushEvent push in simulator.Events.Pushes)
/// {
///     Console.WriteLine($"{push.GeomA} gave {push.GeomB} {push.Impulse}");
/// }
/// </code>
/// </example>
public readonly struct PushEvent : IPairEvent
{
    internal PushEvent(Geom a, Geom b, Vector2 impulse)
    {
        GeomA = a;
        GeomB = b;
        Impulse = impulse;
    }

    /// <summary>The geom created first.</summary>
    public Geom GeomA { get; }

    /// <summary>The other geom.</summary>
    public Geom GeomB { get; }

    /// <summary>
    /// The impulse of all their contacts, friction included, on the body of <see cref="GeomB"/>; that of <see cref="GeomA"/> got the
    /// opposite. Mass times length/s.
    /// </summary>
    public Vector2 Impulse { get; }

    ulong IPairEvent.Order => PairOrder.Of(GeomA, GeomB);

    /// <summary>The two geoms and the impulse, for a debugger.</summary>
    /// <returns>A line of text.</returns>
    public override string ToString() => GeomA + " and " + GeomB + ": " + Impulse;
}
