namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Where an item stands with its simulator: additions and removals wait for the next update.</summary>
internal enum Membership : byte
{
    None,
    AddQueued,
    Added,
    RemoveQueued,
}
