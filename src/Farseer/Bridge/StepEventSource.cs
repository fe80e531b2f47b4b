using System;
#if NET8_0_OR_GREATER
using System.Diagnostics.CodeAnalysis;
#endif
using System.Diagnostics.Tracing;
using Farseer.Engine.Stepping;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Events of steps for tracing tools. The order of the numbers is that of the parameters of each event's method, which the tools read from
/// the method.
/// </summary>
[EventSource(Name = StepSignals.Name)]
internal sealed unsafe class StepEventSource : EventSource
{
    public static readonly StepEventSource Log = new StepEventSource();

    private const int StepEvent = 1;
    private const int RollbackEvent = 2;
    private const int Counts = 7;
    private const int Numbers = Counts + (int)StepStage.Count;

    private StepEventSource()
    {
    }

    /// <summary>A step ended. Times are seconds.</summary>
    [Event(StepEvent, Level = EventLevel.Informational)]
    public void Step(
        long step,
        int bodies,
        int sleeping,
        int contacts,
        int islands,
        int substeps,
        bool missedBudget,
        double changes,
        double broadPhase,
        double narrowPhase,
        double islandsTime,
        double forces,
        double solve,
        double finish,
        double continuous,
        double sleep)
    {
        // The schema of what Tell writes, which does so without boxing.
        _ = step + bodies + sleeping + contacts + islands + substeps + changes + broadPhase + narrowPhase + islandsTime + forces + solve
            + finish
            + continuous + sleep;
        _ = missedBudget;
    }

    /// <summary>A simulator went back to a state, of so many bytes; the step is that which it had come to before.</summary>
    [Event(RollbackEvent, Level = EventLevel.Informational)]
#if NET8_0_OR_GREATER
    [UnconditionalSuppressMessage("Trimming", "IL2026", Justification = "All parameters are primitive.")]
#endif
    public void Rollback(long step, int bytes)
    {
        EventData* data = stackalloc EventData[2];
        Set(data, &step, sizeof(long));
        Set(data + 1, &bytes, sizeof(int));
        WriteEventCore(RollbackEvent, 2, data);
    }

    [NonEvent]
#if NET8_0_OR_GREATER
    [UnconditionalSuppressMessage("Trimming", "IL2026", Justification = "All parameters are primitive.")]
#endif
    public void Tell(StepProfile profile, in StepFigures figures)
    {
        StepFigures f = figures;
        int missed = f.MissedBudget ? 1 : 0;
        double* seconds = stackalloc double[(int)StepStage.Count];
        EventData* data = stackalloc EventData[Numbers];
        Set(data, &f.Step, sizeof(long));
        Set(data + 1, &f.Bodies, sizeof(int));
        Set(data + 2, &f.Sleeping, sizeof(int));
        Set(data + 3, &f.Contacts, sizeof(int));
        Set(data + 4, &f.Islands, sizeof(int));
        Set(data + 5, &f.Substeps, sizeof(int));

        // A bool is four bytes in an event.
        Set(data + 6, &missed, sizeof(int));
        for (int stage = 0; stage < (int)StepStage.Count; stage++)
        {
            seconds[stage] = profile[(StepStage)stage];
            Set(data + Counts + stage, seconds + stage, sizeof(double));
        }

        WriteEventCore(StepEvent, Numbers, data);
    }

    private static void Set(EventData* data, void* value, int size)
    {
        *data = default;
        data->DataPointer = (IntPtr)value;
        data->Size = size;
    }
}
