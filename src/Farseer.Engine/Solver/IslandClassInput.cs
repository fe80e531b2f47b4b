using Farseer.Engine.Bodies;
using Farseer.Engine.Graph;
using Farseer.Engine.Islands;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Solver;

/// <summary>What <see cref="IslandClasses"/> reads of a step: its bodies and what joins them.</summary>
[NotState(Why.OfOneStep)]
internal unsafe struct IslandClassInput
{
    public JointSolver? Joints;
    public ConstraintGraph Graph;
    public IslandStore Islands;
    public SagForecast Forecast;
    public BodyStore Bodies;

    /// <summary>1 for a body that the solver may move.</summary>
    public byte* Moves;

    /// <summary>The bodies that are solved.</summary>
    public int* List;
    public int Count;
}
