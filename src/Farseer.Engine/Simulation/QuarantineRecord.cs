using System.Runtime.InteropServices;

namespace Farseer.Engine.Simulation;

/// <summary>How the state of a body came to leave its range.</summary>
internal enum QuarantineCause
{
    /// <summary>It was out of range when the step began.</summary>
    SetFromOutside,

    /// <summary>Forces, impulses and gravity of this step, before contacts were solved.</summary>
    Forces,

    /// <summary>Found at the end of the step.</summary>
    Solver,
}

/// <summary>A body that a step took out because its state left <see cref="Bodies.StateRange"/>.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct QuarantineRecord
{
    public int Body;
    public QuarantineCause Cause;
}
