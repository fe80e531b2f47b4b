using System;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Accuracy;

/// <summary>
/// How many substeps a step may take to end within a time, from how long the last ones took. It reads no clock itself: who has one
/// tells it, and no step that sets no limit asks.
/// </summary>
/// <remarks>
/// A step of n substeps takes a + b·n, with a ≥ 0 for what is done once. Only t/n is kept: (t/n)·m is at least a + b·m for more substeps,
/// so growing stays within the limit, and for fewer it is at most that, so the next step, whose t/n is larger, takes less again.
/// Telling a from b would need steps of different n close together, which a calm scene does not have.
/// </remarks>
[NotState(Why.Running)]
internal sealed class PaceControl
{
    /// <summary>Share of the limit that is aimed at; the rest is for steps that take a little longer than the last.</summary>
    private const double Aim = 0.9;

    /// <summary>
    /// Share of a longer time that is believed at once: one step may have been interrupted. A shorter one is believed whole.
    /// </summary>
    private const double Trust = 0.5;

    private double _perSubstep;

    /// <summary>Forgets what earlier steps took.</summary>
    public void Reset() => _perSubstep = 0;

    public void Learn(double seconds, int substeps)
    {
        double now = seconds / substeps;
        _perSubstep = _perSubstep == 0 || now < _perSubstep ? now : _perSubstep + (Trust * (now - _perSubstep));
    }

    /// <summary>Most substeps of a step that is to end within <paramref name="limit"/> seconds; at least 1.</summary>
    public int Most(double limit)
    {
        double most = _perSubstep > 0 ? Aim * limit / _perSubstep : int.MaxValue;
        return (int)Math.Max(1, Math.Min(most, int.MaxValue));
    }
}
