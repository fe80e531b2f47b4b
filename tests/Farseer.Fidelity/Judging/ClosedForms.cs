using System;
using System.Collections.Generic;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Judging;

/// <summary>A closed form that stands in for the original's numbers where a decision here is truer than the original.</summary>
/// <param name="Reason">Which decision, in one line.</param>
/// <param name="Row">The state of a body at a time, or null where the original's row stays the reference.</param>
/// <param name="MassProperty">A mass property of a body, or null where the original's stays the reference.</param>
public sealed record ClosedForm(string Reason, Func<SceneFile, string, double, Row?>? Row, Func<SceneFile, string, string, double?>? MassProperty);

/// <summary>The scenes judged by a closed form: at most eight.</summary>
public static class ClosedForms
{
    public static IReadOnlyDictionary<string, ClosedForm> ByScene { get; } = new Dictionary<string, ClosedForm>(StringComparer.Ordinal)
    {
    };
}
