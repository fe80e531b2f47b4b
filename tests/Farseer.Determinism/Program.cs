using System;
using System.Globalization;
using System.Reflection;
using System.Runtime.Versioning;
using Farseer.Scenes;
using FarseerGames.FarseerPhysics;

namespace Farseer.Determinism;

/// <summary>
/// Arguments: a number of runs and names of scenes. Runs each scene so many times in this process and prints, a line each: its name
/// and the hash of each run. The first line names the asset and the configuration that ran.
/// </summary>
internal static class Program
{
    private const int Steps = 600;

    private static int Main(string[] arguments)
    {
        if (arguments.Length < 2 || !int.TryParse(arguments[0], NumberStyles.None, CultureInfo.InvariantCulture, out int runs))
        {
            Console.Error.WriteLine("error: give a number of runs and names of scenes");
            return 2;
        }

        Assembly library = typeof(PhysicsSimulator).Assembly;
        string framework = library.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName;
        string configuration = library.GetCustomAttribute<AssemblyConfigurationAttribute>()!.Configuration;
        Console.WriteLine($"{framework} {configuration}");
        foreach (string name in arguments[1..])
        {
            if (SceneLibrary.Find(name) is not { } scene)
            {
                Console.Error.WriteLine($"error: there is no scene '{name}'");
                return 2;
            }

            Console.Write(scene.Name);
            for (int run = 0; run < runs; run++)
            {
                Console.Write(string.Create(CultureInfo.InvariantCulture, $" {Run(scene):x16}"));
            }

            Console.WriteLine();
        }

        return 0;
    }

    private static ulong Run(Scene scene)
    {
        PhysicsSimulator simulator = new();
        scene.Build(simulator);
        for (int step = 0; step < Steps; step++)
        {
            scene.Step(simulator, step, scene.Dt);
        }

        return simulator.MotionHash();
    }
}
