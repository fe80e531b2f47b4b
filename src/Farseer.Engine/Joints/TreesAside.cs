using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints;

/// <summary>
/// Trees that are solved apart from the general passes for as long as they need nothing else, and then given back to them.
/// </summary>
internal abstract class TreesAside
{
    /// <summary>Trees given back by the last pass.</summary>
    [NotState(Why.OfOneStep)]
    public int GivenCount { get; set; }

    /// <summary>The rows of the step's start are no longer those of the present poses.</summary>
    [NotState(Why.OfOneStep)]
    public bool HasMoved { get; set; }

    /// <summary>Which tree was given back.</summary>
    public abstract int Given(int index);

    /// <summary>Joints of a tree that is given back, in the order of the sweep, of those that have rows.</summary>
    /// <param name="tree">Which of the trees given back last.</param>
    /// <param name="index">Which of its joints with rows.</param>
    /// <returns>The active joint, -1: there are no more.</returns>
    public abstract int GivenSoft(int tree, int index);
}
