using Farseer.Engine.Accuracy;
using Farseer.Engine.Solver;

namespace Farseer.Engine.Simulation;

/// <summary>What a step reports of itself, and the substeps that a budget of error asks for.</summary>
internal sealed partial class World
{
    private ErrorMeter? _meter;
    private EnergyAudit? _audit;
    private ImpactLaw? _impactLaw;
    private StepMeasures _measures;
    private int _substeps = 1;
    private int _mostSubsteps;

    // As they were when the step began: a handler may switch within it.
    private bool _reports;
    private bool _budgeted;

    /// <summary>Each step measures what it did. Off by default: then nothing of it runs, and no bit changes either way.</summary>
    public bool ReportEnabled { get; set; }

    public BudgetControl Budget { get; } = new BudgetControl();

    /// <summary>The last step measured itself.</summary>
    public bool HasMeasured { get; private set; }

    /// <summary>Of the last step that measured itself.</summary>
    public ref readonly StepMeasures Measures => ref _measures;

    /// <summary>The audit of this step, or null if nobody wants it.</summary>
    private EnergyAudit? Audit => _reports ? _audit : null;

    private void BeginAccuracy()
    {
        // Once for the whole step: a handler may turn the dial, and the substeps must add up to the step.
        _substeps = Budget.Choose(Settings.Substeps);
        _mostSubsteps = _substeps;
        _budgeted = Budget.IsOn;
        _reports = ReportEnabled || _budgeted;
        if (_reports)
        {
            MakeAudit().BeginStep(Bodies);
        }
    }

    private EnergyAudit MakeAudit() => _audit ??= new EnergyAudit();

    private ErrorMeter MakeMeter() => _meter ??= new ErrorMeter(Bodies, Shapes, _contacts, _graph, Joints);

    private ImpactLaw MakeImpactLaw() => _impactLaw ??= new ImpactLaw(Bodies, _contacts, _graph, Joints, MakeMeter());

    private void EndAccuracy(float dt)
    {
        HasMeasured = _reports;
        if (!HasMeasured || _audit == null)
        {
            return;
        }

        ErrorMeter meter = MakeMeter();
        ImpactLaw impactLaw = MakeImpactLaw();
        _measures = default;
        _measures.Substeps = _substeps;
        _measures.MostSubsteps = _mostSubsteps;
        meter.Measure(ref _measures, Settings, _audit);
        _audit.EndStep(ref _measures, meter.Groups, dt);
        if (UserJoints == null || !UserJoints.Any)
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

    private unsafe void AuditSolve(in SolverInput input)
    {
        _mostSubsteps = System.Math.Max(_mostSubsteps, input.Substeps);
        Audit?.BeginSolve(input.List, input.PaddedCount, input.Substep, input.Joints);
    }
}
