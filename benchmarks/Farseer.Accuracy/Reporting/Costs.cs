using System.Collections.Generic;
using System.Globalization;
using System.IO;
using Farseer.Accuracy.Sweeping;

namespace Farseer.Accuracy.Reporting;

/// <summary>What the scenes of the aims cost at the default dial, beside another engine's default.</summary>
internal static class Costs
{
    private const int Runs = 5;

    private static readonly string[] _scenes =
    [
        "S03_bounce=0.8", "S08_pendulum=90", "S09_double_pendulum=90", "S11_rope=100", "S11_rope=1000", "S11b_rope_swing=100",
        "S12_bridge=100",
        "S12_bridge=1000", "S13_ragdoll=3", "S15_stack=10", "S15_stack=20", "S15_stack=40", "S16_pyramid=10", "S16_pyramid=20",
        "S17_mass_ratio=100", "S17_mass_ratio=1000", "S18_arch=1", "S18_arch=0.7", "S29_concave=24",
    ];

    /// <summary>The table as lines of Markdown.</summary>
    public static List<string> Lines()
    {
        SweepCommand.WarmUp(_scenes);
        var lines = new List<string> { $"| scene | ns a body-step | {SweepData.DefaultPeer} | ratio |", "|---|---|---|---|" };
        foreach (string scene in _scenes)
        {
            List<Row> rows = Runner.Run(Options.ParseScene(scene), new Dial(Options.DefaultIterations, Options.DefaultDt), Runs);
            double own = rows[0].NanosecondsPerBodyStep;
            double? peer = SweepData.PeerDefaultCost(SweepData.DefaultPeer, scene);
            string other = peer is null ? "– | –" : string.Create(CultureInfo.InvariantCulture, $"{peer:F0} | {own / peer:F2}");
            lines.Add(string.Create(CultureInfo.InvariantCulture, $"| `{scene}` | {own:F0} | {other} |"));
        }

        return lines;
    }

    public static void Print(TextWriter output)
    {
        foreach (string line in Lines())
        {
            output.WriteLine(line);
        }
    }
}
