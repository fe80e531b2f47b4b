using System.Collections.Generic;
using System.Linq;

namespace Farseer.Accuracy.Dials;

/// <summary>The kinds of scene of docs/Dials.md, in its order.</summary>
internal static class DialKinds
{
    private const int Throws = 20;

    private static readonly string[] _place = ["x_mm", "y_mm"];

    public static IReadOnlyList<DialKind> All { get; } =
    [
        new("stack", "tall stack: 20 boxes", "height, mm", Known("S15"), [20], ["height_error_pct_of_box"], 1000, 1e-3, "A") { Unit = 10 },
        new("pyramid", "pyramid of 10 rows", "largest displacement, mm", Known("S16"), [10], ["max_displacement_mm"], 1000, 0.01, "A"),
        new("heavy", "heavy on light: 100 on 1", "height, mm", Known("S17"), [100], ["height_error_mm"], 1000, 1e-3, "A"),
        new("arch", "arch of 17 stones", "largest displacement, mm", Known("S18"), [1], ["max_displacement_mm"], 1000, 0.03, "A"),
        new("pit", "pit of concave bodies", "deepest overlap ever, mm", Known("S29"), [22, 24, 26], ["max_penetration_peak_mm"], 125, 0.01, "A"),
        new("throw", "throw: landing, tumbling, sliding", "resting place, mm", DialScenes.Throw, Each(Throws), _place, 1000, 0.01, "A"),
        new("bounce", "bouncing and spinning box", "place after 2 s, mm", DialScenes.Bounce, Each(Throws), _place, 1000, 0.01, "A"),
        new("rope", "swinging rope with a load", "place of the load after 3 s, mm", DialScenes.Rope, [10, 30, 100, 300, 1000], _place, 1000, 0.01, "A"),
        new("bridge", "bridge under 100 planks' weight", "deepest overlap of the load, mm", Known("S12"), [50, 100, 200],
            ["load_penetration_peak_mm"], 125, 0.01, "A"),
        new("pendulum", "double pendulum", "energy, share", Known("S09"), [80, 90, 100], ["energy_max_error_frac"], 1, 3e-5, "A"),
        new("springs", "springs of 1 to 20 Hz", "frequency, share", Known("S14"), [1005, 8010, 20005], ["freq_rel_error"], 1, 1e-6, "A"),
        new("ragdoll", "ragdoll that lands", "place of the trunk after 1 s, mm", DialScenes.Ragdoll, Each(Throws), _place, 400, 0.01, "A"),
    ];

    public static DialKind Find(string name) => All.Single(kind => kind.Name == name);

    private static SceneInfo Known(string name) => Catalogue.Find(name)!;

    private static double[] Each(int count) => [.. Enumerable.Range(1, count).Select(i => (double)i)];
}
