namespace Farseer.Engine.Stepping;

/// <summary>The phases of a step; the order of the members is the order of execution. Each is timed by <see cref="StepProfile"/>.</summary>
internal enum StepStage
{
    DeferredChanges,
    BroadPhase,
    NarrowPhase,
    GraphAndIslands,
    Forces,
    Solve,
    Finish,
    Continuous,
    Sleep,
    Count,
}
