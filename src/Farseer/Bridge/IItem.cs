namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// What joints, springs and controllers have in common: they are taken in and out at an update and give up when a body is gone.
/// </summary>
internal interface IItem : IStatePart
{
    PhysicsSimulator? Simulator { get; set; }

    Membership Membership { get; set; }

    bool IsDisposed { get; }

    /// <summary>Disposes the item if something it needs is disposed.</summary>
    void Validate();
}
