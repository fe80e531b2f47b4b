using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics;

/// <content>Figures of the state as a whole, for tests, benchmarks and displays. (Additions to the original.)</content>
public partial class PhysicsSimulator
{
    /// <summary>Pairs of pieces that touch after the last update; a geom of a concave outline or a chain has several pieces. Counted when asked for.</summary>
    public int ContactCount => World.ContactCount;

    /// <summary>Deepest overlap of two geoms that push each other apart, a length of the scene, after the last update; 0 if there is none. Measured when asked for.</summary>
    public float LargestPenetration => World.LargestPenetration();

    /// <summary>
    /// A 64-bit hash of places and velocities of all bodies. The same scene gives the same hash on every platform and processor;
    /// two hashes that differ show that the states differ in at least one bit.
    /// </summary>
    /// <returns>The hash.</returns>
    public ulong StateHash() => World.StateHash();

    /// <summary>Tells those who watch the process what the step was like.</summary>
    private void TellStep()
    {
        StepFigures figures;
        figures.Step = StepCount;
        figures.Bodies = BodyList.Count;
        figures.Sleeping = World.AsleepCount;
        figures.Contacts = World.ContactCount;
        figures.Islands = World.IslandCount;
        figures.Substeps = World.Substeps;
        figures.MissedBudget = _errorBudget.IsBounded && World.HasMeasured && !Report.IsWithinBudget;
        StepSignals.TellStep(World, figures);
    }
}
