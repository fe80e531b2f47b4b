using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>A pair of geoms that began or ceased to touch: see <see cref="StepEvents"/>. (An addition to the original.)</summary>
/// <example>
/// <code>
/// simulator.RecordedEvents = StepEventKinds.Contacts;
/// simulator.Update(dt);
/// foreach (ContactEvent begun in simulator.Events.ContactsBegun)
/// {
///     Geom first = begun.GeomA;
/// }
/// </code>
/// </example>
public readonly struct ContactEvent : IPairEvent
{
    internal ContactEvent(Geom a, Geom b)
    {
        GeomA = a;
        GeomB = b;
    }

    /// <summary>The geom created first. One whose contact ended may be disposed.</summary>
    public Geom GeomA { get; }

    /// <summary>The other geom.</summary>
    public Geom GeomB { get; }

    ulong IPairEvent.Order => PairOrder.Of(GeomA, GeomB);

    /// <summary>The two geoms, for a debugger.</summary>
    /// <returns>Both as <see cref="Geom.ToString"/> says.</returns>
    public override string ToString() => GeomA + " and " + GeomB;
}
