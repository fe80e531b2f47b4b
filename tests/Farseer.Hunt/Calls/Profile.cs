namespace Farseer.Hunt.Calls;

/// <summary>What a world is made of, and so what must hold in it.</summary>
internal enum Profile
{
    /// <summary>Bodies and hard joints in free space that nobody touches: momentum stays, energy does not rise.</summary>
    Free,

    /// <summary>
    /// Bodies and hard joints over a thick floor that nobody touches: energy does not rise, nothing is under the floor.
    /// </summary>
    Passive,

    /// <summary>Anything is called, also by handlers, with ordinary numbers: nobody is quarantined.</summary>
    Ordinary,

    /// <summary>Anything is called with any number: every value stays finite, updates end, and no exception comes but refusals.</summary>
    Extreme,
}
