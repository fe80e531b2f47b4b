using Farseer.Engine.Simulation;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// What a simulator tells those who watch the process: see docs/Observability.md. While nobody does, it costs a few comparisons an update.
/// </summary>
internal static class StepSignals
{
    /// <summary>The name of the event source and of the meter.</summary>
    public const string Name = "Farseer.Physics";

    /// <summary>Somebody hears of steps.</summary>
    public static bool AreHeard =>
#if NET8_0_OR_GREATER
        StepMeter.IsHeard ||
#endif
        StepEventSource.Log.IsEnabled();

    /// <summary>Tells of the step that just ended, which was profiled.</summary>
    public static void TellStep(World world, in StepFigures figures)
    {
#if NET8_0_OR_GREATER
        StepMeter.Tell(world.Profile, figures);
#endif
        if (StepEventSource.Log.IsEnabled())
        {
            StepEventSource.Log.Tell(world.Profile, figures);
        }
    }

    /// <summary>Tells that a simulator went back to a state.</summary>
    public static void TellRollback(long step, int bytes)
    {
#if NET8_0_OR_GREATER
        StepMeter.TellRollback();
#endif
        if (StepEventSource.Log.IsEnabled())
        {
            StepEventSource.Log.Rollback(step, bytes);
        }
    }
}

/// <summary>Numbers of a step, but for its times.</summary>
internal struct StepFigures
{
    public long Step;
    public int Bodies;
    public int Sleeping;
    public int Contacts;
    public int Islands;
    public int Substeps;

    /// <summary>There is an error budget, and the step missed it.</summary>
    public bool MissedBudget;
}
