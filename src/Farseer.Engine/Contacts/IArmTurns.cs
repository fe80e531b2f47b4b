namespace Farseer.Engine.Contacts;

/// <summary>
/// Whether arms are turned along as far as bodies have turned, or no further than <see cref="TurnedArms"/> allows: a type, so that each has
/// code of its own.
/// </summary>
internal interface IArmTurns
{
    bool AreLimited { get; }
}

/// <summary>As far as the bodies have turned.</summary>
internal readonly struct WholeTurns : IArmTurns
{
    public bool AreLimited => false;
}

/// <summary>No further than is allowed.</summary>
internal readonly struct LimitedTurns : IArmTurns
{
    public bool AreLimited => true;
}
