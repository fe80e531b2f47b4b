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
        new("stack", "tall stack: 20 boxes", "height, mm",
            Known("S15"), [20], ["height_error_pct_of_box"], 1000, 1e-3,
            "Turn `Iterations`: a doubling divides the sag by four. 1/dt gains in leaps: the pile takes more substeps than it "
            + "is told to, and fewer of them once steps are short.") { Unit = 10 },
        new("pyramid", "pyramid of 10 rows", "largest displacement, mm",
            Known("S16"), [10], ["max_displacement_mm"], 1000, 0.01,
            "Turn `Iterations`: both dials divide the error by about four, and a shorter step also pays for finding the "
            + "contacts again."),
        new("heavy", "heavy on light: 100 on 1", "height, mm",
            Known("S17"), [100], ["height_error_mm"], 1000, 1e-3,
            "Turn `Iterations`. The first doubling of 1/dt gives nothing: the pile then takes half as many extra substeps. "
            + "Further ones divide by four as well."),
        new("arch", "arch of 17 stones", "largest displacement, mm",
            Known("S18"), [1], ["max_displacement_mm"], 1000, 0.03,
            "Turn `Iterations`; over three doublings 1/dt buys nearly as much for the same time, but its first doubling gives "
            + "nothing."),
        new("pit", "pit of concave bodies", "deepest overlap ever, mm",
            Known("S29"), [22, 24, 26], ["max_penetration_peak_mm"], 125, 0.01,
            "Turn 1/dt: a doubling of `Iterations` halves the overlap too, but takes more time, and further ones gain less. The "
            + "pile falls otherwise at every setting, so single runs scatter; the figure is a median of three."),
        new("throw", "throw: landing, tumbling, sliding", "resting place, mm",
            DialScenes.Throw, Each(Throws), _place, 1000, 0.01,
            "Neither helps: what is left is chance. Where a tumbling box comes to rest hangs on each of its hits."),
        new("bounce", "bouncing and spinning box", "place after 2 s, mm",
            DialScenes.Bounce, Each(Throws), _place, 1000, 0.01,
            "Neither helps, and little is missing: impacts happen at their moment at any setting. What is left scatters by "
            + "hundredths of a millimetre, and each bounce makes it larger."),
        new("rope", "swinging rope with a load", "place of the load after 3 s, mm",
            DialScenes.Rope, [10, 30, 100, 300, 1000], _place, 1000, 0.01,
            "Leave both: after a swing of 25 m the load is within a tenth of a millimetre. If that is too much, turn "
            + "`Iterations`."),
        new("bridge", "bridge under 100 planks' weight", "deepest overlap of the load, mm",
            Known("S12"), [50, 100, 200], ["load_penetration_peak_mm"], 125, 0.01,
            "Turn `Iterations`: it gains a little more for the same time than 1/dt. The first doubling of either divides the depth "
            + "of the landing by about three. The joints are closed to a micrometre at the default."),
        new("pendulum", "double pendulum", "energy, share",
            Known("S09"), [80, 90, 100], ["energy_max_error_frac"], 1, 3e-5,
            "Turn `Iterations`: both dials divide the error of the energy by about four, and `Iterations` takes less time. "
            + "The motion is chaotic: a doubling keeps it right for up to two seconds more."),
        new("springs", "springs of 1 to 20 Hz", "frequency, share",
            Known("S14"), [1005, 8010, 20005], ["freq_rel_error"], 1, 1e-6,
            "Neither helps: springs follow their closed form at any step, up to rounding. Take the longest step that looks "
            + "smooth."),
        new("ragdoll", "ragdoll that lands", "place of the trunk after 1 s, mm",
            DialScenes.Ragdoll, Each(Throws), _place, 400, 0.01,
            "Neither helps: small differences grow while a ragdoll lands, and both dials change little but chance. Its joints "
            + "are closed to a micrometre at the default."),
    ];

    public static DialKind Find(string name) => All.Single(kind => kind.Name == name);

    private static SceneInfo Known(string name) => Catalogue.Find(name)!;

    private static double[] Each(int count) => [.. Enumerable.Range(1, count).Select(i => (double)i)];
}
