using System;
using System.Globalization;
using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <summary>
/// Tells which body the simulator took out because its state was no longer one of numbers. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// simulator.BodyQuarantined += (sender, lost) =&gt; Console.WriteLine(lost.Body + " left the range of numbers");
/// </code>
/// </example>
[NotState(Why.Fixed)]
public sealed class BodyQuarantinedEventArgs : EventArgs
{
    internal BodyQuarantinedEventArgs(Body body, long step, string reason, string? lastCall, long lastCallStep)
    {
        Body = body;
        Step = step;
        Reason = reason;
        LastCall = lastCall;
        LastCallStep = lastCallStep;
    }

    /// <summary>
    /// The body. It is disabled, stands still, and is at its last good position; <see cref="Body.Enabled"/> = true lets it go on.
    /// </summary>
    public Body Body { get; }

    /// <summary>The step in which it happened: the first update that moved anything is 1.</summary>
    public long Step { get; }

    /// <summary>Where it was found, a sentence for a log.</summary>
    public string Reason { get; }

    /// <summary>
    /// The last member of the body that was called to change its motion, position or mass; null if there was none. What only forces of
    /// contacts did has no call of its own: then it is the last one before.
    /// </summary>
    public string? LastCall { get; }

    /// <summary>The step after which <see cref="LastCall"/> came; 0 before the first.</summary>
    public long LastCallStep { get; }

    /// <summary>The whole report in one line.</summary>
    /// <returns>The text, in English.</returns>
    public override string ToString() =>
        "Body quarantined in step " + Step.ToString(CultureInfo.InvariantCulture) + ": " + Reason + " Last call: "
        + (LastCall is null ? "none" : LastCall + ", after step " + LastCallStep.ToString(CultureInfo.InvariantCulture)) + ".";
}
