using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>A geom that entered or left a sensor: see <see cref="StepEvents"/>. (An addition to the original.)</summary>
/// <example>
/// <code>
/// simulator.RecordedEvents = StepEventKinds.Sensors;
/// simulator.Update(dt);
/// foreach (SensorEvent entered in simulator.Events.SensorsEntered)
/// {
///     Geom who = entered.Visitor;
/// }
/// </code>
/// </example>
public readonly struct SensorEvent : IPairEvent
{
    internal SensorEvent(Geom sensor, Geom visitor)
    {
        Sensor = sensor;
        Visitor = visitor;
    }

    /// <summary>The sensor.</summary>
    public Geom Sensor { get; }

    /// <summary>The geom that came or went. One that left may be disposed.</summary>
    public Geom Visitor { get; }

    ulong IPairEvent.Order => PairOrder.Of(Sensor, Visitor);

    /// <summary>The two geoms, for a debugger.</summary>
    /// <returns>Both as <see cref="Geom.ToString"/> says.</returns>
    public override string ToString() => Visitor + " in " + Sensor;
}
