using System;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Accuracy;

/// <summary>
/// Chooses the substeps of a step so that its error stays below a budget, from what the last steps left: the state alone decides,
/// no clock. The error of contacts falls with the square of the substeps, so one step tells about how many the next one needs; down
/// it goes one at a time and only after a while, for what comes next may be harder.
/// </summary>
internal sealed class BudgetControl
{
    /// <summary>Share of the budget that is aimed at: the error of the next step is not quite that of the last.</summary>
    private const double Aim = 0.7;

    /// <summary>Steps that could have been done with fewer substeps before one is taken away.</summary>
    private const int Patience = 30;

    private int _now;
    private int _calm;

    /// <summary>Largest error, a length; 0: no such bound.</summary>
    public double Length { get; set; }

    /// <summary>Largest error as a share of the smaller body; 0: no such bound.</summary>
    public double Share { get; set; }

    /// <summary>Most substeps of a step: the bound on its time.</summary>
    public int MostSubsteps { get; set; } = 64;

    public bool IsOn => Length > 0 || Share > 0;

    /// <summary>Forgets what earlier steps needed.</summary>
    public void Reset()
    {
        _now = 0;
        _calm = 0;
    }

    /// <summary>The substeps of the next step; never fewer than the dial says.</summary>
    public int Choose(int dial)
    {
        if (!IsOn)
        {
            return dial;
        }

        _now = Math.Max(dial, Math.Min(_now, Math.Max(dial, MostSubsteps)));
        return _now;
    }

    /// <summary>The error as a multiple of the budget; above 1 it is not kept.</summary>
    public double Load(in StepMeasures m)
    {
        double load = Length > 0 ? m.Error / Length : 0;
        return Share > 0 ? Math.Max(load, m.ErrorShare / Share) : load;
    }

    public void Learn(in StepMeasures m)
    {
        double load = Math.Max(Length > 0 ? m.Curable / Length : 0, Share > 0 ? m.CurableShare / Share : 0) / Aim;
        if (load > 1)
        {
            // At most double: an impact looks worse than it is, and is over in the next step.
            double wanted = _now * Math.Sqrt(Math.Min(load, 4));
            _now = Math.Min(Math.Max(_now + 1, (int)Math.Ceiling(wanted)), 100000);
            _calm = 0;
            return;
        }

        double fewer = _now - 1;
        bool enough = fewer >= 1 && load * _now * _now <= fewer * fewer;
        _calm = enough ? _calm + 1 : 0;
        if (_calm >= Patience)
        {
            _now--;
            _calm = 0;
        }
    }

    /// <summary>Writes, or reads, what later steps read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Value(ref _now);
        s.Value(ref _calm);
        Length = s.Value(Length);
        Share = s.Value(Share);
        MostSubsteps = s.Value(MostSubsteps);
    }
}
