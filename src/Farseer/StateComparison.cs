using System.Collections.Generic;
using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// In what two states differ, field by field: of two simulators that were made by the same program, or of one at two times. It is made by
/// <see cref="PhysicsSimulator.Compare"/> and <see cref="PhysicsSimulatorState.Compare"/>.
/// </summary>
/// <remarks>
/// Compared is all that a state holds. The fields are those that captures write, and have the names that they have in the source: what is
/// saved is compared. References to bodies, geoms, joints, springs and controllers are the same if these were made as the same ones in
/// turn, handlers if they call the same method.
/// </remarks>
/// <example>
/// <code>
/// StateComparison comparison = simulator.Compare(peer);
/// if (!comparison.IsSame)
/// {
///     Console.WriteLine(comparison);
/// }
/// </code>
/// </example>
public sealed class StateComparison
{
    internal StateComparison(List<StateDifference> differences) => Differences = differences;

    /// <summary>Nothing differs.</summary>
    public bool IsSame => Differences.Count == 0;

    /// <summary>What differs, in the order in which a state is written; not more than were asked for.</summary>
    public IReadOnlyList<StateDifference> Differences { get; }

    /// <summary>The first of them; null if nothing differs.</summary>
    public StateDifference? First => IsSame ? null : Differences[0];

    /// <summary>A report: a line for each difference.</summary>
    /// <returns>The text.</returns>
    public override string ToString() => StateReport.Text(Differences);
}
