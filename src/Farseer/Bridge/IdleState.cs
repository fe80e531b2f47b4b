using System;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>What an inactivity controller knows of a body.</summary>
[Flags]
internal enum IdleState : byte
{
    None = 0,

    /// <summary>The controller has disabled it, and nobody has enabled it since.</summary>
    Disabled = 1,

    /// <summary>It reaches others; for the length of a search.</summary>
    Awake = 2,

    /// <summary>It may be reached; for the length of a search.</summary>
    Resting = 4,
}
