using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics;

namespace Farseer.Accuracy.Dials;

/// <summary>A setting other than the two dials, and what it changes in a scene.</summary>
/// <param name="What">The member and its two values.</param>
/// <param name="Kind">The scene and its error.</param>
/// <param name="From">The first value.</param>
/// <param name="To">The second.</param>
internal sealed record OtherDial(string What, DialKind Kind, Dial From, Dial To);

/// <summary>What the other settings of the simulator give and take.</summary>
internal static class OtherDials
{
    private static readonly Dial _default = new(Options.DefaultIterations, Options.DefaultDt);

    private static readonly DialKind _shot = new(
        "shot", "shots of 100 m/s at a thin wall", "share that passed",
        Catalogue.Find("S20")!, [100], ["tunnelled_frac"], 1, 0, string.Empty);

    private static readonly DialKind _overlap = new(
        "overlap", "box that begins half in the floor", "seconds until it is out",
        Catalogue.Find("S19")!, [0.5], ["recovery_time_s"], 10, 0, string.Empty);

    public static IReadOnlyList<OtherDial> All { get; } =
    [
        Switch("`AdaptIterations` true → false", "stack", simulator => simulator.AdaptIterations = false),
        Switch("`AdaptIterations` true → false", "heavy", simulator => simulator.AdaptIterations = false),
        Switch("`AdaptIterations` true → false", "bridge", simulator => simulator.AdaptIterations = false),
        Switch("`ErrorBudget` none → 0.1 mm", "pyramid", simulator => simulator.ErrorBudget = ErrorBudget.OfLength(1e-4f)),
        Switch("`ErrorBudget` none → 1 mm", "pit", simulator => simulator.ErrorBudget = ErrorBudget.OfLength(1e-3f)),
        Switch("`EnableReport` false → true", "pyramid", simulator => simulator.EnableReport = true),
        Switch("`EnableReport` false → true", "pit", simulator => simulator.EnableReport = true),
        Switch("`AllowSleep` false → true", "pyramid", simulator => simulator.AllowSleep = true),
        new("`IsContinuousCollisionEnabled` true → false", _shot, _default,
            Tuned(simulator => simulator.IsContinuousCollisionEnabled = false)),
        new("`BiasFactor` 0.8 → 0.2", _overlap, _default, Tuned(simulator => simulator.BiasFactor = 0.2f)),
    ];

    private static OtherDial Switch(string what, string kind, Action<PhysicsSimulator> tune) =>
        new(what, DialKinds.Find(kind), _default, Tuned(tune));

    private static Dial Tuned(Action<PhysicsSimulator> tune) => _default with { Tune = tune };
}
