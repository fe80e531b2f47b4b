using System;
using Farseer.Benchmarks.Memory;
using Farseer.Benchmarks.Pairs;
using Farseer.Benchmarks.Queries;
using Farseer.Benchmarks.Scenes;
using Farseer.Benchmarks.Sleeping;
using Farseer.Benchmarks.States;
using Farseer.Benchmarks.Suites;
using Farseer.Benchmarks.Trees;
using Farseer.Benchmarks.Unused;

switch (args.Length > 0 ? args[0] : "")
{
    case "pairs":
        return PairFinding.Run();
    case "queries":
        return QueryTiming.Run();
    case "sleeping":
        return SleepTiming.Run();
    case "scenes":
        return SceneCommand.Run(args.AsSpan(1), Console.Out, Console.Error);
    case "resting":
        return RestingTiming.Run(args.AsSpan(1), Console.Out, Console.Error);
    case "series":
        return SizeSeries.Run(args.AsSpan(1), Console.Out, Console.Error);
    case "compare":
        return ResultComparison.Run(args.AsSpan(1), Console.Out, Console.Error);
    case "bdn":
        return SuiteCommand.Run(args[1..], Console.Out);
    case "trees":
        return TreeTiming.Run(args.AsSpan(1), Console.Out);
    case "memory":
        return MemoryCommand.Run(args.AsSpan(1), Console.Out, Console.Error);
    case "allocation":
        return AllocationCommand.Run(args.AsSpan(1), Console.Out, Console.Error);
    case "rollback":
        return StateTiming.Run(args.AsSpan(1), Console.Out, Console.Error);
    case "state":
        return StateCommand.Run(args.AsSpan(1), Console.Out, Console.Error);
    case "unused":
        return UnusedFeatures.Run(Console.Out);
    default:
        Console.WriteLine("usage: Farseer.Benchmarks <verb>");
        Console.WriteLine("  pairs   time of each pair finder, ns a body");
        Console.WriteLine("  queries time of rays, boxes and shapes against 100 to 100,000 bodies, ns a query");
        Console.WriteLine("  sleeping time of steps of worlds asleep and awake, and of allowing sleep where nothing rests");
        Console.WriteLine($"  {SceneCommand.Usage}");
        Console.WriteLine("          whole steps of the performance scenes, --runs times after a run that warms up");
        Console.WriteLine($"  {RestingTiming.Usage}");
        Console.WriteLine("          time of a step of 1, 5, 10 and 20 boxes at rest");
        Console.WriteLine($"  {SizeSeries.Usage}");
        Console.WriteLine("          ns a body-step from 15 bodies to 1,000,000, or to LARGEST, beside those of 1,000");
        Console.WriteLine($"  {ResultComparison.Usage}");
        Console.WriteLine("          two result files of scenes --csv side by side; one: beside a run made now");
        Console.WriteLine($"  {SuiteCommand.Usage}");
        Console.WriteLine("          the suites of BenchmarkDotNet: kernels, pairs, joints, whole scenes; FILE takes the figures as CSV");
        Console.WriteLine($"  {StateCommand.Usage}");
        Console.WriteLine("          every scene back from each seventh step and forward again: how often the state is another one");
        Console.WriteLine($"  {TreeTiming.Usage}");
        Console.WriteLine("          time of trees of joints, ns a body and substep");
        Console.WriteLine($"  {MemoryCommand.Usage}");
        Console.WriteLine("          what a scene keeps in memory, bytes a body by store");
        Console.WriteLine($"  {AllocationCommand.Usage}");
        Console.WriteLine("          what scenes allocate after their first second, by store");
        Console.WriteLine($"  {StateTiming.Usage}");
        Console.WriteLine("          what states and frames of a rollback buffer take, as shares of an update");
        Console.WriteLine("  unused  time and bits of features that have nothing to do");
        return 0;
}
