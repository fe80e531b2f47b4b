using System;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// Kinds of events that a simulator records: see <see cref="PhysicsSimulator.RecordedEvents"/>. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// simulator.RecordedEvents = StepEventKinds.Hits | StepEventKinds.Sensors;
/// </code>
/// </example>
[Flags]
public enum StepEventKinds
{
    /// <summary>None: the default, which costs nothing.</summary>
    None = 0,

    /// <summary>
    /// Geoms that begin to touch and that part: <see cref="StepEvents.ContactsBegun"/>, <see cref="StepEvents.ContactsEnded"/>.
    /// </summary>
    Contacts = 1,

    /// <summary>Geoms that meet at speed: <see cref="StepEvents.Hits"/>.</summary>
    Hits = 2,

    /// <summary>
    /// Geoms that enter and leave sensors: <see cref="StepEvents.SensorsEntered"/>, <see cref="StepEvents.SensorsLeft"/>.
    /// </summary>
    Sensors = 4,

    /// <summary>Joints and springs that break: <see cref="StepEvents.BrokenJoints"/>, <see cref="StepEvents.BrokenSprings"/>.</summary>
    Breaks = 8,

    /// <summary>Bodies that fall asleep and wake: <see cref="StepEvents.FellAsleep"/>, <see cref="StepEvents.Woke"/>.</summary>
    Sleep = 16,

    /// <summary>Bodies that are no longer where they were: <see cref="StepEvents.Moved"/>.</summary>
    Moves = 32,

    /// <summary>Pairs of geoms that push each other, and by how much: <see cref="StepEvents.Pushes"/>.</summary>
    Pushes = 64,

    /// <summary>All kinds.</summary>
    All = 127,
}
