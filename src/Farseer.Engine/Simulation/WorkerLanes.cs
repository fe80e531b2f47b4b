using System.Runtime.InteropServices;
using Farseer.Engine.Contacts;
using Farseer.Engine.NarrowPhase;

namespace Farseer.Engine.Simulation;

/// <summary>
/// Where pairs and rows pass through on their way, for each worker of the narrow phase. It stays from step to step and from world to world:
/// a bundle in which pairs are only looked at must never have held an impulse, and lanes that are not in use have numbers, not bits that
/// chance left there.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
internal struct WorkerLanes
{
    public PairLanes Pairs;

    /// <summary>New rows, pairs without a row that are looked at, pairs of struck bodies, and pairs of fast ones.</summary>
    public ContactBundle Filled;
    public ContactBundle Looked;
    public ContactBundle Struck;
    public ContactBundle Fast;
}
