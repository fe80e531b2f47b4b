using System;
using System.Collections.Generic;

namespace Farseer.Rollback;

/// <summary>What rollback cost a side.</summary>
internal sealed class PeerFigures
{
    private readonly SortedDictionary<int, int> _depths = [];

    /// <summary>How often it went back.</summary>
    public int Rollbacks { get; private set; }

    /// <summary>Frames done again.</summary>
    public int FramesAgain { get; private set; }

    public int Deepest { get; private set; }

    /// <summary>Time to go back and to do the frames again.</summary>
    public TimeSpan RollbackTime { get; private set; }

    public TimeSpan LongestRollback { get; private set; }

    public TimeSpan SaveTime { get; set; }

    public int Saves { get; set; }

    /// <summary>Ticks without a frame, because the other was too far behind.</summary>
    public int Waits { get; set; }

    /// <summary>Checksums of the other side that were compared on the way.</summary>
    public int Checked { get; set; }

    public int Unequal { get; set; }

    /// <summary>How many rollbacks went back by so many frames.</summary>
    public IReadOnlyDictionary<int, int> Depths => _depths;

    public void AddRollback(int depth, TimeSpan time)
    {
        Rollbacks++;
        FramesAgain += depth;
        Deepest = Math.Max(Deepest, depth);
        RollbackTime += time;
        LongestRollback = time > LongestRollback ? time : LongestRollback;
        _depths[depth] = _depths.GetValueOrDefault(depth) + 1;
    }
}
