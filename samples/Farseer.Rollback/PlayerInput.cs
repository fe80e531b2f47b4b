using System;

namespace Farseer.Rollback;

/// <summary>What a player holds down in a frame: a byte, which travels over the network.</summary>
[Flags]
internal enum PlayerInput : byte
{
    None = 0,
    Left = 1,
    Right = 2,
    Up = 4,
    Down = 8,
    Kick = 16,
}
