using System;

namespace Farseer.Samples.Commands;

/// <summary>Prints the commands.</summary>
internal static class HelpCommand
{
    private const string Words = """
        Farseer samples

          list                      the scenes and what they show
          run <scene|file.json>     run to the end and print the results
              --steps N             updates instead of the scene's own number
              --iterations N        the accuracy dial of the simulator (default 5)
              --dt S                seconds an update
              --json                one JSON object instead of tables
          watch <scene|file.json>   live in the terminal
              --iterations N, --dt S
              keys: space pause, right or n one step, + and - speed, r restart, q quit
          draw <scene|file.json>    one step as a picture (SVG)
              --step N              after N updates (default: the scene's last)
              --out f.svg           the file (default: the scene's name)
              --show LIST           besides: vertices,grids,boxes,axes or all
              --iterations N, --dt S
          advise <scene|file.json>  the cheapest setting for an error, with the curve
              --error E             the largest error (default: 1/10000 of the view)
              --steps N             how much of the scene (default: all, at most 10 s)
          learn                     balance a pole on a cart by random search in 64 worlds
              --turns N, --seed N, --workers N
              --out f.svg           the best run (default: learned.svg)
          sweep <specification>     run a shard of a sweep, or go on with it (docs/Sweeps.md)
              --shard I/N           which part of how many; or --shards N within a job
              --out f.jsonl         its rows (default: sweep-I-of-N.jsonl)
          merge <file...>           put shards together; each run must be there, repeats agree
              --out f.jsonl         all rows (default: sweep.jsonl)
          check                     run all scenes and compare with what must come out
          help                      this

        Without arguments: a menu in a terminal, otherwise the scene falling-stack.
        A scene file is described in docs/SceneFormat.md.
        Exit code: 0 fine, 1 a check failed or no setting found, 2 wrong use or a
        broken file.
        """;

    public static int Execute()
    {
        Console.WriteLine(Words);
        return 0;
    }
}
