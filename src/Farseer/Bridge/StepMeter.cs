#if NET8_0_OR_GREATER
using System.Collections.Generic;
using System.Diagnostics.Metrics;
using Farseer.Engine.Stepping;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Metrics of the steps of all simulators of the process.</summary>
internal static class StepMeter
{
    private static readonly Meter _meter = new Meter(StepSignals.Name);
    private static readonly Histogram<double> _duration =
        _meter.CreateHistogram<double>("farseer.step.duration", "s", "Time of a step.");

    private static readonly Histogram<double> _phase =
        _meter.CreateHistogram<double>("farseer.step.phase.duration", "s", "Time of one phase of a step.");

    private static readonly Histogram<int> _bodies = _meter.CreateHistogram<int>("farseer.step.bodies", "{body}", "Bodies in a step.");
    private static readonly Histogram<int> _sleeping =
        _meter.CreateHistogram<int>("farseer.step.sleeping", "{body}", "Bodies asleep after a step.");
    private static readonly Histogram<int> _contacts =
        _meter.CreateHistogram<int>("farseer.step.contacts", "{contact}", "Contacts after a step.");
    private static readonly Histogram<int> _islands =
        _meter.CreateHistogram<int>("farseer.step.islands", "{island}", "Islands told apart in a step.");
    private static readonly Histogram<int> _substeps =
        _meter.CreateHistogram<int>("farseer.step.substeps", "{substep}", "Substeps of a step.");
    private static readonly Counter<long> _missed =
        _meter.CreateCounter<long>("farseer.budget.missed", "{step}", "Steps that missed their error budget.");

    private static readonly Counter<long> _rollbacks =
        _meter.CreateCounter<long>("farseer.rollbacks", "{rollback}", "States gone back to.");

    private static readonly KeyValuePair<string, object?>[] _phases =
    [
        new("phase", "changes"), new("phase", "broad_phase"), new("phase", "narrow_phase"), new("phase", "islands"), new("phase", "forces"),
        new("phase", "solve"), new("phase", "finish"), new("phase", "continuous"), new("phase", "sleep"),
    ];

    /// <summary>Somebody hears of steps.</summary>
    public static bool IsHeard =>
        _duration.Enabled
        || _phase.Enabled
        || _bodies.Enabled
        || _sleeping.Enabled
        || _contacts.Enabled
        || _islands.Enabled
        || _substeps.Enabled
        || _missed.Enabled;

    public static void Tell(StepProfile profile, in StepFigures figures)
    {
        _duration.Record(profile.Total);
        for (int stage = 0; _phase.Enabled && stage < _phases.Length; stage++)
        {
            _phase.Record(profile[(StepStage)stage], _phases[stage]);
        }

        _bodies.Record(figures.Bodies);
        _sleeping.Record(figures.Sleeping);
        _contacts.Record(figures.Contacts);
        _islands.Record(figures.Islands);
        _substeps.Record(figures.Substeps);
        if (figures.MissedBudget)
        {
            _missed.Add(1);
        }
    }

    public static void TellRollback() => _rollbacks.Add(1);
}
#endif
