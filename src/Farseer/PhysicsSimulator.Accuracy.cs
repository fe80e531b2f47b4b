using System;
using System.Diagnostics;
using Farseer.Engine.Accuracy;
using Farseer.Engine.Settings;

using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics;

/// <content>What an update says of its own error, and the error that is asked for. (Additions to the original.)</content>
public partial class PhysicsSimulator
{
    private readonly PaceControl _pace = new PaceControl();
    private ErrorBudget _errorBudget;

    /// <summary>
    /// True fills <see cref="Report"/> in each update; false, the default, costs nothing. The motion is the same, bit for bit.
    /// </summary>
    public bool EnableReport
    {
        get => World.Accuracy.ReportEnabled;
        set => World.Accuracy.ReportEnabled = value;
    }

    /// <summary>
    /// The errors of the last update. Filled while <see cref="EnableReport"/> is true or there is an <see cref="ErrorBudget"/>.
    /// </summary>
    public StepReport Report { get; private set; }

    /// <summary>
    /// The largest <see cref="StepReport.Error"/> that each update may have: overlap, separation, slip, impacts, and the estimated error of
    /// the motion. The simulator takes the iterations that keep the error below it, at least <see cref="Iterations"/> and at most those of
    /// the budget, and <see cref="StepReport.IsWithinBudget"/> says whether it could. It goes by the errors of earlier updates, so the
    /// first updates under a new load may miss the budget. The same scene gives the same bits, unless the budget has an
    /// <see cref="FarseerPhysics.ErrorBudget.TimeLimit"/>. Default <see cref="FarseerPhysics.ErrorBudget.None"/>.
    /// </summary>
    public ErrorBudget ErrorBudget
    {
        get => _errorBudget;
        set
        {
            _errorBudget = value;
            World.Accuracy.Budget.Length = value.Length;
            World.Accuracy.Budget.Share = value.Share;
            World.Accuracy.Budget.MostSubsteps = value.MostIterations;
            World.Accuracy.Budget.Reset();
            _pace.Reset();
        }
    }

    /// <summary>A step of the world, with no more iterations than the budget's time allows.</summary>
    private void StepWorld(float dt)
    {
        TimeSpan limit = _errorBudget.TimeLimit;
        if (limit == TimeSpan.Zero || !_errorBudget.IsBounded)
        {
            SharedScratch.Step(World, dt);
            FillReport(TimeSpan.Zero, TimeSpan.Zero);
            return;
        }

        World.Accuracy.Budget.MostSubsteps = Math.Min(_errorBudget.MostIterations, _pace.Most(limit.TotalSeconds));
        long start = Stopwatch.GetTimestamp();
        SharedScratch.Step(World, dt);
        double seconds = (Stopwatch.GetTimestamp() - start) / (double)Stopwatch.Frequency;
        if (World.Accuracy.HasMeasured)
        {
            _pace.Learn(seconds, World.Accuracy.Measures.Substeps);
        }

        FillReport(new TimeSpan((long)(seconds * TimeSpan.TicksPerSecond)), limit);
    }

    private void FillReport(TimeSpan stepTime, TimeSpan timeLimit)
    {
        if (!World.Accuracy.HasMeasured)
        {
            return;
        }

        ref readonly StepMeasures measures = ref World.Accuracy.Measures;
        Report = new StepReport(
            measures,
            measures.WorstBody >= 0 ? _table.Body(measures.WorstBody) : null,
            measures.WorstPartner >= 0 ? _table.Body(measures.WorstPartner) : null,
            measures.WorstJoint >= 0 ? _jointRelay.Find(measures.WorstJoint) : null,
            World.Accuracy.Budget.Load(measures),
            stepTime,
            timeLimit);
    }
}
