using System;
using System.CommandLine;
using Farseer.Benchmarks;
using Farseer.Benchmarks.Growth;
using Farseer.Benchmarks.Jointed;
using Farseer.Benchmarks.Memory;
using Farseer.Benchmarks.Pairs;
using Farseer.Benchmarks.Queries;
using Farseer.Benchmarks.Scenes;
using Farseer.Benchmarks.Sleeping;
using Farseer.Benchmarks.States;
using Farseer.Benchmarks.Suites;
using Farseer.Benchmarks.Trees;
using Farseer.Benchmarks.Unused;
using Farseer.Benchmarks.Worlds;

return Farseer.CommandLines.CommandLine.Run(
    new RootCommand("Times of whole steps and of their parts.")
    {
        Verb.Plain("pairs", "Time of each pair finder, ns a body.", _ => PairFinding.Run()),
        Verb.Plain("queries", "Time of rays, boxes and shapes against 100 to 100,000 bodies, ns a query.", _ => QueryTiming.Run()),
        Verb.Plain(
            "sleeping", "Time of steps of worlds asleep and awake, and of allowing sleep where nothing rests.", _ => SleepTiming.Run()),
        SceneCommand.Create(),
        RestingTiming.Create(),
        SizeSeries.Create(),
        JointedTiming.Create(),
        GrowthCommand.Create(),
        ResultComparison.Create(),
        SuiteCommand.Create(),
        TreeTiming.Create(),
        MemoryCommand.Create(),
        WorldMemory.Create(),
        AllocationCommand.Create(),
        StateTiming.Create(),
        StateCommand.Create(),
        TurnTiming.Create(),
        WorldFigures.Create(),
        Verb.Plain("unused", "Time and bits of features that have nothing to do.", UnusedFeatures.Run),
    },
    args,
    Console.Out,
    Console.Error);
