using System;
using System.CommandLine;
using System.Globalization;
using System.IO;
using Farseer.Hunt.Calls;
using Farseer.Hunt.Running;
using Farseer.Hunt.Soaking;

namespace Farseer.Hunt;

public static class Program
{
    public static int Main(string[] args)
    {
        var facade = new Option<string>("--facade") { DefaultValueFactory = _ => "farseer", Description = "farseer or flash" };
        facade.AcceptOnlyFromAmong("farseer", "flash");
        var seconds = new Option<double>("--seconds") { DefaultValueFactory = _ => 60, Description = "how long worlds are made" };
        var seed = new Option<ulong?>("--seed") { Description = "the first world; without, a new one each time" };
        var worlds = new Option<int>("--worlds") { DefaultValueFactory = _ => int.MaxValue, Description = "how many at most" };
        var workers = new Option<int?>(
            "--workers") { Description = "for all worlds; without, every fourth runs with 1, 2 and 4, which must end with the same bits" };
        var profile = new Option<Profile?>("--profile") { Description = "worlds of this kind alone" };
        var folder = new Option<string>("--out") { DefaultValueFactory = _ => "hunt", Description = "where files of failures go" };
        var root = new RootCommand("Makes random worlds, calls anything, and looks at what must always hold.") { facade, seconds, seed,
            worlds, workers, profile, folder };
        root.SetAction(result =>
        {
            string place = result.GetValue(folder)!;
            Directory.CreateDirectory(place);
            var hunter = new Hunter(Facades.Find(result.GetValue(facade)!), Console.Out)
            {
                Folder = place,
                Only = result.GetValue(profile),
                Workers = result.GetValue(workers),
            };
            hunter.Run(result.GetValue(seed) ?? (ulong)DateTime.UtcNow.Ticks, TimeSpan.FromSeconds(result.GetValue(seconds)),
                result.GetValue(worlds));
            return hunter.Failures == 0 ? 0 : 1;
        });

        var files = new Argument<string[]>("file") { Description = "files of failures" };
        var replay = new Command("replay", "Runs worlds that are kept as files.") { files };
        replay.SetAction(result =>
        {
            int failed = 0;
            foreach (string file in result.GetValue(files)!)
            {
                Script script = ProgramText.Read(File.ReadAllText(file), Facades.Find);
                Failure? failure = new Hunter(script.Facade, Console.Out).Try(script, compareWorkers: true);
                Console.WriteLine($"{file}: {(failure is null ? "holds" : Machine.Describe(failure))}");
                failed += failure is null ? 0 : 1;
            }

            return failed == 0 ? 0 : 1;
        });
        root.Add(replay);
        var calls = new Option<long>("--calls") { DefaultValueFactory = _ => long.MaxValue, Description = "how many calls at most" };
        var state = new Command("state", "Captures worlds before some steps, does something else with them, restores them, and compares.")
        {
            facade, seconds, seed, worlds, calls, profile,
        };
        state.SetAction(result => StateHunt.Run(Facades.Find(result.GetValue(facade)!),
            result.GetValue(seed) ?? (ulong)DateTime.UtcNow.Ticks, TimeSpan.FromSeconds(result.GetValue(seconds)),
            result.GetValue(worlds), result.GetValue(calls), result.GetValue(profile),
            Console.Out).Different == 0 ? 0 : 1);
        root.Add(state);
        root.Add(SoakCommand(seconds));
        return root.Parse(args).Invoke();
    }

    private static Command SoakCommand(Option<double> seconds)
    {
        var steps = new Option<long>("--body-steps") { DefaultValueFactory = _ => 100_000_000, Description = "how many at most" };
        var threads = new Option<int>("--threads") { DefaultValueFactory = _ => 4, Description = "that make worlds at once" };
        var round = new Option<double>("--round") { DefaultValueFactory = _ => 10, Description = "seconds until a look at what is left" };
        var soak = new Command("soak", "Makes and drops worlds on many threads, and looks at what is left of them.")
        {
            seconds, steps, threads, round,
        };
        soak.SetAction(result =>
        {
            string? left = new Soak(Console.Out).Run(TimeSpan.FromSeconds(result.GetValue(seconds)), result.GetValue(steps),
                result.GetValue(threads), TimeSpan.FromSeconds(result.GetValue(round)));
            Console.WriteLine(left ?? "nothing is left");
            return left is null ? 0 : 1;
        });
        return soak;
    }
}
