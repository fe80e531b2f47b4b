using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Numerics;
using System.Runtime;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Farseer.Scenes.Performance;
using FarseerGames.FarseerPhysics;

namespace Farseer.Startup;

/// <summary>
/// Arguments: a timing scene or scene=size, steps to run, and --warm-up to begin with <see cref="PhysicsSimulator.WarmUp"/>. Prints what
/// they took in this process, which has just started and compiles what nobody compiled before, and how many methods that were, then what
/// the same steps take once that is done.
/// </summary>
internal static class Program
{
    private const int DefaultSteps = 200;
    private const string WarmUp = "--warm-up";

    /// <summary>Steps that are told by themselves: the first, those to the tenth and to the hundredth.</summary>
    private static readonly int[] _ends = [1, 10, 100];

    private static int Main(string[] all)
    {
        string[] arguments = Array.FindAll(all, a => a != WarmUp);
        string[] named = (arguments.Length > 0 ? arguments[0] : "compounds").Split('=');
        int steps = DefaultSteps;
        if (PerformanceScenes.Find(named[0]) is not { } scene)
        {
            Console.Error.WriteLine($"error: there is no timing scene '{named[0]}'");
            return 2;
        }

        int size = scene.DefaultSize;
        if ((named.Length > 1 && (!TryRead(named[1], out size) || size < 1 || size > scene.LargestSize))
            || (arguments.Length > 1 && !TryRead(arguments[1], out steps)))
        {
            Console.Error.WriteLine($"error: give {scene.Name}=SIZE with a size of 1 to {scene.LargestSize}, and a number of steps");
            return 2;
        }

        string form = RuntimeFeature.IsDynamicCodeCompiled ? "compiled in the process" : "native";
        int lanes = Vector512.IsHardwareAccelerated ? Vector512<float>.Count : Vector<float>.Count;
        Console.WriteLine(FormattableString.Invariant(
            $"{scene.Name}={size}, {steps} steps, {form}, {lanes} lanes; {(DateTime.Now
                - Process.GetCurrentProcess().StartTime).TotalMilliseconds:F0} ms since the process began; {Megabytes():F1} MB on disk"));
        if (arguments.Length < all.Length)
        {
            WarmUpTwice();
        }

        Run("new process", scene, size, steps);
        Run("again", scene, size, steps);
        return 0;
    }

    /// <summary>What lies in the program's folder, but for what only debuggers and editors read.</summary>
    private static double Megabytes()
    {
        long bytes = 0;
        foreach (string file in Directory.EnumerateFiles(AppContext.BaseDirectory, "*", SearchOption.AllDirectories))
        {
            bytes += Path.GetExtension(file) is ".pdb" or ".dbg" or ".xml" ? 0 : new FileInfo(file).Length;
        }

        return bytes / 1e6;
    }

    private static bool TryRead(string text, out int number) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out number);

    private static void WarmUpTwice()
    {
        Console.WriteLine("warm-up");
        foreach (string name in (string[])["first call", "second call"])
        {
            var begin = new Mark();
            PhysicsSimulator.WarmUp();
            Print(name, begin);
        }
    }

    private static void Run(string name, PerformanceScene scene, int size, int steps)
    {
        var begin = new Mark();
        using PhysicsSimulator simulator = new();
        scene.Build(simulator, size);
        Console.WriteLine(name);
        Print("build", begin);
        int step = 0;
        for (int i = 0; step < steps; i++)
        {
            int from = step;
            int end = i < _ends.Length ? Math.Min(_ends[i], steps) : steps;
            var start = new Mark();
            for (; step < end; step++)
            {
                scene.Drive(step);
                simulator.Update(scene.Dt);
            }

            Print(end == from + 1 ? $"step {end}" : $"steps {from + 1} to {end}", start);
        }

        Print("all", begin);
        Console.WriteLine($"  hash {simulator.MotionHash():x16}");
    }

    private static void Print(string what, in Mark since)
    {
        double time = Stopwatch.GetElapsedTime(since.Time).TotalMilliseconds;
        double processor = (Environment.CpuUsage.TotalTime - since.Processor).TotalMilliseconds;
        long methods = JitInfo.GetCompiledMethodCount() - since.Methods;
        Console.WriteLine(FormattableString.Invariant(
            $"  {what,-18} {time,9:F1} ms {processor,9:F1} ms of processor time {methods,6} methods compiled"));
    }

    /// <summary>A moment, how long processors had worked and how many methods had been compiled by then.</summary>
    private readonly struct Mark()
    {
        public long Methods { get; } = JitInfo.GetCompiledMethodCount();

        public TimeSpan Processor { get; } = Environment.CpuUsage.TotalTime;

        public long Time { get; } = Stopwatch.GetTimestamp();
    }
}
