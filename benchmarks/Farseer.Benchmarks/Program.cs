using System;
using Farseer.Benchmarks.Pairs;

switch (args.Length > 0 ? args[0] : "")
{
    case "pairs":
        return PairFinding.Run();
    default:
        Console.WriteLine("usage: Farseer.Benchmarks <verb>");
        Console.WriteLine("  pairs   time of each pair finder, ns a body");
        return 0;
}
