using System;
using System.Linq;
using Box2D.Dynamics;

namespace Farseer.Fidelity.Flash;

/// <summary>
/// What was recorded is what the original did, with its faults: a scene is run with every compatibility flag of the library.
/// </summary>
internal static class FlashQuirks
{
    public static Box2DFlash202Quirks All { get; } = Enum.GetValues<Box2DFlash202Quirks>().Aggregate((a, b) => a | b);
}
