using System;
using System.Diagnostics;

namespace Farseer.Engine.Stepping;

/// <summary>
/// Whether helpers are worth waiting for. Where other programs want the processors too, the system takes one from a helper in the midst of a
/// block, and the step stands still for a time slice, some milliseconds. A step that does so again and again is better done alone.
/// </summary>
internal sealed class CrewPatience
{
    /// <summary>Share of a step that helpers are thought to save.</summary>
    private const double Gain = 0.25;

    /// <summary>Steps that are not shared when waiting has outweighed that: so many for each step that it could have done meanwhile, twice as many each time, up to a limit.</summary>
    private const double RestShare = 4;
    private const int MostRest = 256;

    /// <summary>Steps whose gain is kept against waiting to come.</summary>
    private const double MostKept = 4;

    private double _credit;
    private double _cost;
    private long _since;
    private long _waited;
    private int _rest;
    private int _left;

    /// <summary>Before a step that would be shared.</summary>
    /// <param name="cost">What it would take one worker, nanoseconds.</param>
    public bool MayShare(double cost)
    {
        if (_left > 0)
        {
            _left--;
            return false;
        }

        _cost = cost;
        _waited = 0;
        return true;
    }

    /// <summary>The first worker waits for others.</summary>
    /// <param name="isLong">It has waited for longer than what they have in hand should take.</param>
    public void Look(bool isLong)
    {
        if (isLong)
        {
            _since = Stopwatch.GetTimestamp();
        }
    }

    /// <summary>The waiting is over.</summary>
    public void Found()
    {
        if (_since != 0)
        {
            _waited += Stopwatch.GetTimestamp() - _since;
            _since = 0;
        }
    }

    /// <summary>After a step that was shared.</summary>
    public void End()
    {
        double waited = _waited * (1e9 / Stopwatch.Frequency);
        _credit = Math.Min(_credit + (Gain * _cost), MostKept * Gain * _cost) - waited;
        if (_credit >= 0)
        {
            _rest = _waited == 0 ? Math.Max(0, _rest - 1) : _rest;
            return;
        }

        _credit = 0;
        _rest = (int)Math.Min(Math.Max(2.0 * _rest, RestShare * waited / _cost), MostRest);
        _left = _rest;
    }
}
