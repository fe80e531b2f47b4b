using System;

namespace Farseer.Fidelity.Fine;

/// <summary>Something in a scene that the equations of motion here do not know.</summary>
internal sealed class NotExpressedException(string what) : Exception(what);
