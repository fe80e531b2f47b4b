using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;

namespace Farseer.Testbed;

/// <summary>The console: list, run, watch and check. Without arguments the first scene runs, that of the manual.</summary>
public static class Program
{
    public static int Main(string[] args)
    {
        string command = args.Length > 0 ? args[0] : "run";
        switch (command)
        {
            case "list":
                foreach (TestScene scene in SceneList.Makers.Select(m => m()))
                {
                    Console.WriteLine($"{scene.Name,-18} {scene.Description}");
                }

                return 0;
            case "check":
                return SceneList.Makers.Select(m => Run(m(), false)).ToList().All(ok => ok) ? 0 : 1;
            case "run" or "watch":
                Func<TestScene>? maker = Find(args.Length > 1 ? args[1] : null);
                if (maker is not null)
                {
                    return Run(maker(), command == "watch") ? 0 : 1;
                }

                break;
        }

        Console.Error.WriteLine("Farseer.Testbed [list | check | run <scene> | watch <scene>]");
        return 2;
    }

    private static Func<TestScene>? Find(string? name) => name is null ? SceneList.Makers[0] : SceneList.Makers.FirstOrDefault(m => m().Name == name);

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
