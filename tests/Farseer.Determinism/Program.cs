using System;
using System.Globalization;
using System.Reflection;
using System.Runtime.Versioning;
using Farseer.Scenes;
using FarseerGames.FarseerPhysics;

namespace Farseer.Determinism;

/// <summary>
/// Runs each scene named on the command line twice in this process and prints, a line each: name, first hash, second hash.
/// The first line names the asset and the configuration that ran.
/// </summary>
internal static class Program
{
    private const int Steps = 600;

    private static int Main(string[] names)
    {
        Assembly library = typeof(PhysicsSimulator).Assembly;
        string framework = library.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName;
        string configuration = library.GetCustomAttribute<AssemblyConfigurationAttribute>()!.Configuration;
        Console.WriteLine($"{framework} {configuration}");
        foreach (string name in names)
        {
            if (SceneLibrary.Find(name) is not { } scene)
            {
                Console.Error.WriteLine($"error: there is no scene '{name}'");
                return 2;
            }

            Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{scene.Name} {Run(scene):x16} {Run(scene):x16}"));
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

        return simulator.StateHash();
    }
}
