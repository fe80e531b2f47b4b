using System;
using Farseer.Benchmarks.Pairs;
using Farseer.Benchmarks.Queries;
using Farseer.Benchmarks.Scenes;
using Farseer.Benchmarks.Sleeping;

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
    default:
        Console.WriteLine("usage: Farseer.Benchmarks <verb>");
        Console.WriteLine("  pairs   time of each pair finder, ns a body");
        Console.WriteLine("  queries time of rays, boxes and shapes against 100 to 100,000 bodies, ns a query");
        Console.WriteLine("  sleeping time of steps of worlds asleep and awake, and of allowing sleep where nothing rests");
        Console.WriteLine($"  {SceneCommand.Usage}");
        Console.WriteLine("          whole steps of the performance scenes");
        return 0;
}
