using System;
using Farseer.Engine.Simulation;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics;

/// <content>Bodies whose state is no longer one of numbers.</content>
public partial class PhysicsSimulator
{
    /// <summary>
    /// Raised at the end of an update for each body that it took out because a velocity or position was not a number, infinite, or so large
    /// (beyond 9.2·10¹⁸) that its square is. Such a body is disabled, as by <see cref="Body.Enabled"/>, at its last good position and
    /// without velocity; the others go on. A static body only loses its velocity. The cause may be a wrong number put into
    /// <see cref="Body.LinearVelocity"/>, or forces and masses beyond the range of floats. (An addition to the original.)
    /// </summary>
    public event EventHandler<BodyQuarantinedEventArgs>? BodyQuarantined;

    /// <summary>Steps made so far.</summary>
    internal long StepCount { get; private set; }

    private void TellQuarantined()
    {
        int count = World.BodyStage.QuarantinedCount;
        for (int i = 0; i < count; i++)
        {
            QuarantineRecord record = World.BodyStage.Quarantined(i);
            if (World.BodyStage.IsQuarantined(record.Body) && _table.Body(record.Body) is { } body)
            {
                body.Quarantine();
            }
        }

        for (int i = 0; i < count && BodyQuarantined is not null; i++)
        {
            QuarantineRecord record = World.BodyStage.Quarantined(i);
            if (_table.Body(record.Body) is { } body)
            {
                try
                {
                    BodyQuarantined?.Invoke(this, Tell(body, record.Cause));
                }
                catch (Exception exception)
                {
                    _relay.Keep(exception);
                }
            }
        }
    }

    private BodyQuarantinedEventArgs Tell(Body body, QuarantineCause cause)
    {
        if (cause != QuarantineCause.SetFromOutside)
        {
            string reason = cause == QuarantineCause.Forces
                ? "forces and impulses drove its velocity or place out of range."
                : "contacts drove its velocity or place out of range.";
            return new BodyQuarantinedEventArgs(body, StepCount, reason, body.LastCall, body.LastCallStep);
        }

        // All other members that set something refuse what is out of range.
        bool byImpulse = body.LastCall == nameof(Body.ApplyAngularImpulse) && body.LastCallStep == StepCount - 1;
        string call = byImpulse ? nameof(Body.ApplyAngularImpulse) : nameof(Body.LinearVelocity) + " or " + nameof(Body.AngularVelocity);
        return new BodyQuarantinedEventArgs(body, StepCount, "its velocity was out of range when the step began.", call, StepCount - 1);
    }
}
