using System;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <summary>Ways in which a body may not move: see <see cref="Body.MotionLocks"/>. (An addition to the original.)</summary>
/// <example>
/// <code>
/// body.MotionLocks = MotionLocks.X | MotionLocks.Rotation;
/// </code>
/// </example>
[Flags]
public enum MotionLocks
{
    /// <summary>It moves freely.</summary>
    None = 0,

    /// <summary>Its x stays.</summary>
    X = 1,

    /// <summary>Its y stays.</summary>
    Y = 2,

    /// <summary>It does not turn: see <see cref="Body.FixedRotation"/>.</summary>
    Rotation = 4,

    /// <summary>It stays where it is, unless it is moved by hand.</summary>
    All = 7,
}
