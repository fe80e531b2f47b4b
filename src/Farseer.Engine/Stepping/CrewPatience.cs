using System;
using System.Diagnostics;

namespace Farseer.Engine.Stepping;

/// <summary>
/// Whether helpers are worth waiting for. Where other programs want the processors too, the system takes one from a helper in the midst of
/// a block, and the step stands still for a time slice, some milliseconds. A step that does so again and again is better done alone. And
/// where processors are far from each other, or are two halves of one, sharing may take longer than it saves, whoever comes in time: now
/// and then some steps are done the other way, and what is quicker goes on.
/// </summary>
internal sealed class CrewPatience
{
    /// <summary>Share of a step that helpers are thought to save.</summary>
    private const double Gain = 0.25;

    /// <summary>
    /// Steps that are not shared when waiting has outweighed that: so many for each step that it could have done meanwhile, twice as many
    /// each time, up to a limit.
    /// </summary>
    private const double RestShare = 4;
    private const int MostRest = 256;

    /// <summary>Steps whose gain is kept against waiting to come.</summary>
    private const double MostKept = 4;

    /// <summary>Steps done the other way, of which the median counts, and beside how many of the usual way.</summary>
    private const int Trial = 3;

    /// <summary>Steps from one trial to the next: at first, and after trials that changed nothing, each of which doubles it.</summary>
    private const int FirstStretch = 16;
    private const int LastStretch = 512;

    /// <summary>
    /// Of the time of one worker what sharing may take at most: what only saves less than that is not worth another processor.
    /// </summary>
    private const double WorthSharing = 0.97;

    private readonly double[] _usual = new double[Trial];
    private readonly double[] _tried = new double[Trial];
    private int _stretch = FirstStretch;
    private int _steps;
    private bool _alone;
    private long _began;

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
        _began = Stopwatch.GetTimestamp();
        return _alone == IsTrial;
    }

    private bool IsTrial => _steps >= _stretch;

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

    /// <summary>After a step that was done alone, whether it had been asked for or not.</summary>
    public void EndAlone()
    {
        if (_began != 0)
        {
            Compare();
        }
    }

    /// <summary>After a step that was shared.</summary>
    public void End()
    {
        Compare();
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

    /// <summary>Sets the time of the step, as a part of what it was estimated at, against those of the steps before it.</summary>
    private void Compare()
    {
        double time = (Stopwatch.GetTimestamp() - _began) / _cost;
        _began = 0;
        if (!IsTrial)
        {
            _usual[_steps++ % Trial] = time;
            return;
        }

        _tried[_steps++ - _stretch] = time;
        if (_steps < _stretch + Trial)
        {
            return;
        }

        double ratio = Median(_tried) / Median(_usual);
        bool changes = _alone ? ratio < WorthSharing : ratio * WorthSharing < 1;
        _alone ^= changes;
        _stretch = changes ? FirstStretch : Math.Min(2 * _stretch, LastStretch);
        _steps = 0;
    }

    private static double Median(double[] times)
    {
        Array.Sort(times);
        return times[Trial / 2];
    }
}
