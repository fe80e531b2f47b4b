using System.Numerics;

namespace FarseerGames.FarseerPhysics.Viewer;

/// <summary>What a <see cref="RunRecorder"/> records, and how the page shows it.</summary>
/// <example>
/// <code>
/// var recorder = new RunRecorder(simulator, new RunRecorderOptions { Title = "Level 3", MostBytes = 5_000_000 });
/// </code>
/// </example>
public sealed class RunRecorderOptions
{
    /// <summary>The heading of the page. Default "Farseer".</summary>
    public string Title { get; set; } = "Farseer";

    /// <summary>
    /// Largest size that the data of a recording should have in the file, bytes; above 0. Where all bits need more, as few digits as
    /// necessary are left out, and the page says how many; the last resort is to leave out contacts. What is recorded in memory keeps
    /// all bits. Default 20,000,000.
    /// </summary>
    public long MostBytes { get; set; } = 20_000_000;

    /// <summary>True records contacts with their normals, depths and impulses. Default true.</summary>
    public bool Contacts { get; set; } = true;

    /// <summary>
    /// True asks the simulator for events (<see cref="PhysicsSimulator.RecordedEvents"/>): contacts, hits, sensors, breaks and sleep.
    /// Default true.
    /// </summary>
    public bool Events { get; set; } = true;

    /// <summary>True asks the simulator for its accuracy report (<see cref="PhysicsSimulator.EnableReport"/>). Default true.</summary>
    public bool Report { get; set; } = true;

    /// <summary>
    /// True adds up impulses over whole updates (<see cref="PhysicsSimulator.SumImpulses"/>), so that they are exact. Default true.
    /// </summary>
    public bool SumImpulses { get; set; } = true;

    /// <summary>
    /// Least corner of what the page shows at first, in the world. Default (0, 0); with <see cref="ViewMax"/> equal to it: what there is.
    /// </summary>
    public Vector2 ViewMin { get; set; }

    /// <summary>The other corner. Default (0, 0).</summary>
    public Vector2 ViewMax { get; set; }

    /// <summary>True: y upwards. Null, the default: upwards unless gravity points along +y.</summary>
    public bool? IsYUp { get; set; }
}
