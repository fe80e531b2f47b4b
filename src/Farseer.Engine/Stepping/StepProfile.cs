using System.Diagnostics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Stepping;

/// <summary>Seconds spent in each stage of the last step. Off by default; nothing in the engine decides by it.</summary>
[NotState(Why.Running)]
internal sealed class StepProfile
{
    private readonly long[] _ticks = new long[(int)StepStage.Count];
    private long _stageStart;

    public bool Enabled { get; set; }

    public double this[StepStage stage] => _ticks[(int)stage] / (double)Stopwatch.Frequency;

    public double Total
    {
        get
        {
            long sum = 0;
            foreach (long t in _ticks)
            {
                sum += t;
            }

            return sum / (double)Stopwatch.Frequency;
        }
    }

    public void Begin()
    {
        if (Enabled)
        {
            System.Array.Clear(_ticks, 0, _ticks.Length);
            _stageStart = Stopwatch.GetTimestamp();
        }
    }

    /// <summary>Books the time since the previous mark to <paramref name="stage"/>.</summary>
    public void End(StepStage stage)
    {
        if (Enabled)
        {
            long now = Stopwatch.GetTimestamp();
            _ticks[(int)stage] += now - _stageStart;
            _stageStart = now;
        }
    }
}
