using System;
using Farseer.Engine.Accuracy;
using Farseer.Engine.Solver;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>What a step reports of itself, and the substeps that a budget of error asks for.</summary>
internal sealed class AccuracyStage : WorldPhase
{
    private ErrorMeter? _meter;
    private EnergyAudit? _audit;
    private ImpactLaw? _impactLaw;
    private StepMeasures _measures;
    private int _mostSubsteps;

    // As they were when the step began: a handler may switch within it.
    private bool _reports;
    private bool _budgeted;

    public AccuracyStage(WorldStores stores)
        : base(stores)
    {
    }

    /// <summary>Each step measures what it did. Off by default: then nothing of it runs, and no bit changes either way.</summary>
    public bool ReportEnabled { get; set; }

    public BudgetControl Budget { get; } = new BudgetControl();

    /// <summary>The last step measured itself.</summary>
    public bool HasMeasured { get; private set; }

    /// <summary>Of the last step that measured itself.</summary>
    public ref readonly StepMeasures Measures => ref _measures;

    /// <summary>The audit of this step, or null if nobody wants it.</summary>
    public EnergyAudit? Audit => _reports ? _audit : null;

    public void Begin()
    {
        // Once for the whole step: a handler may turn the dial, and the substeps must add up to the step.
        _stores.Substeps = Budget.Choose(_settings.Substeps);
        _mostSubsteps = _stores.Substeps;
        _budgeted = Budget.IsOn;
        _reports = ReportEnabled || _budgeted;
        if (_reports)
        {
            MakeAudit().BeginStep(_bodies);
        }
    }

    private EnergyAudit MakeAudit() => _audit ??= new EnergyAudit();

    private ErrorMeter MakeMeter() => _meter ??= new ErrorMeter(_bodies, _shapes, _contacts, _graph, _joints);

    private ImpactLaw MakeImpactLaw() => _impactLaw ??= new ImpactLaw(_bodies, _contacts, _graph, _joints, MakeMeter());

    public void End(float dt)
    {
        HasMeasured = _reports;
        if (!HasMeasured || _audit == null)
        {
            return;
        }

        ErrorMeter meter = MakeMeter();
        ImpactLaw impactLaw = MakeImpactLaw();
        _measures = default;
        _measures.Substeps = _stores.Substeps;
        _measures.MostSubsteps = _mostSubsteps;
        meter.Measure(ref _measures, _settings, _audit);
        _audit.EndStep(ref _measures, meter.Groups, dt);
        if (!_stores.AnyUserJoints)
        {
            impactLaw.Run(ref _measures, _audit, dt);
        }

        JudgeOutcasts();
        meter.NameGroup(ref _measures);
        if (_budgeted && Budget.IsOn)
        {
            Budget.Learn(_measures);
        }
    }

    /// <summary>A body whose numbers left their range is off by more than any bound.</summary>
    private void JudgeOutcasts()
    {
        for (int i = 0; i < _lists.OutcastCount; i++)
        {
            ErrorMeter.Judge(ref _measures, ErrorCause.Lost, double.PositiveInfinity, 0, 0, _lists.Outcast(i).Body, -1);
            _measures.ErrorShare = double.PositiveInfinity;
        }
    }

    public unsafe void BeginSolve(in SolverInput input)
    {
        _mostSubsteps = Math.Max(_mostSubsteps, input.Substeps);
        Audit?.BeginSolve(input.List, input.PaddedCount, input.Substep, input.Joints);
    }

    /// <summary>Writes, or reads, what later steps and readers read of it.</summary>
    public void Visit(StateStream s)
    {
        ReportEnabled = s.Of(nameof(AccuracyStage)).Value(ReportEnabled);
        HasMeasured = s.Value(HasMeasured);
        Budget.Visit(s.Of(nameof(Budget)));
        s.Of(nameof(AccuracyStage)).Value(ref _measures);
        s.Value(ref _mostSubsteps);
        s.Value(ref _reports);
        s.Value(ref _budgeted);
        if (s.Lacks(_audit))
        {
            MakeAudit();
        }

        s.Reference(ref _audit);
        _audit?.Visit(s.Of(nameof(_audit)));
        if (s.Lacks(_meter))
        {
            MakeMeter();
        }

        s.Of(nameof(AccuracyStage)).Reference(ref _meter);
        _meter?.Visit(s.Of(nameof(_meter)));
        if (s.Lacks(_impactLaw))
        {
            MakeImpactLaw();
        }

        s.Of(nameof(AccuracyStage)).Reference(ref _impactLaw);
    }
}
