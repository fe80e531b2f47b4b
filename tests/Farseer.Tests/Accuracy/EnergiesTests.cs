using System.IO;
using System.Linq;
using Farseer.Accuracy;
using Farseer.Accuracy.Energies;
using Xunit;

namespace Farseer.Tests.Accuracy;

/// <summary>The random worlds whose energy is looked at.</summary>
public class EnergiesTests
{
    /// <summary>In the first tenth of a second nothing has touched anything: bodies fall, and what hangs swings.</summary>
    [Fact]
    public void Energies_BeforeAnythingTouches_DoNotRise()
    {
        foreach (EnergyKind kind in EnergyWorlds.Kinds)
        {
            for (int seed = 1; seed <= 30; seed++)
            {
                // Velocities and positions of a joint's bodies are right to a float's rounding.
                Assert.InRange(EnergyWorlds.Rise(kind, seed, 0.1), 0, 1e-5);
            }
        }
    }

    /// <summary>
    /// Links of rings and chains bounce off each other at two points at once. To stop one that parted before the impact gave energy: one
    /// world had a third more than at its start, others thousands of times as much.
    /// </summary>
    [Fact]
    public void Energies_OfBouncingChains_AreNotMade()
    {
        EnergyKind chains = EnergyWorlds.Kinds.Single(kind => kind.Name == "chains");
        for (int seed = 1; seed <= 20; seed++)
        {
            // Newton's rule with friction may give some: a hundredth here at most.
            Assert.InRange(EnergyWorlds.Rise(chains, seed, 10), 0, 0.02);
        }
    }

    [Fact]
    public void Energies_OfOneSeed_AreTheSameFigures()
    {
        foreach (EnergyKind kind in EnergyWorlds.Kinds)
        {
            Assert.Equal(EnergyWorlds.Rise(kind, 7, 2), EnergyWorlds.Rise(kind, 7, 2));
        }
    }

    [Fact]
    public void Command_WithAFile_WritesAFigureForEachWorld()
    {
        string path = Path.GetTempFileName();
        try
        {
            using var output = new StringWriter();
            int code = Cli.Run(["energies", "--seeds", "2", "--seconds", "1", "--csv", path], output, TextWriter.Null);
            string[] lines = File.ReadAllLines(path);

            Assert.Equal("name,value,limit,better", lines[0]);
            Assert.Equal(2 * EnergyWorlds.Kinds.Length, lines.Length - 1);
            Assert.Equal(lines.Length - 1, lines.Skip(1).Select(line => line.Split(',')[0]).Distinct().Count());
            Assert.Equal(code == 0, output.ToString().TrimEnd().EndsWith(" 0 failed", System.StringComparison.Ordinal));
        }
        finally
        {
            File.Delete(path);
        }
    }
}
