using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Farseer.Hunt;
using Farseer.Hunt.Calls;
using Farseer.Hunt.Running;
using Xunit;
using Xunit.Abstractions;

namespace Farseer.Shared;

/// <summary>
/// Random worlds, random calls, and what must hold whatever is done: see the folder of the hunt. FARSEER_HUNT_SECONDS sets how long
/// new worlds are
/// made; the seed is printed.
/// </summary>
public abstract class HuntedWorlds
{
    private const string Kept = "hunt/";
    private const string Open = Kept + "open/";

#if NETSTANDARD_ASSET
    private const double Seconds = 5;
#else
    private const double Seconds = 30;
#endif

    /// <summary>
    /// Of these kinds there are worlds that still fail (the files in open/): some in ten thousand. A hundredth of all worlds may, and
    /// three at least.
    /// </summary>
    private const double OpenShare = 0.01;

    private static readonly HashSet<string> _open = new HashSet<string>(StringComparer.Ordinal)
    {
        "quarantine", "energy", "momentum", "below the floor", "not finite: Joint.ReactionForce",
    };

    private readonly Facade _facade;
    private readonly ITestOutputHelper _output;

    protected HuntedWorlds(string facade, ITestOutputHelper output)
    {
        _facade = Facades.Find(facade);
        _output = output;
    }

    [Fact]
    public void NewWorlds_WithRandomCalls_KeepAllInvariants()
    {
        string? more = Environment.GetEnvironmentVariable("FARSEER_HUNT_SECONDS");
        double seconds = more is null ? Seconds : double.Parse(more, CultureInfo.InvariantCulture);
        string folder = Directory.CreateTempSubdirectory("hunt").FullName;
        using var log = new StringWriter(CultureInfo.InvariantCulture);
        var hunter = new Hunter(_facade, log) { Folder = folder, ShrinkTime = TimeSpan.FromSeconds(20) };
        hunter.Run((ulong)DateTime.UtcNow.Ticks, TimeSpan.FromSeconds(seconds));
        _output.WriteLine(log.ToString());

        int most = Math.Max(3, (int)(OpenShare * hunter.Worlds));
        List<string> wrong = hunter.Kinds.Where(k => !_open.Contains(k.Key) || k.Value > most).Select(k => k.Key).ToList();
        string? program = hunter.Files.FirstOrDefault(f => wrong.Any(k => f.Contains(Hunter.FileNameOf(k), StringComparison.Ordinal)));
        Assert.True(wrong.Count == 0, log + "\n" + (program is null ? "" : File.ReadAllText(program)));
        Directory.Delete(folder, true);
    }

    [Fact]
    public void PublicMember_IsModelledOrLeftOutWithAReason()
    {
        Assert.Empty(_facade.Catalogue.Unknown);
        Assert.Empty(_facade.Catalogue.UnusedReasons);
    }

    [Fact]
    public void ModelledMember_InSomeWorld_DoesWhatItSays()
    {
        const int Worlds = 300;
        var done = new HashSet<string>(StringComparer.Ordinal);
        for (ulong seed = 0; seed < Worlds; seed++)
        {
            Script script = Decoder.Read(_facade, Choices.FromSeed(seed));
            var machine = new Machine(script);
            machine.Run();
            done.UnionWith(Call.All(script.Calls).Where(c => machine.Outcomes.GetValueOrDefault(c.Id) == Outcome.Done).Select(c
                => c.Member.Key));
        }

        // Some are rare, as those of a gear of two joints; many that nothing ever calls would have arguments that they always refuse.
        List<string> never = _facade.Members.Select(m => m.Key).Where(k => !done.Contains(k)).ToList();
        _output.WriteLine(string.Join("\n", never));
        Assert.InRange(never.Count, 0, _facade.Members.Count / 10);
    }

    [Fact]
    public void World_WrittenAndReadAgain_EndsWithTheSameBits()
    {
        for (ulong seed = 0; seed < 40; seed++)
        {
            Script script = Decoder.Read(_facade, Choices.FromSeed(seed));
            var first = new Machine(script);
            first.Run();
            Script again = ProgramText.Read(ProgramText.Write(script, first.Outcomes, "", first.Worlds), Facades.Find);
            var second = new Machine(again);
            second.Run();

            Assert.Equal(script.Profile, again.Profile);
            Assert.Equal(first.Hashes, second.Hashes);
        }
    }

    [Fact]
    public void KeptWorld_ThatWasMended_Holds()
    {
        List<string> names = Names(Kept).Where(n => !n.StartsWith(Open, StringComparison.Ordinal)).ToList();
        Assert.NotEmpty(names);
        foreach (string name in names)
        {
            Failure? failure = new Hunter(_facade, TextWriter.Null).Try(Read(name), compareWorkers: true);
            Assert.True(failure is null, name + ": " + (failure is null ? "" : Machine.Describe(failure)));
        }
    }

    [Fact]
    public void OpenWorld_Runs()
    {
        foreach (string name in Names(Open))
        {
            Failure? failure = new Hunter(_facade, TextWriter.Null).Try(Read(name), compareWorkers: false);
            _output.WriteLine($"{name}: {(failure is null ? "holds now: it may go one folder up" : Machine.Describe(failure))}");
            Assert.True(failure is null || _open.Contains(failure.Kind), name);
        }
    }

    [Fact]
    public void FailingWorld_Shrunk_KeepsTheCallsThatMatter()
    {
        // As if the second step after any joint failed.
        static bool Fails(Script script) =>
            script.Calls.SkipWhile(c => c.Made?.Name.EndsWith("Joint", StringComparison.Ordinal) != true).Count(c
                => c.Member is StepMember) > 1;

        Script script = Enumerable.Range(0, 1000).Select(i => Decoder.Read(_facade, Choices.FromSeed((ulong)i))).First(s
            => s.Calls.Count > 100 && Fails(s));
        Script small = new Shrinker(Fails, TimeSpan.FromSeconds(20)).Shrink(script);

        Assert.Equal(3, small.Calls.Count);
        Assert.All(small.Calls.Where(c => c.Member is StepMember), c => Assert.Equal(1, c.Arguments[2]));
    }

    private static Script Read(string name)
    {
        using var reader = new StreamReader(typeof(HuntedWorlds).Assembly.GetManifestResourceStream(name)!);
        return ProgramText.Read(reader.ReadToEnd(), Facades.Find);
    }

    private IEnumerable<string> Names(string folder) => typeof(HuntedWorlds).Assembly.GetManifestResourceNames()
        .Where(n => n.StartsWith(folder + _facade.Name + "-", StringComparison.Ordinal));
}
