using Farseer.Engine.BroadPhase;
using Farseer.Engine.Continuous;
using Farseer.Engine.Graph;
using Farseer.Engine.Solver;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>
/// What the phases of a step work with and forget at its end. The worlds that a thread steps share it with their <see cref="Scratch"/>:
/// thousands of small ones have none of their own, and find in the cache what the one before them has left there.
/// </summary>
[NotState(Why.OfOneStep)]
internal sealed class StepTools
{
    public StepTools() => PairFlight = new PairFlight(Sweep, SecondSweep);

    public BodyWork Bodies { get; } = new BodyWork();

    /// <summary>Pairs that a search finds.</summary>
    public PairBuffer Pairs { get; } = new PairBuffer();

    public PairWork PairWork { get; } = new PairWork();

    public ContactUpdateWork ContactUpdate { get; } = new ContactUpdateWork();

    public IdleWork Idle { get; } = new IdleWork();

    public FastPairStage FastPairs { get; } = new FastPairStage();

    public StruckPairs Struck { get; } = new StruckPairs();

    public FreeMeetings Meetings { get; } = new FreeMeetings();

    public ColorRanges Ranges { get; } = new ColorRanges();

    public SubstepSolver Solver { get; } = new SubstepSolver();

    public SolverUnits Units { get; } = new SolverUnits();

    public BounceBound BounceBound { get; } = new BounceBound();

    public FastBodySweep Sweep { get; } = new FastBodySweep();

    /// <summary>The sweep of the other body of a pair.</summary>
    public FastBodySweep SecondSweep { get; } = new FastBodySweep();

    public PairFlight PairFlight { get; }

    public SweepWork Sweeps { get; } = new SweepWork();

    /// <summary>
    /// The tools that go with some memory. A step that throws leaves them as they are then, and takes them from it: no other world is to
    /// find them so.
    /// </summary>
    public static StepTools Of(Scratch scratch)
    {
        if (scratch.Tools is StepTools tools)
        {
            return tools;
        }

        tools = new StepTools();
        scratch.Tools = tools;
        return tools;
    }

    /// <summary>Forgets the world: that of the thread's last step is not to live for as long as the thread does.</summary>
    public void Forget()
    {
        Bodies.Forget();
        Ranges.Forget();
        PairWork.Forget();
        ContactUpdate.Forget();
        Idle.Forget();
        FastPairs.Forget();
        Struck.Forget();
        Meetings.Forget();
        Solver.Forget();
        Units.Forget();
        Sweeps.Forget();
    }
}
