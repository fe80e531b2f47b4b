using Farseer.Engine.Accuracy;
using Farseer.Engine.Solver;

namespace Farseer.Engine.Simulation;

/// <summary>What a step reports of itself, and the substeps that a budget of error asks for.</summary>
internal sealed partial class World
{
    private ErrorMeter? _meter;
    private EnergyAudit? _audit;
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
        _reports = ReportEnabled;
        _budgeted = Budget.IsOn;
        if (_reports)
        {
            _audit ??= new EnergyAudit();
            _audit.BeginStep(Bodies);
        }
    }

    private void EndAccuracy()
    {
        HasMeasured = _reports || _budgeted;
        if (!HasMeasured)
        {
            return;
        }

        _meter ??= new ErrorMeter(Bodies, Shapes, _contacts, Joints);
        _measures = default;
        _measures.Substeps = _substeps;
        _measures.MostSubsteps = _mostSubsteps;
        _meter.Measure(ref _measures, Settings.AllowedPenetration);
        Audit?.EndStep(ref _measures, _meter.Groups);
        if (_budgeted && Budget.IsOn)
        {
            Budget.Learn(_measures);
        }
    }

    private unsafe void AuditSolve(in SolverInput input)
    {
        _mostSubsteps = System.Math.Max(_mostSubsteps, input.Substeps);
        Audit?.BeginSolve(input.List, input.PaddedCount, input.Substep, input.Joints);
    }
}
