using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Threading;
using Farseer.CommandLines;

namespace Farseer.Testbed;

/// <summary>The console: list, run, watch and check. Without arguments the first scene runs, that of the manual.</summary>
public static class Program
{
    public static int Main(string[] args)
    {
        var name =
            new Argument<string?>("scene") { Description = "the name of a scene; without, the first", Arity = ArgumentArity.ZeroOrOne };
        var list = new Command("list", "Names the scenes.");
        list.SetAction(result => List(result.InvocationConfiguration.Output));
        var check = new Command("check", "Runs all scenes and says whether they end as they must.");
        check.SetAction(_ => Code(SceneList.Makers.Select(m => Run(m(), false)).ToList().All(ok => ok)));
        var run = new Command("run", "Runs a scene to its end.") { name };
        run.SetAction(result => Code(Run(Find(result.GetValue(name)), false)));
        var watch = new Command("watch", "Shows a scene in letters.") { name };
        watch.SetAction(result => Code(Run(Find(result.GetValue(name)), true)));
        var root = new RootCommand(
            "Scenes with the API of Box2DFlash. Without a command: the first one, that of the manual.") { list, check, run, watch };
        root.SetAction(_ => Code(Run(Find(null), false)));
        return CommandLine.Run(root, args, Console.Out, Console.Error);
    }

    private static int Code(bool holds) => holds ? 0 : 1;

    private static void List(TextWriter output)
    {
        foreach (TestScene scene in SceneList.Makers.Select(m => m()))
        {
            output.WriteLine($"{scene.Name,-18} {scene.Description}");
        }
    }

    private static TestScene Find(string? name)
    {
        List<TestScene> all = [.. SceneList.Makers.Select(m => m())];
        return all.Find(s => name is null || s.Name == name)
            ?? throw new UsageException($"there is no scene '{name}'{Names.Suggestion(name!, all.Select(s => s.Name))}; 'list' names them");
    }

    private static bool Run(TestScene scene, bool watch)
    {
        Console.WriteLine($"{scene.Name}: {scene.Description}");
        bool animate = watch && !Console.IsOutputRedirected;
        for (int step = 0; step < scene.Steps; step++)
        {
            scene.Step(step);
            if (animate)
            {
                Console.Write("\u001b[H\u001b[2J" + TextDraw.Picture(scene));
                Thread.Sleep(16);
            }
        }

        if (watch && !animate)
        {
            Console.Write(TextDraw.Picture(scene));
        }

        List<Outcome> outcomes = [.. scene.Check()];
        foreach (Outcome outcome in outcomes)
        {
            Console.WriteLine((outcome.Holds ? "  ok    " : "  WRONG ") + outcome.What);
        }

        return outcomes.All(o => o.Holds);
    }
}
